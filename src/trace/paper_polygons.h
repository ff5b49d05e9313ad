#pragma once

#include <span>
#include <vector>

#include "trace/paper_scene.h"

namespace overfly {

// What a test of a ray with a polygon needs, worked out once for many rays: the plane and the sides.
struct PaperPolygons {
    // An EdgeFunction whose sign has been multiplied in.
    struct Edge {
        Vector<Scene> of_direction, of_moment;

        [[nodiscard]] double at(Vector<Scene> d, Vector<Scene> o_cross_d) const {
            return dot(of_direction, d) + dot(of_moment, o_cross_d);
        }
    };
    struct Polygon {
        Vector<Scene> normal;
        double offset = 0.0;  // the plane: dot(normal, p) = offset
        std::uint32_t first_edge = 0, edges = 0;
    };

    std::vector<Polygon> polygons;  // as in the scene
    std::vector<Edge> edges;

    [[nodiscard]] std::span<const Edge> edges_of(const Polygon& p) const {
        return {edges.data() + p.first_edge, p.edges};
    }
};

// Is the value of an edge function that of a line which passes the edge outside the polygon? `facing` is
// dot(normal, direction): a line inside has every edge function of the other sign.
[[nodiscard]] inline bool is_outside(double edge_value, double facing) { return edge_value * facing > 0.0; }

// The polygons with their bodies where they are at time u. At 0 they are at home: in the frames of their bodies.
// `out` is written over; its memory is used again.
void polygons_at(const PaperScene& scene, double u, PaperPolygons& out);

}  // namespace overfly
