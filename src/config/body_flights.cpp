#include "config/body_flights.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "config/document_file.h"

namespace overfly::config {
namespace {

// The ways to the flight of a body: bodies, its index, flight, and what is inside.
bool is_inside_a_flight(const Override& o) {
    return o.keys.size() > 3 && o.keys[0] == "bodies" && o.keys[2] == "flight";
}

void read_flight_of(BodyDocument& body, std::span<const Override> changes, Findings& findings) {
    FlightDocument flight{.file = body.flight_file, .keyframes = {}, .places = {}};
    read_document(flight.file, changes, findings, [&](Section& document) { read_flight(document, flight); });
    std::get<BodyFlight>(body.motion).keyframes = std::move(flight.keyframes);
    body.places.keyframes = std::move(flight.places);
}

}  // namespace

std::vector<BodyFlightOverride> take_body_flight_overrides(std::vector<Override>& overrides) {
    const auto inside = std::stable_partition(overrides.begin(), overrides.end(),
                                              [](const Override& o) { return !is_inside_a_flight(o); });
    std::vector<BodyFlightOverride> taken;
    for (auto o = inside; o != overrides.end(); ++o) {
        taken.push_back({o->keys[1], std::move(*o)});
        taken.back().change.keys.erase(taken.back().change.keys.begin(), taken.back().change.keys.begin() + 3);
    }
    overrides.erase(inside, overrides.end());
    return taken;
}

void read_body_flights(std::vector<BodyDocument>& bodies, const std::vector<BodyFlightOverride>& overrides,
                       Findings& findings) {
    std::vector<bool> used(overrides.size(), false);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].flight_file.empty() || !std::holds_alternative<BodyFlight>(bodies[i].motion)) continue;
        std::vector<Override> changes;
        for (std::size_t k = 0; k < overrides.size(); ++k) {
            if (overrides[k].body != std::to_string(i)) continue;
            changes.push_back(overrides[k].change);
            used[k] = true;
        }
        read_flight_of(bodies[i], changes, findings);
    }
    for (std::size_t k = 0; k < overrides.size(); ++k) {
        if (used[k]) continue;
        findings.problems.push_back(
            {overrides[k].change.place, fmt::format("bodies: got {}, allowed the index of a body that "
                                                    "follows a flight",
                                                    in_quotes(overrides[k].body))});
    }
}

}  // namespace overfly::config
