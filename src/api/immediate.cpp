// Immediate mode: vertices one by one, as in OpenGL 1, into lists of triangles.
#include <algorithm>

#include "api/arrays.h"

namespace gp::api {

namespace {

constexpr size_t mostVertices = size_t(1) << 24;

void checkOutside(const ImmediateObject& im) {
    if (im.open) fail(GP_ERROR_INVALID_OPERATION, "between gpBegin and gpEnd");
}

struct Triangle {
    uint32_t a, b, c;
};

// Triangle n of a primitive, by its vertices counted from 0. The last corner is the one whose
// colour a flat face has; which way the corners run is what the primitive says.
// [OpenGL 2.1 specification, sections 2.6.1 and 2.14.7]
Triangle triangleOf(GpPrimitive primitive, uint32_t n) {
    const uint32_t half = n / 2;
    const bool second = n % 2 != 0;
    switch (primitive) {
        case GP_TRIANGLE_STRIP:
            return second ? Triangle{n + 1, n, n + 2} : Triangle{n, n + 1, n + 2};
        case GP_TRIANGLE_FAN: return {0, n + 1, n + 2};
        case GP_QUADS: {
            const uint32_t q = 4 * half;
            return second ? Triangle{q + 1, q + 2, q + 3} : Triangle{q, q + 1, q + 3};
        }
        case GP_QUAD_STRIP: {
            const uint32_t q = 2 * half;
            return second ? Triangle{q + 2, q, q + 3} : Triangle{q, q + 1, q + 3};
        }
        case GP_POLYGON: return {n + 1, n + 2, 0};
        case GP_TRIANGLES: break;
    }
    return {3 * n, 3 * n + 1, 3 * n + 2};
}

uint32_t trianglesOf(GpPrimitive primitive, uint32_t vertices) {
    switch (primitive) {
        case GP_TRIANGLES: return vertices / 3;
        case GP_QUADS: return vertices / 4 * 2;
        case GP_QUAD_STRIP: return vertices < 4 ? 0 : (vertices / 2 - 1) * 2;
        default: return vertices < 3 ? 0 : vertices - 2;
    }
}

// As push_back does, so that many small primitives do not copy what is there each time.
template <class T>
void makeRoom(std::vector<T>& values, size_t more) {
    if (values.size() + more > values.capacity())
        values.reserve(std::max(values.size() + more, 2 * values.capacity()));
}

void end(ImmediateObject& im) {
    if (!im.open) fail(GP_ERROR_INVALID_OPERATION, "without gpBegin");
    const uint32_t first = im.firstVertex;
    const auto count = uint32_t(im.vertices.size()) - first;
    const uint32_t triangles = trianglesOf(im.primitive, count);
    // Flat faces have vertices of their own.
    std::vector<ImmediateVertex> faces;
    std::vector<uint32_t> indices;
    const bool flat = im.shadeModel == GP_SHADE_FLAT;
    if (flat && 3 * size_t(triangles) + first > mostVertices)
        fail(GP_ERROR_TOO_LARGE, "flat faces would have more than 2^24 vertices");
    for (uint32_t n = 0; n < triangles; ++n) {
        const Triangle t = triangleOf(im.primitive, n);
        for (const uint32_t corner : {t.a, t.b, t.c}) {
            indices.push_back(first + (flat ? uint32_t(faces.size()) : corner));
            if (!flat) continue;
            faces.push_back(im.vertices[first + corner]);
            faces.back().color = im.vertices[first + t.c].color;
        }
    }
    makeRoom(im.indices, indices.size());
    makeRoom(im.vertices, faces.size());  // nothing fails from here on
    im.indices.insert(im.indices.end(), indices.begin(), indices.end());
    if (flat) {
        im.vertices.resize(first);
        im.vertices.insert(im.vertices.end(), faces.begin(), faces.end());
    }
    im.open = false;
}

// What both kinds of descriptor have in common.
template <class Desc>
void fill(const ImmediateObject& im, Desc& desc) {
    checkOutside(im);
    if (im.indices.empty()) fail(GP_ERROR_INVALID_OPERATION, "there is no whole triangle");
    const ImmediateVertex& v = im.vertices[0];
    constexpr size_t stride = sizeof(ImmediateVertex);
    desc.vertexCount = uint32_t(im.vertices.size());
    desc.positions = &v.position.x, desc.positionStride = stride;
    if (im.hasColors) desc.colors = &v.color.x, desc.colorStride = stride;
    desc.indices = im.indices.data();
    desc.indexCount = uint32_t(im.indices.size());
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpImmediate gpNewImmediate(GpDevice device) {
    return enter("gpNewImmediate", "device", device, [](DeviceObject& d) {
        return publish<GpImmediate>(std::make_shared<ImmediateObject>(d));
    });
}

GpError gpReleaseImmediate(GpImmediate immediate) {
    return enter("gpReleaseImmediate", "immediate", immediate,
                 [&](ImmediateObject&) { handles().remove(bitsOf(immediate)); });
}

GpError gpClearImmediate(GpImmediate immediate) {
    return enter("gpClearImmediate", "immediate", immediate, [](ImmediateObject& im) {
        checkOutside(im);
        im.vertices.clear();
        im.indices.clear();
    });
}

GpError gpColor4f(GpImmediate immediate, float r, float g, float b, float a) {
    return enter("gpColor4f", "immediate", immediate, [=](ImmediateObject& im) {
        const float rgba[4] = {r, g, b, a};
        checkFinite(rgba, 4, "color");
        im.current.color = {r, g, b, a};
        im.hasColors = true;
    });
}

GpError gpNormal3f(GpImmediate immediate, float x, float y, float z) {
    return enter("gpNormal3f", "immediate", immediate, [=](ImmediateObject& im) {
        const float xyz[3] = {x, y, z};
        checkFinite(xyz, 3, "normal");
        im.current.normal = {x, y, z};
        im.hasNormals = true;
    });
}

GpError gpTexCoord2f(GpImmediate immediate, float u, float v) {
    return enter("gpTexCoord2f", "immediate", immediate, [=](ImmediateObject& im) {
        const float uv[2] = {u, v};
        checkFinite(uv, 2, "texCoord");
        im.current.texCoord = {u, v};
        im.hasTexCoords = true;
    });
}

GpError gpVertex3f(GpImmediate immediate, float x, float y, float z) {
    return enter("gpVertex3f", "immediate", immediate, [=](ImmediateObject& im) {
        if (!im.open) fail(GP_ERROR_INVALID_OPERATION, "not between gpBegin and gpEnd");
        const float xyz[3] = {x, y, z};
        checkFinite(xyz, 3, "position");
        if (im.vertices.size() >= mostVertices)
            fail(GP_ERROR_TOO_LARGE, "there are 2^24 vertices, which is the most");
        im.vertices.push_back(im.current);
        im.vertices.back().position = {x, y, z};
    });
}

GpError gpShadeModel(GpImmediate immediate, GpShadeModel model) {
    return enter("gpShadeModel", "immediate", immediate, [&](ImmediateObject& im) {
        const uint32_t number = checkEnum(model, 2, "model");
        checkOutside(im);
        im.shadeModel = GpShadeModel(number);
    });
}

GpError gpBegin(GpImmediate immediate, GpPrimitive primitive) {
    return enter("gpBegin", "immediate", immediate, [&](ImmediateObject& im) {
        const uint32_t number = checkEnum(primitive, 6, "primitive");
        checkOutside(im);
        im.primitive = GpPrimitive(number);
        im.firstVertex = uint32_t(im.vertices.size());
        im.open = true;
    });
}

GpError gpEnd(GpImmediate immediate) {
    return enter("gpEnd", "immediate", immediate, [](ImmediateObject& im) { end(im); });
}

GpError gpGetImmediateMesh(GpImmediate immediate, GpMeshDesc* desc) {
    return enter("gpGetImmediateMesh", "immediate", immediate, [&](ImmediateObject& im) {
        checkPointer(desc, "desc");
        fill(im, *desc);
        const ImmediateVertex& v = im.vertices[0];
        if (im.hasNormals) desc->normals = &v.normal.x, desc->normalStride = sizeof v;
        if (im.hasTexCoords)
            desc->texCoords[0] = &v.texCoord.x, desc->texCoordStride[0] = sizeof v;
    });
}

GpError gpGetImmediateDraw(GpImmediate immediate, GpDrawDesc* desc) {
    return enter("gpGetImmediateDraw", "immediate", immediate, [&](ImmediateObject& im) {
        checkPointer(desc, "desc");
        fill(im, *desc);
        desc->positionComponents = 3;
        const ImmediateVertex& v = im.vertices[0];
        if (im.hasTexCoords) desc->texCoords = &v.texCoord.x, desc->texCoordStride = sizeof v;
    });
}

}  // extern "C"
