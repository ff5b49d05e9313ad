// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/ground_runs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shade/ground_ray-inl.h"
#include "shade/ground_runs.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace ground_runs {

using namespace ground_ray;  // NOLINT(google-build-using-namespace): of the same vector unit

using Floats = hn::Rebind<float, Doubles>;

HWY_INLINE void store(V v, GroundRuns::Lane<float>& lane, std::size_t i) {
    hn::Store(hn::DemoteTo(Floats(), v), Floats(), lane.data() + i);
}

// Through three values, at v = 0, 1/2 and 1.
HWY_INLINE void store(V begin, V middle, V end, GroundRuns::Quadratic& q, std::size_t i) {
    const V twice_rise = hn::Sub(hn::Mul(set(4.0), middle), hn::Mul(set(3.0), begin));
    store(begin, q.c[0], i);
    store(hn::Sub(twice_rise, end), q.c[1], i);
    store(hn::Add(hn::Sub(hn::Mul(set(2.0), begin), hn::Mul(set(4.0), middle)), hn::Mul(set(2.0), end)), q.c[2], i);
}

// As many runs as a vector holds.
class Some {
  public:
    HWY_INLINE Some(const MotionPiece& scene, GroundRuns& runs, std::size_t first)
        : runs_(runs),
          i_(first),
          rays_(scene, load(runs.x, first), load(runs.y, first)),
          triangles_(runs.triangles, first),
          column1_(from_first(runs.triangles.column, 1, first)),
          column2_(from_first(runs.triangles.column, 2, first)),
          row1_(from_first(runs.triangles.row, 1, first)),
          row2_(from_first(runs.triangles.row, 2, first)) {}

    HWY_INLINE void follow(Vector<Scene> to_sun, double lowest_m) const {
        const V begin_u = load(runs_.from_u, i_), end_u = load(runs_.to_u, i_);
        const V middle_u = hn::Mul(set(0.5), hn::Add(begin_u, end_u));
        const V3 begin_direction = rays_.direction(begin_u), end_direction = rays_.direction(end_u);
        const Place middle = place(triangles_.meet(rays_, middle_u, rays_.direction(middle_u)));
        // The numbers that are quotients are told to any scale; this one keeps them near to 1.
        const V scale = hn::Div(set(1.0), middle.over);
        const Place begin = place(triangles_.meet(rays_, begin_u, begin_direction));
        const Place end = place(triangles_.meet(rays_, end_u, end_direction));
        const auto quadratic = [&](V b, V m, V e, GroundRuns::Quadratic& q) {
            store(hn::Mul(scale, b), hn::Mul(scale, m), hn::Mul(scale, e), q, i_);
        };
        quadratic(begin.column, middle.column, end.column, runs_.columns);
        quadratic(begin.row, middle.row, end.row, runs_.rows);
        quadratic(begin.depth, middle.depth, end.depth, runs_.depths);
        quadratic(begin.over, middle.over, end.over, runs_.over);
        store(hn::Add(cells(begin, middle), cells(middle, end)), runs_.cells, i_);
        store_triangle();
        store_rays(begin_direction, end_direction, to_sun);
        store_height(middle_u, lowest_m);
    }

  private:
    struct Place {
        V column, row, depth, over;  // the former times the latter
    };
    HWY_INLINE Place place(const Triangles::Meeting& m) const {
        return {hn::Add(hn::Mul(m.share1, column1_), hn::Mul(m.share2, column2_)),
                hn::Add(hn::Mul(m.share1, row1_), hn::Mul(m.share2, row2_)), m.depth, m.over};
    }
    static HWY_INLINE V cells(const Place& from, const Place& to) {
        const V columns = hn::Sub(hn::Div(to.column, to.over), hn::Div(from.column, from.over));
        const V rows = hn::Sub(hn::Div(to.row, to.over), hn::Div(from.row, from.over));
        return hn::Max(hn::Abs(columns), hn::Abs(rows));
    }

    HWY_INLINE void store_triangle() const {
        const V zero = hn::Zero(Doubles());
        store(hn::Min(hn::Min(column1_, column2_), zero), runs_.least_column, i_);
        store(hn::Max(hn::Max(column1_, column2_), zero), runs_.most_column, i_);
        store(hn::Min(hn::Min(row1_, row2_), zero), runs_.least_row, i_);
        store(hn::Max(hn::Max(row1_, row2_), zero), runs_.most_row, i_);
    }

    HWY_INLINE void store_rays(V3 begin, V3 end, Vector<Scene> to_sun) const {
        const V begin_length = hn::Sqrt(dot(begin, begin)), end_length = hn::Sqrt(dot(end, end));
        store(begin_length, runs_.per_depth.from, i_);
        store(hn::Sub(end_length, begin_length), runs_.per_depth.more, i_);
        const V begin_cosine = hn::Div(dot(begin, set(to_sun)), begin_length);
        const V end_cosine = hn::Div(dot(end, set(to_sun)), end_length);
        store(begin_cosine, runs_.towards_sun.from, i_);
        store(hn::Sub(end_cosine, begin_cosine), runs_.towards_sun.more, i_);
    }

    HWY_INLINE void store_height(V u, double lowest_m) const {
        store(hn::Sub(rays_.height_over_ball_m(u), set(lowest_m)), runs_.from_height_m, i_);
    }

    GroundRuns& runs_;
    std::size_t i_;
    Rays rays_;
    Triangles triangles_;
    V column1_, column2_, row1_, row2_;
};

}  // namespace ground_runs

void follow_all(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundRuns& runs, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(ground_runs::Doubles()))
        ground_runs::Some(scene, runs, i).follow(to_sun, lowest_m);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(follow_all);

void follow_ground(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundRuns& runs,
                   std::size_t count) {
    HWY_DYNAMIC_DISPATCH(follow_all)(scene, to_sun, lowest_m, runs, count);
}
}  // namespace overfly
#endif
