#pragma once

#include <string>
#include <vector>

// What probe.cpp does with the pixels of frames, through OpenEXR alone. Frames are of one part, with R, G, B, A in half
// and Z in float.
namespace overfly::probe {

using Arguments = std::vector<std::string>;

// change FRAME CHANNEL FACTOR: multiplies the values of a channel, which may make them `nan` or `inf`
bool change(const Arguments& a);
// pixels_of FROM TO: gives a frame the pixels of another one; its header stays
bool pixels_of(const Arguments& a);
// hashed_bytes FRAME: prints what docs/manifest.md says that the hash of the pixels is made of
bool print_hashed_bytes(const Arguments& a);
// centroid A B CHANNEL: prints x and y, in pixels, of the centre of what differs between two frames, by how much it
// does
bool print_centroid(const Arguments& a);

}  // namespace overfly::probe
