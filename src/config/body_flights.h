#pragma once

#include <vector>

#include "config/documents.h"
#include "config/overrides.h"
#include "config/section.h"

namespace overfly::config {

// An override of something in the flight document that a body follows, `bodies.0.flight.keyframes.2.time_s=4`: as that
// document sees it.
struct BodyFlightOverride {
    std::string body;  // its index, as written
    Override change;
};

// Splits off the overrides that reach into the flight documents of bodies; one of `bodies.0.flight` itself stays.
[[nodiscard]] std::vector<BodyFlightOverride> take_body_flight_overrides(std::vector<Override>& overrides);

// Reads the flight documents that the bodies follow. An override for a body that follows none is a problem.
void read_body_flights(std::vector<BodyDocument>& bodies, const std::vector<BodyFlightOverride>& overrides,
                       Findings& findings);

}  // namespace overfly::config
