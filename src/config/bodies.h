#pragma once

#include "config/documents.h"
#include "config/section.h"

namespace overfly::config {

// The bodies of a shot. The keyframes of the flights that they follow stay empty (body_flights.h).
void read_bodies(Section& document, std::vector<BodyDocument>& bodies);

}  // namespace overfly::config
