#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// The world of J. Chapman, T. W. Calvert and J. Dill, "Spatio-Temporal Coherence in Ray Tracing", 1991, section 5: a
// camera that stands still, and bodies of convex polygons that are translated along polynomials of time. Time u runs
// from 0 at the first frame to 1 at the last. The scalar tracers of the paper (paper_discrete.h, paper_continuous.h)
// exist to be measured against each other; frames are made by the tracers of tracer.h.

// How far a body has gone: u * velocity + u^2 * bend.
struct PaperMotion {
    Vector<Scene> velocity, bend;

    [[nodiscard]] Vector<Scene> at(double u) const { return u * velocity + (u * u) * bend; }
    [[nodiscard]] int degree() const { return bend != Vector<Scene>{} ? 2 : velocity != Vector<Scene>{} ? 1 : 0; }
};

// Stands still. The line of sight through the centre of a pixel starts at `eye`.
struct PaperCamera {
    Point<Scene> eye;
    Vector<Scene> first;                // through the upper left pixel
    Vector<Scene> per_column, per_row;  // from pixel to pixel
    int rows = 400, columns = 512;

    [[nodiscard]] Vector<Scene> direction(int row, int column) const {
        return first + static_cast<double>(row) * per_row + static_cast<double>(column) * per_column;
    }
};

// Planar and convex, its corners anticlockwise or clockwise.
struct PaperPolygon {
    std::uint32_t first_corner = 0, corners = 0;  // in PaperScene::corners
    std::uint32_t body = 0;                       // that carries it, in PaperScene::bodies
};

struct PaperScene {
    PaperCamera camera;
    int frames = 100;  // REQUIRES: at least 2
    std::vector<PaperMotion> bodies;
    std::vector<Point<Scene>> positions;  // at u = 0
    std::vector<VertexId> corners;
    std::vector<PaperPolygon> polygons;

    [[nodiscard]] double u_of(int frame) const { return static_cast<double>(frame) / (frames - 1); }
};

// The rows of the paper's Figure 5.
struct PaperCounters {
    std::uint64_t bv_tests = 0, bv_hits = 0;      // of a ray with a bounding volume
    std::uint64_t poly_tests = 0, poly_hits = 0;  // of a ray with a polygon

    friend bool operator==(const PaperCounters&, const PaperCounters&) = default;
};

// The animation as both tracers shade it: each pixel of each frame is the number of the polygon that it sees. Pixels
// are stored in blocks of some of a row's, all frames of a block together: a frame's next block is near, and so is a
// pixel's next frame.
class PaperFrames {
  public:
    using Pixel = std::uint16_t;
    static constexpr Pixel kNothing = 0xFFFF;
    static constexpr int kBlock = 32;  // pixels: one line of the cache

    // REQUIRES: fewer polygons than a pixel can tell apart.
    explicit PaperFrames(const PaperScene& scene);

    // The pixels of a row of a frame, from that of `column`, the first of a block, to the end of the block.
    [[nodiscard]] Pixel* block(int frame, int row, int column) {
        return pixels_.data() + ((row * blocks_ + column / kBlock) * frames_ + frame) * kBlock;
    }
    [[nodiscard]] Pixel at(int frame, int row, int column) const {
        return pixels_[static_cast<std::size_t>(((row * blocks_ + column / kBlock) * frames_ + frame) * kBlock +
                                                column % kBlock)];
    }

  private:
    std::ptrdiff_t blocks_, frames_;  // blocks in a row
    std::vector<Pixel> pixels_;
};

}  // namespace overfly
