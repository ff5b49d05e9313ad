#include "config/document_keys.h"

#include <algorithm>

#include "config/document_file.h"

namespace overfly {

std::vector<std::string> document_keys(DocumentKind kind) {
    config::Findings findings;
    findings.listing_keys = true;
    config::Section absent(nullptr, "", findings);
    read_top(absent, [kind](config::Section& document) {
        TerrainDocument terrain;
        FlightDocument flight;
        ShotDocument shot;
        BatchDocument batch;
        switch (kind) {
            case DocumentKind::Terrain:
                return read_terrain(document, terrain);
            case DocumentKind::Flight:
                return read_flight(document, flight);
            case DocumentKind::Shot:
                return read_shot(document, shot);
            case DocumentKind::Batch:
                return read_batch(document, batch);
        }
    });
    std::ranges::sort(findings.keys);
    return findings.keys;
}

}  // namespace overfly
