// From the parts of a glTF file to a scene. Everything is built aside and appended at the end, so
// that an error leaves the scene as it was.
#include "io/gltf.h"

#include <cmath>
#include <filesystem>

#include <glm/gtc/quaternion.hpp>

#include "io/gltf_light.h"
#include "io/gltf_player.h"
#include "scene/hash.h"

namespace gp::io {

namespace {

// The same file gives the same ids in every run; a second copy of it in a scene gets others.
uint64_t seedOf(const std::string& path, const Scene& scene) {
    const std::string name = std::filesystem::path(path).filename().string();
    uint64_t copies = 0;
    for (const std::string& source : scene.sources)
        copies += std::filesystem::path(source).filename().string() == name;
    return hashBytes(name.data(), name.size(), copies);
}

glm::mat4 trs(glm::vec3 t, glm::vec4 xyzw, glm::vec3 s) {
    const glm::quat q(xyzw.w, xyzw.x, xyzw.y, xyzw.z);
    const float length = glm::length(q);
    glm::mat4 m = length > 0 && std::isfinite(length) ? glm::mat4_cast(q / length) : glm::mat4(1);
    for (int i = 0; i < 3; ++i) m[i] *= s[i];
    m[3] = glm::vec4(t, 1);
    return m;
}

class Loader {
public:
    Loader(const std::string& path, const GltfOptions& options, const Scene& target)
        : m_options(options), m_document(path), m_accessors(m_document),
          m_materials(m_document, options.maxImagePixels), m_seed(seedOf(path, target)),
          m_meshes(m_document, m_accessors, m_materials, m_seed, options.playable),
          m_firstCamera(target.cameras.size()) {}

    Scene load() {
        m_nodes = readNodes(m_document);
        m_scene.animations = listAnimations(m_document, m_nodes);
        identifyNodes(m_nodes, m_seed);
        if (m_options.playable) m_parts.restNodes = m_nodes;
        animate();
        placeNodes(m_document.path(), parentsFirst(m_nodes), m_nodes);
        for (const uint32_t i : nodesOfScene(m_document, m_nodes, m_options.scene)) addNode(i);
        m_materials.loadTextures();
        refuseHugeBounds();
        m_scene.sources.push_back(m_document.path());
        m_scene.warnings = m_document.takeWarnings();
        return std::move(m_scene);
    }

    // After load(), where the options asked for it.
    std::shared_ptr<GltfPlayer> player() {
        m_parts.path = m_document.path();
        m_parts.deformables = m_meshes.takeDeformables();
        return std::make_shared<GltfPlayer>(std::move(m_parts));
    }

private:
    // Squares of lengths must fit in a float, with room for what a tracer adds.
    void refuseHugeBounds() const {
        constexpr float most = 1e18f;
        const Bounds b = worldBounds(m_scene);
        if (b.empty()) return;
        for (int c = 0; c < 3; ++c)
            if (!(b.lo[c] >= -most && b.hi[c] <= most))
                m_document.root().fail("the scene is too large: it reaches beyond 1e18 m");
    }

    void animate() {
        const size_t count = m_scene.animations.size();
        requireAnimation(m_document.path(), m_options.animation, count);
        for (uint32_t i = 0; i < count; ++i) {
            const bool plays = m_options.animation == allAnimations ||
                               i == static_cast<uint32_t>(std::max(m_options.animation, 0));
            if (!plays && !m_options.playable) continue;
            Animation a = readAnimation(m_document, m_accessors, i, m_nodes);
            if (plays) poseNodes(a, m_options.time, m_nodes);
            if (m_options.playable) m_parts.animations.push_back(std::move(a));
        }
    }

    void addNode(uint32_t i) {
        const Node& node = m_nodes[i];
        if (node.camera) {
            if (node.moves) m_parts.cameras.emplace_back(i, m_firstCamera + m_scene.cameras.size());
            m_scene.cameras.push_back(readCamera(m_document, node));
        }
        if (node.light) {
            m_scene.lights.push_back(readLight(m_document, node));
            if (node.moves) m_parts.lights.emplace_back(i, m_scene.lights.back());
        }
        if (!node.mesh) return;
        const std::vector<Meshes::Shown> shown = m_meshes.show(i, m_nodes);
        // A skin places its vertices in the world by itself. (glTF 2.0, 3.7.3.3)
        const glm::mat4 world = node.skin ? glm::mat4(1) : node.worldFromNode;
        const std::vector<glm::mat4> copies = copiesOf(i);
        for (const Meshes::Shown& s : shown)
            for (size_t c = 0; c < copies.size(); ++c) {
                addInstance(i, s, world * copies[c], c);
                if (m_options.playable && node.moves && !node.skin)
                    m_parts.instances.push_back({i, copies[c], m_scene.instances.back()});
            }
    }

    // EXT_mesh_gpu_instancing: where the copies stand, seen from the node.
    std::vector<glm::mat4> copiesOf(uint32_t node) {
        const auto e = m_document.element("nodes", node).extension("EXT_mesh_gpu_instancing");
        if (!e) return {glm::mat4(1)};
        const Value attributes = (*e)["attributes"];
        const auto t = attributes.index("TRANSLATION", "accessors");
        const auto r = attributes.index("ROTATION", "accessors");
        const auto s = attributes.index("SCALE", "accessors");
        if (!t && !r && !s) attributes.fail("has neither TRANSLATION, ROTATION nor SCALE");
        std::vector<glm::vec3> translations, scales;
        std::vector<glm::vec4> rotations;
        if (t) translations = m_accessors.vec3s(*t);
        if (r) rotations = m_accessors.vec4s(*r, Integers::fractions);
        if (s) scales = m_accessors.vec3s(*s);
        const size_t count = t ? translations.size() : r ? rotations.size() : scales.size();
        if (!t) translations.assign(count, glm::vec3(0));
        if (!r) rotations.assign(count, glm::vec4(0, 0, 0, 1));
        if (!s) scales.assign(count, glm::vec3(1));
        if (translations.size() != count || rotations.size() != count || scales.size() != count)
            attributes.fail("the accessors have different counts");
        std::vector<glm::mat4> copies(count);
        for (size_t i = 0; i < count; ++i)
            copies[i] = trs(translations[i], rotations[i], scales[i]);
        return copies;
    }

    void addInstance(uint32_t nodeIndex, const Meshes::Shown& shown, const glm::mat4& world,
                     uint64_t copy) {
        const Node& node = m_nodes[nodeIndex];
        const Value where = m_document.element("nodes", nodeIndex);
        m_document.budget().spend(sizeof(Instance) + 64, where);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r)
                if (!std::isfinite(world[c][r])) where.fail("its transform is not finite");
        auto instance = std::make_shared<Instance>();
        const uint64_t key[2] = {shown.primitive, copy};
        instance->id = hashBytes(key, sizeof key, node.pathHash);
        instance->name = node.name.empty() ? shown.mesh->name : node.name;
        instance->mesh = shown.mesh;
        instance->worldFromObject = glm::mat4x3(world);
        m_scene.instances.push_back(std::move(instance));
    }

    GltfOptions m_options;
    Document m_document;
    Accessors m_accessors;
    Materials m_materials;
    uint64_t m_seed;
    Meshes m_meshes;
    size_t m_firstCamera;  // that of the file, among those of the scene
    std::vector<Node> m_nodes;
    Scene m_scene;
    GltfPlayer::Parts m_parts;
};

template <typename T>
void append(std::vector<T>& to, std::vector<T>&& from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

std::shared_ptr<GltfPlayer> loadGltf(const std::string& path, const GltfOptions& options,
                                     Scene& scene) {
    Loader loader(path, options, scene);
    Scene loaded = loader.load();
    std::shared_ptr<GltfPlayer> player = options.playable ? loader.player() : nullptr;
    scene.instances.reserve(scene.instances.size() + loaded.instances.size());
    scene.lights.reserve(scene.lights.size() + loaded.lights.size());
    append(scene.instances, std::move(loaded.instances));
    append(scene.lights, std::move(loaded.lights));
    append(scene.cameras, std::move(loaded.cameras));
    append(scene.sources, std::move(loaded.sources));
    append(scene.animations, std::move(loaded.animations));
    append(scene.warnings, std::move(loaded.warnings));
    ++scene.revision;
    return player;
}

}  // namespace gp::io
