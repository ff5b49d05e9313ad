#pragma once

namespace overfly {

// Of OpenEXR's compressions those that suit our frames. `overfly bench write` measures what each of them takes.
enum class Compression {
    Zip,   // lossless, 16 lines at a time
    Zips,  // lossless, line by line
    Piz,   // lossless, wavelets
    Dwaa,  // lossy where it is colour, lossless where it is alpha or anything else
};

[[nodiscard]] constexpr bool is_lossy(Compression compression) { return compression == Compression::Dwaa; }

// Layers that a compression is chosen for together.
enum class LayerGroup {
    Beauty,  // R, G, B, A and light of all kinds
    Data,    // everything that is not for the eye: Z, N, lon, ...
};

// How a frame's file stores its layers, group by group.
struct FrameStorage {
    Compression beauty = Compression::Zip;  // of LayerGroup::Beauty
    Compression data = Compression::Zip;    // of LayerGroup::Data; never a lossy one
    double quality = 45.0;                  // of Dwaa, OpenEXR's level: the higher, the smaller and the coarser

    friend bool operator==(const FrameStorage&, const FrameStorage&) = default;
};

}  // namespace overfly
