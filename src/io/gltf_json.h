// JSON of a glTF file, read with suspicion: every access says what it expects, and a value that
// is not that is a FileError that names the file and the place ("nodes[3].mesh: ...").
//
// Why not tinygltf: its 2.7.0 (Debian 12) indexes bufferViews, accessors and images without
// checking them, adds offsets without looking for overflow, opens any path that a uri names, and
// keeps a second copy of everything. All of it would have to be checked in front of it, which is
// most of the work of reading the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "io/file_error.h"

namespace gp::io {

struct JsonFile {
    std::string path;
    nlohmann::json root;

    size_t listSize(const char* list) const;  // of an array at the top, 0 if absent
};

class Value {
public:
    Value(const JsonFile& file, const nlohmann::json& json, std::string where)
        : m_file(&file), m_json(&json), m_where(std::move(where)) {}

    [[noreturn]] void fail(const std::string& what) const;
    [[noreturn]] void unsupported(const std::string& what) const;
    const std::string& where() const { return m_where; }

    bool isObject() const { return m_json->is_object(); }
    std::vector<std::string> keys() const;  // of this object's members
    bool has(const char* key) const { return find(key).has_value(); }
    std::optional<Value> find(const char* key) const;   // member of this object
    Value operator[](const char* key) const;            // the same; it must be there
    std::optional<Value> extension(const char* name) const;
    size_t size() const;                                // of this array
    Value at(size_t i) const;

    double asNumber() const;
    uint64_t asCount() const;  // an integer that is not negative
    const std::string& asText() const;
    uint32_t asIndexInto(const char* list) const;  // of an element of a list at the top

    double number(const char* key, double fallback) const;
    float real(const char* key, float fallback) const;
    // Within [0, 1]: what lies outside is moved to the nearer end.
    float factor(const char* key, float fallback) const;
    uint64_t count(const char* key, uint64_t fallback) const;
    bool flag(const char* key, bool fallback) const;
    std::string text(const char* key, const std::string& fallback) const;
    std::optional<uint32_t> index(const char* key, const char* list) const;

    template <int N>
    glm::vec<N, float> vec(const char* key, glm::vec<N, float> fallback) const {
        if (const std::optional<Value> v = find(key)) v->reals(&fallback[0], N);
        return fallback;
    }
    void reals(float* out, size_t n) const;  // this array has exactly n numbers

private:
    const JsonFile* m_file;
    const nlohmann::json* m_json;
    std::string m_where;
};

// An array at the top of the file; element i of it. The index has been checked.
Value listElement(const JsonFile& file, const char* list, uint32_t i);

}  // namespace gp::io
