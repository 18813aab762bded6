#include "view/scene_index.h"

#include <fmt/format.h>

namespace gp::tool::view {
namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_number_float()) {
        return fmt::format("{:.4g}", value.get<double>());
    }
    if (!value.is_array()) {
        return value.dump();
    }
    std::string text;
    for (const Json& element : value) {
        text += (text.empty() ? "" : ", ") + textOf(element);
    }
    return text;
}

// Objects within objects become names with a dot.
void flatten(const Json& object, const std::string& prefix, std::vector<Row>& rows) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_object()) {
            flatten(value, prefix + key + ".", rows);
        } else {
            rows.emplace_back(prefix + key, textOf(value));
        }
    }
}

std::string textureText(const Json& textures, const Json& index) {
    const auto number = index.get<std::size_t>();
    if (number >= textures.size()) {
        return fmt::format("texture {}", number);
    }
    const Json& texture = textures[number];
    const std::string name = texture.value("name", "");
    return fmt::format("{} ({}x{})", name.empty() ? fmt::format("texture {}", number) : name,
                       texture.value("width", 0), texture.value("height", 0));
}

// One layer of the library's models, its textures apart.
void addLayer(const Json& layer, std::size_t number, std::vector<Row>& rows) {
    const std::string prefix = number == 0 ? "" : fmt::format("layer {}: ", number);
    if (number > 0) {
        rows.emplace_back(prefix + "model", layer.value("model", ""));
    }
    flatten(layer.value("parameters", Json::object()), prefix, rows);
    for (const char* key : {"file", "weight"}) {
        if (layer.contains(key)) {
            rows.emplace_back(prefix + key, textOf(layer.at(key)));
        }
    }
}

void addMaterial(const Json& material, const Json& textures, PickedThing& thing) {
    thing.materialName = material.value("name", "");
    thing.model = "glTF";
    const Json layers = material.value("layers", Json::array());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (i == 0) {
            thing.model = layers[i].value("model", "");
        }
        addLayer(layers[i], i, thing.parameters);
    }
    Json rest = material;
    for (const char* key : {"name", "layers", "textures"}) {
        rest.erase(key);
    }
    flatten(rest, "", thing.parameters);
    const Json uses = material.value("textures", Json::object());  // items() keeps no temporary
    for (const auto& [use, index] : uses.items()) {
        thing.parameters.emplace_back("texture: " + use, textureText(textures, index));
    }
}

}  // namespace

SceneIndex::SceneIndex(Json description) : m_description(std::move(description)) {}

std::optional<PickedThing> SceneIndex::thingAt(std::uint32_t id) const {
    if (id == 0 || !m_description.contains("instances")) {
        return std::nullopt;
    }
    const Json& instances = m_description.at("instances");  // there may be many: no copies
    if (id > instances.size()) {
        return std::nullopt;
    }
    const Json& instance = instances.at(id - 1);
    const Json& mesh = m_description.at("meshes").at(instance.at("mesh").get<std::size_t>());
    const Json& material =
        instance.contains("material") ? instance.at("material") : mesh.at("material");
    PickedThing thing;
    thing.instance = id - 1;
    thing.instanceName = instance.value("name", "");
    thing.meshName = mesh.value("name", "");
    addMaterial(m_description.at("materials").at(material.get<std::size_t>()),
                m_description.at("textures"), thing);
    return thing;
}

std::size_t SceneIndex::instanceCount() const {
    return m_description.contains("instances") ? m_description.at("instances").size() : 0;
}

std::vector<std::string> SceneIndex::cameras() const {
    std::vector<std::string> names;
    for (const Json& camera : m_description.value("cameras", Json::array())) {
        names.push_back(camera.value("name", ""));
    }
    return names;
}

}  // namespace gp::tool::view
