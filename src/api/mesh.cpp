#include "api/arrays.h"
#include "api/scenes.h"

namespace gp::api {

namespace {

constexpr uint32_t elementExponent = 28;  // at most 2^28 vertices, and as many indices

static_assert(GP_MESH_STATIC == int(MeshKind::staticMesh) &&
              GP_MESH_MOVABLE == int(MeshKind::movable) &&
              GP_MESH_DYNAMIC == int(MeshKind::dynamic));

MeshData dataFrom(const GpMeshDesc& desc) {
    checkCounts(desc, elementExponent, elementExponent);
    const uint32_t count = desc.vertexCount;
    MeshData data;
    data.positions = copyStrided<glm::vec3>(desc.positions, count, desc.positionStride,
                                            "positionStride");
    data.normals = copyStrided<glm::vec3>(desc.normals, count, desc.normalStride, "normalStride");
    data.tangents = copyStrided<glm::vec4>(desc.tangents, count, desc.tangentStride,
                                           "tangentStride");
    data.uv[0] = copyStrided<glm::vec2>(desc.texCoords[0], count, desc.texCoordStride[0],
                                        "texCoordStride[0]");
    data.uv[1] = copyStrided<glm::vec2>(desc.texCoords[1], count, desc.texCoordStride[1],
                                        "texCoordStride[1]");
    data.colors = copyStrided<glm::vec4>(desc.colors, count, desc.colorStride, "colorStride");
    checkVertices(data.positions, "positions");
    checkVertices(data.normals, "normals");
    checkVertices(data.tangents, "tangents");
    checkVertices(data.uv[0], "texCoords[0]");
    checkVertices(data.uv[1], "texCoords[1]");
    if (!data.colors.empty()) checkRange(&data.colors[0].x, data.colors.size() * 4, 0, 1, "colors");
    data.indices = indicesFrom(desc);
    return data;
}

// An instance may bring another material, with a normal map where the mesh's has none, so tangents
// are generated wherever coordinates say which way they run.
MeshOptions optionsFor(const Material& material, const MeshData& data) {
    MeshOptions options;
    options.updatable = true;
    for (const TextureUse* use : {&material.anisotropyTexture, &material.normalTexture}) {
        if (!use->texture) continue;
        options.tangentUv = use->texCoord;
        options.uvTransform = use->uvTransform;
    }
    const bool used = material.normalTexture.texture || material.coatNormalTexture.texture ||
                      material.anisotropy > 0;
    options.needsTangents = used || !data.uv[0].empty();
    return options;
}

void fill(Mesh& mesh, const GpMeshDesc& desc) {
    MeshData data = dataFrom(desc);
    const MeshOptions options = optionsFor(mesh.material->shown(), data);
    fillMesh(mesh, std::move(data), options);
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpMesh gpNewMesh(GpDevice device, const GpMeshDesc* desc) {
    return enter("gpNewMesh", "device", device, [&](DeviceObject& d) {
        checkPointer(desc, "desc");
        auto object = std::make_shared<MeshObject>(d);
        object->mesh = std::make_shared<gp::Mesh>();
        gp::Mesh& mesh = *object->mesh;
        mesh.id = desc->id;
        mesh.name = nameOr(desc->name);
        mesh.kind = gp::MeshKind(checkEnum(desc->kind, 3, "kind"));
        mesh.material = desc->material ? resolve(d, desc->material, "material")->material
                                       : d.defaultMaterial;
        fill(mesh, *desc);
        return publish<GpMesh>(object);
    });
}

GpError gpUpdateMesh(GpMesh mesh, const GpMeshDesc* desc) {
    return enter("gpUpdateMesh", "mesh", mesh, [&](MeshObject& object) {
        checkPointer(desc, "desc");
        gp::Mesh& target = *object.mesh;
        if (target.kind != gp::MeshKind::dynamic)
            fail(GP_ERROR_INVALID_OPERATION, "the mesh is not of kind GP_MESH_DYNAMIC");
        // Into a mesh of its own first, so that a failure leaves the old vertices.
        gp::Mesh fresh;
        fresh.material = target.material;
        fill(fresh, *desc);
        exchangeVertices(target, fresh);
        meshChanged(*object.device, target);
    });
}

GpError gpUpdateTexCoords(GpMesh mesh, uint32_t set, const float* uv, size_t stride) {
    return enter("gpUpdateTexCoords", "mesh", mesh, [&](MeshObject& object) {
        if (set > 1) fail(GP_ERROR_OUT_OF_RANGE, "set is {}, but only 0 and 1 exist", set);
        gp::Mesh& target = *object.mesh;
        const auto given =
            copyStrided<glm::vec2>(uv, uint32_t(target.givenCount), stride, "stride");
        checkVertices(given, "uv");
        gp::updateTexCoords(target, set, given);
        texCoordsChanged(*object.device, target);
    });
}

GpError gpReleaseMesh(GpMesh mesh) {
    return enter("gpReleaseMesh", "mesh", mesh,
                 [&](MeshObject&) { handles().remove(bitsOf(mesh)); });
}

}  // extern "C"
