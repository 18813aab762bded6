// A walk over the header of an OpenEXR file that believes nothing. OpenEXR 3.1 allocates what the
// header asks for (attributes, offset tables, line and tile buffers) before it reads the pixels;
// here every size is compared with the length of the file first.
// [OpenEXR, "File Layout": magic, version, attributes (name, type, size, value), offset tables]
#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

#include "io/image_codec.h"

namespace gp::io {

namespace {

constexpr uint32_t versionMultiPart = 0x1000;
constexpr uint64_t pixelsPerByte = 16384;  // large flat areas in DWAB; measured: 6,000
constexpr uint64_t harmlessBuffer = uint64_t(64) << 20;

struct Window {
    int64_t width = 0, height = 0;
};

// What of one part's header decides how much memory is asked for.
struct Part {
    std::optional<Window> data, display;
    uint64_t channels = 0;
    unsigned compression = 0;
    std::optional<Window> tile;
    uint64_t chunkCount = 0;
};

struct Cursor {
    const ImageSource& source;
    size_t position = 0;

    const uint8_t* take(size_t count) {
        if (count > source.bytes.size() - position)
            source.fail("damaged EXR: the file ends inside of its header");
        position += count;
        return source.data() + position - count;
    }
    int32_t int32() {
        int32_t v;
        std::memcpy(&v, take(4), 4);
        return v;
    }
    std::string_view text() {
        const uint8_t* first = source.data() + position;
        const size_t most = std::min<size_t>(256, source.bytes.size() - position);
        const void* end = std::memchr(first, 0, most);
        if (!end) source.fail("damaged EXR: a name in the header does not end");
        const size_t length = static_cast<size_t>(static_cast<const uint8_t*>(end) - first);
        position += length + 1;
        return {reinterpret_cast<const char*>(first), length};
    }
};

Window readWindow(Cursor& in) {
    int64_t v[4];
    for (int64_t& x : v) x = in.int32();
    // Far-away windows overflow the int arithmetic of OpenEXR.
    constexpr int64_t farthest = int64_t(1) << 29;
    for (int64_t x : v)
        if (x < -farthest || x > farthest)
            in.source.fail("damaged EXR: a window lies absurdly far away");
    if (v[2] < v[0] || v[3] < v[1]) in.source.fail("the image is empty (EXR window)");
    return {v[2] - v[0] + 1, v[3] - v[1] + 1};
}

// Name, pixel type, linearity, two samplings, each channel; an empty name ends the list. OpenEXR
// reads up to that name, wherever it stands.
uint64_t countChannels(Cursor& in, size_t end) {
    uint64_t count = 0;
    while (!in.text().empty()) {
        in.take(8);
        const int32_t x = in.int32(), y = in.int32();
        if (x < 1 || y < 1) in.source.fail("damaged EXR: bad sampling of a channel");
        ++count;
    }
    if (in.position != end) in.source.fail("damaged EXR: the list of channels has a wrong size");
    return count;
}

// OpenEXR reads values of these types by their own size whatever the file says, and so would
// leave our path through the header.
void checkFixedSize(const ImageSource& source, std::string_view name, std::string_view type,
                    int32_t size) {
    struct Fixed {
        std::string_view type;
        int32_t size;
    };
    constexpr Fixed fixed[] = {{"box2i", 16},      {"box2f", 16},   {"chromaticities", 32},
                               {"compression", 1}, {"double", 8},   {"envmap", 1},
                               {"float", 4},       {"int", 4},      {"keycode", 28},
                               {"lineOrder", 1},   {"m33f", 36},    {"m33d", 72},
                               {"m44f", 64},       {"m44d", 128},   {"rational", 8},
                               {"tiledesc", 9},    {"timecode", 8}, {"v2i", 8},
                               {"v2f", 8},         {"v2d", 16},     {"v3i", 12},
                               {"v3f", 12},        {"v3d", 24},     {"deepImageState", 1}};
    for (const Fixed& f : fixed)
        if (f.type == type && f.size != size)
            source.fail("damaged EXR: attribute '" + std::string(name) + "' has a wrong size");
}

// The same for types of which it reads as much as their own numbers say.
void checkOwnSize(const Cursor& begin, std::string_view name, std::string_view type,
                  int32_t size) {
    Cursor in = begin;
    const size_t end = in.position + size_t(size);
    bool right = type != "floatvector" || size % 4 == 0;
    if (type == "preview") {
        const uint64_t w = uint32_t(in.int32()), h = uint32_t(in.int32());
        const uint64_t pixels = (uint64_t(std::max(size, 8)) - 8) / 4;
        right = size >= 8 && size % 4 == 0 &&
                (w == 0 || h == 0 ? pixels == 0 : h <= pixels / w && w * h == pixels);
    }
    if (type == "stringvector") {
        while (right && in.position < end) {
            const int32_t length = in.int32();
            right = length >= 0 && in.position <= end && size_t(length) <= end - in.position;
            if (right) in.take(size_t(length));
        }
    }
    if (!right)
        in.source.fail("damaged EXR: attribute '" + std::string(name) +
                       "' is not as long as its parts");
}

// Reads one attribute; false at the end of the header.
bool readAttribute(Cursor& in, Part& part) {
    const std::string_view name = in.text();
    if (name.empty()) return false;
    const std::string_view type = in.text();
    const int32_t size = in.int32();
    const size_t begin = in.position;
    if (size < 0 || size_t(size) > in.source.bytes.size() - begin)
        in.source.fail("damaged EXR: attribute '" + std::string(name) +
                       "' is longer than the file");
    const size_t end = begin + size_t(size);
    checkFixedSize(in.source, name, type, size);
    checkOwnSize(in, name, type, size);
    if (type == "box2i" && name == "dataWindow") part.data = readWindow(in);
    if (type == "box2i" && name == "displayWindow") part.display = readWindow(in);
    if (type == "chlist") part.channels = countChannels(in, end);
    if (type == "compression") part.compression = *in.take(1);
    if (type == "int" && name == "chunkCount") part.chunkCount = uint64_t(uint32_t(in.int32()));
    if (type == "tiledesc" && name == "tiles") {
        const int64_t x = uint32_t(in.int32()), y = uint32_t(in.int32());
        part.tile = Window{x, y};
    }
    in.position = end;
    return true;
}

uint64_t linesPerChunk(unsigned compression) {
    switch (compression) {
        case 0: case 1: case 2: return 1;  // none, RLE, ZIPS
        case 3: case 5: return 16;         // ZIP, PXR24
        case 9: return 256;                // DWAB
        default: return 32;                // PIZ, B44, B44A, DWAA
    }
}

uint64_t ceilDiv(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

void checkPart(const ImageSource& source, const Part& part) {
    if (!part.data || !part.display) source.fail("damaged EXR: a window is missing");
    if (part.channels == 0) source.fail("EXR without channels");
    const uint64_t width = uint64_t(part.data->width), height = uint64_t(part.data->height);
    checkImageSize(source, width, height, pixelsPerByte);
    checkImageSize(source, uint64_t(part.display->width), uint64_t(part.display->height),
                   pixelsPerByte);

    uint64_t chunks = ceilDiv(height, linesPerChunk(part.compression));
    uint64_t bufferPixels = width * std::min(height, linesPerChunk(part.compression));
    if (part.tile) {
        const uint64_t x = uint64_t(part.tile->width), y = uint64_t(part.tile->height);
        if (x == 0 || y == 0 || x > source.maxPixels / y)
            source.fail("damaged EXR: tiles of " + std::to_string(x) + " x " + std::to_string(y));
        chunks = ceilDiv(width, x) * ceilDiv(height, y);
        bufferPixels = std::max(bufferPixels, x * y);
    }
    chunks = std::max(chunks, part.chunkCount);
    if (chunks > source.bytes.size() / 8)
        source.fail("damaged EXR: the file is too short for its " + std::to_string(chunks) +
                    " blocks (truncated?)");
    const uint64_t limit = std::max(harmlessBuffer, source.bytes.size() * 1024);
    if (bufferPixels > limit / 4 / part.channels)
        source.fail("damaged EXR: one block would take more than " +
                    std::to_string(limit >> 20) + " MiB");
}

}  // namespace

void checkExrHeader(const ImageSource& source) {
    Cursor in{source};
    in.take(4);
    const uint32_t version = uint32_t(in.int32());
    const bool multiPart = (version & versionMultiPart) != 0;
    constexpr int mostParts = 1024;
    for (int parts = 0; parts < mostParts; ++parts) {
        // In a multi-part file an empty header ends the list of parts.
        if (multiPart && parts > 0 && in.position < source.bytes.size() &&
            source.bytes[in.position] == std::byte(0))
            return;
        Part part;
        while (readAttribute(in, part)) {}
        checkPart(source, part);
        if (!multiPart) return;
    }
    source.fail("damaged EXR: more than " + std::to_string(mostParts) + " parts");
}

}  // namespace gp::io
