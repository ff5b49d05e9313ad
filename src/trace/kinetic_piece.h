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
#include "trace/silhouette_form.h"

namespace overfly {

// An edge that may end what is seen, as lines of sight pass it.
struct Silhouette {
    HalfEdgeId half_edge = kNone;
    SideForm across;        // of the edge, in the direction of the half-edge
    SideForm begin, end;    // of lines across its ends: both >= 0 for a line of sight that passes between them
    bool has_ends = false;  // false where the edge turns so that begin and end tell nothing
    FilmBounds film;        // where the edge appears at any time of the piece
    FloatForm rough_across, rough_begin, rough_end;

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
// each triangle, and some 650 bytes for each silhouette edge in the picture.
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
    // Whether all of a triangle is surely nearer to the camera than all of a silhouette, at about a time; or that is
    // behind the camera.
    [[nodiscard]] bool hides(TriangleId triangle, const Silhouette& silhouette, double u) const;
    // Whether stride() can follow lines of sight through the picture.
    [[nodiscard]] bool is_ahead() const { return is_ahead_; }
    [[nodiscard]] std::span<const Silhouette> silhouettes() const { return silhouettes_; }
    // When the camera passes through the surface, ascending, in the piece's u.
    [[nodiscard]] std::span<const double> surface_passages() const { return surface_passages_; }

    // A silhouette for a while, and where on the film it appears meanwhile.
    struct Near {
        std::uint32_t silhouette;
        FilmBounds film;
    };
    // Those that a line through this part of the film may pass, or come near to by kFilmRounding, between two times in
    // the piece's u; ascending, each once.
    [[nodiscard]] std::vector<Near> silhouettes_near(const FilmBounds& part, double from_u, double to_u) const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    // Relative to the motion's reference.
    [[nodiscard]] std::array<Vector<Scene>, 2> ends_of(HalfEdgeId half_edge) const;
    struct BinRange {
        std::size_t left, right, top, bottom;  // all included
    };
    [[nodiscard]] BinRange bins_of(const FilmBounds& part) const;
    [[nodiscard]] FilmBounds bounds_of(std::size_t column, std::size_t row) const;
    [[nodiscard]] std::vector<std::uint32_t> binned_near(const FilmBounds& part) const;
    void find_silhouettes(const KineticMesh& mesh);
    void add_silhouette(HalfEdgeId half_edge, const FilmCurves& curves, std::vector<Silhouette>& out) const;
    void fill_bins();
    void add_to_bins(std::uint32_t silhouette, const BinRange& range);

    const MotionPiece* motion_;
    FilmBounds picture_;
    LinesOverPiece lines_;
    StrideScene stride_scene_;
    bool is_ahead_;
    std::vector<Facing> facing_;
    std::vector<double> surface_passages_;
    std::vector<Silhouette> silhouettes_;
    std::size_t columns_ = 0, rows_ = 0;
    // What is near at hand of a silhouette, so that most need not be looked at any further.
    struct Binned {
        float low_x, high_x, low_y, high_y;  // rounded outwards
        std::uint32_t silhouette;
    };
    std::vector<std::vector<Binned>> bins_;  // row by row, silhouettes ascending
};

}  // namespace overfly
