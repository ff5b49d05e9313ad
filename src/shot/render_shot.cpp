#include "shot/render_shot.h"

#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "io/temporary_file.h"
#include "shot/flight_notes.h"
#include "shot/frame_developer.h"
#include "shot/frame_headers.h"
#include "shot/frame_loop.h"
#include "shot/frame_writer.h"
#include "shot/frames_on_disk.h"
#include "shot/input_files.h"
#include "shot/manifest_description.h"
#include "shot/memory_plan.h"
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
    const SceneMemory memory = scene_memory(sizes_of(shot, scenery.stage, scenery.bodies));
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
    const Motion& motion = scenery.sight.motions.front();
    const MemoryPlan plan =
        plan_memory(shot, memory, {exposing.film_bytes(), thread_limit(), most_films(motion, frames)});
    rendering.say(plan.text());
    manifest.save();  // without the frames that are about to be replaced
    const auto finish = [&](const PlannedFrame& frame, FilmFrame film) {
        const FrameHeader header = headers.of(frame);
        return FinishedFrame{developer.develop(std::move(film), header.camera.tan_half_fov), header};
    };
    FrameWriter writer(finish, shot.output.storage, manifest);
    const TracedFrames traced = run_frames({exposing, motion, frames, writer, plan.frames, rendering.options.progress});
    rendering.result.counters = traced.counters;
    rendering.result.trace_s = traced.seconds;
    rendering.result.write_s = writer.seconds();
    rendering.result.frames_rendered = writer.frames_written();
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
    // Before the folder is made, so that what is refused leaves nothing behind.
    const ShotBodies bodies = missing.empty() ? ShotBodies{} : make_bodies(shot, stage);
    for (const std::string& note : mesh_notes(bodies)) rendering.say(note);
    if (!missing.empty()) require_memory(shot, stage, bodies);
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
