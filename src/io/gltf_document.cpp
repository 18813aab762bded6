#include "io/gltf_document.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "io/file.h"
#include "io/gltf_uri.h"

namespace gp::io {

namespace {

constexpr uint32_t magicGltf = 0x46546c67, chunkJson = 0x4e4f534a, chunkBinary = 0x004e4942;
// glTF itself needs about ten levels; the rest is for extras.
constexpr size_t deepestNesting = 128;

constexpr const char* supportedExtensions[] = {
    "EXT_mesh_gpu_instancing",      "KHR_lights_punctual",
    "KHR_materials_anisotropy",     "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_iridescence",    "KHR_materials_sheen",
    "KHR_materials_specular",       "KHR_materials_transmission",
    "KHR_materials_unlit",          "KHR_materials_volume",
    "KHR_mesh_quantization",        "KHR_texture_transform"};

bool isSupported(const std::string& name) {
    return std::find(std::begin(supportedExtensions), std::end(supportedExtensions), name) !=
           std::end(supportedExtensions);
}

uint32_t word(std::span<const std::byte> bytes, size_t at) {
    uint32_t v;
    std::memcpy(&v, bytes.data() + at, 4);
    return v;
}

// Brackets outside of strings; a parser must never see millions of levels.
bool nestsTooDeep(std::string_view text) {
    size_t depth = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            else if (c == '"') inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepestNesting) return true;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return false;
}

nlohmann::json parseJson(const std::string& path, std::string_view text) {
    const auto fail = [&](const std::string& what) {
        throw FileError(FileError::Kind::invalid, path, what);
    };
    if (nestsTooDeep(text)) fail("not glTF: JSON nested too deeply");
    try {
        nlohmann::json root = nlohmann::json::parse(text);
        if (!root.is_object()) fail("not glTF: the JSON is not an object");
        return root;
    } catch (const nlohmann::json::parse_error& e) {
        fail("damaged glTF: the JSON is invalid or ends early at byte " + std::to_string(e.byte));
    } catch (const nlohmann::json::exception&) {
        fail("damaged glTF: the JSON holds a number that is too large");
    }
    return {};
}

}  // namespace

void Budget::spend(uint64_t bytes, const Value& forWhat) {
    constexpr uint64_t always = uint64_t(256) << 20, factor = 4096;
    const std::lock_guard lock(m_mutex);
    const uint64_t limit = std::max(always, m_source * factor);
    if (bytes > limit - m_used)
        forWhat.fail("the file asks for more than " + std::to_string(limit >> 20) +
                     " MiB of memory, made from " + std::to_string(m_source) + " bytes");
    m_used += bytes;
}

Document::Document(const std::string& path) {
    m_json.path = path;
    m_folder = std::filesystem::path(path).parent_path().string();
    std::vector<std::byte> file = readFile(path);
    m_budget.earn(file.size());
    parseContainer(std::move(file));
    const std::string version = root()["asset"].text("version", "");
    if (!version.starts_with("2."))
        root().unsupported("glTF version '" + version.substr(0, 20) + "'; only 2.0 can be read");
    const std::string least = root()["asset"].text("minVersion", "2.0");
    if (least != "2.0")
        root().unsupported("needs glTF version '" + least.substr(0, 20) + "'; 2.0 can be read");
    checkExtensions();
    m_buffers.resize(size("buffers"));
}

void Document::parseContainer(std::vector<std::byte>&& file) {
    const auto fail = [&](const std::string& what) {
        throw FileError(FileError::Kind::invalid, path(), what);
    };
    const auto text = [&](size_t at, size_t length) {
        return std::string_view(reinterpret_cast<const char*>(file.data()) + at, length);
    };
    if (file.size() < 4 || word(file, 0) != magicGltf) {
        std::string_view all = text(0, file.size());
        if (all.starts_with("\xef\xbb\xbf")) all.remove_prefix(3);
        if (all.find_first_not_of(" \t\r\n") == std::string_view::npos) fail("the file is empty");
        m_json.root = parseJson(path(), all);
        return;
    }
    if (file.size() < 20) fail("damaged GLB: the file ends inside of its header");
    if (word(file, 4) != 2)
        throw FileError(FileError::Kind::unsupported, path(),
                        "GLB version " + std::to_string(word(file, 4)) + "; only 2 can be read");
    if (word(file, 8) > file.size())
        fail("damaged GLB: truncated, " + std::to_string(file.size()) + " of " +
             std::to_string(word(file, 8)) + " bytes");
    const size_t end = word(file, 8);
    size_t at = 12;
    for (int i = 0; at + 8 <= end; ++i) {
        const size_t length = word(file, at);
        const uint32_t type = word(file, at + 4);
        if (length > end - at - 8) fail("damaged GLB: a chunk is longer than the file");
        if (i == 0 && type != chunkJson) fail("damaged GLB: the first chunk is not JSON");
        if (i == 0) m_json.root = parseJson(path(), text(at + 8, length));
        if (i == 1 && type == chunkBinary) {
            const auto first = file.begin() + static_cast<ptrdiff_t>(at + 8);
            m_binary.assign(first, first + static_cast<ptrdiff_t>(length));
            m_hasBinary = true;
        }
        at += 8 + (length + 3) / 4 * 4;
    }
    if (m_json.root.is_null()) fail("damaged GLB: there is no JSON chunk");
}

void Document::checkExtensions() {
    if (const auto required = root().find("extensionsRequired"))
        for (size_t i = 0; i < required->size(); ++i)
            if (const std::string& name = required->at(i).asText(); !isSupported(name))
                root().unsupported("requires the extension " + name.substr(0, 80) +
                                   ", which is not supported; export the file without it");
    if (const auto used = root().find("extensionsUsed"))
        for (size_t i = 0; i < used->size(); ++i)
            if (const std::string& name = used->at(i).asText(); !isSupported(name))
                warn("uses the extension " + name.substr(0, 80) + ", which is ignored");
}

std::vector<std::byte> Document::readUri(const Value& uri) {
    std::vector<std::byte> bytes;
    if (isDataUri(uri.asText())) {
        bytes = decodeDataUri(uri);
    } else {
        const std::string target = resolveUri(uri, m_folder);
        try {
            bytes = readFile(target);
        } catch (const FileError& e) {
            throw FileError(e.kind, path(), uri.where() + ": " + e.what());
        }
    }
    m_budget.earn(bytes.size());
    return bytes;
}

std::span<const std::byte> Document::buffer(uint32_t index) {
    const Value value = element("buffers", index);
    const uint64_t length = value["byteLength"].asCount();
    const auto checked = [&](const std::vector<std::byte>& bytes) {
        if (length > bytes.size())
            value.fail("claims " + std::to_string(length) + " bytes, but there are only " +
                       std::to_string(bytes.size()) + " (truncated?)");
        return std::span(bytes.data(), length);
    };
    const auto uri = value.find("uri");
    if (!uri) {
        if (index != 0 || !m_hasBinary) value.fail("has no data: neither uri nor GLB chunk");
        return checked(m_binary);
    }
    Buffer& b = m_buffers[index];
    if (!b.loaded) b.bytes = readUri(*uri);
    b.loaded = true;
    return checked(b.bytes);
}

Document::View Document::view(uint32_t bufferView) {
    const Value value = element("bufferViews", bufferView);
    const std::span<const std::byte> bytes = buffer(value["buffer"].asIndexInto("buffers"));
    const uint64_t offset = value.count("byteOffset", 0);
    const uint64_t length = value["byteLength"].asCount();
    if (offset > bytes.size() || length > bytes.size() - offset)
        value.fail("lies outside of its buffer (" + std::to_string(offset) + " + " +
                   std::to_string(length) + " of " + std::to_string(bytes.size()) + " bytes)");
    View view;
    view.bytes = bytes.subspan(offset, length);
    view.stride = value.count("byteStride", 0);
    if (value.has("byteStride") && (view.stride < 1 || view.stride > 4096))
        value.fail("byteStride " + std::to_string(view.stride) + " is out of range");
    return view;
}

void Document::warn(const std::string& text) {
    // A file can have one reason to complain for each of its million nodes.
    constexpr size_t most = 100;
    if (m_warnings.size() >= most) return;
    const std::string line = path() + ": " + text;
    if (std::find(m_warnings.begin(), m_warnings.end(), line) == m_warnings.end())
        m_warnings.push_back(line);
}

}  // namespace gp::io
