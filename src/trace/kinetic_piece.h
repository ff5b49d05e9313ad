#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "trace/kinetic_line.h"
#include "trace/kinetic_scene.h"
#include "trace/line.h"
#include "trace/silhouette.h"
#include "trace/silhouette_film.h"

namespace overfly {

// On which side of a line in the scene the lines of sight are: that of film point (x, y) by x * right + y * down +
// view.
struct SideForm {
    Bernstein<4> right{}, down{}, view{};

    SideForm() = default;
    SideForm(const LinesOverPiece& lines, const EdgeFunction& edge)
        : right(lines.right.side_of(edge)), down(lines.down.side_of(edge)), view(lines.view.side_of(edge)) {}

    [[nodiscard]] Bernstein<4> at(double x, double y) const {
        Bernstein<4> side{};
        for (std::size_t j = 0; j < 5; ++j) side[j] = x * right[j] + y * down[j] + view[j];
        return side;
    }
    // Bounds over a part of the film and the whole piece.
    struct Range {
        double least, most;
    };
    [[nodiscard]] Range range(const FilmBounds& part) const;
};

// An edge that may end what is seen, as lines of sight pass it.
struct Silhouette {
    HalfEdgeId half_edge = kNone;
    SideForm across;        // of the edge, in the direction of the half-edge
    SideForm begin, end;    // of lines across its ends: both >= 0 for a line of sight that passes between them
    bool has_ends = false;  // false where the edge turns so that begin and end tell nothing
    FilmBounds film;        // where the edge appears at any time of the piece

    // False only if no line through `part` passes the edge while the piece lasts.
    [[nodiscard]] bool may_cross(const FilmBounds& part) const;
};

// What the kinetic tracer has to know of a mesh, whatever the motion: 24 bytes for each triangle.
struct KineticMesh {
    explicit KineticMesh(const TriangleMesh& terrain)
        : mesh(&terrain), across(terrain), borders(border_edges(terrain)) {}

    const TriangleMesh* mesh;
    Across across;
    std::vector<HalfEdgeId> borders;
};

// What the kinetic tracer has to know of a motion piece before it follows any sample: from which side each triangle is
// seen, and where on the film the surface may end, in bins. 16 bytes for each vertex, 9 bits for
// each triangle, and some 450 bytes for each silhouette edge in the picture.
class KineticPiece {
  public:
    // For samples within `picture`. All must outlive it, but for the bounds.
    KineticPiece(const KineticMesh& mesh, const MotionPiece& piece, const FilmBounds& picture);

    [[nodiscard]] const TriangleMesh& mesh() const { return *stride_scene_.mesh; }
    [[nodiscard]] const MotionPiece& motion() const { return *motion_; }
    [[nodiscard]] const LinesOverPiece& lines() const { return lines_; }
    [[nodiscard]] const StrideScene& stride_scene() const { return stride_scene_; }
    [[nodiscard]] Facing facing(TriangleId triangle) const { return facing_[triangle]; }
    // 1 if it is seen from the front at a time, else -1.
    [[nodiscard]] double facing_sign(TriangleId triangle, double u) const;
    [[nodiscard]] Line line_at(double u, double x, double y) const {
        return {motion_->reference, motion_->origin.at(u), motion_->direction_at(u, x, y)};
    }
    // Whether stride() can follow lines of sight through the picture.
    [[nodiscard]] bool is_ahead() const { return is_ahead_; }
    [[nodiscard]] std::span<const Silhouette> silhouettes() const { return silhouettes_; }
    // When the camera passes through the surface, ascending, in the piece's u.
    [[nodiscard]] std::span<const double> surface_passages() const { return surface_passages_; }

    // Which silhouettes a line through this part of the film may pass; ascending, each once.
    [[nodiscard]] std::vector<std::uint32_t> silhouettes_near(const FilmBounds& part) const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    struct BinRange {
        std::size_t left, right, top, bottom;  // all included
    };
    [[nodiscard]] BinRange bins_of(const FilmBounds& part) const;
    [[nodiscard]] FilmBounds bounds_of(std::size_t column, std::size_t row) const;
    void find_silhouettes(const KineticMesh& mesh);
    void fill_bins();

    const MotionPiece* motion_;
    FilmBounds picture_;
    LinesOverPiece lines_;
    StrideScene stride_scene_;
    bool is_ahead_;
    std::vector<Facing> facing_;
    std::vector<double> surface_passages_;
    std::vector<Silhouette> silhouettes_;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::vector<std::uint32_t>> bins_;  // row by row, silhouettes ascending
};

}  // namespace overfly
