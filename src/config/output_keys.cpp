#include "config/output_keys.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

namespace overfly::config {
namespace {

constexpr NamedValue<Compression> kLossless[] = {
    {"zip", Compression::Zip}, {"zips", Compression::Zips}, {"piz", Compression::Piz}};
constexpr NamedValue<Compression> kAny[] = {
    {"zip", Compression::Zip}, {"zips", Compression::Zips}, {"piz", Compression::Piz}, {"dwaa", Compression::Dwaa}};

void read_name(Section& section, std::string& output_name) {
    std::string name;
    if (!section.read("name", name)) return;
    const bool file_name = name.find('/') == std::string::npos && name.find('\0') == std::string::npos;
    if (file_name && name != "." && name != "..") {
        output_name = name;
    } else {
        section.refuse("name", "a file name without folders");
    }
}

// A word alone is for all layers, as far as they bear it.
void read_storage(Section& section, FrameStorage& storage) {
    if (section.has_word("compression")) {
        if (section.read("compression", storage.beauty, kAny) && !is_lossy(storage.beauty))
            storage.data = storage.beauty;
        return;
    }
    section.section("compression", [&](Section& groups) {
        groups.read("beauty", storage.beauty, kAny);
        groups.read("data", storage.data, kLossless);
        if (groups.read("quality", storage.quality, {1, 1000}) && !is_lossy(storage.beauty))
            groups.refuse("quality", "nothing where beauty is not dwaa");
    });
}

struct BurnInWord {
    const char* word;
    bool BurnIn::*field;
};

constexpr std::array<BurnInWord, 3> kBurnInWords = {
    {{"frame", &BurnIn::frame}, {"place", &BurnIn::place}, {"time", &BurnIn::time}}};

void read_burn_in(const Node& node, const std::string& path, std::vector<Problem>& problems, BurnIn& burn_in) {
    if (node.kind == Node::Kind::Scalar && (node.scalar == "true" || node.scalar == "false")) {
        const bool all = node.scalar == "true";
        burn_in = {.frame = all, .place = all, .time = all};
        return;
    }
    if (node.kind != Node::Kind::List) {
        problems.push_back(refusal(path, node, "true, false or a list of frame, place, time"));
        return;
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        const Node& item = node.items[i];
        const auto* const known = std::ranges::find_if(kBurnInWords, [&](const BurnInWord& w) {
            return item.kind == Node::Kind::Scalar && item.scalar == w.word;
        });
        if (known != kBurnInWords.end()) {
            burn_in.*known->field = true;
        } else {
            problems.push_back(refusal(fmt::format("{}.{}", path, i), item, "frame, place or time"));
        }
    }
}

void read_view(Section& section, ViewChoice& view) {
    section.read("ocio_config", view.config, PathTo::File);
    section.read("colour_space", view.colour_space);
    section.read("display", view.display);
    section.read("view", view.view);
}

}  // namespace

void read_output(Section& section, OutputDocument& output) {
    section.read("folder", output.folder, PathTo::Folder);
    read_name(section, output.name);
    read_storage(section, output.storage);
    section.read("layer_files", output.layer_files);
    section.read("contact_sheet", output.contact_sheet);
    section.read("movie", output.movie);
    section.read_node("burn_in", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        read_burn_in(node, path, problems, output.preview.burn_in);
    });
    section.section("preview", [&](Section& s) { read_view(s, output.preview.view); });
}

}  // namespace overfly::config
