#include "config/section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/document_path.h"
#include "config/nearest_word.h"

namespace overfly::config {

Section::Section(const Node* node, std::string path, Findings& findings)
    : node_(node), path_(std::move(path)), findings_(findings) {
    // A section whose lines are all commented out is empty, not wrong.
    if (!node_ || node_->kind == Node::Kind::Mapping || node_->kind == Node::Kind::Nothing) return;
    refuse_node(path_, *node_, "a mapping (`key: value` lines)");
    node_ = nullptr;
}

bool Section::read(std::string_view key, double& value, const Range& allowed) {
    const Node* node = find(key);
    if (!node) return false;
    const std::optional<double> number = number_of(*node);
    if (!number) return refuse_node(path_of(key), *node, "a number, " + allowed.text());
    if (!allowed.contains(*number)) return refuse_node(path_of(key), *node, allowed.text());
    value = *number;
    return true;
}

bool Section::read(std::string_view key, int& value, const Range& allowed) {
    const Node* node = find(key);
    if (!node) return false;
    const std::optional<double> number = number_of(*node);
    if (!number || *number != std::trunc(*number)) {
        return refuse_node(path_of(key), *node, "a whole number, " + allowed.text());
    }
    if (!allowed.contains(*number)) return refuse_node(path_of(key), *node, allowed.text());
    value = static_cast<int>(*number);
    return true;
}

bool Section::read(std::string_view key, std::optional<int>& value, const Range& allowed) {
    int number = 0;
    const bool taken = read(key, number, allowed);
    if (taken) value = number;
    return taken;
}

bool Section::read(std::string_view key, Angle& value, const Range& allowed_deg) {
    double deg = 0.0;
    const bool taken = read(key, deg, allowed_deg);
    if (taken) value = Angle::degrees(deg);
    return taken;
}

bool Section::read_any_number(std::string_view key, std::optional<double>& value) {
    const Node* node = find(key);
    if (!node) return false;
    const std::optional<double> number = number_of(*node);
    if (!number) return refuse_node(path_of(key), *node, "a number");
    value = number;
    return true;
}

bool Section::read(std::string_view key, bool& value) {
    static constexpr NamedValue<bool> kWords[] = {{"true", true}, {"false", false}};
    return read(key, value, kWords);
}

bool Section::read(std::string_view key, std::string& value, std::string_view allowed) {
    const Node* node = find(key);
    if (!node) return false;
    if (node->kind != Node::Kind::Scalar || node->scalar.empty()) return refuse_node(path_of(key), *node, allowed);
    value = node->scalar;
    return true;
}

bool Section::read(std::string_view key, std::filesystem::path& value, PathTo target) {
    const Node* node = find(key);
    return node && take_path(path_of(key), *node, value, target);
}

bool Section::read(std::string_view key, std::vector<std::filesystem::path>& value, PathTo target) {
    const Node* node = find(key);
    if (!node) return false;
    const bool list = node->kind == Node::Kind::List;
    if (list && node->items.empty()) return refuse_node(path_of(key), *node, "at least one path");
    if (!list && node->kind != Node::Kind::Scalar) return refuse_node(path_of(key), *node, "a path or a list of paths");
    std::vector<std::filesystem::path> paths;
    for (const Node& item : list ? std::span(node->items) : std::span(node, 1)) {
        const std::string path = list ? fmt::format("{}.{}", path_of(key), paths.size()) : path_of(key);
        take_path(path, item, paths.emplace_back(), target);
    }
    value = std::move(paths);
    return true;
}

bool Section::take_path(const std::string& path, const Node& node, std::filesystem::path& value, PathTo target) {
    // A path of the file system can't hold a NUL: what follows it would silently be lost.
    const bool usable =
        node.kind == Node::Kind::Scalar && !node.scalar.empty() && node.scalar.find('\0') == std::string::npos;
    if (!usable) return refuse_node(path, node, "a path");
    if (target == PathTo::Raster && is_gdal_name(node.scalar)) {
        value = node.scalar;
        return true;
    }
    // A document's paths are relative to itself, those of the command line to where it is typed.
    std::filesystem::path resolved =
        node.from_override() ? std::filesystem::path(node.scalar) : path_in(node.place.file.parent_path(), node.scalar);
    std::error_code cannot_look;
    const auto status = std::filesystem::status(resolved, cannot_look);
    if (target != PathTo::Folder && !std::filesystem::exists(status)) {
        return refuse_node(path, node,
                           fmt::format("a file that exists; there is no '{}'", on_one_line(resolved.string())));
    }
    if (target == PathTo::File && std::filesystem::is_directory(status)) {
        return refuse_node(path, node, fmt::format("a file; '{}' is a folder", on_one_line(resolved.string())));
    }
    value = std::move(resolved);
    return true;
}

bool Section::section(std::string_view key, const std::function<void(Section&)>& read) {
    const Node* node = find(key);
    Section inner(node, path_of(key), findings_);
    read(inner);
    inner.close();
    return node != nullptr;
}

void Section::read_node(std::string_view key, const NodeReader& read) {
    if (const Node* node = find(key)) read(*node, path_of(key), findings_.problems);
}

void Section::each(std::string_view key, Empty empty, const std::function<void(Section&)>& read) {
    const auto read_item = [&](const Node* item, std::string index) {
        Section inner(item, fmt::format("{}.{}", path_of(key), index), findings_);
        read(inner);
        inner.close();
    };
    const Node* node = find(key);
    if (findings_.listing_keys) return read_item(nullptr, "N");
    if (!node) return;
    const bool may_be_empty = empty == Empty::Allowed;
    if (may_be_empty && node->kind == Node::Kind::Nothing) return;
    if (node->kind != Node::Kind::List || (node->items.empty() && !may_be_empty)) {
        refuse_node(path_of(key), *node, may_be_empty ? "a list of mappings" : "a list of at least one mapping");
        return;
    }
    for (std::size_t i = 0; i < node->items.size(); ++i) read_item(&node->items[i], std::to_string(i));
}

bool Section::has(std::string_view key) { return find(key) != nullptr; }

bool Section::has_word(std::string_view key) {
    const Node* node = find(key);
    return node && node->kind == Node::Kind::Scalar;
}

void Section::require(std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
        if (!has(key)) problem(fmt::format("missing key '{}'", key));
    }
}

void Section::allow_one_of(std::string_view key, std::string_view other) {
    if (!has(key) || !has(other)) return;
    // Reported at the second of the two, where the reader of the document meets the contradiction.
    const auto second = std::ranges::find_if(node_->entries.rbegin(), node_->entries.rend(),
                                             [&](const auto& e) { return e.key == key || e.key == other; });
    const std::string prefix = path_.empty() ? "" : path_ + ": ";
    findings_.problems.push_back(
        {second->value.place, fmt::format("{}got both '{}' and '{}', allowed one of them", prefix, key, other)});
}

bool Section::refuse(std::string_view key, std::string_view allowed) {
    const Node* node = find(key);
    return node && refuse_node(path_of(key), *node, allowed);
}

void Section::problem(std::string message) {
    if (!node_) return;
    findings_.problems.push_back({node_->place, path_.empty() ? std::move(message) : path_ + ": " + message});
}

void Section::close() {
    if (!node_) return;
    for (auto entry = node_->entries.begin(); entry != node_->entries.end(); ++entry) {
        const auto first = std::ranges::find(node_->entries.begin(), entry, entry->key, &Node::Entry::key);
        if (first != entry) {
            findings_.problems.push_back(
                {entry->place, fmt::format("duplicate key {}{}; the first is at line {}", in_quotes(entry->key),
                                           inside(), first->place.line)});
        } else if (std::ranges::find(known_, entry->key) == known_.end()) {
            const std::optional<std::string> meant = nearest_word(entry->key, known_);
            findings_.problems.push_back(
                {entry->place,
                 fmt::format("unknown key {}{};{} known: {}", in_quotes(entry->key), inside(),
                             meant ? fmt::format(" did you mean '{}'?", *meant) : "", fmt::join(known_, ", "))});
        }
    }
}

const Node* Section::find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) {
        known_.emplace_back(key);
        if (findings_.listing_keys) findings_.keys.push_back(path_of(key));
    }
    return node_ ? node_->find(key) : nullptr;
}

std::string Section::path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

std::string Section::inside() const { return path_.empty() ? "" : fmt::format(" in '{}'", path_); }

bool Section::refuse_node(std::string_view path, const Node& node, std::string_view allowed) {
    findings_.problems.push_back(refusal(path, node, allowed));
    return false;
}

std::optional<std::size_t> Section::word_index(std::string_view key, std::span<const std::string> words) {
    const Node* node = find(key);
    if (!node) return std::nullopt;
    if (node->kind == Node::Kind::Scalar) {
        const auto word = std::ranges::find(words, node->scalar);
        if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
    }
    const std::optional<std::string> meant = nearest_word(node->scalar, words);
    refuse_node(path_of(key), *node,
                fmt::format("{} or {}{}", fmt::join(words.first(words.size() - 1), ", "), words.back(),
                            meant ? fmt::format("; did you mean '{}'?", *meant) : ""));
    return std::nullopt;
}

}  // namespace overfly::config
