#include "config/document_file.h"
#include "config/read.h"

namespace overfly {
namespace config {

void read_batch(Section& document, BatchDocument& batch) {
    document.require({"shots"});
    document.read("shots", batch.shots, PathTo::File);
}

}  // namespace config

BatchDocument read_batch_document(const std::filesystem::path& file) {
    config::Findings findings;
    BatchDocument batch{.file = file, .shots = {}};
    read_document(file, {}, findings, [&](config::Section& document) { read_batch(document, batch); });
    finish(findings);
    return batch;
}

}  // namespace overfly
