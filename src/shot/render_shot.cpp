#include "shot/render_shot.h"

#include <algorithm>
#include <chrono>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "io/frame_file.h"
#include "io/temporary_file.h"
#include "shot/expose_piece.h"
#include "shot/flight_notes.h"
#include "shot/frame_developer.h"
#include "shot/frame_headers.h"
#include "shot/frames_on_disk.h"
#include "shot/input_files.h"
#include "shot/manifest_description.h"
#include "shot/previews.h"
#include "shot/scene_light.h"
#include "shot/sequence_manifest.h"
#include "shot/shot_facts.h"
#include "shot/shot_inputs.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"
#include "shot/shot_tracers.h"
#include "shot/stage.h"

namespace overfly {
namespace {

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw UserError({folder}, fmt::format("output.folder: can't be made: {}", error.message()));
}

struct Rendering {
    const ShotDocument& shot;
    const RenderOptions& options;
    RenderResult result{};

    void say(const std::string& text) const {
        if (options.say) options.say(text);
    }
};

// Frames in the order of time, rendered piece by piece of the flight; each is written as soon as its shutter has
// closed.
class FrameLoop {
  public:
    FrameLoop(Rendering& rendering, const Motion& motion, const FrameHeaders& headers, const FrameDeveloper& developer,
              SequenceManifest& manifest)
        : rendering_(&rendering), motion_(&motion), headers_(&headers), developer_(&developer), manifest_(&manifest) {}

    void run(const Exposing& exposing, std::span<const PlannedFrame> frames) {
        total_ = static_cast<double>(frames.size());
        std::size_t next = 0;  // the first frame whose shutter has not opened yet
        for (const MotionPiece& piece : motion_->pieces) {
            while (next < frames.size() && is_exposed_in(frames[next], piece)) {
                open_.push_back({frames[next], exposing.film(frames[next])});
                ++next;
            }
            if (open_.empty()) continue;
            expose(exposing, piece);
            write_closed(piece.when.end_s);
        }
        check(open_.empty() && next == frames.size(), "every frame's exposure lies within the motion");
    }

  private:
    struct OpenFrame {
        PlannedFrame frame;
        FilmFrame film;
        double render_s = 0.0;
    };

    void expose(const Exposing& exposing, const MotionPiece& piece) {
        const Stopwatch watch;
        std::vector<PlannedFrame> frames;
        std::vector<FilmFrame*> films;
        for (OpenFrame& open : open_) {
            frames.push_back(open.frame);
            films.push_back(&open.film);
        }
        const auto closing = static_cast<double>(
            std::ranges::count_if(frames, [&](const PlannedFrame& f) { return f.exposure.end_s <= piece.when.end_s; }));
        const auto progress = [&](double share) {
            if (rendering_->options.progress)
                rendering_->options.progress("rendering", done_ + share * closing, total_);
        };
        expose_piece(exposing, piece, frames, films, rendering_->result.counters, progress);
        rendering_->result.trace_s += watch.seconds();
        share_out(watch.seconds(), piece.when);
    }

    // What a piece took, among the frames that were exposed in it, by how long they were; equally for instants.
    void share_out(double seconds, TimeRange piece) {
        const auto exposed_s = [&](const OpenFrame& open) {
            const TimeRange& e = open.frame.exposure;
            return std::max(0.0, std::min(e.end_s, piece.end_s) - std::max(e.begin_s, piece.begin_s));
        };
        double all_s = 0.0;
        for (const OpenFrame& open : open_) all_s += exposed_s(open);
        for (OpenFrame& open : open_) {
            const double share = all_s > 0.0 ? exposed_s(open) / all_s : 1.0 / static_cast<double>(open_.size());
            open.render_s += share * seconds;
        }
    }

    void write_closed(double until_s) {
        const Stopwatch watch;
        const auto still_open = std::stable_partition(
            open_.begin(), open_.end(), [&](const OpenFrame& open) { return open.frame.exposure.end_s <= until_s; });
        std::vector<OpenFrame> closed(std::make_move_iterator(open_.begin()), std::make_move_iterator(still_open));
        open_.erase(open_.begin(), still_open);
        std::vector<ManifestFrame> listed(closed.size());
        parallel_for(closed.size(), [&](std::size_t i) {
            const FrameHeader header = headers_->of(closed[i].frame);
            const FrameDigest digest = write_digested_frame(
                closed[i].frame.file, developer_->develop(std::move(closed[i].film), header.camera.tan_half_fov),
                header, rendering_->shot.output.storage);
            listed[i] = manifest_frame(closed[i].frame, digest, closed[i].render_s);
        });
        for (ManifestFrame& frame : listed) manifest_->add(std::move(frame));
        manifest_->save();
        done_ += static_cast<double>(closed.size());
        rendering_->result.frames_rendered += static_cast<int>(closed.size());
        rendering_->result.write_s += watch.seconds();
    }

    Rendering* rendering_;
    const Motion* motion_;
    const FrameHeaders* headers_;
    const FrameDeveloper* developer_;
    SequenceManifest* manifest_;
    std::vector<OpenFrame> open_;
    double done_ = 0.0, total_ = 0.0;
};

std::vector<PlannedFrame> frames_to_render(Rendering& rendering, const std::vector<PlannedFrame>& wanted,
                                           const std::string& inputs, SequenceManifest& manifest) {
    const RenderOptions& options = rendering.options;
    if (manifest.was_broken()) rendering.say("the manifest can't be read and is made anew from the frames");
    FramesOnDisk found = look_at_frames(wanted, {rendering.shot, inputs, options.repair, options.progress}, manifest);
    rendering.result.frames_kept = found.kept;
    for (const std::string& news : found.news) rendering.say(news);
    return std::move(found.to_render);
}

// Everything that a shot is rendered from, ready.
struct Scenery {
    Stage& stage;
    const CameraPath& path;
    const std::vector<PlannedFrame>& planned;  // all of the shot
    const ShotBodies& bodies;
    const Daylight& daylight;
    const Sight& sight;
    const ShotObjects& objects;
};

void report_mesh(Rendering& rendering, const FlightMeshReport& mesh) {
    rendering.result.mesh = mesh;
    if (mesh.triangles == mesh.triangles_before) return;
    rendering.say(fmt::format("mesh for the flight: {} of {} triangles, at most {:.2g} pixels off", mesh.triangles,
                              mesh.triangles_before, mesh.largest_error_px));
}

void render_frames(Rendering& rendering, const Scenery& scenery, const std::vector<PlannedFrame>& frames,
                   const FrameHeaders& headers, SequenceManifest& manifest) {
    const ShotDocument& shot = rendering.shot;
    const Stopwatch watch;
    const SceneLight light(shot, scenery.stage, scenery.daylight, scenery.objects, rendering.options.progress);
    ShotFacts facts(shot, scenery.stage, scenery.path, scenery.planned, scenery.bodies, scenery.objects);
    facts.set_ground(light.facts());
    rendering.result.light_s = watch.seconds();
    scenery.stage.drop_full_mesh();
    SceneShader shader = light.shader(scenery.bodies);
    if (!shot.layers.empty()) shader.set_facts(&facts.sources());
    const FrameDeveloper developer(shot, scenery.stage, scenery.daylight, scenery.objects.names());
    const ShotTracers tracers(shot, scenery.stage, scenery.bodies, scenery.sight, rendering.options.check_every);
    const Exposing exposing = {tracers.pair(),
                               shader,
                               {shot.image.width, shot.image.height},
                               rendering.options.should_stop,
                               scenery.planned,
                               {},
                               shot.shutter.curve,
                               tracers.filter()};
    manifest.save();  // without the frames that are about to be replaced
    FrameLoop(rendering, scenery.sight.motions.front(), headers, developer, manifest).run(exposing, frames);
}

std::vector<PlannedFrame> chosen(const std::vector<PlannedFrame>& frames, const std::string& choice) {
    if (choice.empty()) return frames;
    std::vector<PlannedFrame> out;
    for (const int number : parse_frame_range(choice, {frames.front().number, frames.back().number})) {
        out.push_back(frames[static_cast<std::size_t>(number - frames.front().number)]);
    }
    return out;
}

// Every long job reports its progress, so the user's wish to stop is looked at there as well.
RenderOptions stoppable(RenderOptions options) {
    if (!options.should_stop) return options;
    options.progress = [should_stop = options.should_stop, progress = options.progress](std::string_view what,
                                                                                        double done, double total) {
        if (should_stop()) throw Interrupted();
        if (progress) progress(what, done, total);
    };
    return options;
}

}  // namespace

RenderResult render_shot(const ShotDocument& shot, const RenderOptions& asked) {
    const Stopwatch watch;
    const RenderOptions options = stoppable(asked);
    Rendering rendering{shot, options};
    RenderResult& result = rendering.result;
    const PreviewLook preview_look = preview_look_of(shot);
    if (makes_previews(shot)) rendering.say("preview: " + preview_look.view.story());
    Stage stage(prepare_terrain(shot.terrain, options.cache_folder, options.progress), middle_of(shot.flight));
    result.prepare_s = watch.seconds();
    const CameraPath path = make_path(shot.flight, stage);
    const std::vector<PlannedFrame> frames = plan_frames(shot, path.times());
    const std::vector<PlannedFrame> wanted = chosen(frames, options.frames);
    result.frames_in_shot = static_cast<int>(frames.size());
    result.frames_wanted = static_cast<int>(wanted.size());
    result.folder = shot.output.folder;
    for (const std::string& note : flight_notes(wanted, path, stage.surroundings())) rendering.say(note);
    const std::string inputs = shot_inputs_hash(shot, stage.terrain().scene.content_hash);
    SequenceManifest manifest(shot.output.folder, shot.output.name, inputs);
    const std::vector<PlannedFrame> missing = frames_to_render(rendering, wanted, inputs, manifest);
    // Before the folder is made, so that a body that is refused leaves nothing behind.
    const ShotBodies bodies = missing.empty() ? ShotBodies{} : make_bodies(shot, stage);
    for (const std::string& note : mesh_notes(bodies)) rendering.say(note);
    make_folder(shot.output.folder);
    remove_abandoned_files(shot.output.folder);
    std::vector<InputFile> files;
    if (!missing.empty() || manifest.is_changed()) files = input_files(shot, stage.terrain().inputs);
    ManifestSubjects subjects = {shot, stage.terrain(), frames, files, options.command, {}, {}};
    if (!missing.empty()) {
        report_mesh(rendering, fit_mesh_to_flight(stage, shot, path, options.cache_folder, options.progress));
        const Daylight daylight(shot.look.look);
        const Sight sight =
            make_sight(shot, path, shot_motion(shot, path, frames, stage), {stage, bodies, daylight.to_sun()});
        result.motion_pieces = sight.motions.front().pieces.size();
        result.motion_error_px = largest_error_px(sight);
        subjects.mesh_error_px = result.mesh.largest_error_px;
        subjects.motion_error_px = result.motion_error_px;
        manifest.describe(describe_sequence(subjects));
        const ShotObjects objects(shot, stage, options.progress);
        const FrameHeaders headers(shot, stage, path, inputs, files, objects.names());
        render_frames(rendering, {stage, path, frames, bodies, daylight, sight, objects}, missing, headers, manifest);
    } else if (manifest.is_changed()) {
        manifest.describe(describe_sequence(subjects));
        manifest.save();
    }
    const Stopwatch preview_watch;
    result.previews = make_previews(shot, preview_look, frames, inputs, result.frames_rendered > 0, options.progress);
    result.preview_s = preview_watch.seconds();
    result.total_s = watch.seconds();
    return result;
}

}  // namespace overfly
