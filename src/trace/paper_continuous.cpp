#include "trace/paper_continuous.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "core/polynomial_roots.h"
#include "trace/paper_polygons.h"
#include "trace/paper_ray.h"
#include "trace/paper_records.h"
#include "trace/paper_stretches.h"

namespace overfly {
namespace {

// The ray as one body sees it, by the Bernstein coefficients of its polynomials in u. Of those of degree N the first
// N + 1 count.
struct Body {
    int degree = 0;
    std::array<Vector<Scene>, 3> origin;
    std::array<Vector<Scene>, 3> moment;  // origin x direction
};

std::vector<Body> bodies_of(const PaperScene& scene) {
    const Vector<Scene> eye = scene.camera.eye - Point<Scene>{};
    std::vector<Body> bodies;
    for (const PaperMotion& m : scene.bodies) {
        const Vector<Scene> last = eye - m.at(1.0);
        if (m.degree() == 2) {
            bodies.push_back({2, {eye, eye - 0.5 * m.velocity, last}, {}});
        } else {
            bodies.push_back({m.degree(), {eye, last, last}, {}});
        }
    }
    return bodies;
}

template <std::size_t N>
Bernstein<2> to_quadratic(const Bernstein<N>& b) {
    if constexpr (N == 0) return {b[0], b[0], b[0]};
    if constexpr (N == 1) return {b[0], 0.5 * (b[0] + b[1]), b[1]};
    if constexpr (N == 2) return b;
}

double farthest_coordinate_m(const PaperScene& scene, std::span<const Body> bodies) {
    double farthest = 0.0;
    const auto reach = [&](Vector<Scene> v) {
        farthest = std::max({farthest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    for (const Point<Scene>& p : scene.positions) reach(p - Point<Scene>{});
    for (const Body& body : bodies) {
        for (const Vector<Scene>& origin : body.origin) reach(origin);
    }
    return farthest;
}

// Everything about one animation that does not change from pixel to pixel, and the memory that pixels share.
class Walk {
  public:
    Walk(const PaperScene& scene, const PaperHierarchy& tree, PaperVolumes volumes) : scene_(&scene), tree_(tree) {
        if (volumes == PaperVolumes::Carried) {
            set_boxes_carried(scene, tree_);
        } else {
            set_boxes_always(scene, tree_);
        }
        polygons_at(scene, 0.0, polygons_);
        bodies_ = bodies_of(scene);
        extent_m_ = farthest_coordinate_m(scene, bodies_);
        number_carriers();
    }

    // What the pixel sees when.
    const std::vector<PaperRecord>& visible(int row, int column) {
        const PaperDirection direction(scene_->camera.direction(row, column));
        records_.clear();
        prepare_rays(direction);
        find_records(direction);
        return occlusion_.nearest(records_);
    }

    [[nodiscard]] const PaperCounters& counters() const { return counters_; }

  private:
    template <std::size_t N>
    using Sides = std::vector<Bernstein<N>>;

    // Bodies that carry boxes are few, and each costs every pixel a swept ray: nodes refer to them by their number
    // among the carriers.
    void number_carriers() {
        for (PaperNode& node : tree_) {
            if (node.body == PaperNode::kWorld) continue;
            const auto known = std::ranges::find(carriers_, node.body);
            const std::uint32_t number = static_cast<std::uint32_t>(known - carriers_.begin());
            if (known == carriers_.end()) carriers_.push_back(node.body);
            node.body = number;
        }
    }

    void prepare_rays(const PaperDirection& direction) {
        swept_.clear();
        for (const std::uint32_t carrier : carriers_) {
            const auto& [degree, origin, moment] = bodies_[carrier];
            const Vector<Scene> middle = degree == 2 ? origin[1] : 0.5 * (origin[0] + origin[2]);
            swept_.emplace_back(direction, std::array{origin[0], middle, origin[2]}, extent_m_);
        }
        for (Body& body : bodies_) {
            for (int j = 0; j <= body.degree; ++j) {
                const auto k = static_cast<std::size_t>(j);
                body.moment[k] = cross(body.origin[k], direction.d);
            }
        }
    }

    void find_records(const PaperDirection& direction) {
        const PaperStillRay still(direction, scene_->camera.eye);
        std::array<std::uint32_t, kPaperDeepest> waiting;
        std::size_t waiting_count = 0;
        for (std::uint32_t index = 0;;) {
            const PaperNode& node = tree_[index];
            ++counters_.bv_tests;
            const bool meets = node.body == PaperNode::kWorld
                                   ? still.meets(node.box, std::numeric_limits<double>::infinity())
                                   : swept_[node.body].meets(node.box);
            if (meets) {
                ++counters_.bv_hits;
                if (node.polygon == kNone) {
                    waiting[waiting_count++] = node.second;
                    ++index;
                    continue;
                }
                test_polygon(node.polygon, direction.d);
            }
            if (waiting_count == 0) return;
            index = waiting[--waiting_count];
        }
    }

    void test_polygon(std::uint32_t index, Vector<Scene> d) {
        ++counters_.poly_tests;
        switch (bodies_[scene_->polygons[index].body].degree) {
            case 0:
                return test_polygon_of<0>(index, d);
            case 1:
                return test_polygon_of<1>(index, d);
            default:
                return test_polygon_of<2>(index, d);
        }
    }

    // Of a body whose motion is a polynomial of degree N; so are then the edge functions and the depth.
    template <std::size_t N>
    void test_polygon_of(std::uint32_t index, Vector<Scene> d) {
        const PaperPolygons::Polygon& polygon = polygons_.polygons[index];
        const Body& body = bodies_[scene_->polygons[index].body];
        const double facing = dot(polygon.normal, d);
        if (facing == 0.0) return;
        Sides<N>& crossed = std::get<Sides<N>>(crossed_);
        crossed.clear();
        for (const PaperPolygons::Edge& edge : polygons_.edges_of(polygon)) {
            Bernstein<N> side;
            for (std::size_t j = 0; j <= N; ++j) side[j] = edge.at(d, body.moment[j]) * facing;
            if (is_outside_always<N>(side, crossed)) return;
        }
        Bernstein<N> depth;
        Bernstein<N> behind;
        for (std::size_t j = 0; j <= N; ++j) {
            depth[j] = (polygon.offset - dot(polygon.normal, body.origin[j])) / facing;
            behind[j] = -depth[j];
        }
        if (is_outside_always<N>(behind, crossed)) return;
        inside_.hold_always();
        for (const Bernstein<N>& side : crossed) cut_out<N>(side);
        for (const auto& stretch : inside_.get()) {
            records_.add({stretch.begin, stretch.end, to_quadratic<N>(depth), index});
        }
        if (!inside_.get().empty()) ++counters_.poly_hits;
    }

    // Outside is where a side is positive. By the coefficients, between which the polynomial lies; one that may be both
    // is added to `crossed`.
    template <std::size_t N>
    static bool is_outside_always(const Bernstein<N>& side, Sides<N>& crossed) {
        double least = side[0];
        double most = side[0];
        for (std::size_t j = 1; j <= N; ++j) least = std::min(least, side[j]);
        for (std::size_t j = 1; j <= N; ++j) most = std::max(most, side[j]);
        if (least > 0.0) return true;
        if (most <= 0.0) return false;
        crossed.push_back(side);
        return false;
    }

    // Takes the times at which a side is positive out of inside_.
    template <std::size_t N>
    void cut_out(const Bernstein<N>& side) {
        if constexpr (N > 0) {
            // The first coefficient that is not zero has the sign that the polynomial starts with.
            bool outside = *std::ranges::find_if(side, [](double b) { return b != 0.0; }) > 0.0;
            double from = 0.0;
            for (const double u : sign_change_roots<N>(side)) {
                if (outside) inside_.cut_out(from, u);
                outside = !outside;
                from = u;
            }
            if (outside) inside_.cut_out(from, 1.0);
        }
    }

    const PaperScene* scene_;
    PaperHierarchy tree_;
    std::vector<std::uint32_t> carriers_;
    PaperPolygons polygons_;  // at home
    std::vector<Body> bodies_;
    double extent_m_ = 0.0;
    PaperCounters counters_;
    // Of the pixel at hand:
    std::vector<PaperSweptRay> swept_;                  // by carrier
    std::tuple<Sides<0>, Sides<1>, Sides<2>> crossed_;  // of one polygon, those that the ray may cross
    PaperStretches inside_;
    PaperRecordList records_;
    PaperOcclusion occlusion_;
};

// Each record shades the frames whose instants it contains; the rest see nothing. `pixel` is that of the first frame.
void shade(const std::vector<PaperRecord>& visible, int frames, PaperFrames::Pixel* pixel) {
    const auto first_from = [&](double u) {
        const double place = u * (frames - 1);
        const int before = static_cast<int>(place);
        return before < place ? before + 1 : before;
    };
    int frame = 0;
    const auto shade_until = [&](int end, PaperFrames::Pixel polygon) {
        for (; frame < end; ++frame) pixel[static_cast<std::ptrdiff_t>(frame) * PaperFrames::kBlock] = polygon;
    };
    double reached = 0.0;
    for (const PaperRecord& r : visible) {
        if (r.begin > reached) shade_until(first_from(r.begin), PaperFrames::kNothing);
        shade_until(r.end < 1.0 ? first_from(r.end) : frames, static_cast<PaperFrames::Pixel>(r.polygon));
        reached = r.end;
    }
    shade_until(frames, PaperFrames::kNothing);
}

}  // namespace

PaperCounters trace_paper_continuous(const PaperScene& scene, const PaperHierarchy& tree, PaperVolumes volumes,
                                     PaperFrames& out) {
    Walk walk(scene, tree, volumes);
    for (int row = 0; row < scene.camera.rows; ++row) {
        for (int left = 0; left < scene.camera.columns; left += PaperFrames::kBlock) {
            PaperFrames::Pixel* block = out.block(0, row, left);
            const int right = std::min(left + PaperFrames::kBlock, scene.camera.columns);
            for (int column = left; column < right; ++column) {
                shade(walk.visible(row, column), scene.frames, block + (column - left));
            }
        }
    }
    return walk.counters();
}

}  // namespace overfly
