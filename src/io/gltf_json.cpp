#include "io/gltf_json.h"

#include <algorithm>
#include <cmath>

namespace gp::io {

using nlohmann::json;

size_t JsonFile::listSize(const char* list) const {
    const auto it = root.find(list);
    if (it == root.end()) return 0;
    if (!it->is_array())
        throw FileError(FileError::Kind::invalid, path, std::string(list) + ": must be an array");
    return it->size();
}

Value listElement(const JsonFile& file, const char* list, uint32_t i) {
    return Value(file, file.root, "").operator[](list).at(i);
}

void Value::fail(const std::string& what) const {
    throw FileError(FileError::Kind::invalid, m_file->path,
                    m_where.empty() ? what : m_where + ": " + what);
}

void Value::unsupported(const std::string& what) const {
    throw FileError(FileError::Kind::unsupported, m_file->path,
                    m_where.empty() ? what : m_where + ": " + what);
}

std::optional<Value> Value::find(const char* key) const {
    if (!m_json->is_object()) fail("must be an object");
    const auto it = m_json->find(key);
    if (it == m_json->end()) return std::nullopt;
    return Value(*m_file, *it, m_where.empty() ? key : m_where + "." + key);
}

std::vector<std::string> Value::keys() const {
    if (!m_json->is_object()) fail("must be an object");
    std::vector<std::string> names;
    for (const auto& member : m_json->items()) names.push_back(member.key());
    return names;
}

Value Value::operator[](const char* key) const {
    std::optional<Value> v = find(key);
    if (!v) fail(std::string("'") + key + "' is missing");
    return *v;
}

std::optional<Value> Value::extension(const char* name) const {
    const std::optional<Value> all = find("extensions");
    return all ? all->find(name) : std::nullopt;
}

size_t Value::size() const {
    if (!m_json->is_array()) fail("must be an array");
    return m_json->size();
}

Value Value::at(size_t i) const {
    if (i >= size()) fail("has no element " + std::to_string(i));
    return Value(*m_file, (*m_json)[i], m_where + "[" + std::to_string(i) + "]");
}

double Value::asNumber() const {
    if (!m_json->is_number()) fail("must be a number");
    return m_json->get<double>();
}

uint64_t Value::asCount() const {
    if (m_json->is_number_unsigned()) return m_json->get<uint64_t>();
    // Some writers put 3.0 where an integer is meant.
    constexpr double exact = 9007199254740992.0;  // 2^53
    const double v = m_json->is_number() ? m_json->get<double>() : -1;
    if (!(v >= 0 && v <= exact) || v != std::floor(v)) fail("must be a whole number, 0 or more");
    return static_cast<uint64_t>(v);
}

const std::string& Value::asText() const {
    if (!m_json->is_string()) fail("must be a string");
    return m_json->get_ref<const std::string&>();
}

uint32_t Value::asIndexInto(const char* list) const {
    const uint64_t i = asCount();
    if (i >= m_file->listSize(list))
        fail(std::string("there is no ") + list + "[" + std::to_string(i) + "]");
    return static_cast<uint32_t>(i);
}

double Value::number(const char* key, double fallback) const {
    const std::optional<Value> v = find(key);
    return v ? v->asNumber() : fallback;
}

float Value::real(const char* key, float fallback) const {
    const std::optional<Value> v = find(key);
    if (v) v->reals(&fallback, 0);
    return fallback;
}

float Value::factor(const char* key, float fallback) const {
    return std::clamp(real(key, fallback), 0.0f, 1.0f);
}

uint64_t Value::count(const char* key, uint64_t fallback) const {
    const std::optional<Value> v = find(key);
    return v ? v->asCount() : fallback;
}

bool Value::flag(const char* key, bool fallback) const {
    const std::optional<Value> v = find(key);
    if (!v) return fallback;
    if (!v->m_json->is_boolean()) v->fail("must be true or false");
    return v->m_json->get<bool>();
}

std::string Value::text(const char* key, const std::string& fallback) const {
    const std::optional<Value> v = find(key);
    return v ? v->asText() : fallback;
}

std::optional<uint32_t> Value::index(const char* key, const char* list) const {
    const std::optional<Value> v = find(key);
    if (!v) return std::nullopt;
    return v->asIndexInto(list);
}

void Value::reals(float* out, size_t n) const {
    const auto narrow = [](const Value& v) {
        const double d = v.asNumber();
        if (std::abs(d) > 3.4028234663852886e38) v.fail("is too large");
        return static_cast<float>(d);
    };
    if (n == 0) {  // a number by itself
        *out = narrow(*this);
        return;
    }
    if (size() != n) fail("must have " + std::to_string(n) + " numbers");
    for (size_t i = 0; i < n; ++i) out[i] = narrow(at(i));
}

}  // namespace gp::io
