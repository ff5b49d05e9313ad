#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/error.h"
#include "flight/image_error.h"
#include "flight/motion.h"

namespace overfly {
namespace {

// Times inside a piece at which it is fitted and measured: Chebyshev's, denser towards the ends.
constexpr int kTimes = 24;

// A piece passes if the error found is below this part of the bound. Between 24 times and 25 film points the error of a
// quadratic rises by a few percent; the rest is for ground nearer between two times than at either.
constexpr double kSafety = 0.7;

// No piece is halved below this. A camera that flies straight over its target turns by 180 degrees at once, and no
// quadratic follows: that flip lasts this long.
constexpr double kShortestPiece_s = 1e-5;

// Nothing nearer than this is aimed for: a camera that touches the ground has points at distance 0.
constexpr double kNearest_m = 0.01;

double inner_u(int k) { return 0.5 - 0.5 * std::cos(std::numbers::pi * (k + 0.5) / kTimes); }

// The welcome time that is nearest.
double nearest_gap_s(double time_s, const MotionOptions::Gaps& gaps) {
    return gaps.about_s + gaps.period_s * std::round((time_s - gaps.about_s) / gaps.period_s);
}

// Where a stretch is cut in two.
double middle_s(TimeRange stretch, const MotionOptions::Gaps& gaps) {
    if (gaps.period_s <= 0.0) return stretch.centre_s();
    const double gap_s = nearest_gap_s(stretch.centre_s(), gaps);
    const double margin_s = 0.01 * stretch.duration_s();
    return gap_s > stretch.begin_s + margin_s && gap_s < stretch.end_s - margin_s ? gap_s : stretch.centre_s();
}

struct Cut {
    double time_s = 0.0;
    RayFrame camera;
    Vector<Scene> to_sun;
};

class Fitter {
  public:
    Fitter(const View& view, const MotionOptions& options) : view_(view), options_(options) {
        motion_.bound_px = options.bound_px;
    }

    // Adds pieces from one cut to another, which share the cameras at their joints to the last bit.
    void fit(const Cut& from, const Cut& to) {
        const Attempt attempt = attempt_piece(from, to);
        const double span_s = to.time_s - from.time_s;
        if (!(attempt.error_px <= kSafety * options_.bound_px) && span_s > 2.0 * kShortestPiece_s) {
            const Cut middle = cut_at(middle_s({from.time_s, to.time_s}, options_.gaps));
            fit(from, middle);
            fit(middle, to);
            return;
        }
        motion_.pieces.push_back(attempt.piece);
        motion_.largest_error_px = std::max(motion_.largest_error_px, attempt.error_px);
    }

    Cut cut_at(double time_s) const {
        return {time_s, view_.rays_at(time_s), view_.to_sun_at ? view_.to_sun_at(time_s) : Vector<Scene>{}};
    }
    Motion take() { return std::move(motion_); }

  private:
    struct Attempt {
        MotionPiece piece;
        double error_px = 0.0;
    };
    using Cuts = std::array<Cut, kTimes>;

    Attempt attempt_piece(const Cut& from, const Cut& to) const {
        Cuts exact;
        MotionPiece piece{{from.time_s, to.time_s}, from.camera.origin, {}, {}, {}, {}};
        for (int k = 0; k < kTimes; ++k) exact[index(k)] = cut_at(piece.time_at(inner_u(k)));
        const auto fit_one = [&](auto value_of) {
            std::array<Vector<Scene>, kTimes> inside;
            std::transform(exact.begin(), exact.end(), inside.begin(), value_of);
            return quadratic(value_of(from), value_of(to), inside);
        };
        piece.origin = fit_one([&](const Cut& cut) { return cut.camera.origin - piece.reference; });
        piece.right = fit_one([](const Cut& cut) { return cut.camera.right; });
        piece.down = fit_one([](const Cut& cut) { return cut.camera.down; });
        piece.view = fit_one([](const Cut& cut) { return cut.camera.view; });
        piece.to_sun = fit_one([](const Cut& cut) { return cut.to_sun; });
        return {piece, error_px(piece, exact)};
    }

    // Through both ends, and nearest in the middle by least squares: with w = u (1 - u), the distance of the values
    // inside from the chord is met by -c2 w. The fit is linear in the values, so where a body spins at a distance the
    // errors of origin and direction cancel at that distance.
    static QuadraticVector quadratic(Vector<Scene> from, Vector<Scene> to,
                                     const std::array<Vector<Scene>, kTimes>& inside) {
        Vector<Scene> sum;
        double squares = 0.0;
        for (int k = 0; k < kTimes; ++k) {
            const double u = inner_u(k), w = u * (1.0 - u);
            sum = sum + w * (inside[index(k)] - from - u * (to - from));
            squares += w * w;
        }
        const Vector<Scene> c2 = -(sum / squares);
        return {from, to - from - c2, c2};
    }

    double error_px(const MotionPiece& piece, const Cuts& exact) const {
        const double half_height = static_cast<double>(options_.height_px) / options_.width_px;
        double largest = 0.0;
        for (int k = 0; k < kTimes; ++k) {
            const double u = inner_u(k);
            const RayFrame fitted{piece.origin_at(u), piece.right.at(u), piece.down.at(u), piece.view.at(u)};
            const Cut& cut = exact[index(k)];
            Reach reach = view_.reach_at(cut.time_s, cut.camera.origin);
            reach.nearest_m = std::max(kNearest_m, reach.nearest_m);
            reach.farthest_m = std::max(reach.nearest_m, reach.farthest_m);
            const double sun_error = length(piece.to_sun.at(u) - cut.to_sun) / length(cut.camera.right);
            const double error = std::max(sun_error, image_error(cut.camera, fitted, half_height, reach));
            // Not a number where the fitted camera has collapsed.
            largest = error >= 0.0 ? std::max(largest, error) : std::numeric_limits<double>::infinity();
        }
        return largest * 0.5 * options_.width_px;
    }

    static std::size_t index(int k) { return static_cast<std::size_t>(k); }

    const View& view_;
    const MotionOptions& options_;
    Motion motion_;
};

// Where the path changes from one polynomial to another, and between those evenly, or nearly where gaps are welcome, so
// that no piece is a sliver.
std::vector<double> even_cuts_s(const CameraPath& path, TimeRange when, const MotionOptions& options) {
    std::vector<double> wanted_s(path.joints_s().begin(), path.joints_s().end());
    wanted_s.insert(wanted_s.end(), options.cuts_s.begin(), options.cuts_s.end());
    std::ranges::sort(wanted_s);
    std::vector<double> stops_s{when.begin_s};
    for (const double joint_s : wanted_s)
        if (joint_s > stops_s.back() + kShortestPiece_s && joint_s < when.end_s - kShortestPiece_s)
            stops_s.push_back(joint_s);
    stops_s.push_back(when.end_s);

    std::vector<double> result{when.begin_s};
    for (std::size_t i = 0; i + 1 < stops_s.size(); ++i) {
        const double span_s = stops_s[i + 1] - stops_s[i];
        // A whole number of longest pieces is that many, whatever rounding says.
        const int count = std::max(1, static_cast<int>(std::ceil(span_s / options.longest_piece_s - 1e-6)));
        for (int k = 1; k < count; ++k) {
            const double half_s = 0.5 * span_s / count;
            const double even_s = stops_s[i] + span_s * k / count;
            result.push_back(middle_s({even_s - half_s, even_s + half_s}, options.gaps));
        }
        result.push_back(stops_s[i + 1]);
    }
    return result;
}

}  // namespace

Motion fit_motion(const View& view, std::span<const double> cuts_s, const MotionOptions& options) {
    check(cuts_s.size() >= 2 && std::ranges::is_sorted(cuts_s), "a motion is fitted between cuts in order");
    check(options.bound_px > 0.0, "a motion's bound is positive");
    check(options.width_px > 0 && options.height_px > 0, "a motion's picture has pixels");
    Fitter fitter(view, options);
    Cut from = fitter.cut_at(cuts_s.front());
    for (const double cut_s : cuts_s.subspan(1)) {
        const Cut to = fitter.cut_at(cut_s);
        fitter.fit(from, to);
        from = to;
    }
    return fitter.take();
}

Motion fit_motion(const CameraPath& path, TimeRange when, const Surroundings& surroundings,
                  const MotionOptions& options) {
    check(when.duration_s() > 0.0 && options.longest_piece_s > 0.0,
          "a motion and its longest piece last for some time");
    const View view = {[&](double time_s) { return ray_frame(path.pose_at(time_s)); },
                       [&](double, Point<Scene> origin) { return Reach{surroundings.distance_to_ground_m(origin)}; },
                       {}};
    return fit_motion(view, even_cuts_s(path, when, options), options);
}

}  // namespace overfly
