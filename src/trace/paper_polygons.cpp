#include "trace/paper_polygons.h"

#include "trace/edge_function.h"

namespace overfly {

void polygons_at(const PaperScene& scene, double u, PaperPolygons& out) {
    out.polygons.clear();
    out.edges.clear();
    for (const PaperPolygon& p : scene.polygons) {
        const Vector<Scene> gone = scene.bodies[p.body].at(u);
        const auto corner = [&](std::uint32_t k) { return scene.corners[p.first_corner + k % p.corners]; };
        const auto place = [&](std::uint32_t k) { return scene.positions[corner(k)] - Point<Scene>{} + gone; };
        PaperPolygons::Polygon prepared;
        prepared.first_edge = static_cast<std::uint32_t>(out.edges.size());
        prepared.edges = p.corners;
        prepared.normal = cross(place(1) - place(0), place(2) - place(0));
        prepared.offset = dot(prepared.normal, place(0));
        out.polygons.push_back(prepared);
        for (std::uint32_t k = 0; k < p.corners; ++k) {
            const EdgeFunction e = edge_function(corner(k), corner(k + 1), place(k), place(k + 1));
            out.edges.push_back({-e.sign * e.a_cross_b, -e.sign * e.b_minus_a});
        }
    }
}

}  // namespace overfly
