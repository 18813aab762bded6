// PNG through libpng. libpng reports errors by longjmp, which must not pass over destructors:
// everything between setjmp and the end of a call works on plain pointers owned by the caller.
#include <csetjmp>
#include <cstdlib>
#include <cstring>

#include <png.h>

#include "io/file.h"
#include "io/image_codec.h"
#include "io/image_file.h"

namespace gp::io {

namespace {

constexpr size_t signatureBytes = 8;
constexpr size_t harmlessBlock = size_t(8) << 20;

// The state of one reading; `message` receives libpng's words.
struct PngReader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const uint8_t* data = nullptr;
    size_t size = 0;
    size_t position = 0;
    size_t largestBlock = harmlessBlock;  // of memory that libpng may ask for
    char message[128] = "";

    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct PngWriter {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<std::byte> bytes;
    char message[128] = "";

    ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

template <typename State>
void onError(png_structp png, png_const_charp text) {
    State& state = *static_cast<State*>(png_get_error_ptr(png));
    std::strncpy(state.message, text, sizeof state.message - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

// libpng only warns of chunks above its own limit, and then makes room for them all the same.
png_voidp onAllocate(png_structp png, png_alloc_size_t size) {
    const PngReader& reader = *static_cast<PngReader*>(png_get_mem_ptr(png));
    return size <= reader.largestBlock ? std::malloc(size) : nullptr;
}

void onFree(png_structp, png_voidp block) { std::free(block); }

void onRead(png_structp png, png_bytep target, png_size_t count) {
    PngReader& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > reader.size - reader.position) png_error(png, "the file ends too early");
    std::memcpy(target, reader.data + reader.position, count);
    reader.position += count;
}

void onWrite(png_structp png, png_bytep source, png_size_t count) {
    PngWriter& writer = *static_cast<PngWriter*>(png_get_io_ptr(png));
    const std::byte* first = reinterpret_cast<const std::byte*>(source);
    writer.bytes.insert(writer.bytes.end(), first, first + count);
}

void onFlush(png_structp) {}

bool readHeader(PngReader& r) {
    if (setjmp(png_jmpbuf(r.png))) return false;
    // Sizes are our business (checkImageSize); text and profiles are not worth memory.
    png_set_user_limits(r.png, 0x7fffffffu, 0x7fffffffu);
    png_set_chunk_malloc_max(r.png, harmlessBlock);
    png_set_chunk_cache_max(r.png, 64);
    png_set_read_fn(r.png, &r, onRead);
    png_read_info(r.png, r.info);
    return true;
}

// To four channels of 8 or 16 bits, values as stored: no gamma is applied.
bool readPixels(PngReader& r, uint8_t* pixels, size_t rowBytes, uint32_t height, bool wide) {
    if (setjmp(png_jmpbuf(r.png))) return false;
    png_set_expand(r.png);
    png_set_gray_to_rgb(r.png);
    png_set_filler(r.png, 0xffff, PNG_FILLER_AFTER);
    if (wide) png_set_swap(r.png);  // files are big-endian
    const int passes = png_set_interlace_handling(r.png);
    png_read_update_info(r.png, r.info);
    if (png_get_rowbytes(r.png, r.info) != rowBytes) png_error(r.png, "unexpected row size");
    for (int pass = 0; pass < passes; ++pass)
        for (uint32_t y = 0; y < height; ++y)
            png_read_row(r.png, pixels + y * rowBytes, nullptr);
    png_read_end(r.png, nullptr);
    return true;
}

Image floatsFromWide(const std::vector<uint16_t>& wide, uint32_t width, uint32_t height) {
    Image image = allocateImage(width, height, PixelFormat::rgba32f);
    for (size_t i = 0; i < wide.size(); ++i) image.floats()[i] = float(wide[i]) / 65535.0f;
    return image;
}

bool writePixels(PngWriter& w, uint32_t width, uint32_t height, const uint8_t* rgba,
                 PngPixel pixel) {
    if (setjmp(png_jmpbuf(w.png))) return false;
    png_set_write_fn(w.png, &w, onWrite, onFlush);
    const bool alpha = pixel == PngPixel::rgba;
    png_set_IHDR(w.png, w.info, width, height, 8,
                 alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(w.png, w.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(w.png, 4);  // a third of the default's time for 2 % more bytes
    png_write_info(w.png, w.info);
    if (!alpha) png_set_filler(w.png, 0, PNG_FILLER_AFTER);  // the fourth byte is left out
    for (uint32_t y = 0; y < height; ++y) png_write_row(w.png, rgba + size_t(y) * width * 4);
    png_write_end(w.png, w.info);
    return true;
}

}  // namespace

bool isPng(std::span<const std::byte> bytes) {
    return bytes.size() >= signatureBytes &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, signatureBytes) == 0;
}

Image decodePng(const ImageSource& source) {
    PngReader r;
    r.data = source.data();
    r.size = source.bytes.size();
    r.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &r, onError<PngReader>, onWarning, &r,
                                     onAllocate, onFree);
    if (r.png) r.info = png_create_info_struct(r.png);
    if (!r.info) throw std::bad_alloc();
    if (!readHeader(r)) source.fail(std::string("damaged PNG: ") + r.message);

    const uint32_t width = png_get_image_width(r.png, r.info);
    const uint32_t height = png_get_image_height(r.png, r.info);
    // Deflate turns one byte into at most 1,032; a pixel has at least one bit.
    checkImageSize(source, width, height, 1032 * 8);
    r.largestBlock += size_t(width) * 8;  // a row
    const bool wide = png_get_bit_depth(r.png, r.info) == 16;
    if (wide) {
        std::vector<uint16_t> values(size_t(width) * height * 4);
        if (!readPixels(r, reinterpret_cast<uint8_t*>(values.data()), size_t(width) * 8, height,
                        true))
            source.fail(std::string("damaged PNG: ") + r.message);
        return floatsFromWide(values, width, height);
    }
    Image image = allocateImage(width, height, PixelFormat::rgba8);
    if (!readPixels(r, image.bytes(), size_t(width) * 4, height, false))
        source.fail(std::string("damaged PNG: ") + r.message);
    return image;
}

void savePng(const std::string& path, uint32_t width, uint32_t height, const uint8_t* rgba,
             PngPixel pixel) {
    PngWriter w;
    w.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &w, onError<PngWriter>, onWarning);
    if (w.png) w.info = png_create_info_struct(w.png);
    if (!w.info) throw std::bad_alloc();
    if (!writePixels(w, width, height, rgba, pixel))
        throw FileError(FileError::Kind::writeFailed, path,
                        std::string("cannot be written: ") + w.message);
    AtomicFile file(path);
    file.write(w.bytes);
    file.commit();
}

}  // namespace gp::io
