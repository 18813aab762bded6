#include "io/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace gp::io {

namespace {

// componentType of glTF 2.0, 3.6.2.2
enum ComponentType : uint32_t {
    int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126
};

uint64_t componentBytes(const Value& value, uint64_t type) {
    switch (type) {
        case int8: case uint8: return 1;
        case int16: case uint16: return 2;
        case uint32: case float32: return 4;
        default: value.fail("unknown componentType " + std::to_string(type));
    }
}

uint64_t componentCount(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "MAT4") return 16;
    return static_cast<uint64_t>(type.back() - '0');  // VEC2, VEC3, VEC4
}

template <typename S, typename T>
T converted(S v, bool fraction) {
    if constexpr (std::is_same_v<S, float> || std::is_integral_v<T>) {
        return static_cast<T>(v);
    } else {
        if (!fraction) return static_cast<T>(v);
        // glTF 2.0, 3.6.2.2: c / max, and -128 means the same as -127
        return std::max(static_cast<T>(v) / static_cast<T>(std::numeric_limits<S>::max()), T(-1));
    }
}

template <typename S, typename T>
void convertElements(const std::byte* from, uint64_t stride, uint64_t count, uint64_t components,
                     bool fraction, T* out) {
    if (count == 0) return;  // memcpy takes no null, not even for nothing
    if (std::is_same_v<S, T> && stride == components * sizeof(S)) {
        std::memcpy(out, from, count * stride);
        return;
    }
    for (uint64_t i = 0; i < count; ++i, from += stride)
        for (uint64_t c = 0; c < components; ++c) {
            S v;
            std::memcpy(&v, from + c * sizeof(S), sizeof(S));
            *out++ = converted<S, T>(v, fraction);
        }
}

}  // namespace

// Where an accessor's values lie, checked against the buffer view.
struct Accessors::Layout {
    Value value;
    uint64_t count = 0;
    uint64_t components = 0;
    uint64_t componentType = 0;
    bool normalized = false;

    uint64_t elementBytes() const { return components * componentBytes(value, componentType); }

    // `count` elements at `offset` of a view; fails where they do not fit.
    const std::byte* place(const Value& where, const Document::View& view, uint64_t offset,
                           uint64_t n, uint64_t bytes, uint64_t stride) const {
        if (stride < bytes) where.fail("byteStride is smaller than an element");
        // n * stride may overflow; the division cannot.
        const uint64_t room = view.bytes.size();
        if (n > 0 && (offset > room || bytes > room - offset ||
                      (n - 1) > (room - offset - bytes) / stride))
            where.fail("reaches beyond its bufferView (" + std::to_string(n) +
                       " elements at byte " + std::to_string(offset) + " of " +
                       std::to_string(room) + ")");
        return view.bytes.data() + (n > 0 ? offset : 0);
    }

    template <typename T>
    void convert(uint64_t type, const std::byte* from, uint64_t stride, uint64_t n, uint64_t width,
                 bool fraction, T* out) const {
        switch (type) {
            case int8: return convertElements<int8_t>(from, stride, n, width, fraction, out);
            case uint8: return convertElements<uint8_t>(from, stride, n, width, fraction, out);
            case int16: return convertElements<int16_t>(from, stride, n, width, fraction, out);
            case uint16: return convertElements<uint16_t>(from, stride, n, width, fraction, out);
            case uint32: return convertElements<uint32_t>(from, stride, n, width, fraction, out);
            default: return convertElements<float>(from, stride, n, width, fraction, out);
        }
    }
};

uint64_t Accessors::count(uint32_t accessor) const {
    return m_document.element("accessors", accessor)["count"].asCount();
}

Accessors::Layout Accessors::layout(uint32_t accessor, const char* type) const {
    Layout l{m_document.element("accessors", accessor)};
    const std::string actual = l.value.text("type", "");
    if (actual != type)
        l.value.fail(std::string("must be ") + type + " here, but is '" + actual.substr(0, 20) +
                     "'");
    l.count = l.value["count"].asCount();
    l.components = componentCount(type);
    l.componentType = l.value["componentType"].asCount();
    l.normalized = l.value.flag("normalized", false);
    componentBytes(l.value, l.componentType);
    // Indices are 32 bits, and arithmetic below must not overflow.
    if (l.count > 0xfffffffeu) l.value.fail("count " + std::to_string(l.count) + " is absurd");
    return l;
}

template <typename T>
void Accessors::decode(const Layout& l, T* out, Integers integers) {
    const bool fraction = l.normalized || integers == Integers::fractions;
    if (const auto index = l.value.index("bufferView", "bufferViews")) {
        const Document::View view = m_document.view(*index);
        const uint64_t stride = view.stride ? view.stride : l.elementBytes();
        const std::byte* from = l.place(l.value, view, l.value.count("byteOffset", 0), l.count,
                                        l.elementBytes(), stride);
        l.convert(l.componentType, from, stride, l.count, l.components, fraction, out);
    }
    if (l.value.has("sparse")) decodeSparse(l, out, integers);
}

template <typename T>
void Accessors::decodeSparse(const Layout& l, T* out, Integers integers) {
    const Value sparse = l.value["sparse"], where = sparse["indices"], what = sparse["values"];
    const uint64_t n = sparse["count"].asCount();
    if (n > l.count) sparse.fail("replaces more elements than there are");
    const uint64_t type = where["componentType"].asCount();
    if (type != uint8 && type != uint16 && type != uint32)
        where.fail("componentType must be unsigned");
    const uint64_t indexBytes = componentBytes(where, type);
    const Document::View indexView =
        m_document.view(where["bufferView"].asIndexInto("bufferViews"));
    const Document::View valueView =
        m_document.view(what["bufferView"].asIndexInto("bufferViews"));
    const std::byte* indices = l.place(where, indexView, where.count("byteOffset", 0), n,
                                       indexBytes, indexBytes);
    std::vector<uint32_t> targets(n);
    l.convert(type, indices, indexBytes, n, 1, false, targets.data());
    const std::byte* from = l.place(what, valueView, what.count("byteOffset", 0), n,
                                    l.elementBytes(), l.elementBytes());
    const bool fraction = l.normalized || integers == Integers::fractions;
    for (uint64_t i = 0; i < n; ++i) {
        if (targets[i] >= l.count)
            where.fail("element " + std::to_string(targets[i]) + " does not exist");
        l.convert(l.componentType, from + i * l.elementBytes(), l.elementBytes(), 1, l.components,
                  fraction, out + targets[i] * l.components);
    }
}

template <typename V>
std::vector<V> Accessors::vectors(uint32_t accessor, const char* type, Integers integers) {
    const Layout l = layout(accessor, type);
    // A count is believed only where the bytes are there: place() has to see them before the
    // memory is asked for. Accessors of zeros have none and must be small.
    constexpr uint64_t mostZeros = uint64_t(1) << 22;
    if (const auto index = l.value.index("bufferView", "bufferViews")) {
        const Document::View view = m_document.view(*index);
        l.place(l.value, view, l.value.count("byteOffset", 0), l.count, l.elementBytes(),
                view.stride ? view.stride : l.elementBytes());
    } else if (l.count > mostZeros) {
        l.value.fail("has " + std::to_string(l.count) + " elements and no bufferView");
    }
    std::vector<V> out(l.count, V(0));
    using Component = std::conditional_t<std::is_same_v<V, uint32_t> ||
                                             std::is_same_v<V, glm::u32vec4>, uint32_t, float>;
    decode(l, reinterpret_cast<Component*>(out.data()), integers);
    return out;
}

std::vector<float> Accessors::scalars(uint32_t a, Integers i) {
    return vectors<float>(a, "SCALAR", i);
}
std::vector<glm::vec2> Accessors::vec2s(uint32_t a) {
    return vectors<glm::vec2>(a, "VEC2", Integers::asFlagged);
}
std::vector<glm::vec3> Accessors::vec3s(uint32_t a, Integers i) {
    return vectors<glm::vec3>(a, "VEC3", i);
}
std::vector<glm::vec4> Accessors::vec4s(uint32_t a, Integers i) {
    return vectors<glm::vec4>(a, "VEC4", i);
}
std::vector<glm::mat4> Accessors::mat4s(uint32_t a) {
    if (m_document.element("accessors", a).count("componentType", 0) != float32)
        m_document.element("accessors", a).fail("matrices must be of floats");
    return vectors<glm::mat4>(a, "MAT4", Integers::asFlagged);
}

std::vector<glm::vec4> Accessors::colors(uint32_t a) {
    if (m_document.element("accessors", a).text("type", "") != "VEC3")
        return vec4s(a, Integers::fractions);
    const std::vector<glm::vec3> rgb = vec3s(a, Integers::fractions);
    std::vector<glm::vec4> out(rgb.size());
    for (size_t i = 0; i < rgb.size(); ++i) out[i] = glm::vec4(rgb[i], 1);
    return out;
}

std::vector<uint32_t> Accessors::indices(uint32_t a) {
    const uint64_t type = m_document.element("accessors", a).count("componentType", 0);
    if (type != uint8 && type != uint16 && type != uint32)
        m_document.element("accessors", a).fail("indices must be unsigned integers");
    return vectors<uint32_t>(a, "SCALAR", Integers::asFlagged);
}

std::vector<glm::u32vec4> Accessors::joints(uint32_t a) {
    const uint64_t type = m_document.element("accessors", a).count("componentType", 0);
    if (type != uint8 && type != uint16 && type != uint32)
        m_document.element("accessors", a).fail("joints must be unsigned integers");
    return vectors<glm::u32vec4>(a, "VEC4", Integers::asFlagged);
}

void Accessors::requireFinite(const float* values, size_t n, size_t components, uint32_t accessor,
                              const char* what) const {
    for (size_t i = 0; i < n * components; ++i)
        if (!std::isfinite(values[i]))
            m_document.element("accessors", accessor)
                .fail(std::string(what) + " " + std::to_string(i / components) +
                      " is not finite (NaN or infinity)");
}

}  // namespace gp::io
