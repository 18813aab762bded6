// A glTF file and the buffers it refers to.
#pragma once

#include <cstddef>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "io/gltf_json.h"

namespace gp::io {

// How much memory a file may make us use. Many references to the same few bytes must not become
// gigabytes; the limit grows with what was really read.
class Budget {
public:
    void earn(uint64_t sourceBytes) { m_source += sourceBytes; }
    void spend(uint64_t bytes, const Value& forWhat);  // from any thread

private:
    std::mutex m_mutex;
    uint64_t m_source = 0;
    uint64_t m_used = 0;
};

class Document {
public:
    // Reads and checks the container, the version and the required extensions.
    explicit Document(const std::string& path);

    const JsonFile& json() const { return m_json; }
    Value root() const { return Value(m_json, m_json.root, ""); }
    size_t size(const char* list) const { return m_json.listSize(list); }
    Value element(const char* list, uint32_t i) const { return listElement(m_json, list, i); }
    const std::string& path() const { return m_json.path; }
    const std::string& folder() const { return m_folder; }

    // The bytes of a buffer view; stride 0: none is given.
    struct View {
        std::span<const std::byte> bytes;
        uint64_t stride = 0;
    };
    View view(uint32_t bufferView);

    // The file that `uri` names, or the data in it.
    std::vector<std::byte> readUri(const Value& uri);

    void warn(const std::string& text);  // each text once
    std::vector<std::string> takeWarnings() { return std::move(m_warnings); }
    Budget& budget() { return m_budget; }

private:
    struct Buffer {
        std::vector<std::byte> bytes;
        bool loaded = false;
    };

    void parseContainer(std::vector<std::byte>&& file);
    void checkExtensions();
    std::span<const std::byte> buffer(uint32_t index);

    JsonFile m_json;
    std::string m_folder;
    std::vector<std::byte> m_binary;  // the GLB file's own chunk
    bool m_hasBinary = false;
    std::vector<Buffer> m_buffers;
    std::vector<std::string> m_warnings;
    Budget m_budget;
};

}  // namespace gp::io
