#include "shot/many_looks.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <map>
#include <string>

#include "film/integrate.h"
#include "shot/glider_shot.h"

namespace overfly {
namespace {

using namespace testing;

// Looks at all that lines see in a piece, at an instant of the time that they see it.
std::vector<SceneShader::Look> looks_of(std::span<const ImageSample> lines, const SurfaceSegmentLists& lists,
                                        const MotionPiece& piece) {
    std::vector<SceneShader::Look> looks;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for_each_stretch(lists.of(i), piece.when, [&](const SurfaceSegment* seen, TimeRange when) {
            const SceneShader::Sighting sighting = {lines[i].x, lines[i].y, seen, lists.reflected};
            looks.push_back({sighting, when.begin_s + 0.3 * when.duration_s()});
        });
    }
    return looks;
}

using Bits = std::array<std::uint32_t, 5>;
Bits bits(const Radiance& r) { return std::bit_cast<Bits>(r); }

// What a look meets, in words.
std::string met(const GliderShot& shot, const MotionPiece& piece, const SceneShader::Look& look) {
    const auto& [x, y, seen, reflected] = look.sighting;
    if (seen == nullptr || seen->triangle == kNone) {
        const double u = piece.u_at(look.time_s);
        const Vector<Scene> direction = normalized(piece.direction_at(u, x, y));
        return shot.light().far().distance_m(piece.origin_at(u), direction) ? "far ground" : "sky";
    }
    if (seen->surface > 0) return seen->reflected != kNone ? "mirror" : "body";
    const auto& corner = shot.mesh().triangles[seen->triangle];
    const auto from_first = [&](std::size_t k, auto GridPlace::*of) {
        return shot.mesh().samples[corner[k]].*of - shot.mesh().samples[corner[0]].*of;
    };
    const int twice_cells = from_first(1, &GridPlace::column) * from_first(2, &GridPlace::row) -
                            from_first(1, &GridPlace::row) * from_first(2, &GridPlace::column);
    return std::string(std::abs(twice_cells) > 1 ? "large" : "small") + " triangle " +
           (seen->in_shadow ? "in shadow" : "in the sun");
}

using Counts = std::map<std::string, int>;

// Compares all looks of a few pieces for the vector unit that is chosen, and counts what they met.
Counts compared(const GliderShot& shot) {
    Counts counts;
    const SceneShader shader = shot.shader();
    const std::vector<ImageSample> lines = lines_through_all_pixels();
    for (const double place : {0.1, 0.5, 0.9}) {
        const MotionPiece& piece = shot.piece(place);
        const SurfaceSegmentLists lists = shot.traced(lines, piece);
        const std::vector<SceneShader::Look> looks = looks_of(lines, lists, piece);
        std::vector<Radiance> found(looks.size());
        ManyLooks(shader, piece).look(looks, found);
        Counts different;
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const std::string what = met(shot, piece, looks[i]);
            ++counts[what];
            if (bits(found[i]) != bits(shader.radiance(piece, looks[i]))) ++different[what];
        }
        for (const auto& [what, count] : different) ADD_FAILURE() << what << ": " << count << " differ";
    }
    return counts;
}

void expect_met(const Counts& counts, const std::vector<std::string>& all) {
    for (const std::string& what : all) {
        const auto found = counts.find(what);
        EXPECT_GT(found == counts.end() ? 0 : found->second, 10) << what;
    }
}

TEST(ManyLooks, SayWhatOneLookSaysOnTheFullMesh) {
    const GliderShot shot(0.0);
    const Counts counts = compared(shot);
    expect_met(counts,
               {"small triangle in the sun", "small triangle in shadow", "body", "mirror", "far ground", "sky"});
}

TEST(ManyLooks, SayWhatOneLookSaysOnFewTriangles) {
    const GliderShot shot(0.5);
    ASSERT_LT(shot.mesh().triangles.size(), shot.full_mesh().triangles.size());
    const Counts counts = compared(shot);
    expect_met(counts, {"small triangle in the sun", "large triangle in the sun", "large triangle in shadow", "mirror",
                        "far ground", "sky"});
}

TEST(ManyLooks, SayTheSameOnEveryVectorUnit) {
    const GliderShot shot(0.5);
    for_each_vector_unit([&](const char* name) {
        SCOPED_TRACE(name);
        static_cast<void>(compared(shot));
    });
}

}  // namespace
}  // namespace overfly
