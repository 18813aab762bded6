// Arrays of vertices and indices as C hands them over.
#pragma once

#include <cstddef>
#include <vector>

#include "api/check.h"

namespace gp::api {

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

// Of any descriptor with vertexCount, indices and indexCount: at most so many, triangles whole.
template <class Desc>
void checkCounts(const Desc& desc, uint32_t vertexExponent, uint32_t indexExponent) {
    if (desc.vertexCount == 0) fail(GP_ERROR_INVALID_ARGUMENT, "vertexCount is 0");
    if (desc.vertexCount > 1u << vertexExponent)
        fail(GP_ERROR_TOO_LARGE, "vertexCount is {}, more than 2^{}", desc.vertexCount,
             vertexExponent);
    if (desc.indexCount > 1u << indexExponent)
        fail(GP_ERROR_TOO_LARGE, "indexCount is {}, more than 2^{}", desc.indexCount,
             indexExponent);
    checkPointer(desc.positions, "positions");
    if (desc.indices && desc.indexCount == 0) fail(GP_ERROR_INVALID_ARGUMENT, "indexCount is 0");
    if (!desc.indices && desc.indexCount != 0)
        fail(GP_ERROR_INVALID_ARGUMENT, "indices is NULL, but indexCount is {}", desc.indexCount);
    const uint32_t corners = desc.indices ? desc.indexCount : desc.vertexCount;
    if (corners % 3 != 0)
        fail(GP_ERROR_INVALID_ARGUMENT, "{} is {}, not a multiple of 3",
             desc.indices ? "indexCount" : "vertexCount", corners);
}

// After checkCounts; every index names a vertex.
template <class Desc>
std::vector<uint32_t> indicesFrom(const Desc& desc) {
    std::vector<uint32_t> indices;
    if (desc.indices) indices.assign(desc.indices, desc.indices + desc.indexCount);
    for (size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= desc.vertexCount)
            fail(GP_ERROR_OUT_OF_RANGE, "indices[{}] is {}, but vertexCount is {}", i, indices[i],
                 desc.vertexCount);
    return indices;
}

}  // namespace gp::api
