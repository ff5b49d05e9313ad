#include "app/render_json.h"

#include <nlohmann/json.hpp>

namespace overfly {

nlohmann::ordered_json counters_json(const TraceCounters& counters) {
    const double rays = counters.rays > 0 ? static_cast<double>(counters.rays) : 1.0;
    return {{"rays", counters.rays},
            {"box_tests_per_ray", static_cast<double>(counters.box_tests) / rays},
            {"box_hits_per_ray", static_cast<double>(counters.box_hits) / rays},
            {"triangle_tests_per_ray", static_cast<double>(counters.triangle_tests) / rays},
            {"triangle_hits_per_ray", static_cast<double>(counters.triangle_hits) / rays},
            {"segments_per_ray", static_cast<double>(counters.segments) / rays},
            {"decided_in_double_share", static_cast<double>(counters.resolved) / rays},
            {"restarts", counters.restarts},
            {"crossings", counters.crossings},
            {"occlusions", counters.occlusions},
            {"disocclusions", counters.disocclusions},
            {"lost", counters.lost},
            {"checked", counters.checked},
            {"differed", counters.differed},
            {"differed_by_edge", counters.differed_by_edge}};
}

nlohmann::ordered_json render_json(const RenderResult& r) {
    return {{"folder", r.folder.string()},
            {"frames",
             {{"in_shot", r.frames_in_shot},
              {"wanted", r.frames_wanted},
              {"rendered", r.frames_rendered},
              {"kept", r.frames_kept}}},
            {"contact_sheet", r.previews.contact_sheet.string()},
            {"movie", r.previews.movie.string()},
            {"seconds",
             {{"prepare", r.prepare_s},
              {"mesh", r.mesh.seconds},
              {"light", r.light_s},
              {"trace_and_shade", r.trace_s},
              {"write", r.write_s},
              {"preview", r.preview_s},
              {"total", r.total_s}}},
            {"mesh",
             {{"triangles_before", r.mesh.triangles_before},
              {"triangles", r.mesh.triangles},
              {"largest_error_px", r.mesh.largest_error_px},
              {"from_cache", r.mesh.from_cache}}},
            {"motion", {{"pieces", r.motion_pieces}, {"largest_error_px", r.motion_error_px}}},
            {"tracer", counters_json(r.counters)}};
}

}  // namespace overfly
