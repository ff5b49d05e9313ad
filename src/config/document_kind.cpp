#include <vector>

#include "config/document_file.h"
#include "config/read.h"

namespace overfly {

DocumentKind document_kind(const std::filesystem::path& file) {
    std::vector<Problem> problems;
    const std::optional<config::Node> document = config::load_document(file, problems);
    if (!document) throw UserError(std::move(problems));

    std::vector<DocumentKind> kinds;
    if (document->find("dem")) kinds.push_back(DocumentKind::Terrain);
    if (document->find("keyframes")) kinds.push_back(DocumentKind::Flight);
    if (document->find("terrain") || document->find("flight")) kinds.push_back(DocumentKind::Shot);
    if (document->find("shots")) kinds.push_back(DocumentKind::Batch);
    if (kinds.size() == 1) return kinds.front();
    throw UserError({file}, std::string("got the keys of ") + (kinds.empty() ? "no" : "more than one") +
                                " kind of document, allowed one of: 'dem' (terrain), 'keyframes' (flight), 'terrain' "
                                "and 'flight' (shot), 'shots' (batch)");
}

}  // namespace overfly
