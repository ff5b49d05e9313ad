#include "trace/kinetic_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/parallel.h"
#include "flight/film_drift.h"
#include "trace/silhouette_facing.h"
#include "trace/silhouette_filter.h"

namespace overfly {
namespace {

// Bins across the width of the film, and no more than this down: 30 pixels each in a picture of 1920, about as far as
// an edge moves in a few frames.
constexpr std::size_t kColumns = 64;

// So few bins are filled without asking whether the edge comes through them.
constexpr std::size_t kBinsUnasked = 4;

// Edges that are prepared in one go by one thread.
constexpr std::size_t kEdgesTogether = 512;

constexpr double kDoubt_u = static_cast<double>(kGuessDoubt);

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
float rounded_down(double v) { return std::nextafter(static_cast<float>(v), -kFloatInfinity); }
float rounded_up(double v) { return std::nextafter(static_cast<float>(v), kFloatInfinity); }

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
    const std::vector<HalfEdgeId> edges = silhouette_edges(*mesh.mesh, mesh.borders, facing_);
    std::vector<std::vector<Silhouette>> parts((edges.size() + kEdgesTogether - 1) / kEdgesTogether);
    parallel_for(parts.size(), [&](std::size_t i) {
        const std::size_t first = i * kEdgesTogether;
        for (const HalfEdgeId h : std::span(edges).subspan(first, std::min(kEdgesTogether, edges.size() - first)))
            add_silhouette(h, curves, parts[i]);
    });
    for (const std::vector<Silhouette>& part : parts) silhouettes_.insert(silhouettes_.end(), part.begin(), part.end());
}

std::array<Vector<Scene>, 2> KineticPiece::ends_of(HalfEdgeId half_edge) const {
    const auto& corner = mesh().triangles[half_edge / 4];
    const auto place = [&](std::uint32_t k) { return mesh().positions[corner[k]] - motion_->reference; };
    return {place(half_edge % 4), place((half_edge % 4 + 1) % 3)};
}

void KineticPiece::add_silhouette(HalfEdgeId half_edge, const FilmCurves& curves, std::vector<Silhouette>& out) const {
    const auto& corner = mesh().triangles[half_edge / 4];
    const VertexId from = corner[half_edge % 4];
    const VertexId to = corner[(half_edge % 4 + 1) % 3];
    const auto [a, b] = ends_of(half_edge);
    const std::optional<FilmBounds> film = edge_on_film(curves, a, b);
    if (!film || !film->overlaps(picture_)) return;
    Silhouette& s = out.emplace_back();
    s.half_edge = half_edge;
    s.across = {lines_, edge_function(from, to, a, b)};
    s.film = *film;
    set_ends(lines_, *motion_, a, b, s);
    s.rough_across = FloatForm(s.across);
    s.rough_begin = FloatForm(s.begin);
    s.rough_end = FloatForm(s.end);
}

void KineticPiece::fill_bins() {
    const double width = picture_.high_x - picture_.low_x;
    const double height = picture_.high_y - picture_.low_y;
    columns_ = width > 0.0 ? kColumns : 1;
    rows_ = width > 0.0
                ? static_cast<std::size_t>(std::clamp(std::ceil(kColumns * height / width), 1.0, 1.0 * kColumns))
                : 1;
    bins_.resize(columns_ * rows_);
    for (std::uint32_t s = 0; s < silhouettes_.size(); ++s) add_to_bins(s, bins_of(silhouettes_[s].film));
}

// By halves, so that most of the bins of a large box that the edge does not come through are left out together.
void KineticPiece::add_to_bins(std::uint32_t silhouette, const BinRange& range) {
    const Silhouette& s = silhouettes_[silhouette];
    const std::size_t columns = range.right - range.left + 1;
    const std::size_t rows = range.bottom - range.top + 1;
    const FilmBounds first = bounds_of(range.left, range.top);
    const FilmBounds last = bounds_of(range.right, range.bottom);
    const bool is_large = columns * rows > kBinsUnasked;
    if (is_large && !s.may_cross({first.low_x, last.high_x, first.low_y, last.high_y})) return;
    if (is_large) {
        BinRange one = range;
        BinRange other = range;
        if (columns >= rows) {
            one.right = range.left + columns / 2 - 1;
            other.left = one.right + 1;
        } else {
            one.bottom = range.top + rows / 2 - 1;
            other.top = one.bottom + 1;
        }
        add_to_bins(silhouette, one);
        return add_to_bins(silhouette, other);
    }
    const Binned binned = {rounded_down(s.film.low_x), rounded_up(s.film.high_x), rounded_down(s.film.low_y),
                           rounded_up(s.film.high_y), silhouette};
    for (std::size_t row = range.top; row <= range.bottom; ++row) {
        for (std::size_t column = range.left; column <= range.right; ++column)
            bins_[row * columns_ + column].push_back(binned);
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

bool KineticPiece::hides(TriangleId triangle, const Silhouette& silhouette, double u) const {
    const Vector<Scene> right = motion_->right.at(u);
    const Vector<Scene> down = motion_->down.at(u);
    const Vector<Scene> view = motion_->view.at(u);
    Vector<Scene> ahead = cross(right, down);
    if (dot(ahead, view) < 0.0) ahead = -ahead;
    const Point<Scene> eye = motion_->origin_at(u);
    // In the time by which a guess of a passage is off the camera moves and turns a little.
    const auto longest = [](const QuadraticVector& q) { return length(q.c1) + 2.0 * length(q.c2); };
    const double turned = longest(motion_->right) / length(right) + longest(motion_->down) / length(down);
    const double moved = longest(motion_->origin);
    const double scale = kDoubt_u * length(ahead);
    struct Depth {
        double value, doubt;
    };
    const auto depth = [&](VertexId v) {
        const Vector<Scene> to = mesh().positions[v] - eye;
        const double reach = std::abs(to.x) + std::abs(to.y) + std::abs(to.z);
        return Depth{dot(ahead, to), scale * (moved + turned * reach)};
    };
    double furthest = -kInfinity;
    for (const VertexId v : mesh().triangles[triangle]) furthest = std::max(furthest, depth(v).value + depth(v).doubt);
    const auto& owner = mesh().triangles[silhouette.half_edge / 4];
    const std::uint32_t side = silhouette.half_edge % 4;
    const Depth a = depth(owner[side]);
    const Depth b = depth(owner[(side + 1) % 3]);
    if (std::max(a.value + a.doubt, b.value + b.doubt) < 0.0) return true;
    return furthest > 0.0 && std::min(a.value - a.doubt, b.value - b.doubt) > furthest;
}

// Those of the bins may come through the part at any time of the piece, which is often many exposures long.
std::vector<KineticPiece::Near> KineticPiece::silhouettes_near(const FilmBounds& part, double from_u,
                                                               double to_u) const {
    const std::vector<std::uint32_t> binned = binned_near(part);
    if (binned.empty()) return {};
    const FilmCurves curves(part_of(*motion_, {motion_->time_at(from_u), motion_->time_at(to_u)}));
    constexpr auto kRounding = static_cast<double>(kFilmRounding);
    const FilmBounds wider = {part.low_x - kRounding, part.high_x + kRounding, part.low_y - kRounding,
                              part.high_y + kRounding};
    std::vector<Near> near;
    for (const std::uint32_t s : binned) {
        const auto [a, b] = ends_of(silhouettes_[s].half_edge);
        const std::optional<FilmBounds> film = edge_on_film(curves, a, b);
        if (film && film->overlaps(wider)) near.push_back({s, *film});
    }
    return near;
}

std::vector<std::uint32_t> KineticPiece::binned_near(const FilmBounds& part) const {
    std::vector<std::uint32_t> near;
    const BinRange range = bins_of(part);
    const float low_x = rounded_down(part.low_x);
    const float high_x = rounded_up(part.high_x);
    const float low_y = rounded_down(part.low_y);
    const float high_y = rounded_up(part.high_y);
    for (std::size_t row = range.top; row <= range.bottom; ++row) {
        for (std::size_t column = range.left; column <= range.right; ++column) {
            for (const Binned& b : bins_[row * columns_ + column]) {
                const bool overlaps = b.low_x <= high_x && b.high_x >= low_x && b.low_y <= high_y && b.high_y >= low_y;
                if (overlaps && silhouettes_[b.silhouette].may_cross(part)) near.push_back(b.silhouette);
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
