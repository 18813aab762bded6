// Any bytes must give an image of the size that it says, or a FileError.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <zlib.h>

#include "io/image_file.h"

namespace {

// libpng refuses a chunk with a wrong checksum before it looks at it; with right ones the fuzzer
// gets further.
void repairPngChecksums(std::vector<std::byte>& file) {
    uint8_t* p = reinterpret_cast<uint8_t*>(file.data());
    const auto word = [](const uint8_t* q) {
        return uint32_t(q[0]) << 24 | uint32_t(q[1]) << 16 | uint32_t(q[2]) << 8 | q[3];
    };
    for (size_t at = 8; at + 12 <= file.size();) {
        const size_t length = word(p + at);
        if (length > file.size() - at - 12) return;
        const uint32_t crc = uint32_t(crc32(0, p + at + 4, uInt(length + 4)));
        for (unsigned i = 0; i < 4; ++i) p[at + 8 + length + i] = uint8_t(crc >> (24 - 8 * i));
        at += length + 12;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::byte* first = reinterpret_cast<const std::byte*>(data);
    std::vector<std::byte> file(first, first + size);
    if (size > 8 && std::memcmp(data, "\x89PNG", 4) == 0) repairPngChecksums(file);
    try {
        const gp::Image image = gp::io::decodeImage(file, "fuzz", uint64_t(1) << 20);
        const size_t bytes = size_t(image.width) * image.height * gp::bytesPerPixel(image.format);
        if (bytes == 0 || image.pixels.size() != bytes) std::abort();
    } catch (const gp::io::FileError&) {
    }
    return 0;
}
