#include "config/document_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <tuple>
#include <utility>

#include "config/yaml_text.h"

namespace overfly::config {
namespace {

// A raster given by mistake is refused before it is all in memory. 100,000 keyframes are 10 MB.
constexpr std::size_t kMaxDocumentBytes = 64 << 20;

std::optional<std::string> text_of(const std::filesystem::path& file, std::vector<Problem>& problems) {
    const auto refuse = [&](std::string message) {
        problems.push_back({{file}, std::move(message)});
        return std::nullopt;
    };
    std::error_code cannot_look;
    const auto status = std::filesystem::status(file, cannot_look);
    if (!std::filesystem::exists(status)) return refuse("no such file");
    if (std::filesystem::is_directory(status)) return refuse("got a folder, allowed a YAML file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return refuse(fmt::format("cannot be read: {}", std::strerror(errno)));

    std::string text;
    for (char block[65536]; text.size() <= kMaxDocumentBytes && stream;) {
        stream.read(block, sizeof block);
        text.append(block, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) return refuse(fmt::format("cannot be read: {}", std::strerror(errno)));
    if (text.size() > kMaxDocumentBytes) return refuse("got more than 64 MB, allowed a YAML document");
    return text;
}

}  // namespace

std::optional<Node> load_document(const std::filesystem::path& file, std::vector<Problem>& problems) {
    const std::optional<std::string> text = text_of(file, problems);
    if (!text) return std::nullopt;
    std::optional<Node> document = parse_yaml(*text, {file}, TextOrigin::File, problems);
    if (!document || document->kind == Node::Kind::Mapping) return document;
    problems.push_back({document->place, fmt::format("got {}, allowed a mapping (`key: value` lines)",
                                                     document->kind == Node::Kind::Nothing ? "an empty document"
                                                                                           : description(*document))});
    return std::nullopt;
}

void read_top(Section& document, const std::function<void(Section&)>& read) {
    read(document);
    std::string for_people;
    document.read("name", for_people);
    document.read("description", for_people);
    document.close();
}

void read_document(const std::filesystem::path& file, std::span<const Override> overrides, Findings& findings,
                   const std::function<void(Section&)>& read) {
    const std::size_t first = findings.problems.size();
    std::optional<Node> root = load_document(file, findings.problems);
    if (!root) return;
    for (const Override& o : overrides) apply_override(o, *root, findings.problems);
    Section document(&*root, "", findings);
    read_top(document, read);
    const auto own = std::span(findings.problems).subspan(first);
    std::ranges::stable_sort(own, {}, [](const Problem& p) { return std::pair(p.place.line, p.place.column); });
}

void finish(Findings& findings) {
    std::set<std::string> said;
    std::erase_if(findings.problems, [&](const Problem& p) { return !said.insert(p.text()).second; });
    if (!findings.problems.empty()) throw UserError(std::move(findings.problems));
}

}  // namespace overfly::config
