// Typed arrays of a glTF file, decoded: any component type, normalised or not, strided, sparse.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf_document.h"

namespace gp::io {

// What an attribute is read as.
enum class Integers : uint8_t {
    asFlagged,  // integers are fractions where the accessor says `normalized`
    fractions   // they always are (colours, weights, rotations)
};

class Accessors {
public:
    explicit Accessors(Document& document) : m_document(document) {}

    uint64_t count(uint32_t accessor) const;

    std::vector<float> scalars(uint32_t accessor, Integers integers = Integers::asFlagged);
    std::vector<glm::vec2> vec2s(uint32_t accessor);
    std::vector<glm::vec3> vec3s(uint32_t accessor, Integers integers = Integers::asFlagged);
    std::vector<glm::vec4> vec4s(uint32_t accessor, Integers integers = Integers::asFlagged);
    std::vector<glm::mat4> mat4s(uint32_t accessor);
    std::vector<glm::vec4> colors(uint32_t accessor);    // VEC3 gets an alpha of 1
    std::vector<uint32_t> indices(uint32_t accessor);    // unsigned SCALAR
    std::vector<glm::u32vec4> joints(uint32_t accessor); // unsigned VEC4

    // Fails where one of n values of so many components is NaN or infinite.
    void requireFinite(const float* values, size_t n, size_t components, uint32_t accessor,
                       const char* what) const;

private:
    struct Layout;
    Layout layout(uint32_t accessor, const char* type) const;
    template <typename T>
    void decode(const Layout& layout, T* out, Integers integers);
    template <typename T>
    void decodeSparse(const Layout& layout, T* out, Integers integers);
    template <typename V>
    std::vector<V> vectors(uint32_t accessor, const char* type, Integers integers);

    Document& m_document;
};

}  // namespace gp::io
