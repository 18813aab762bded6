// JPEG through libjpeg-turbo, which reports errors by a callback that must not return: it jumps,
// over frames that hold plain pointers only.
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>
// After jpeglib.h, which it needs.
#include <jerror.h>

#include "io/image_codec.h"

namespace gp::io {

namespace {

// A small progressive file can ask for millions of passes over a large picture.
constexpr int maxScans = 500;

struct JpegReader {
    jpeg_decompress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    jpeg_progress_mgr progress = {};
    std::jmp_buf jump;
    char message[JMSG_LENGTH_MAX] = "";

    ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
};

void onError(j_common_ptr jpeg) {
    JpegReader& reader = *static_cast<JpegReader*>(jpeg->client_data);
    jpeg->err->format_message(jpeg, reader.message);
    std::longjmp(reader.jump, 1);
}

// libjpeg invents pixels for data that is missing or broken; to us that is an error.
void onMessage(j_common_ptr jpeg, int level) {
    if (level != -1) return;
    const int code = jpeg->err->msg_code;
    if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
        code == JWRN_ARITH_BAD_CODE || code == JWRN_MUST_RESYNC || code == JWRN_BOGUS_PROGRESSION)
        onError(jpeg);
}

void onProgress(j_common_ptr jpeg) {
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > maxScans)
        ERREXIT(jpeg, JERR_BAD_PROGRESSION);
}

bool readHeader(JpegReader& r, const ImageSource& source) {
    r.jpeg.err = jpeg_std_error(&r.errors);
    r.errors.error_exit = onError;
    r.errors.emit_message = onMessage;
    r.jpeg.client_data = &r;
    if (setjmp(r.jump)) return false;
    jpeg_create_decompress(&r.jpeg);
    r.progress.progress_monitor = onProgress;
    r.jpeg.progress = &r.progress;
    jpeg_mem_src(&r.jpeg, source.data(), static_cast<unsigned long>(source.bytes.size()));
    jpeg_read_header(&r.jpeg, TRUE);
    return true;
}

bool readPixels(JpegReader& r, uint8_t* pixels, size_t rowBytes) {
    if (setjmp(r.jump)) return false;
    const bool cmyk = r.jpeg.jpeg_color_space == JCS_CMYK || r.jpeg.jpeg_color_space == JCS_YCCK;
    r.jpeg.out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&r.jpeg);
    while (r.jpeg.output_scanline < r.jpeg.output_height) {
        uint8_t* row = pixels + r.jpeg.output_scanline * rowBytes;
        jpeg_read_scanlines(&r.jpeg, &row, 1);
    }
    jpeg_finish_decompress(&r.jpeg);
    return true;
}

// Adobe's files store the inks inverted: 255 is no ink.
void rgbaFromCmyk(Image& image, bool inverted) {
    uint8_t* p = image.bytes();
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        const unsigned light = inverted ? p[i + 3] : 255u - p[i + 3];
        for (size_t c = 0; c < 3; ++c) {
            const unsigned ink = inverted ? p[i + c] : 255u - p[i + c];
            p[i + c] = static_cast<uint8_t>((ink * light + 127) / 255);
        }
        p[i + 3] = 255;
    }
}

}  // namespace

bool isJpeg(std::span<const std::byte> bytes) {
    return bytes.size() >= 3 && bytes[0] == std::byte(0xff) && bytes[1] == std::byte(0xd8) &&
           bytes[2] == std::byte(0xff);
}

Image decodeJpeg(const ImageSource& source) {
    JpegReader r;
    if (!readHeader(r, source)) source.fail(std::string("damaged JPEG: ") + r.message);
    // Each block of 64 pixels takes at least one bit; subsampled and skipped ones share it.
    checkImageSize(source, r.jpeg.image_width, r.jpeg.image_height, 4096);
    Image image = allocateImage(r.jpeg.image_width, r.jpeg.image_height, PixelFormat::rgba8);
    if (!readPixels(r, image.bytes(), size_t(image.width) * 4))
        source.fail(std::string("damaged JPEG: ") + r.message);
    if (r.jpeg.out_color_space == JCS_CMYK)
        rgbaFromCmyk(image, r.jpeg.saw_Adobe_marker != FALSE);
    return image;
}

}  // namespace gp::io
