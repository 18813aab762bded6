#include "api/check.h"
#include "api/scenes.h"

namespace gp::api {

namespace {

constexpr uint32_t elementLimit = 1u << 28;  // of vertices and of indices

static_assert(GP_MESH_STATIC == int(MeshKind::staticMesh) &&
              GP_MESH_MOVABLE == int(MeshKind::movable) &&
              GP_MESH_DYNAMIC == int(MeshKind::dynamic));

// Copies `count` elements that stand `stride` bytes apart. Byte by byte: strides may leave floats
// where a float must not stand.
template <class T>
std::vector<T> copyStrided(const void* source, uint32_t count, size_t stride, const char* field) {
    std::vector<T> result;
    if (!source) return result;
    if (stride == 0) stride = sizeof(T);
    if (stride < sizeof(T))
        fail(GP_ERROR_OUT_OF_RANGE, "{} is {}, but an element has {} bytes", field, stride,
             sizeof(T));
    if (stride > size_t(PTRDIFF_MAX) / count)
        fail(GP_ERROR_TOO_LARGE, "{} is {}, too large for {} vertices", field, stride, count);
    result.resize(count);
    const std::byte* bytes = static_cast<const std::byte*>(source);
    if (stride == sizeof(T)) {
        std::memcpy(result.data(), bytes, sizeof(T) * count);
        return result;
    }
    for (size_t i = 0; i < count; ++i) std::memcpy(&result[i], bytes + i * stride, sizeof(T));
    return result;
}

// Every component finite, or the message names the first vertex that is not.
template <class T>
void checkVertices(const std::vector<T>& values, const char* field) {
    constexpr int components = T::length();
    for (size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < components; ++c)
            if (!std::isfinite(values[i][c]))
                fail(GP_ERROR_NOT_FINITE, "{}[{}][{}] is {}", field, i, c, values[i][c]);
}

void checkCounts(const GpMeshDesc& desc) {
    if (desc.vertexCount == 0) fail(GP_ERROR_INVALID_ARGUMENT, "vertexCount is 0");
    if (desc.vertexCount > elementLimit)
        fail(GP_ERROR_TOO_LARGE, "vertexCount is {}, more than 2^28", desc.vertexCount);
    if (desc.indexCount > elementLimit)
        fail(GP_ERROR_TOO_LARGE, "indexCount is {}, more than 2^28", desc.indexCount);
    checkPointer(desc.positions, "positions");
    if (desc.indices && desc.indexCount == 0) fail(GP_ERROR_INVALID_ARGUMENT, "indexCount is 0");
    if (!desc.indices && desc.indexCount != 0)
        fail(GP_ERROR_INVALID_ARGUMENT, "indices is NULL, but indexCount is {}", desc.indexCount);
    const uint32_t corners = desc.indices ? desc.indexCount : desc.vertexCount;
    if (corners % 3 != 0)
        fail(GP_ERROR_INVALID_ARGUMENT, "{} is {}, not a multiple of 3",
             desc.indices ? "indexCount" : "vertexCount", corners);
}

MeshData dataFrom(const GpMeshDesc& desc) {
    checkCounts(desc);
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
    if (desc.indices) data.indices.assign(desc.indices, desc.indices + desc.indexCount);
    for (size_t i = 0; i < data.indices.size(); ++i)
        if (data.indices[i] >= count)
            fail(GP_ERROR_OUT_OF_RANGE, "indices[{}] is {}, but vertexCount is {}", i,
                 data.indices[i], count);
    return data;
}

// An instance may bring another material, with a normal map where the mesh's has none, so tangents
// are generated wherever coordinates say which way they run.
MeshOptions optionsFor(const Material& material, const MeshData& data) {
    MeshOptions options;
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
    const MeshOptions options = optionsFor(*mesh.material, data);
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

GpError gpReleaseMesh(GpMesh mesh) {
    return enter("gpReleaseMesh", "mesh", mesh,
                 [&](MeshObject&) { handles().remove(bitsOf(mesh)); });
}

}  // extern "C"
