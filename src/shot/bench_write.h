#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/progress.h"
#include "film/frame_storage.h"

namespace overfly {

struct WriteBenchOptions {
    int runs = 5;  // of each; the quickest counts
    Progress progress;
};

// What one group of layers takes in one compression, for a frame on average.
struct GroupCost {
    LayerGroup group = LayerGroup::Beauty;
    Compression compression = Compression::Zip;
    double quality = 0.0;  // of a lossy one
    double bytes = 0.0, wall_s = 0.0, processor_s = 0.0;
    double rmse = 0.0;  // of red, green and blue in linear light; 0: lossless
};

// The time of writing a frame into a file, with all that this takes, beside that of compressing its groups of layers
// alone: from buffers that are ready into memory. Of frames on average, in the default compression.
struct WritingTime {
    double wall_s = 0.0, processor_s = 0.0;
    double compression_wall_s = 0.0, compression_processor_s = 0.0;

    [[nodiscard]] double ratio() const { return wall_s / compression_wall_s; }
};

struct WriteBench {
    int frames = 0, width = 0, height = 0;        // of the first frame
    double beauty_bytes = 0.0, data_bytes = 0.0;  // of a frame on average, not compressed
    std::vector<GroupCost> costs;
    WritingTime writing;

    // What to take where nothing may be lost: of the compressions that come within kAlmost of the smallest size, the
    // quickest.
    static constexpr double kAlmost = 1.1;
    [[nodiscard]] const GroupCost& best_lossless(LayerGroup group) const;
    // The one that loses least where colours may lose something.
    [[nodiscard]] const GroupCost& best_lossy() const;
};

// Frames are read from their files, and compressed one after another on one thread. REQUIRES: frames is not empty.
// Throws UserError where one can't be read.
[[nodiscard]] WriteBench bench_write(std::span<const std::filesystem::path> frames, const WriteBenchOptions& options);

}  // namespace overfly
