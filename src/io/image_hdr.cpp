// Radiance pictures (.hdr, .pic): text header, then pixels of three mantissas and one exponent.
// Our own reader, because stb_image 2.27 (Debian 12) loops for ever on a run of length zero, takes
// truncated files for black ones, and ignores EXPOSURE.
// [Ward 1991, "Real Pixels", Graphics Gems II; the format as in Radiance's filefmts document]
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "io/file.h"
#include "io/image_codec.h"
#include "io/image_file.h"

namespace gp::io {

namespace {

struct Cursor {
    const ImageSource& source;
    size_t position = 0;

    size_t left() const { return source.bytes.size() - position; }
    uint8_t byte() {
        if (left() == 0) source.fail("damaged HDR: the file ends too early");
        return source.data()[position++];
    }
    std::string_view line() {
        const char* first = reinterpret_cast<const char*>(source.data()) + position;
        const void* end = std::memchr(first, '\n', left());
        if (!end) source.fail("damaged HDR: the header does not end");
        const size_t length = static_cast<size_t>(static_cast<const char*>(end) - first);
        position += length + 1;
        return {first, length};
    }
};

// The product of all EXPOSURE lines: stored values have been multiplied by it.
float readHeader(Cursor& in) {
    float exposure = 1;
    in.line();
    for (std::string_view line = in.line(); !line.empty(); line = in.line()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            in.source.unsupported("HDR in the format '" + std::string(line.substr(7, 40)) +
                                  "'; only 32-bit_rle_rgbe can be read");
        if (line.starts_with("EXPOSURE=")) {
            const float e = std::strtof(std::string(line.substr(9)).c_str(), nullptr);
            if (!(e > 0) || !std::isfinite(e)) in.source.fail("damaged HDR: bad EXPOSURE");
            exposure *= e;
        }
    }
    return exposure;
}

// Runs of the old kind: a pixel (1, 1, 1, n) repeats the last one; several in a row count as
// digits to the base of 256.
void readOldRow(Cursor& in, uint8_t* row, size_t width, size_t x) {
    unsigned shift = 0;
    while (x < width) {
        uint8_t* p = row + x * 4;
        for (int c = 0; c < 4; ++c) p[c] = in.byte();
        if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
            shift = 0;
            ++x;
            continue;
        }
        const size_t count = shift < 24 ? size_t(p[3]) << shift : width;
        if (x == 0 || count > width - x) in.source.fail("damaged HDR: a run leaves its row");
        for (size_t i = 0; i < count; ++i, ++x) std::memcpy(row + x * 4, row + (x - 1) * 4, 4);
        shift += 8;
    }
}

void readRow(Cursor& in, uint8_t* row, size_t width) {
    uint8_t start[4];
    for (uint8_t& b : start) b = in.byte();
    const bool runs = start[0] == 2 && start[1] == 2 && start[2] < 128;
    if (!runs || width < 8 || width > 0x7fff) {
        in.position -= 4;
        return readOldRow(in, row, width, 0);
    }
    if ((size_t(start[2]) << 8 | start[3]) != width)
        in.source.fail("damaged HDR: a row of the wrong length");
    for (size_t c = 0; c < 4; ++c) {
        for (size_t x = 0; x < width;) {
            const unsigned code = in.byte();
            const size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > width - x)
                in.source.fail("damaged HDR: a run leaves its row");
            if (code > 128) {
                const uint8_t value = in.byte();
                for (size_t end = x + count; x < end; ++x) row[x * 4 + c] = value;
            } else {
                for (size_t end = x + count; x < end; ++x) row[x * 4 + c] = in.byte();
            }
        }
    }
}

// Two numbers of a "-Y 512 +X 1024" line; other orientations are not found in practice.
bool parseResolution(std::string_view line, uint64_t& width, uint64_t& height) {
    unsigned long long w = 0, h = 0;
    const std::string text(line.substr(0, 64));
    if (std::sscanf(text.c_str(), "-Y %19llu +X %19llu", &h, &w) != 2) return false;
    width = w;
    height = h;
    return true;
}

// The three mantissas share the exponent of the largest; rounded, so that a round trip is exact.
void encodePixel(const float* rgba, uint8_t* out) {
    float rgb[3];
    for (int c = 0; c < 3; ++c)
        rgb[c] = rgba[c] > 0 ? std::min(rgba[c], 1.69e38f) : 0.0f;  // NaN and negatives: black
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    std::memset(out, 0, 4);
    if (largest < 1e-32f) return;
    int exponent = 0;
    const float mantissa = std::frexp(largest, &exponent);
    if (mantissa * 256.0f >= 255.5f) ++exponent;
    for (int c = 0; c < 3; ++c)
        out[c] = static_cast<uint8_t>(std::lround(std::ldexp(rgb[c], 8 - exponent)));
    out[3] = static_cast<uint8_t>(exponent + 128);
}

// One component of a row: literal stretches, and runs where four or more values are equal.
void writeRuns(const std::vector<uint8_t>& row, size_t c, size_t width, std::string& out) {
    const auto runAt = [&](size_t x) {
        size_t n = 1;
        while (n < 127 && x + n < width && row[(x + n) * 4 + c] == row[x * 4 + c]) ++n;
        return n;
    };
    for (size_t x = 0; x < width;) {
        size_t literals = 0;
        while (literals < 128 && x + literals < width && runAt(x + literals) < 4) ++literals;
        if (literals > 0) {
            out += static_cast<char>(literals);
            for (size_t i = 0; i < literals; ++i) out += static_cast<char>(row[(x + i) * 4 + c]);
            x += literals;
        } else {
            const size_t n = runAt(x);
            out += static_cast<char>(128 + n);
            out += static_cast<char>(row[x * 4 + c]);
            x += n;
        }
    }
}

}  // namespace

bool isHdr(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("#?RADIANCE") || text.starts_with("#?RGBE");
}

Image decodeHdr(const ImageSource& source) {
    Cursor in{source};
    const float scale = 1.0f / readHeader(in);
    uint64_t width = 0, height = 0;
    if (!parseResolution(in.line(), width, height))
        source.unsupported("HDR without a resolution line of the form '-Y height +X width'");
    // A run of at most 127 pixels takes two bytes in each of the four components.
    checkImageSize(source, width, height, 64);
    Image image = allocateImage(uint32_t(width), uint32_t(height), PixelFormat::rgba32f);
    std::vector<uint8_t> row(width * 4);
    float* out = image.floats();
    for (uint64_t y = 0; y < height; ++y) {
        readRow(in, row.data(), width);
        for (uint64_t x = 0; x < width; ++x, out += 4) {
            const uint8_t* p = row.data() + x * 4;
            const float unit = p[3] ? std::ldexp(scale, int(p[3]) - 136) : 0.0f;
            for (int c = 0; c < 3; ++c) out[c] = std::min(float(p[c]) * unit, 3.4e38f);
            out[3] = 1;
        }
    }
    return image;
}

void saveHdr(const std::string& path, uint32_t width, uint32_t height, const float* rgba) {
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) +
                      " +X " + std::to_string(width) + "\n";
    const bool runs = width >= 8 && width <= 0x7fff;
    std::vector<uint8_t> row(size_t(width) * 4);
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x)
            encodePixel(rgba + (size_t(y) * width + x) * 4, row.data() + size_t(x) * 4);
        if (!runs) {
            out.append(reinterpret_cast<const char*>(row.data()), row.size());
            continue;
        }
        out += {2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 0xff)};
        for (size_t c = 0; c < 4; ++c) writeRuns(row, c, width, out);
    }
    AtomicFile file(path);
    file.write({reinterpret_cast<const std::byte*>(out.data()), out.size()});
    file.commit();
}

}  // namespace gp::io
