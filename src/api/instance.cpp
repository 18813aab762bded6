#include <algorithm>
#include <map>

#include "api/check.h"
#include "api/scenes.h"
#include "scene/kept_maps.h"

namespace gp::api {

namespace {

constexpr uint32_t allVisibility = visibleToCamera | visibleToBounce | visibleToShadow;
static_assert(GP_VISIBLE_CAMERA == int(visibleToCamera) &&
              GP_VISIBLE_BOUNCE == int(visibleToBounce) &&
              GP_VISIBLE_SHADOW == int(visibleToShadow));

// Rays and normals go through the inverse, so that must exist and be made of finite floats.
void checkInvertible(const glm::mat4x3& m, const char* field) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]), t(m[3]);
    const double volume = glm::dot(x, glm::cross(y, z));
    const double lengths = glm::length(x) * glm::length(y) * glm::length(z);
    // Below this the three axes lie in a plane as far as floats can tell.
    constexpr double flattest = 1e-9;
    if (!(std::abs(volume) > flattest * lengths) || lengths == 0)
        fail(GP_ERROR_OUT_OF_RANGE, "{} cannot be inverted: its determinant is {:g}", field,
             volume);
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(x, y, z));
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!std::isfinite(float(inverse[c][r])) || !std::isfinite(float((inverse * t)[r])))
                fail(GP_ERROR_OUT_OF_RANGE, "{} has an inverse beyond the range of floats", field);
}

glm::mat4x3 transformFrom(const float* rows, const char* field) {
    checkFinite(rows, 12, field);
    glm::mat4x3 m;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) m[column][row] = rows[row * 4 + column];
    checkInvertible(m, field);
    return m;
}

// A name stands for the bits of the rays that it hides the instance from.
uint32_t visibilityFrom(const GpVisibility& name, uint32_t invisibleTo) {
    constexpr uint32_t hidden[] = {0, visibleToBounce | visibleToShadow, visibleToCamera};
    const uint32_t which = checkEnum(name, 4, "visibility");
    if (invisibleTo & ~allVisibility)
        fail(GP_ERROR_INVALID_ARGUMENT, "invisibleTo has unknown bits: {:#x}", invisibleTo);
    if (which != GP_VISIBILITY_SKY) return allVisibility & ~(hidden[which] | invisibleTo);
    if (invisibleTo != 0)
        fail(GP_ERROR_INVALID_ARGUMENT,
             "invisibleTo is {:#x}, but all rays see what is GP_VISIBILITY_SKY", invisibleTo);
    return visibleToSky;
}

glm::vec4 colorFrom(const float* color) {
    checkRange(color, 4, 0, 1, "color");
    return {vec3From(color), color[3]};
}

std::shared_ptr<Instance> instanceFrom(SceneObject& scene, const GpInstanceDesc& desc) {
    auto instance = std::make_shared<Instance>();
    instance->id = desc.id;
    instance->name = nameOr(desc.name);
    instance->mesh = resolve(*scene.device, desc.mesh, "mesh")->mesh;
    if (desc.material)
        instance->material = resolve(*scene.device, desc.material, "material")->material;
    if (!allZero(desc.worldFromObject, 12))
        instance->worldFromObject = transformFrom(desc.worldFromObject, "worldFromObject");
    instance->visibility = visibilityFrom(desc.visibility, desc.invisibleTo);
    if (!allZero(desc.color, 4)) instance->color = colorFrom(desc.color);
    if (desc.id != 0 && scene.instanceIds.contains(desc.id))
        fail(GP_ERROR_DUPLICATE_ID, "id {} belongs to another instance of the scene", desc.id);
    return instance;
}

// Adds the instance and its handle: all of it or, when memory ends, nothing.
GpInstance addInstance(SceneObject& scene, std::shared_ptr<Instance> instance) {
    auto object = std::make_shared<InstanceObject>(*scene.device);
    object->scene = std::static_pointer_cast<SceneObject>(scene.shared_from_this());
    object->instance = instance;
    const Mesh* mesh = instance->mesh.get();
    const uint64_t id = instance->id;

    scene.scene.instances.push_back(std::move(instance));
    Undo undoList([&] { scene.scene.instances.pop_back(); });
    if (id != 0) scene.instanceIds.insert(id);
    Undo undoId([&] { scene.instanceIds.erase(id); });
    if (mesh->kind == MeshKind::dynamic) countUse(scene, mesh, 1);
    Undo undoUse([&] { countUse(scene, mesh, -1); });
    const GpInstance handle = publish<GpInstance>(std::move(object));
    undoList.keep();
    undoId.keep();
    undoUse.keep();
    ++scene.scene.revision;
    return handle;
}

static_assert(GP_MAP_BASE_COLOR == int(mapBaseColor) && GP_MAP_NORMAL == int(mapNormal) &&
              GP_MAP_SLOPES == int(mapSlopes) && GP_MAP_ALPHA == int(mapAlpha) &&
              GP_MAP_EMISSION == int(mapEmission) && GP_MAP_ROUGHNESS == int(mapRoughness) &&
              GP_MAP_METALLIC == int(mapMetallic) && GP_MAP_OTHERS == int(mapOthers));

// All copies are made before the first instance has another material: memory may end.
GpReplacedMaterials replaceModels(Scene& scene, const char* name, const Material& replacement,
                                  uint32_t keep) {
    GpReplacedMaterials result{};
    std::map<std::shared_ptr<const Material>, std::shared_ptr<const Material>> copies;
    std::vector<Instance*> instances;
    for (const auto& instance : scene.instances) {
        if (instance->ofSea || (name && instance->surface().name != name)) continue;
        instances.push_back(instance.get());
        const std::shared_ptr<const Material> old = instance->surfacePtr();
        if (copies.contains(old)) continue;
        MaterialWithMaps copy = withMapsOf(*old, replacement, keep);
        result.kept |= copy.kept;
        result.left |= copy.left;
        copies[old] = std::make_shared<const Material>(std::move(copy.material));
    }
    for (Instance* instance : instances) instance->material = copies.at(instance->surfacePtr());
    result.instances = uint32_t(instances.size());
    if (result.instances > 0) ++scene.revision;
    return result;
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpInstance gpNewInstance(GpScene scene, const GpInstanceDesc* desc) {
    return enter("gpNewInstance", "scene", scene, [&](SceneObject& s) {
        checkPointer(desc, "desc");
        return addInstance(s, instanceFrom(s, *desc));
    });
}

GpError gpSetInstanceTransform(GpInstance instance, const float* worldFromObject) {
    return enter("gpSetInstanceTransform", "instance", instance, [&](InstanceObject& object) {
        checkPointer(worldFromObject, "worldFromObject");
        const glm::mat4x3 transform = transformFrom(worldFromObject, "worldFromObject");
        if (object.instance->mesh->kind == gp::MeshKind::staticMesh)
            fail(GP_ERROR_INVALID_OPERATION, "the mesh is of kind GP_MESH_STATIC");
        object.instance->worldFromObject = transform;
        ++object.scene->scene.revision;
    });
}

GpError gpSetInstanceMaterial(GpInstance instance, GpMaterial material) {
    return enter("gpSetInstanceMaterial", "instance", instance, [&](InstanceObject& object) {
        object.instance->material =
            material ? resolve(*object.device, material, "material")->material : nullptr;
        ++object.scene->scene.revision;
    });
}

GpError gpSetInstanceColor(GpInstance instance, const float* color) {
    return enter("gpSetInstanceColor", "instance", instance, [&](InstanceObject& object) {
        object.instance->color = color ? colorFrom(color) : glm::vec4(1);
        ++object.scene->scene.revision;
    });
}

GpError gpSetInstanceVisibility(GpInstance instance, GpVisibility visibility,
                                uint32_t invisibleTo) {
    return enter("gpSetInstanceVisibility", "instance", instance, [&](InstanceObject& object) {
        object.instance->visibility = visibilityFrom(visibility, invisibleTo);
        ++object.scene->scene.revision;
    });
}

GpError gpRemoveInstance(GpInstance instance) {
    return enter("gpRemoveInstance", "instance", instance, [&](InstanceObject& object) {
        auto& instances = object.scene->scene.instances;
        const gp::Mesh* mesh = object.instance->mesh.get();
        if (mesh->kind == gp::MeshKind::dynamic) countUse(*object.scene, mesh, -1);
        object.scene->instanceIds.erase(object.instance->id);
        instances.erase(std::find(instances.begin(), instances.end(), object.instance));
        ++object.scene->scene.revision;
        handles().remove(bitsOf(instance));
    });
}

GpError gpReplaceMaterial(GpScene scene, const char* name, GpMaterial material,
                          uint32_t* replaced) {
    return enter("gpReplaceMaterial", "scene", scene, [&](SceneObject& s) {
        const auto replacement = resolve(*s.device, material, "material")->material;
        uint32_t count = 0;
        for (auto& instance : s.scene.instances) {
            if (instance->ofSea || (name && instance->surface().name != name)) continue;
            instance->material = replacement;
            ++count;
        }
        if (count > 0) ++s.scene.revision;
        if (replaced) *replaced = count;
    });
}

GpError gpReplaceMaterialModel(GpScene scene, const char* name, GpMaterial material,
                               uint32_t keep, GpReplacedMaterials* replaced) {
    return enter("gpReplaceMaterialModel", "scene", scene, [&](SceneObject& s) {
        const auto object = resolve(*s.device, material, "material");
        if (object->animated)
            fail(GP_ERROR_INVALID_ARGUMENT, "material is animated: no map could be kept in it");
        if (keep & ~uint32_t(GP_MAP_ALL))
            fail(GP_ERROR_INVALID_ARGUMENT, "keep has unknown bits: {:#x}", keep);
        const GpReplacedMaterials result = replaceModels(s.scene, name, *object->material, keep);
        if (replaced) *replaced = result;
    });
}

GpError gpReleaseInstance(GpInstance instance) {
    return enter("gpReleaseInstance", "instance", instance,
                 [&](InstanceObject&) { handles().remove(bitsOf(instance)); });
}

}  // extern "C"
