#include "io/bsdf_source.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/merl.h"
#include "scene/find_by_name.h"

namespace gp::io {

namespace {

template <class List>
const typename List::value_type* findIn(const List& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const auto& entry) { return entry.name == name; });
    return found == list.end() ? nullptr : &*found;
}

std::vector<std::string> namesOf(const std::vector<Preset>& presets) {
    std::vector<std::string> names;
    for (const Preset& preset : presets) names.push_back(preset.name);
    return names;
}

// FILE.toml or FILE.toml#NAME.
Preset presetOfFile(const std::string& path, const std::string& name) {
    const std::vector<Preset> all = readPresets(path);
    if (name.empty()) {
        if (all.size() == 1) return all[0];
        throw FileError(FileError::Kind::invalid, path,
                        fmt::format("{} presets: say which, as {}#NAME", all.size(), path));
    }
    if (const Preset* preset = findIn(all, name)) return *preset;
    try {
        throwUnknown("preset", name, namesOf(all));
    } catch (const BsdfError& error) {
        throw FileError(FileError::Kind::invalid, path, error.what());
    }
}

Preset layerOf(BsdfSettings settings) {
    Preset preset;
    preset.name = settings.model->name;
    preset.layers.push_back({std::move(settings), 1, {}, 0});
    return preset;
}

}  // namespace

Preset stackFromName(const std::string& name) {
    const size_t hash = name.rfind('#');
    const std::string path = name.substr(0, hash);
    if (path.ends_with(".toml"))
        return presetOfFile(path, hash == std::string::npos ? "" : name.substr(hash + 1));
    if (isMerlName(name)) {
        BsdfSettings settings(findBsdfModel("measured"));
        settings.measured = readMerl(name);
        return layerOf(std::move(settings));
    }
    if (const BsdfModelInfo* model = findIn(bsdfModels(), name)) {
        if (model->fromFile)
            throw BsdfError(fmt::format("{}: this model is made from a file, whose path is then "
                                        "the model's name (FILE.binary)", name));
        return layerOf(BsdfSettings(*model));
    }
    if (const Preset* preset = findIn(builtInPresets(), name)) return *preset;
    std::vector<std::string> names = namesOf(builtInPresets());
    for (const BsdfModelInfo& model : bsdfModels()) names.push_back(model.name);
    throwUnknown("model", name, names);
}

BsdfSettings bsdfFromName(BsdfDialect dialect, const std::string& name, const BsdfWords& words) {
    if (dialect != BsdfDialect::own && !isMerlName(name))
        return bsdfFromWords(dialect, name, words);
    BsdfSettings settings = flattened(stackFromName(name));
    for (const auto& [parameter, text] : words) settings.set(parameter, text);
    return settings;
}

}  // namespace gp::io
