#include "shot/pixel_timeline.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "config/frame_range.h"
#include "core/error.h"
#include "shot/flight_scene.h"
#include "shot/shot_body.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"
#include "shot/stage.h"

namespace overfly {
namespace {

// As many as a page has room for.
constexpr std::size_t kMostCurves = 6;

// Nobody asks for shadows here.
constexpr Vector<Scene> kAnySun = {0.0, 0.0, 1.0};

// Two numbers with a separator between them and nothing else.
template <class Number>
std::optional<std::pair<Number, Number>> two_numbers(std::string_view text, char separator) {
    std::pair<Number, Number> both{};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, both.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != separator) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, both.second);
    if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
    return both;
}

struct Pixel {
    int x, y;
};

Pixel pixel_of(const std::string& text, PictureSize size) {
    const Place place{"--pixel " + text};
    const auto pixel = two_numbers<int>(text, ',');
    if (!pixel) throw UserError(place, "wanted the column and the row of a pixel, two whole numbers: 480,270");
    const auto [x, y] = *pixel;
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) {
        throw UserError(place, fmt::format("the picture has the pixels 0,0 to {},{}", size.width - 1, size.height - 1));
    }
    return {x, y};
}

TimeRange time_of(const std::string& text, TimeRange available) {
    const Place place{"--time " + text};
    const auto times = two_numbers<double>(text, '-');
    if (!times) throw UserError(place, "wanted a begin and an end in seconds of the flight: 2.4-2.6");
    const auto [begin_s, end_s] = *times;
    if (!(begin_s < end_s)) throw UserError(place, "wanted a begin before the end");
    if (!(available.begin_s <= begin_s && end_s <= available.end_s)) {
        throw UserError(place, fmt::format("the shot lasts from {:.4f} to {:.4f} s of the flight", available.begin_s,
                                           available.end_s));
    }
    return {begin_s, end_s};
}

TimeRange frames_time(const std::string& text, std::span<const PlannedFrame> frames) {
    const std::vector<int> chosen = parse_frame_range(text, {frames.front().number, frames.back().number});
    const auto frame = [&](int number) { return frames[static_cast<std::size_t>(number - frames.front().number)]; };
    const TimeRange when = {frame(chosen.front()).exposure.begin_s, frame(chosen.back()).exposure.end_s};
    if (when.duration_s() > 0.0) return when;
    throw UserError(Place{"--frames " + text},
                    "the frame's exposure is an instant, of which there is no time line; choose more frames or a time");
}

TimeRange time_asked(const PixelQuestion& question, std::span<const PlannedFrame> frames, const Motion& motion) {
    if (!question.frames.empty()) return frames_time(question.frames, frames);
    if (!question.time.empty()) return time_of(question.time, motion.times());
    return motion.piece_at(motion.times().centre_s()).when;
}

// Triangles by the time they are seen; the longest, in the order in which they are first seen.
std::vector<SurfaceTriangle> seen_longest(const Timeline& timeline) {
    struct Seen {
        SurfaceTriangle what;
        double first_s, duration_s;
    };
    std::vector<Seen> all;
    for (const SightRecord& r : timeline.seen) {
        const auto known = std::ranges::find(all, r.what, &Seen::what);
        if (known == all.end()) {
            all.push_back({r.what, r.when.begin_s, r.when.duration_s()});
        } else {
            known->duration_s += r.when.duration_s();
        }
    }
    std::ranges::stable_sort(all, std::greater<>(), &Seen::duration_s);
    if (all.size() > kMostCurves) all.resize(kMostCurves);
    std::ranges::sort(all, {}, &Seen::first_s);
    std::vector<SurfaceTriangle> triangles;
    for (const Seen& s : all) triangles.push_back(s.what);
    return triangles;
}

std::vector<SurfaceTriangle> triangles_asked(const PixelQuestion& question, const Timeline& timeline) {
    if (!question.triangle) return seen_longest(timeline);
    std::vector<SurfaceTriangle> known;
    for (const SightRecord& r : timeline.passed) {
        if (r.what.triangle == *question.triangle) known.push_back(r.what);
    }
    if (!known.empty()) return {*std::min_element(known.begin(), known.end())};
    throw UserError(Place{fmt::format("--triangle {}", *question.triangle)},
                    "the pixel's line of sight doesn't pass through it in that time");
}

std::vector<TimelineSurface> surfaces_of(const Stage& stage, const ShotBodies& bodies, const Sight& sight) {
    std::vector<TimelineSurface> surfaces = {{&stage.mesh(), &sight.motions.front()}};
    for (std::size_t k = 0; k < bodies.size(); ++k) surfaces.push_back({&bodies[k]->mesh(), &sight.motions[k + 1]});
    return surfaces;
}

}  // namespace

PixelTimeline pixel_timeline(const ShotDocument& shot, const PixelQuestion& question) {
    PixelTimeline out;
    out.shot = shot.output.name;
    out.picture = {shot.image.width, shot.image.height};
    const Pixel pixel = pixel_of(question.pixel, out.picture);
    out.x_px = pixel.x;
    out.y_px = pixel.y;
    Stage stage(prepare_terrain(shot.terrain, question.cache_folder, question.progress), middle_of(shot.flight));
    const CameraPath path = make_path(shot.flight, stage);
    const std::vector<PlannedFrame> frames = plan_frames(shot, path.times());
    const ShotBodies bodies = make_bodies(shot, stage);
    fit_mesh_to_flight(stage, shot, path, question.cache_folder, question.progress);
    const Sight sight = make_sight(shot, path, shot_motion(shot, path, frames, stage), {stage, bodies, kAnySun});
    const std::vector<TimelineSurface> surfaces = surfaces_of(stage, bodies, sight);
    out.surfaces = {"terrain"};
    for (const auto& body : bodies) out.surfaces.push_back(body->document().name);
    const TimeRange when = time_asked(question, frames, sight.motions.front());
    for (const PlannedFrame& f : frames) {
        if (intersection(f.exposure, when).duration_s() >= 0.0) out.frames.push_back(f);
    }
    if (question.progress) question.progress("following the pixel", 0.0, 0.0);
    const ImageSample centre = {out.picture.film_x(pixel.x + 0.5), out.picture.film_y(pixel.y + 0.5), 0.0};
    out.timeline = trace_timeline(surfaces, centre, when);
    for (const SurfaceTriangle& what : triangles_asked(question, out.timeline))
        out.curves.push_back(plane_curve(surfaces, out.timeline, what));
    return out;
}

}  // namespace overfly
