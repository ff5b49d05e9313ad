#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/kinetic_scenes.h"
#include "trace/kinetic.h"
#include "trace/kinetic_edge.h"
#include "trace/silhouette_filter.h"
#include "trace/silhouette_passages.h"

namespace overfly {
namespace {

using namespace testing;

constexpr unsigned kSeed = 31;
constexpr int kTimes = 40;
constexpr FilmBounds kPicture = {-1.0, 1.0, -0.57, 0.57};

class KineticParts : public ::testing::Test {
  protected:
    TriangleMesh mesh_ = with_holes(heightfield(50, 50, 100.0, rough_ground), 7);
    KineticMesh kinetic_{mesh_};
};

// A triangle that is said to be seen from one side all through is so at any time; and few are left open.
TEST_F(KineticParts, FacingIsCertain) {
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece(kinetic_, m.piece, kPicture);
        std::size_t open = 0;
        std::size_t wrong = 0;
        for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
            if (piece.facing(t) == Facing::Changes) ++open;
            const auto& corner = mesh_.triangles[t];
            const Point<Scene> v0 = mesh_.positions[corner[0]];
            const Vector<Scene> normal = cross(mesh_.positions[corner[1]] - v0, mesh_.positions[corner[2]] - v0);
            for (int k = 0; k <= kTimes; ++k) {
                const double u = k / static_cast<double>(kTimes);
                const bool is_front = dot(normal, m.piece.origin_at(u) - v0) > 0.0;
                wrong += is_front == (piece.facing_sign(t, u) > 0.0) ? 0 : 1;
            }
        }
        EXPECT_EQ(wrong, 0U) << m.name;
        EXPECT_LT(open, mesh_.triangles.size() / 3) << m.name;
    }
}

// Wherever a point is before the camera, it appears within its bounds.
TEST_F(KineticParts, FilmCurvesHold) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> place(-3000.0, 3000.0);
    int before = 0;
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const FilmCurves curves(m.piece);
        for (int i = 0; i < 300; ++i) {
            const Vector<Scene> p = {place(generator), place(generator), 0.3 * place(generator)};
            const FilmCurves::Place bounds = curves.place(p);
            for (int k = 0; k <= kTimes; ++k) {
                const double u = k / static_cast<double>(kTimes);
                const Vector<Scene> w = p - m.piece.origin.at(u);
                const Vector<Scene> right = m.piece.right.at(u);
                const Vector<Scene> down = m.piece.down.at(u);
                const Vector<Scene> view = m.piece.view.at(u);
                const double depth = dot(w, cross(right, down));
                if (bounds.depth == FilmCurves::Place::Depth::Behind) {
                    EXPECT_LE(depth, 1e-6) << m.name;
                }
                if (bounds.depth != FilmCurves::Place::Depth::Before) continue;
                ++before;
                ASSERT_GT(depth, 0.0) << m.name;
                const double x = dot(w, cross(down, view)) / depth;
                const double y = dot(w, cross(view, right)) / depth;
                EXPECT_GE(x, bounds.film.low_x - 1e-9) << m.name << ", seed " << kSeed;
                EXPECT_LE(x, bounds.film.high_x + 1e-9) << m.name << ", seed " << kSeed;
                EXPECT_GE(y, bounds.film.low_y - 1e-9) << m.name << ", seed " << kSeed;
                EXPECT_LE(y, bounds.film.high_y + 1e-9) << m.name << ", seed " << kSeed;
            }
        }
    }
    EXPECT_GT(before, 10'000);
}

// Every border and every edge of two facings that a sample passes is among its passages: found without bins, films and
// filters, by the roots alone.
TEST_F(KineticParts, NoPassageIsMissed) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(40);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    std::size_t all = 0;
    std::size_t guesses = 0;
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece(kinetic_, m.piece, kPicture);
        const PieceStretch stretch = {&m.piece, 0.0, 1.0, m.piece.when};
        SilhouettePassages found = silhouette_passages(piece, stretch, samples);
        for (SilhouettePassage& p : found.in_order) {
            const double guess_u = p.u;
            const double doubt_u = p.doubt_u;
            const bool is_guess = p.state == SilhouettePassage::State::Guess;
            guesses += is_guess ? 1 : 0;
            resolve(piece, samples[p.sample], p);
            if (p.state == SilhouettePassage::State::None) continue;
            EXPECT_LT(std::abs(p.u - guess_u), is_guess ? doubt_u : 1e-9) << m.name;
        }
        std::vector<Facing> facing;
        for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) facing.push_back(piece.facing(t));
        for (std::uint32_t i = 0; i < samples.size(); ++i) {
            const LineOverPiece line = piece.lines().at(samples[i].x, samples[i].y);
            for (const HalfEdgeId h : silhouette_edges(mesh_, kinetic_.borders, facing)) {
                const VertexId a = mesh_.triangles[h / 4][h % 4];
                const VertexId b = mesh_.triangles[h / 4][(h % 4 + 1) % 3];
                const EdgeSide side(line.side_of(edge_function(a, b, mesh_.positions[a] - m.piece.reference,
                                                               mesh_.positions[b] - m.piece.reference)));
                for (const double u : side.roots()) {
                    const EdgePoint at = edge_point(mesh_, h, piece.line_at(u, samples[i].x, samples[i].y));
                    if (!(at.depth > 0.0 && at.along > 0.0 && at.along < 1.0)) continue;
                    ++all;
                    const bool is_known = std::ranges::any_of(found.in_order, [&](const SilhouettePassage& p) {
                        return p.state == SilhouettePassage::State::Exact && p.sample == i && p.half_edge == h &&
                               std::abs(p.u - u) < 1e-9;
                    });
                    EXPECT_TRUE(is_known) << m.name << ", sample " << i << " edge " << h << " u " << u;
                }
            }
        }
    }
    EXPECT_GT(all, 1'000U);
    EXPECT_GT(guesses, 1'000U);
}

// Of a short stretch only those silhouettes are looked at that appear near the samples meanwhile.
TEST_F(KineticParts, AShortStretchHasThePassagesOfTheWholePiece) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-0.1, 0.1);
    std::vector<ImageSample> samples(1000);
    for (ImageSample& s : samples) s = {0.2 + film(generator), film(generator), 0.0};
    constexpr double kFrom = 0.37, kTo = 0.43;
    std::size_t compared = 0;
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece(kinetic_, m.piece, kPicture);
        const auto passages = [&](double from_u, double to_u) {
            const TimeRange when = {m.piece.time_at(from_u), m.piece.time_at(to_u)};
            std::vector<SilhouettePassage> of_both;
            for (SilhouettePassage p : silhouette_passages(piece, {&m.piece, from_u, to_u, when}, samples).in_order) {
                resolve(piece, samples[p.sample], p);
                const bool is_meant = p.state == SilhouettePassage::State::Exact && p.u > kFrom + 1e-6 && p.u < kTo;
                if (is_meant) of_both.push_back(p);
            }
            return of_both;
        };
        const std::vector<SilhouettePassage> of_piece = passages(0.0, 1.0), of_stretch = passages(kFrom, kTo);
        const auto is_same = [](const SilhouettePassage& a, const SilhouettePassage& b) {
            return a.sample == b.sample && a.half_edge == b.half_edge && a.comes == b.comes &&
                   std::abs(a.u - b.u) < 1e-9;
        };
        EXPECT_TRUE(std::ranges::equal(of_piece, of_stretch, is_same)) << m.name << ", seed " << kSeed;
        const FilmBounds part = film_bounds(samples);
        EXPECT_LE(piece.silhouettes_near(part, kFrom, kTo).size(), piece.silhouettes_near(part, 0.0, 1.0).size());
        compared += of_stretch.size();
    }
    EXPECT_GT(compared, 1'000U);
}

// What is said to be hidden is behind the triangle, corner by corner, or behind the camera, as long as a guess may be
// off.
TEST_F(KineticParts, WhatIsHiddenIsBehind) {
    std::mt19937 generator(kSeed);
    std::size_t hidden = 0;
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece(kinetic_, m.piece, kPicture);
        const auto depth = [&](VertexId v, double u) {
            const Vector<Scene> ahead = cross(m.piece.right.at(u), m.piece.down.at(u));
            return dot(ahead, mesh_.positions[v] - m.piece.origin_at(u));
        };
        std::uniform_int_distribution<TriangleId> any(0, static_cast<TriangleId>(mesh_.triangles.size()) - 1);
        for (const Silhouette& s : piece.silhouettes()) {
            const TriangleId t = any(generator);
            const double middle_u = std::uniform_real_distribution<double>(0.01, 0.99)(generator);
            if (!piece.hides(t, s, middle_u)) continue;
            ++hidden;
            const auto& owner = mesh_.triangles[s.half_edge / 4];
            for (const double off : {-kGuessDoubt, 0.0F, kGuessDoubt}) {
                const double u = middle_u + static_cast<double>(off);
                const std::uint32_t side = s.half_edge % 4;
                const auto edge = std::minmax({depth(owner[side], u), depth(owner[(side + 1) % 3], u)});
                double furthest = 0.0;
                for (const VertexId v : mesh_.triangles[t]) furthest = std::max(furthest, depth(v, u));
                EXPECT_TRUE(edge.first > furthest || edge.second < 0.0) << m.name << ", seed " << kSeed;
            }
        }
    }
    EXPECT_GT(hidden, 1'000U);
}

}  // namespace
}  // namespace overfly
