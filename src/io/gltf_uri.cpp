#include "io/gltf_uri.h"

#include <array>
#include <filesystem>

namespace gp::io {

namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// A percent sign that starts no code stands for itself, as in files of careless writers.
std::string percentDecoded(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        const bool coded = text[i] == '%' && i + 2 < text.size() &&
                           hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        if (!coded) {
            out += text[i];
            continue;
        }
        out += static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2]));
        i += 2;
    }
    return out;
}

std::array<int8_t, 256> makeBase64Table() {
    std::array<int8_t, 256> t;
    t.fill(-1);
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < digits.size(); ++i)
        t[static_cast<uint8_t>(digits[i])] = static_cast<int8_t>(i);
    t['-'] = 62;  // the url-safe alphabet
    t['_'] = 63;
    return t;
}

// [RFC 4648, section 4]; padding may be missing.
std::vector<std::byte> base64Decoded(const Value& value, std::string_view text) {
    static const std::array<int8_t, 256> table = makeBase64Table();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::vector<std::byte> out;
    out.reserve(text.size() / 4 * 3 + 3);
    uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int8_t digit = table[static_cast<uint8_t>(c)];
        if (digit < 0) value.fail("damaged base64 data");
        bits = bits << 6 | static_cast<uint32_t>(digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        out.push_back(static_cast<std::byte>(bits >> held & 0xff));
    }
    return out;
}

// "http:", "file:", "C:": letters, digits, '+', '-', '.' before a colon. [RFC 3986, section 3.1]
bool hasScheme(std::string_view path) {
    const size_t end = path.find_first_of(":/");
    return end != std::string_view::npos && path[end] == ':';
}

}  // namespace

bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

std::vector<std::byte> decodeDataUri(const Value& value) {
    const std::string_view uri = value.asText();
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos) value.fail("a data uri without data");
    if (uri.substr(0, comma).ends_with(";base64"))
        return base64Decoded(value, uri.substr(comma + 1));
    const std::string plain = percentDecoded(uri.substr(comma + 1));
    const std::byte* first = reinterpret_cast<const std::byte*>(plain.data());
    return {first, first + plain.size()};
}

std::string resolveUri(const Value& value, const std::string& folder) {
    const std::string relative = percentDecoded(value.asText());
    const std::string shown = std::string("'").append(relative, 0, 200).append("'");
    if (relative.empty()) value.fail("an empty uri");
    if (relative.find('\0') != std::string::npos || relative.find('\\') != std::string::npos)
        value.fail("a file name with a forbidden character");
    if (hasScheme(relative))
        value.fail(shown +
                   " is not a file beside this one; only relative paths and data: are read");
    const std::filesystem::path normal = std::filesystem::path(relative).lexically_normal();
    if (normal.is_absolute() || *normal.begin() == "..")
        value.fail(shown + " leaves the folder of this file; copy it there");
    return (std::filesystem::path(folder) / normal).string();
}

}  // namespace gp::io
