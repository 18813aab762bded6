#include <cstdio>
#include <cstdlib>
#include <sstream>

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStdIO.h>
#include <ImfTiledOutputFile.h>
#include <jpeglib.h>
#include <png.h>

#include "io/sample_files.h"

namespace gp::test {

namespace {

void appendPng(png_structp png, png_bytep data, png_size_t count) {
    Bytes& out = *static_cast<Bytes*>(png_get_io_ptr(png));
    const std::byte* first = reinterpret_cast<const std::byte*>(data);
    out.insert(out.end(), first, first + count);
}
void flushPng(png_structp) {}

// Display window 4 x 3, the data window as given.
struct Plane {
    Imath::Box2i window;
    std::vector<float> r, g, b, a;
    explicit Plane(Imath::Box2i w) : window(w) {
        for (int y = w.min.y; y <= w.max.y; ++y)
            for (int x = w.min.x; x <= w.max.x; ++x) {
                r.push_back(float(x));
                g.push_back(float(y));
                b.push_back(7);
                a.push_back(0.5f);
            }
    }
};

const Imath::Box2i display({0, 0}, {3, 2});

template <typename T>
Imf::Slice slice(Imf::PixelType type, std::vector<T>& v, const Imath::Box2i& w) {
    return Imf::Slice::Make(type, v.data(), w, sizeof(T),
                            sizeof(T) * size_t(w.max.x - w.min.x + 1));
}

template <typename T>
std::vector<T> converted(const std::vector<float>& v) {
    std::vector<T> out;
    for (const float x : v) out.push_back(T(x));
    return out;
}

// Channels `prefix`R, G, B (and A) of a scanline or tiled file.
template <typename T>
void writePlanes(Imf::OStream& out, Imf::PixelType type, const Plane& plane,
                 const std::string& prefix, bool alpha, bool tiled) {
    Imf::Header header(display, plane.window);
    header.compression() = Imf::ZIP_COMPRESSION;
    std::vector<T> values[4] = {converted<T>(plane.r), converted<T>(plane.g),
                                converted<T>(plane.b), converted<T>(plane.a)};
    Imf::FrameBuffer frame;
    const char* letters[4] = {"R", "G", "B", "A"};
    for (int c = 0; c < (alpha ? 4 : 3); ++c) {
        header.channels().insert(prefix + letters[c], Imf::Channel(type));
        frame.insert(prefix + letters[c], slice(type, values[c], plane.window));
    }
    if (tiled) {
        header.setTileDescription(Imf::TileDescription(2, 2, Imf::MIPMAP_LEVELS));
        Imf::TiledOutputFile file(out, header, 0);
        file.setFrameBuffer(frame);
        for (int l = 0; l < file.numLevels(); ++l)
            file.writeTiles(0, file.numXTiles(l) - 1, 0, file.numYTiles(l) - 1, l);
    } else {
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(plane.window.max.y - plane.window.min.y + 1);
    }
}

void writeGray(Imf::OStream& out, Plane& plane) {
    Imf::Header header(display, plane.window);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer frame;
    frame.insert("Y", slice(Imf::FLOAT, plane.r, plane.window));
    Imf::OutputFile file(out, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(3);
}

// Larger than the others: chroma is stored for every second pixel and filtered.
void writeLumaChroma(Imf::OStream& out) {
    const Imath::Box2i w({0, 0}, {31, 31});
    std::vector<Imf::Rgba> pixels(32 * 32, Imf::Rgba(0.25f, 0.5f, 0.75f, 1.0f));
    Imf::RgbaOutputFile file(out, Imf::Header(w, w), Imf::WRITE_YC, 0);
    file.setFrameBuffer(pixels.data(), 1, 32);
    file.writePixels(32);
}

void writeMultiPart(Imf::OStream& out, Plane& plane) {
    Imf::Header depth(display, plane.window), beauty(display, plane.window);
    depth.setName("depth");
    depth.setType(Imf::SCANLINEIMAGE);
    depth.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    beauty.setName("beauty");
    beauty.setType(Imf::SCANLINEIMAGE);
    Imf::FrameBuffer frame, depthFrame;
    depthFrame.insert("Z", slice(Imf::FLOAT, plane.a, plane.window));
    for (auto [name, v] : {std::pair{"R", &plane.r}, {"G", &plane.g}, {"B", &plane.b}}) {
        beauty.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, slice(Imf::FLOAT, *v, plane.window));
    }
    const Imf::Header headers[2] = {depth, beauty};
    Imf::MultiPartOutputFile file(out, headers, 2, false, 0);
    Imf::OutputPart first(file, 0), second(file, 1);
    first.setFrameBuffer(depthFrame);
    first.writePixels(3);
    second.setFrameBuffer(frame);
    second.writePixels(3);
}

}  // namespace

Bytes samplePng(PngKind kind) {
    Bytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &out, appendPng, flushPng);
    const bool palette = kind == PngKind::palette, gray = kind == PngKind::gray;
    const bool wide = kind == PngKind::wide;
    png_set_IHDR(png, info, 5, 3, wide ? 16 : 8,
                 palette ? PNG_COLOR_TYPE_PALETTE
                 : gray  ? PNG_COLOR_TYPE_GRAY
                         : PNG_COLOR_TYPE_RGBA,
                 kind == PngKind::interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // A gamma that must not change the values.
    png_set_gAMA(png, info, 1.0);
    png_color colors[16];
    png_byte alphas[16];
    for (int i = 0; i < 16; ++i) {
        colors[i] = {png_byte(i), png_byte(10 + i), png_byte(20 + i)};
        alphas[i] = png_byte(100 + i);
    }
    if (palette) {
        png_set_PLTE(png, info, colors, 16);
        png_set_tRNS(png, info, alphas, 16, nullptr);
    }
    png_write_info(png, info);
    const size_t pixelBytes = palette || gray ? 1 : wide ? 8 : 4;
    std::vector<png_byte> pixels(15 * pixelBytes);
    // Byte k of pixel i is i * pixelBytes + k; palette and gray: i.
    for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = png_byte(i);
    std::vector<png_bytep> rows;
    for (size_t y = 0; y < 3; ++y) rows.push_back(pixels.data() + y * 5 * pixelBytes);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

Bytes sampleJpeg(JpegKind kind) {
    jpeg_compress_struct jpeg = {};
    jpeg_error_mgr errors = {};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &buffer, &size);
    const int channels = kind == JpegKind::gray ? 1 : kind == JpegKind::cmyk ? 4 : 3;
    jpeg.image_width = 16;
    jpeg.image_height = 8;
    jpeg.input_components = channels;
    jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 4 ? JCS_CMYK : JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (kind == JpegKind::progressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<unsigned char> row;
    for (int x = 0; x < 16; ++x) {
        const bool left = x < 8;
        if (channels == 1) row.push_back(left ? 50 : 200);
        if (channels == 3) row.insert(row.end(), {static_cast<unsigned char>(left ? 255 : 0),
                                                  static_cast<unsigned char>(left ? 0 : 255), 0});
        // Inverted inks, as Adobe's programs write them: 255 is no ink.
        if (channels == 4)
            row.insert(row.end(), {static_cast<unsigned char>(left ? 255 : 0),
                                   static_cast<unsigned char>(left ? 0 : 255), 0, 255});
    }
    while (jpeg.next_scanline < 8) {
        unsigned char* p = row.data();
        jpeg_write_scanlines(&jpeg, &p, 1);
    }
    jpeg_finish_compress(&jpeg);
    const std::byte* first = reinterpret_cast<const std::byte*>(buffer);
    const Bytes out(first, first + size);
    jpeg_destroy_compress(&jpeg);
    std::free(buffer);
    return out;
}

Bytes sampleExr(ExrKind kind) {
    Imf::StdOSStream out;
    Plane whole(display);
    switch (kind) {
        case ExrKind::rgbaHalf: writePlanes<half>(out, Imf::HALF, whole, "", true, false); break;
        case ExrKind::rgbFloat: writePlanes<float>(out, Imf::FLOAT, whole, "", false, false); break;
        case ExrKind::tiled: writePlanes<half>(out, Imf::HALF, whole, "", true, true); break;
        case ExrKind::uintRgb:
            writePlanes<unsigned>(out, Imf::UINT, whole, "", false, false);
            break;
        case ExrKind::layer:
            writePlanes<half>(out, Imf::HALF, whole, "view.x.", true, false);
            break;
        case ExrKind::smallWindow:
            writePlanes<float>(out, Imf::FLOAT, Plane({{1, 1}, {2, 1}}), "", false, false);
            break;
        case ExrKind::largeWindow:
            writePlanes<float>(out, Imf::FLOAT, Plane({{-2, -1}, {6, 5}}), "", false, false);
            break;
        case ExrKind::gray: writeGray(out, whole); break;
        case ExrKind::lumaChroma: writeLumaChroma(out); break;
        case ExrKind::multiPart: writeMultiPart(out, whole); break;
    }
    return bytesOf(out.str());
}

Bytes sampleHdr() {
    std::string s =
        "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 2 +X 16\n";
    for (int y = 0; y < 2; ++y) {
        s += {2, 2, 0, 16};
        s += {char(128 + 16), char(64)};                          // R: one run
        s += {4, 1, 2, 3, 4, char(128 + 12), char(9)};            // G: literals and a run
        s += {char(128 + 16), char(0)};                           // B
        s += {char(128 + 16), char(128)};                         // exponent: 2^-8 a step
    }
    return bytesOf(s);
}

std::vector<Bytes> greedyImages() {
    using namespace std::string_literals;
    // A chunk of text of almost 2 GiB.
    Bytes png = samplePng(PngKind::rgba);
    png.resize(8 + 25);  // signature and IHDR
    for (const char c : "\x7a\x54\x58\x74zTXt"s) png.push_back(std::byte(c));
    // A list of channels without its end: OpenEXR reads the next attribute as one more channel, and
    // behind it finds an attribute of 1.75 GiB.
    const Bytes inserted = bytesOf(
        "channels\0chlist\0\x12\0\0\0R\0\2\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0"
        "x\0string\0\x0e\0\0\0?????\0y\0z\0\0\0\0\x70"s);
    Bytes exr = sampleExr(ExrKind::rgbFloat);
    exr.insert(exr.begin() + 8, inserted.begin(), inserted.end());
    return {png, exr};
}

}  // namespace gp::test
