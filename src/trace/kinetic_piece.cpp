#include "trace/kinetic_piece.h"
#include "trace/silhouette_facing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace overfly {
namespace {

// Bins across the width of the film, and no more than this down: 30 pixels each in a picture of 1920, about as far as
// an edge moves in a few frames.
constexpr std::size_t kColumns = 64;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The range of a * from to a * to.
std::pair<double, double> product_range(double a, double from, double to) {
    return a < 0.0 ? std::pair(a * to, a * from) : std::pair(a * from, a * to);
}

// Where an edge appears while the piece lasts: nothing if it is behind the camera all through, everywhere if it may
// reach through the camera's plane.
std::optional<FilmBounds> edge_on_film(const FilmCurves& curves, Vector<Scene> a, Vector<Scene> b) {
    using Depth = FilmCurves::Place::Depth;
    const FilmCurves::Place pa = curves.place(a);
    const FilmCurves::Place pb = curves.place(b);
    if (pa.depth == Depth::Behind && pb.depth == Depth::Behind) return std::nullopt;
    if (pa.depth != Depth::Before || pb.depth != Depth::Before)
        return FilmBounds{-kInfinity, kInfinity, -kInfinity, kInfinity};
    return FilmBounds{std::min(pa.film.low_x, pb.film.low_x), std::max(pa.film.high_x, pb.film.high_x),
                      std::min(pa.film.low_y, pb.film.low_y), std::max(pa.film.high_y, pb.film.high_y)};
}

// Lines across the ends of the edge from a to b: along n, which is square to the edge and to the view. Towards a point
// p the side of the line through a along n is -[(a - o) x n].(p - o), which for p = a + r (b - a) is r times
// g = -n.[(b - a) x (a - o)], and that of the line through b is (r - 1) g.
void set_ends(const LinesOverPiece& lines, const MotionPiece& piece, Vector<Scene> a, Vector<Scene> b,
              Silhouette& silhouette) {
    const Vector<Scene> n = cross(b - a, piece.view.at(0.5));
    double least = kInfinity;
    double most = -kInfinity;
    for (const Vector<Scene>& o : coefficients(piece.origin)) {
        const double g = -dot(n, cross(b - a, a - o));
        least = std::min(least, g);
        most = std::max(most, g);
    }
    silhouette.has_ends = least > 0.0 || most < 0.0;
    if (!silhouette.has_ends) return;
    const double sign = least > 0.0 ? 1.0 : -1.0;
    silhouette.begin = {lines, EdgeFunction{cross(a, n), n, sign}};
    silhouette.end = {lines, EdgeFunction{cross(b, n), n, -sign}};
}

}  // namespace

SideForm::Range SideForm::range(const FilmBounds& part) const {
    Range all = {kInfinity, -kInfinity};
    for (std::size_t j = 0; j < 5; ++j) {
        const auto [low_x, high_x] = product_range(right[j], part.low_x, part.high_x);
        const auto [low_y, high_y] = product_range(down[j], part.low_y, part.high_y);
        all = {std::min(all.least, low_x + low_y + view[j]), std::max(all.most, high_x + high_y + view[j])};
    }
    return all;
}

bool Silhouette::may_cross(const FilmBounds& part) const {
    const SideForm::Range side = across.range(part);
    if (side.least >= 0.0 || side.most <= 0.0) return false;
    return !has_ends || (begin.range(part).most >= 0.0 && end.range(part).most >= 0.0);
}

KineticPiece::KineticPiece(const KineticMesh& mesh, const MotionPiece& piece, const FilmBounds& picture)
    : motion_(&piece),
      picture_(picture),
      lines_(piece),
      stride_scene_(*mesh.mesh, mesh.across, piece),
      is_ahead_(
          stride_scene_.is_ahead(std::max(-picture.low_x, picture.high_x), std::max(-picture.low_y, picture.high_y))),
      facing_(facing_over({mesh.mesh, stride_scene_.positions, stride_scene_.origin}, piece)),
      surface_passages_(overfly::surface_passages(*mesh.mesh, facing_, piece)) {
    stride_scene_.set_front(facing_);
    find_silhouettes(mesh);
    fill_bins();
}

void KineticPiece::find_silhouettes(const KineticMesh& mesh) {
    const FilmCurves curves(*motion_);
    for (const HalfEdgeId h : silhouette_edges(*mesh.mesh, mesh.borders, facing_)) {
        const auto& corner = mesh.mesh->triangles[h / 4];
        const VertexId from = corner[h % 4];
        const VertexId to = corner[(h % 4 + 1) % 3];
        const Vector<Scene> a = mesh.mesh->positions[from] - motion_->reference;
        const Vector<Scene> b = mesh.mesh->positions[to] - motion_->reference;
        const std::optional<FilmBounds> film = edge_on_film(curves, a, b);
        if (!film || !film->overlaps(picture_)) continue;
        const EdgeFunction edge = edge_function(from, to, a, b);
        silhouettes_.push_back({h, {lines_, edge}, {}, {}, false, *film});
        set_ends(lines_, *motion_, a, b, silhouettes_.back());
    }
}

void KineticPiece::fill_bins() {
    const double width = picture_.high_x - picture_.low_x;
    const double height = picture_.high_y - picture_.low_y;
    columns_ = width > 0.0 ? kColumns : 1;
    rows_ = width > 0.0
                ? static_cast<std::size_t>(std::clamp(std::ceil(kColumns * height / width), 1.0, 1.0 * kColumns))
                : 1;
    bins_.resize(columns_ * rows_);
    for (std::uint32_t s = 0; s < silhouettes_.size(); ++s) {
        const BinRange range = bins_of(silhouettes_[s].film);
        const bool is_everywhere = std::isinf(silhouettes_[s].film.low_x);
        for (std::size_t row = range.top; row <= range.bottom; ++row) {
            for (std::size_t column = range.left; column <= range.right; ++column) {
                if (!is_everywhere || silhouettes_[s].may_cross(bounds_of(column, row)))
                    bins_[row * columns_ + column].push_back(s);
            }
        }
    }
}

KineticPiece::BinRange KineticPiece::bins_of(const FilmBounds& part) const {
    const auto bin = [](double at, double low, double high, std::size_t count) {
        const auto last = static_cast<double>(count - 1);
        if (!(high > low)) return std::size_t{0};
        return static_cast<std::size_t>(
            std::clamp(std::floor((at - low) / (high - low) * static_cast<double>(count)), 0.0, last));
    };
    return {bin(part.low_x, picture_.low_x, picture_.high_x, columns_),
            bin(part.high_x, picture_.low_x, picture_.high_x, columns_),
            bin(part.low_y, picture_.low_y, picture_.high_y, rows_),
            bin(part.high_y, picture_.low_y, picture_.high_y, rows_)};
}

FilmBounds KineticPiece::bounds_of(std::size_t column, std::size_t row) const {
    const auto at = [](double low, double high, std::size_t i, std::size_t count) {
        return low + (high - low) * static_cast<double>(i) / static_cast<double>(count);
    };
    return {at(picture_.low_x, picture_.high_x, column, columns_),
            at(picture_.low_x, picture_.high_x, column + 1, columns_), at(picture_.low_y, picture_.high_y, row, rows_),
            at(picture_.low_y, picture_.high_y, row + 1, rows_)};
}

double KineticPiece::facing_sign(TriangleId triangle, double u) const {
    if (facing_[triangle] != Facing::Changes) return facing_[triangle] == Facing::Front ? 1.0 : -1.0;
    return value_at<2>(height_over_plane(mesh(), triangle, *motion_), u) < 0.0 ? -1.0 : 1.0;
}

std::vector<std::uint32_t> KineticPiece::silhouettes_near(const FilmBounds& part) const {
    std::vector<std::uint32_t> near;
    const BinRange range = bins_of(part);
    for (std::size_t row = range.top; row <= range.bottom; ++row) {
        for (std::size_t column = range.left; column <= range.right; ++column) {
            for (const std::uint32_t s : bins_[row * columns_ + column]) {
                if (silhouettes_[s].film.overlaps(part) && silhouettes_[s].may_cross(part)) near.push_back(s);
            }
        }
    }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

std::size_t KineticPiece::memory_bytes() const {
    std::size_t bytes =
        facing_.size() * sizeof(Facing) + silhouettes_.size() * sizeof(Silhouette) + stride_scene_.memory_bytes();
    for (const auto& bin : bins_) bytes += bin.size() * sizeof(bin[0]);
    return bytes;
}

}  // namespace overfly
