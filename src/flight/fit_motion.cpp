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

// Ground nearer than this is not aimed for: a camera that touches the ground has points at distance 0.
constexpr double kNearestGround_m = 0.01;

double inner_u(int k) { return 0.5 - 0.5 * std::cos(std::numbers::pi * (k + 0.5) / kTimes); }

struct Cut {
    double time_s = 0.0;
    RayFrame camera;
};

class Fitter {
  public:
    Fitter(const CameraPath& path, const Surroundings& surroundings, const MotionOptions& options)
        : path_(path), surroundings_(surroundings), options_(options) {
        motion_.bound_px = options.bound_px;
    }

    // Adds pieces from one cut to another, which share the cameras at their joints to the last bit.
    void fit(const Cut& from, const Cut& to) {
        const Attempt attempt = attempt_piece(from, to);
        const double span_s = to.time_s - from.time_s;
        if (!(attempt.error_px <= kSafety * options_.bound_px) && span_s > 2.0 * kShortestPiece_s) {
            const Cut middle = cut_at(0.5 * (from.time_s + to.time_s));
            fit(from, middle);
            fit(middle, to);
            return;
        }
        motion_.pieces.push_back(attempt.piece);
        motion_.largest_error_px = std::max(motion_.largest_error_px, attempt.error_px);
    }

    Cut cut_at(double time_s) const { return {time_s, ray_frame(path_.pose_at(time_s))}; }
    Motion take() { return std::move(motion_); }

  private:
    struct Attempt {
        MotionPiece piece;
        double error_px = 0.0;
    };

    Attempt attempt_piece(const Cut& from, const Cut& to) const {
        std::array<RayFrame, kTimes> exact;
        MotionPiece piece{{from.time_s, to.time_s}, from.camera.origin, {}, {}, {}, {}};
        for (int k = 0; k < kTimes; ++k) exact[index(k)] = ray_frame(path_.pose_at(piece.time_at(inner_u(k))));
        const auto fit_one = [&](auto value_of) {
            std::array<Vector<Scene>, kTimes> inside;
            std::transform(exact.begin(), exact.end(), inside.begin(), value_of);
            return quadratic(value_of(from.camera), value_of(to.camera), inside);
        };
        piece.origin = fit_one([&](const RayFrame& camera) { return camera.origin - piece.reference; });
        piece.right = fit_one([](const RayFrame& camera) { return camera.right; });
        piece.down = fit_one([](const RayFrame& camera) { return camera.down; });
        piece.view = fit_one([](const RayFrame& camera) { return camera.view; });
        return {piece, error_px(piece, exact)};
    }

    // Through both ends, and nearest in the middle by least squares: with w = u (1 - u), the distance of the values
    // inside from the chord is met by -c2 w.
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

    double error_px(const MotionPiece& piece, const std::array<RayFrame, kTimes>& exact) const {
        const double half_height = static_cast<double>(options_.height_px) / options_.width_px;
        double largest = 0.0;
        for (int k = 0; k < kTimes; ++k) {
            const double u = inner_u(k);
            const RayFrame fitted{piece.origin_at(u), piece.right.at(u), piece.down.at(u), piece.view.at(u)};
            const RayFrame& camera = exact[index(k)];
            const double ground_m = std::max(kNearestGround_m, surroundings_.distance_to_ground_m(camera.origin));
            const double error = image_error(camera, fitted, half_height, ground_m);
            // Not a number where the fitted camera has collapsed.
            largest = error >= 0.0 ? std::max(largest, error) : std::numeric_limits<double>::infinity();
        }
        return largest * 0.5 * options_.width_px;
    }

    static std::size_t index(int k) { return static_cast<std::size_t>(k); }

    const CameraPath& path_;
    const Surroundings& surroundings_;
    const MotionOptions& options_;
    Motion motion_;
};

// Where the path changes from one polynomial to another, and between those evenly, so that no piece is a sliver.
std::vector<double> cuts_s(const CameraPath& path, TimeRange when, double longest_piece_s) {
    std::vector<double> stops_s{when.begin_s};
    for (const double joint_s : path.joints_s())
        if (joint_s > stops_s.back() + kShortestPiece_s && joint_s < when.end_s - kShortestPiece_s)
            stops_s.push_back(joint_s);
    stops_s.push_back(when.end_s);

    std::vector<double> result{when.begin_s};
    for (std::size_t i = 0; i + 1 < stops_s.size(); ++i) {
        const double span_s = stops_s[i + 1] - stops_s[i];
        // A whole number of longest pieces is that many, whatever rounding says.
        const int count = std::max(1, static_cast<int>(std::ceil(span_s / longest_piece_s - 1e-6)));
        for (int k = 1; k < count; ++k) result.push_back(stops_s[i] + span_s * k / count);
        result.push_back(stops_s[i + 1]);
    }
    return result;
}

}  // namespace

Motion fit_motion(const CameraPath& path, TimeRange when, const Surroundings& surroundings,
                  const MotionOptions& options) {
    check(when.duration_s() > 0.0, "a motion lasts for some time");
    check(options.bound_px > 0.0 && options.longest_piece_s > 0.0, "a motion's bound and longest piece are positive");
    check(options.width_px > 0 && options.height_px > 0, "a motion's picture has pixels");
    Fitter fitter(path, surroundings, options);
    const std::vector<double> cuts = cuts_s(path, when, options.longest_piece_s);
    Cut from = fitter.cut_at(cuts.front());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const Cut to = fitter.cut_at(cuts[i]);
        fitter.fit(from, to);
        from = to;
    }
    return fitter.take();
}

}  // namespace overfly
