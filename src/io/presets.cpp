#include "io/presets.h"

#include <filesystem>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "io/file.h"
#include "io/presets_data.h"
#include "io/toml_depth.h"
#include "scene/find_by_name.h"

namespace gp::io {

namespace {

constexpr size_t sizeLimit = size_t(1) << 22;  // of a file
constexpr size_t keyPartLimit = 16;
constexpr size_t layerLimit = 17;              // the bottom, and what a material has over it

// What is wrong and where.
[[noreturn]] void failAt(const std::string& path, const toml::source_region& where,
                         const std::string& what) {
    throw FileError(FileError::Kind::invalid, fmt::format("{}:{}", path, where.begin.line), what);
}

class Reader {
public:
    Reader(const std::string& path, const std::vector<Preset>* builtIn)
        : path_(path), builtIn_(builtIn) {}

    std::vector<Preset> read(const toml::table& file) {
        // In the order of the lines, which a table's is not: a preset may use those above it.
        std::vector<std::pair<std::string, const toml::node*>> entries;
        for (const auto& [key, node] : file) entries.emplace_back(std::string(key.str()), &node);
        std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
            return a.second->source().begin.line < b.second->source().begin.line;
        });
        for (const auto& [name, node] : entries) {
            const toml::table* table = node->as_table();
            if (!table) fail(*node, "{} is no table; a preset is one: [{}]", name, name);
            presets_.push_back(presetFrom(name, *table));
        }
        return std::move(presets_);
    }

private:
    template <class... Args>
    [[noreturn]] void fail(const toml::node& node, fmt::format_string<Args...> format,
                           Args&&... args) const {
        failAt(path_, node.source(), fmt::format(format, std::forward<Args>(args)...));
    }

    std::string stringOf(const toml::table& table, std::string_view key) const {
        const toml::node* node = table.get(key);
        if (!node) return {};
        if (!node->is_string()) fail(*node, "{} is no string", key);
        return **node->as_string();
    }

    void checkKeys(const toml::table& table, const std::vector<std::string>& known) const {
        for (const auto& [key, node] : table) {
            const std::string word(key.str());
            if (std::find(known.begin(), known.end(), word) != known.end()) continue;
            try {
                throwUnknown("key", word, known);
            } catch (const BsdfError& error) {
                fail(node, "{}", error.what());
            }
        }
    }

    Preset presetFrom(const std::string& name, const toml::table& table) const {
        checkKeys(table, {"title", "group", "reference", "model", "preset", "set", "layers"});
        Preset preset;
        preset.name = name;
        preset.title = stringOf(table, "title");
        preset.group = stringOf(table, "group");
        preset.reference = stringOf(table, "reference");
        const toml::node* layers = table.get("layers");
        if (!layers) {
            preset.layers.push_back({bsdfFrom(name, table), 1, {}, 0});
            return preset;
        }
        if (table.contains("model") || table.contains("preset") || table.contains("set"))
            fail(table, "{} has layers, so model, preset and set belong into them", name);
        const toml::array* list = layers->as_array();
        if (!list || list->empty()) fail(*layers, "{}: layers is no list of tables", name);
        if (list->size() > layerLimit)
            fail(*layers, "{} has {} layers, more than {}", name, list->size(), layerLimit);
        for (const toml::node& node : *list) addLayer(preset, node);
        return preset;
    }

    void addLayer(Preset& preset, const toml::node& node) const {
        const toml::table* table = node.as_table();
        if (!table) fail(node, "{}: a layer is a table: {{ preset = … }}", preset.name);
        checkKeys(*table, {"model", "preset", "set", "weight", "mask", "channel"});
        PresetLayer layer{bsdfFrom(preset.name, *table), 1, {}, 0};
        if (const toml::node* weight = table->get("weight")) {
            const auto value = weight->value<double>();
            if (!value || !(*value >= 0 && *value <= 1))
                fail(*weight, "{}: weight is no number from 0 to 1", preset.name);
            layer.weight = float(*value);
        }
        if (const std::string mask = stringOf(*table, "mask"); !mask.empty())
            layer.maskPath = (std::filesystem::path(path_).parent_path() / mask).string();
        if (const std::string channel = stringOf(*table, "channel"); !channel.empty()) {
            const size_t index = std::string_view("rgba").find(channel);
            if (channel.size() != 1 || index == std::string_view::npos)
                fail(*table->get("channel"), "{}: channel is '{}', not r, g, b or a", preset.name,
                     channel);
            layer.channel = uint32_t(index);
        }
        if (preset.layers.empty()) {
            if (layer.weight != 1 || !layer.maskPath.empty())
                fail(node, "{}: the bottom layer has no weight and no mask", preset.name);
        } else if (const std::string why = whyNotBlended(preset.layers[0].bsdf, layer.bsdf);
                   !why.empty()) {
            fail(node, "{}: {}", preset.name, why);
        }
        preset.layers.push_back(std::move(layer));
    }

    // `model` or `preset`, with `set` over it.
    BsdfSettings bsdfFrom(const std::string& name, const toml::table& table) const {
        const std::string model = stringOf(table, "model"), base = stringOf(table, "preset");
        if (model.empty() == base.empty())
            fail(table, "{}: either model or preset says what it is made from", name);
        try {
            BsdfSettings settings =
                base.empty() ? BsdfSettings(findBsdfModel(model)) : flattened(find(base));
            if (settings.model->fromFile)
                fail(table, "{}: {} is made from a file, not from parameters", name, model);
            if (const toml::node* set = table.get("set")) {
                const toml::table* words = set->as_table();
                if (!words) fail(*set, "{}: set is no table", name);
                for (const auto& [key, value] : *words)
                    settings.set(std::string(key.str()), wordOf(value));
            }
            return settings;
        } catch (const BsdfError& error) {
            fail(table, "{}: {}", name, error.what());
        }
    }

    // As people write it on the command line.
    std::string wordOf(const toml::node& node) const {
        if (node.is_string()) return **node.as_string();
        if (node.is_boolean()) return **node.as_boolean() ? "true" : "false";
        if (const auto number = node.value<double>()) return fmt::format("{}", *number);
        std::string words;
        const toml::array* list = node.as_array();
        if (!list) fail(node, "a value is a number, a string, true, false or a list of numbers");
        for (const toml::node& part : *list) {
            const auto number = part.value<double>();
            if (!number) fail(part, "a list holds numbers");
            words += (words.empty() ? "" : ",") + fmt::format("{}", *number);
        }
        return words;
    }

    const Preset& find(const std::string& name) const {
        std::vector<std::string> names;
        for (const auto* list : {&presets_, builtIn_}) {
            if (!list) continue;
            for (const Preset& preset : *list) {
                if (preset.name == name) return preset;
                names.push_back(preset.name);
            }
        }
        throwUnknown("preset", name, names);
    }

    const std::string& path_;
    const std::vector<Preset>* builtIn_;
    std::vector<Preset> presets_;
};

std::vector<Preset> parse(std::string_view text, const std::string& path,
                          const std::vector<Preset>* builtIn) {
    if (const size_t line = lineWithLongKey(text, keyPartLimit))
        throw FileError(FileError::Kind::invalid, fmt::format("{}:{}", path, line),
                        fmt::format("a key of more than {} parts", keyPartLimit));
    try {
        return Reader(path, builtIn).read(toml::parse(text, path));
    } catch (const toml::parse_error& error) {
        failAt(path, error.source(), std::string(error.description()));
    }
}

}  // namespace

const std::vector<Preset>& builtInPresets() {
    static const std::vector<Preset> all = [] {
        std::vector<Preset> presets;
        for (const PresetText& file : presetTexts()) {
            std::vector<Preset> some = parse(file.text, file.name, &presets);
            presets.insert(presets.end(), std::make_move_iterator(some.begin()),
                           std::make_move_iterator(some.end()));
        }
        return presets;
    }();
    return all;
}

std::vector<Preset> parsePresets(std::string_view text, const std::string& path) {
    return parse(text, path, &builtInPresets());
}

std::vector<Preset> readPresets(const std::string& path) {
    const std::vector<std::byte> bytes = readFile(path);
    if (bytes.size() > sizeLimit)
        throw FileError(FileError::Kind::invalid, path,
                        fmt::format("{} bytes are no file of presets (at most {})", bytes.size(),
                                    sizeLimit));
    return parsePresets({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

BsdfSettings flattened(const Preset& preset) {
    BsdfSettings settings = preset.layers[0].bsdf;
    for (size_t i = 1; i < preset.layers.size(); ++i) {
        const PresetLayer& layer = preset.layers[i];
        if (!layer.maskPath.empty())
            throw BsdfError(fmt::format("{} has a mask ({}): it is a material of scenes, not one "
                                        "set of parameters", preset.name, layer.maskPath));
        settings = blended(settings, layer.bsdf, layer.weight);
    }
    return settings;
}

}  // namespace gp::io
