#include <cstdint>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

using Change = void (*)(World&, GpMeshDesc&);

// The same mistake in a new mesh and in new vertices for an old one.
void add(Rows& rows, const char* what, GpError expected, const char* message, Change change) {
    const auto descOf = [change](World& w) {
        GpMeshDesc desc = triangleDesc(GP_MESH_DYNAMIC);
        change(w, desc);
        return desc;
    };
    rows.push_back({"gpNewMesh", what, expected, message, [descOf](World& w) {
                        const GpMeshDesc desc = descOf(w);
                        return made(gpNewMesh(w.device, &desc));
                    }});
    rows.push_back({"gpUpdateMesh", what, expected, message, [descOf](World& w) {
                        const GpMeshDesc desc = descOf(w);
                        return gpUpdateMesh(w.dynamicMesh, &desc);
                    }});
}

void addNew(Rows& rows, const char* what, GpError expected, const char* message, Change change) {
    rows.push_back({"gpNewMesh", what, expected, message, [change](World& w) {
                        GpMeshDesc desc = triangleDesc(GP_MESH_STATIC);
                        change(w, desc);
                        return made(gpNewMesh(w.device, &desc));
                    }});
}

void addCountRows(Rows& rows) {
    add(rows, "no vertices", GP_ERROR_INVALID_ARGUMENT, "vertexCount is 0",
        [](World&, GpMeshDesc& d) { d.vertexCount = 0; });
    add(rows, "too many vertices", GP_ERROR_TOO_LARGE, "vertexCount is 268435457",
        [](World&, GpMeshDesc& d) { d.vertexCount = (1u << 28) + 1; });
    add(rows, "too many indices", GP_ERROR_TOO_LARGE, "indexCount is 4294967295",
        [](World&, GpMeshDesc& d) {
            static const uint32_t one = 0;
            d.indices = &one;
            d.indexCount = UINT32_MAX;
        });
    add(rows, "no positions", GP_ERROR_INVALID_ARGUMENT, "positions is NULL",
        [](World&, GpMeshDesc& d) { d.positions = nullptr; });
    add(rows, "two vertices", GP_ERROR_INVALID_ARGUMENT, "vertexCount is 2, not a multiple of 3",
        [](World&, GpMeshDesc& d) { d.vertexCount = 2; });
    add(rows, "four indices", GP_ERROR_INVALID_ARGUMENT, "indexCount is 4, not a multiple of 3",
        [](World&, GpMeshDesc& d) {
            static const uint32_t four[] = {0, 1, 2, 0};
            d.indices = four;
            d.indexCount = 4;
        });
    add(rows, "an index count without indices", GP_ERROR_INVALID_ARGUMENT, "indices is NULL",
        [](World&, GpMeshDesc& d) { d.indexCount = 3; });
    add(rows, "indices without a count", GP_ERROR_INVALID_ARGUMENT, "indexCount is 0",
        [](World&, GpMeshDesc& d) {
            static const uint32_t three[] = {0, 1, 2};
            d.indices = three;
        });
    add(rows, "an index past the end", GP_ERROR_OUT_OF_RANGE,
        "indices[4] is 3, but vertexCount is 3", [](World&, GpMeshDesc& d) {
            static const uint32_t six[] = {0, 1, 2, 0, 3, 1};
            d.indices = six;
            d.indexCount = 6;
        });
}

void addValueRows(Rows& rows) {
    add(rows, "a position that is NaN", GP_ERROR_NOT_FINITE, "positions[1][2] is nan",
        [](World&, GpMeshDesc& d) {
            static const float positions[9] = {0, 0, 0, 1, 0, nan, 0, 1, 0};
            d.positions = positions;
        });
    add(rows, "a position that is infinite", GP_ERROR_NOT_FINITE, "positions[2][0] is -inf",
        [](World&, GpMeshDesc& d) {
            static const float positions[9] = {0, 0, 0, 1, 0, 0, -inf, 1, 0};
            d.positions = positions;
        });
    add(rows, "a normal that is NaN", GP_ERROR_NOT_FINITE, "normals[0][1]",
        [](World&, GpMeshDesc& d) {
            static const float normals[9] = {0, nan, 1, 0, 0, 1, 0, 0, 1};
            d.normals = normals;
        });
    add(rows, "a tangent that is NaN", GP_ERROR_NOT_FINITE, "tangents[2][3]",
        [](World&, GpMeshDesc& d) {
            static const float tangents[12] = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, nan};
            d.tangents = tangents;
        });
    add(rows, "a coordinate that is infinite", GP_ERROR_NOT_FINITE, "texCoords[1][2][1] is inf",
        [](World&, GpMeshDesc& d) {
            static const float uv[6] = {0, 0, 1, 0, 0, inf};
            d.texCoords[1] = uv;
        });
    add(rows, "a colour above 1", GP_ERROR_OUT_OF_RANGE, "colors[4] is 1.5",
        [](World&, GpMeshDesc& d) {
            static const float colors[12] = {1, 1, 1, 1, 1.5f, 1, 1, 1, 1, 1, 1, 1};
            d.colors = colors;
        });
    add(rows, "a colour that is NaN", GP_ERROR_NOT_FINITE, "colors[11]",
        [](World&, GpMeshDesc& d) {
            static const float colors[12] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, nan};
            d.colors = colors;
        });
    add(rows, "a stride below an element", GP_ERROR_OUT_OF_RANGE, "positionStride is 8",
        [](World&, GpMeshDesc& d) { d.positionStride = 8; });
    add(rows, "a stride that overflows", GP_ERROR_TOO_LARGE, "positionStride",
        [](World&, GpMeshDesc& d) { d.positionStride = SIZE_MAX / 2; });
    add(rows, "a coordinate stride that overflows", GP_ERROR_TOO_LARGE, "texCoordStride[0]",
        [](World&, GpMeshDesc& d) {
            d.texCoords[0] = trianglePositions;
            d.texCoordStride[0] = SIZE_MAX;
        });
}

}  // namespace

Rows meshRows() {
    Rows rows = {
        {"gpNewMesh", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewMesh(w.device, nullptr)); }},
        {"gpUpdateMesh", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return gpUpdateMesh(w.dynamicMesh, nullptr); }},
        {"gpUpdateMesh", "a static mesh", GP_ERROR_INVALID_OPERATION, "GP_MESH_DYNAMIC",
         [](World& w) {
             const GpMeshDesc desc = triangleDesc(GP_MESH_DYNAMIC);
             return gpUpdateMesh(w.staticMesh, &desc);
         }},
        {"gpUpdateMesh", "a movable mesh", GP_ERROR_INVALID_OPERATION, "GP_MESH_DYNAMIC",
         [](World& w) {
             const GpMeshDesc desc = triangleDesc(GP_MESH_DYNAMIC);
             return gpUpdateMesh(w.mesh, &desc);
         }},
        {"gpNewMesh", "a descriptor of zeros", GP_ERROR_INVALID_ARGUMENT, "vertexCount is 0",
         [](World& w) {
             const GpMeshDesc zeros{};
             return made(gpNewMesh(w.device, &zeros));
         }},
    };
    addCountRows(rows);
    addValueRows(rows);
    addNew(rows, "unknown kind", GP_ERROR_INVALID_ARGUMENT, "kind is 3",
           [](World&, GpMeshDesc& d) { d.kind = anyEnum<GpMeshKind>(3); });
    addNew(rows, "material was released", GP_ERROR_INVALID_HANDLE, "material was released",
           [](World& w, GpMeshDesc& d) { d.material = w.released.material; });
    addNew(rows, "material of another device", GP_ERROR_INVALID_HANDLE,
           "material belongs to another device",
           [](World& w, GpMeshDesc& d) { d.material = w.foreign.material; });
    addHandleRows<GpDevice>(rows, "gpNewMesh", "device", [](World&, GpDevice d) {
        const GpMeshDesc desc = triangleDesc(GP_MESH_STATIC);
        return made(gpNewMesh(d, &desc));
    });
    addHandleRows<GpMesh>(rows, "gpUpdateMesh", "mesh", [](World&, GpMesh m) {
        const GpMeshDesc desc = triangleDesc(GP_MESH_DYNAMIC);
        return gpUpdateMesh(m, &desc);
    });
    addHandleRows<GpMesh>(rows, "gpReleaseMesh", "mesh",
                          [](World&, GpMesh m) { return gpReleaseMesh(m); });
    return rows;
}

}  // namespace gp::test
