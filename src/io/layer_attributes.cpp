#include "io/layer_attributes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "film/cryptomatte.h"

namespace overfly {
namespace {

std::string meanings(const FrameHeader& header) {
    std::string text = header.is_of_a_layer ? "" : fmt::format("Z: {}\n", kDepthMeaning);
    for (const LayerKind& kind : kinds_of(header.layers)) {
        if (!header.layer_files.has(kind.layer))
            text += fmt::format("{}: {}\n", fmt::join(kind.channels, " "), kind.meaning);
    }
    return text;
}

// Cryptomatte 1.2.0, section "Metadata". Of a file that has the layer: tools look for its channels then.
void append_cryptomatte(std::vector<FrameAttribute>& attributes, const std::string& manifest) {
    const std::string prefix = fmt::format("cryptomatte/{}/", cryptomatte_key());
    attributes.push_back({prefix + "name", std::string(kCryptomatteType)});
    attributes.push_back({prefix + "hash", std::string("MurmurHash3_32")});
    attributes.push_back({prefix + "conversion", std::string("uint32_to_float32")});
    attributes.push_back({prefix + "manifest", manifest});
}

}  // namespace

void append_layers(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({kLayersAttribute, meanings(header)});
    if (!header.layer_files.empty())
        attributes.push_back({kLayerFilesAttribute, fmt::format("{}", fmt::join(names_of(header.layer_files), " "))});
    if (!header.layers.has_any({Layer::Id, Layer::Cryptomatte})) return;
    const std::string manifest = cryptomatte_manifest(header.objects);
    attributes.push_back({kObjectsAttribute, manifest});
    if (header.layers.has(Layer::Cryptomatte) && !header.layer_files.has(Layer::Cryptomatte))
        append_cryptomatte(attributes, manifest);
}

std::string cryptomatte_manifest(std::span<const std::string> names) {
    nlohmann::json manifest = nlohmann::json::object();
    for (const std::string& name : names) manifest[name] = cryptomatte_hex(cryptomatte_id(name));
    return manifest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace overfly
