#include "config/yaml_text.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

namespace overfly::config {
namespace {

// Aliases can double a document at each level ("billion laughs"). Both limits are far beyond any flight: a million
// values are 100,000 keyframes.
constexpr std::size_t kMaxDepth = 50;
constexpr std::size_t kMaxValues = 1'000'000;

struct Extent {
    std::size_t values = 1, depth = 1;
};

Extent extent_of(const Node& node) {
    Extent whole;
    const auto add = [&whole](const Node& part) {
        const Extent e = extent_of(part);
        whole.values += e.values;
        whole.depth = std::max(whole.depth, 1 + e.depth);
    };
    for (const Node& item : node.items) add(item);
    for (const Node::Entry& entry : node.entries) add(entry.value);
    return whole;
}

// Builds the node from the parser's events, which throw UserError. yaml-cpp's own tree is not used: it follows aliases
// into themselves, and YAML::LoadAll() never ends on a text that starts with a comma.
class NodeBuilder : public YAML::EventHandler {
  public:
    NodeBuilder(const Place& origin, TextOrigin kind)
        : origin_(origin), kind_(kind), document_(Node::nothing(at(YAML::Mark::null_mark()))) {}

    [[nodiscard]] Node take_document() { return std::move(document_); }

    // yaml-cpp counts from 0, and gives -1 where it knows no place.
    [[nodiscard]] Place at(const YAML::Mark& mark) const {
        if (kind_ == TextOrigin::Override) return origin_;
        if (mark.is_null()) return {origin_.file, 1, 1};
        return {origin_.file, mark.line + 1, mark.column + 1};
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0) throw UserError(at(mark), "got more after the end of the document, allowed one document");
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { add(Node::nothing(at(mark)), {}, anchor); }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string& text) override {
        Node node = Node::nothing(at(mark));
        node.kind = Node::Kind::Scalar;
        node.scalar = text;
        add(std::move(node), {}, anchor);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto known = anchored_.find(anchor);
        if (known == anchored_.end()) throw UserError(at(mark), "got an alias inside of what it stands for");
        add(known->second, extent_of(known->second), 0);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(mark, Node::Kind::List, anchor);
    }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(mark, Node::Kind::Mapping, anchor);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapEnd() override { close(); }

  private:
    // A list or mapping whose end is still to come; a mapping's key whose value is still to come.
    struct Open {
        Node node;
        YAML::anchor_t anchor;
        std::optional<Node> key;
    };

    void open(const YAML::Mark& mark, Node::Kind kind, YAML::anchor_t anchor) {
        Node node = Node::nothing(at(mark));
        node.kind = kind;
        limit(node.place, {});
        open_.push_back({std::move(node), anchor, std::nullopt});
    }

    void close() {
        Open done = std::move(open_.back());
        open_.pop_back();
        add(std::move(done.node), {.values = 0, .depth = 1}, done.anchor);
    }

    // Puts a complete node where it belongs. `extent` is what it adds to the document.
    void add(Node node, const Extent& extent, YAML::anchor_t anchor) {
        limit(node.place, extent);
        if (anchor != 0) anchored_.insert_or_assign(anchor, node);
        if (open_.empty()) {
            document_ = std::move(node);
            return;
        }
        Open& parent = open_.back();
        if (parent.node.kind == Node::Kind::List) {
            parent.node.items.push_back(std::move(node));
        } else if (parent.key) {
            parent.node.entries.push_back({parent.key->scalar, parent.key->place, std::move(node)});
            parent.key.reset();
        } else if (node.kind == Node::Kind::Scalar) {
            parent.key = std::move(node);
        } else {
            throw UserError(node.place, fmt::format("got {} as a key, allowed a word", description(node)));
        }
    }

    void limit(const Place& place, const Extent& added) {
        values_ += added.values;
        if (values_ > kMaxValues) throw UserError(place, fmt::format("more than {} values", kMaxValues));
        if (open_.size() + added.depth > kMaxDepth) {
            throw UserError(place, fmt::format("nested more than {} levels deep", kMaxDepth));
        }
    }

    const Place& origin_;
    TextOrigin kind_;
    Node document_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Node> anchored_;
    std::size_t values_ = 0;
    int documents_ = 0;
};

}  // namespace

std::optional<Node> parse_yaml(const std::string& text, const Place& origin, TextOrigin kind,
                               std::vector<Problem>& problems) {
    NodeBuilder builder(origin, kind);
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        // The second round finds the end of the text, or throws.
        while (parser.HandleNextDocument(builder)) {
        }
        return builder.take_document();
    } catch (const YAML::Exception& e) {
        problems.push_back({builder.at(e.mark), "broken YAML: " + on_one_line(e.msg)});
    } catch (const UserError& e) {
        problems.insert(problems.end(), e.problems().begin(), e.problems().end());
    }
    return std::nullopt;
}

}  // namespace overfly::config
