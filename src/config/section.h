#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.h"
#include "config/range.h"
#include "core/angle.h"
#include "core/error.h"

namespace overfly::config {

// What reading has found so far.
struct Findings {
    std::vector<Problem> problems;
    // Readers ask for all keys of a document, whatever it holds. With `listing_keys` set they are run over an absent
    // document, and every key that they ask for is noted, list items as N: `keyframes.N.time_s`.
    bool listing_keys = false;
    std::vector<std::string> keys;
};

// A word of a closed set, and what it stands for.
template <class Value>
struct NamedValue {
    const char* word;
    Value value;
};

enum class PathTo {
    File,    // must exist
    Raster,  // must exist, or be a name that only GDAL understands
    Folder,  // need not exist yet
};

// A mapping of a document while it is read. Each read() knows its key from then on, leaves `value` as it is where the
// key is absent, and where it holds something that is not allowed, which is noted as a problem; true where a value was
// taken. A section that is absent altogether can be read too: its keys become known, nothing is a problem.
class Section {
  public:
    // The mapping `node`, or an absent one. Anything that is neither a mapping nor empty is a problem.
    Section(const Node* node, std::string path, Findings& findings);

    bool read(std::string_view key, double& value, const Range& allowed);
    bool read(std::string_view key, int& value, const Range& allowed);
    bool read(std::string_view key, std::optional<int>& value, const Range& allowed);
    bool read(std::string_view key, Angle& value, const Range& allowed_deg);
    bool read(std::string_view key, bool& value);
    bool read(std::string_view key, std::string& value, std::string_view allowed = "a text");  // not empty
    bool read(std::string_view key, std::filesystem::path& value, PathTo target);
    bool read(std::string_view key, std::vector<std::filesystem::path>& value, PathTo target);  // one, or a list
    bool read_any_number(std::string_view key, std::optional<double>& value);                   // .nan and .inf too

    template <class Value, std::size_t count>
    bool read(std::string_view key, Value& value, const NamedValue<Value> (&words)[count]) {
        std::vector<std::string> known;
        for (const auto& w : words) known.emplace_back(w.word);
        const std::optional<std::size_t> index = word_index(key, known);
        if (index) value = words[*index].value;
        return index.has_value();
    }

    // Hands the value of `key` to `read`, with its path: for what no other read() understands.
    using NodeReader = std::function<void(const Node& node, const std::string& path, std::vector<Problem>& problems)>;
    void read_node(std::string_view key, const NodeReader& read);

    // Reads a mapping inside this one, and then notes what keys in it are unknown or duplicate. True where it is there.
    bool section(std::string_view key, const std::function<void(Section&)>& read);
    // The same for each mapping of a list, which may be empty or not.
    enum class Empty { Allowed, Refused };
    void each(std::string_view key, Empty empty, const std::function<void(Section&)>& read);

    [[nodiscard]] bool has(std::string_view key);
    [[nodiscard]] bool has_word(std::string_view key);  // a single value, neither a list nor a mapping
    [[nodiscard]] Place place() const { return node_ ? node_->place : Place{}; }
    void require(std::initializer_list<std::string_view> keys);
    void allow_one_of(std::string_view key, std::string_view other);

    // Notes "key: got ..., allowed ..." at the value of `key`. Always false.
    bool refuse(std::string_view key, std::string_view allowed);
    // Notes a problem with the section as a whole, if it is there.
    void problem(std::string message);

    // To be called when all keys have been asked for: notes those that nobody asked for, and duplicates.
    void close();

  private:
    [[nodiscard]] const Node* find(std::string_view key);
    [[nodiscard]] std::string path_of(std::string_view key) const;
    [[nodiscard]] std::string inside() const;
    bool refuse_node(std::string_view path, const Node& node, std::string_view allowed);
    bool take_path(const std::string& path, const Node& node, std::filesystem::path& value, PathTo target);
    [[nodiscard]] std::optional<std::size_t> word_index(std::string_view key, std::span<const std::string> words);

    const Node* node_;
    std::string path_;
    Findings& findings_;
    std::vector<std::string> known_;
};

}  // namespace overfly::config
