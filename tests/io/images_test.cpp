// Every kind of image file, in and out.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "io/image_file.h"
#include "io/sample_files.h"

using namespace gp;
using namespace gp::io;
using namespace gp::test;

namespace {

std::string inTemp(const std::string& name) {
    const auto folder = std::filesystem::temp_directory_path() / "gp-test-images";
    std::filesystem::create_directories(folder);
    return (folder / name).string();
}

std::string errorOf(const Bytes& bytes, uint64_t maxPixels = defaultMaxPixels) {
    try {
        decodeImage(bytes, "some.file", maxPixels);
    } catch (const FileError& e) {
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
        EXPECT_TRUE(std::string(e.what()).starts_with("some.file: ")) << e.what();
        return e.what();
    }
    return "no error";
}

glm::vec4 pixel(const Image& image, uint32_t x, uint32_t y) {
    const size_t i = (size_t(y) * image.width + x) * 4;
    if (image.format == PixelFormat::rgba8)
        return glm::vec4(image.bytes()[i], image.bytes()[i + 1], image.bytes()[i + 2],
                         image.bytes()[i + 3]);
    return {image.floats()[i], image.floats()[i + 1], image.floats()[i + 2],
            image.floats()[i + 3]};
}

}  // namespace

TEST(Png, KeepsStoredValuesWhateverTheGamma) {
    const Image rgba = decodeImage(samplePng(PngKind::rgba), "png");
    ASSERT_EQ(rgba.format, PixelFormat::rgba8);
    ASSERT_EQ(rgba.width, 5u);
    ASSERT_EQ(rgba.height, 3u);
    for (uint32_t i = 0; i < 60; ++i) EXPECT_EQ(rgba.bytes()[i], i);
    EXPECT_EQ(decodeImage(samplePng(PngKind::interlaced), "png").pixels, rgba.pixels);
}

TEST(Png, ExpandsGrayAndPalette) {
    const Image gray = decodeImage(samplePng(PngKind::gray), "png");
    EXPECT_EQ(pixel(gray, 2, 1), glm::vec4(7, 7, 7, 255));
    const Image palette = decodeImage(samplePng(PngKind::palette), "png");
    EXPECT_EQ(pixel(palette, 2, 1), glm::vec4(7, 17, 27, 107));
}

TEST(Png, SixteenBitsBecomeFloats) {
    const Image wide = decodeImage(samplePng(PngKind::wide), "png");
    ASSERT_EQ(wide.format, PixelFormat::rgba32f);
    // Pixel 1 has the bytes 8, 9, 10, ..., big-endian.
    EXPECT_FLOAT_EQ(pixel(wide, 1, 0).x, float(8 * 256 + 9) / 65535.0f);
    EXPECT_FLOAT_EQ(pixel(wide, 1, 0).w, float(14 * 256 + 15) / 65535.0f);
}

TEST(Jpeg, ReadsAllKinds) {
    for (const JpegKind kind : {JpegKind::rgb, JpegKind::progressive, JpegKind::cmyk}) {
        const Image image = decodeImage(sampleJpeg(kind), "jpeg");
        ASSERT_EQ(image.width, 16u);
        ASSERT_EQ(image.height, 8u);
        EXPECT_LT(glm::length(pixel(image, 2, 4) - glm::vec4(255, 0, 0, 255)), 8) << int(kind);
        EXPECT_LT(glm::length(pixel(image, 13, 4) - glm::vec4(0, 255, 0, 255)), 8) << int(kind);
    }
    const Image gray = decodeImage(sampleJpeg(JpegKind::gray), "jpeg");
    EXPECT_LT(glm::length(pixel(gray, 2, 4) - glm::vec4(50, 50, 50, 255)), 4);
}

TEST(Hdr, DecodesRunsAndExposure) {
    const Image image = decodeImage(sampleHdr(), "hdr");
    ASSERT_EQ(image.format, PixelFormat::rgba32f);
    // Exponent byte 128: mantissa / 256; EXPOSURE=2 halves it.
    EXPECT_EQ(pixel(image, 0, 0), glm::vec4(64 / 512.0f, 1 / 512.0f, 0, 1));
    EXPECT_EQ(pixel(image, 3, 1), glm::vec4(64 / 512.0f, 4 / 512.0f, 0, 1));
    EXPECT_EQ(pixel(image, 15, 1), glm::vec4(64 / 512.0f, 9 / 512.0f, 0, 1));
}

TEST(Exr, ReadsAllKinds) {
    const auto read = [](ExrKind k) { return decodeImage(sampleExr(k), "exr"); };
    for (const ExrKind k : {ExrKind::rgbaHalf, ExrKind::rgbFloat, ExrKind::tiled, ExrKind::uintRgb,
                            ExrKind::layer, ExrKind::largeWindow, ExrKind::multiPart}) {
        const Image image = read(k);
        ASSERT_EQ(image.width, 4u) << int(k);
        ASSERT_EQ(image.height, 3u) << int(k);
        const bool alpha = k == ExrKind::rgbaHalf || k == ExrKind::tiled || k == ExrKind::layer;
        for (uint32_t y = 0; y < 3; ++y)
            for (uint32_t x = 0; x < 4; ++x)
                EXPECT_EQ(pixel(image, x, y), glm::vec4(x, y, 7, alpha ? 0.5f : 1.0f)) << int(k);
    }
    EXPECT_EQ(pixel(read(ExrKind::gray), 3, 2), glm::vec4(3, 3, 3, 1));
    const Image small = read(ExrKind::smallWindow);
    ASSERT_EQ(small.width, 4u);
    EXPECT_EQ(pixel(small, 0, 0), glm::vec4(0));
    EXPECT_EQ(pixel(small, 2, 1), glm::vec4(2, 1, 7, 1));
    EXPECT_EQ(pixel(small, 3, 1), glm::vec4(0));
    const Image luma = read(ExrKind::lumaChroma);
    EXPECT_LT(glm::length(pixel(luma, 16, 16) - glm::vec4(0.25f, 0.5f, 0.75f, 1)), 0.01f);
}

TEST(Writers, PngRoundTrip) {
    std::vector<uint8_t> rgba(7 * 5 * 4);
    for (size_t i = 0; i < rgba.size(); ++i) rgba[i] = uint8_t(i * 37);
    const std::string path = inTemp("out.png");
    savePng(path, 7, 5, rgba.data(), PngPixel::rgba);
    const Image back = loadImage(path);
    ASSERT_EQ(back.pixels.size(), rgba.size());
    EXPECT_EQ(std::memcmp(back.pixels.data(), rgba.data(), rgba.size()), 0);
}

TEST(Writers, HdrRoundTripWithinHalfAStep) {
    for (const uint32_t width : {3u, 300u}) {  // plain and run-length coded
        std::vector<float> rgba(size_t(width) * 4 * 4, 1.0f);
        for (size_t i = 0; i < rgba.size(); ++i)
            if (i % 4 != 3) rgba[i] = i % 50 < 25 ? 0.25f : std::exp(float(i % 29) - 14.0f);
        const std::string path = inTemp("out.hdr");
        saveHdr(path, width, 4, rgba.data());
        const Image back = loadImage(path);
        ASSERT_EQ(back.width, width);
        for (size_t p = 0; p < rgba.size(); p += 4) {
            const float largest = std::max({rgba[p], rgba[p + 1], rgba[p + 2]});
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(back.floats()[p + c], rgba[p + c], largest / 250.0f);
        }
        // What has been read is written without a further loss.
        saveHdr(path, width, 4, back.floats());
        EXPECT_EQ(loadImage(path).pixels, back.pixels);
    }
}

TEST(Writers, HdrTakesWhatItCannotStore) {
    const float values[8] = {std::nanf(""), -1, 0, 1, INFINITY, 3e38f, 1e-39f, 1};
    const std::string path = inTemp("odd.hdr");
    saveHdr(path, 2, 1, values);
    const Image back = loadImage(path);
    EXPECT_EQ(pixel(back, 0, 0), glm::vec4(0, 0, 0, 1));
    EXPECT_TRUE(std::isfinite(pixel(back, 1, 0).x));
    EXPECT_GT(pixel(back, 1, 0).x, 1e38f);
}

TEST(Writers, ExrRoundTripWithLayers) {
    std::vector<float> color(6 * 4 * 4), normal(6 * 4 * 3);
    for (size_t i = 0; i < color.size(); ++i) color[i] = float(i) * 0.37f - 3.0f;
    color[0] = 1e6f;  // beyond half
    for (size_t i = 0; i < normal.size(); ++i) normal[i] = float(i);
    const ImageLayer layers[2] = {{"", "RGBA", color.data()}, {"N", "XYZ", normal.data()}};
    const std::string path = inTemp("out.exr");
    saveExr(path, 6, 4, layers, ExrPixel::float32);
    const Image exact = loadImage(path);
    EXPECT_EQ(std::memcmp(exact.pixels.data(), color.data(), color.size() * 4), 0);
    saveExr(path, 6, 4, layers, ExrPixel::half);
    const Image half = loadImage(path);
    EXPECT_EQ(half.floats()[0], 65504.0f);
    for (size_t i = 1; i < color.size(); ++i)
        EXPECT_NEAR(half.floats()[i], color[i], std::abs(color[i]) / 1024 + 1e-6f);
}

TEST(Writers, FailureLeavesNothingBehind) {
    const float white[4] = {1, 1, 1, 1};
    const uint8_t bytes[4] = {};
    const ImageLayer layer[1] = {{"", "RGBA", white}};
    const std::string own = inTemp("of-this-test-only");  // others write beside it at this time
    const std::string folder = own + "/a-folder.d";
    std::filesystem::create_directories(folder + "/inside");
    const auto files = [&] {
        size_t n = 0;
        for (const auto& e : std::filesystem::directory_iterator(own)) n += e.exists();
        return n;
    };
    const size_t before = files();
    // The name is taken by a folder that is not empty: renaming must fail.
    EXPECT_THROW(saveExr(folder, 1, 1, layer, ExrPixel::half), FileError);
    EXPECT_THROW(savePng(folder, 1, 1, bytes, PngPixel::rgba), FileError);
    EXPECT_THROW(saveHdr(folder, 1, 1, white), FileError);
    EXPECT_THROW(savePng(own + "/none/x.png", 1, 1, bytes, PngPixel::rgb), FileError);
    EXPECT_THROW(saveExr(own + "/none/x.exr", 1, 1, layer, ExrPixel::half), FileError);
    EXPECT_EQ(files(), before);
}

TEST(BadImages, NamedInOneLine) {
    EXPECT_EQ(errorOf({}), "some.file: the image file is empty");
    EXPECT_NE(errorOf(bytesOf("GIF89a...")).find("not an image that can be read"),
              std::string::npos);
    try {
        loadImage(inTemp("missing.png"));
        FAIL();
    } catch (const FileError& e) {
        EXPECT_EQ(e.kind, FileError::Kind::notFound);
        EXPECT_NE(std::string(e.what()).find("missing.png: no such file"), std::string::npos);
    }
}

TEST(BadImages, EveryTruncationIsAnError) {
    std::vector<Bytes> files = {sampleHdr()};
    for (int k = 0; k < 5; ++k) files.push_back(samplePng(PngKind(k)));
    for (int k = 0; k < 4; ++k) files.push_back(sampleJpeg(JpegKind(k)));
    for (int k = 0; k < 10; ++k) files.push_back(sampleExr(ExrKind(k)));
    for (size_t f = 0; f < files.size(); ++f) {
        const Image whole = decodeImage(files[f], "whole");
        // A JPEG may lack its end marker's last byte and still be whole.
        for (size_t n = 0; n + 3 < files[f].size(); n += 1 + n / 40) {
            const Bytes cut(files[f].begin(), files[f].begin() + ptrdiff_t(n));
            try {
                // The smaller levels of a tiled EXR come last and are not read.
                EXPECT_EQ(decodeImage(cut, "cut").pixels, whole.pixels) << f << " cut to " << n;
                EXPECT_TRUE(f == 12 && n > files[f].size() * 3 / 4) << f << " cut to " << n;
            } catch (const FileError&) {
            }
        }
    }
}

// The fuzzer starts from them too, under a limit of memory.
TEST(BadImages, AskingForGigabytesIsAnError) {
    const std::vector<Bytes> files = greedyImages();
    EXPECT_NE(errorOf(files[0]).find("damaged PNG"), std::string::npos) << errorOf(files[0]);
    EXPECT_EQ(errorOf(files[1]),
              "some.file: damaged EXR: the list of channels has a wrong size");
}

TEST(BadImages, SizeIsCheckedBeforeAllocation) {
    EXPECT_EQ(errorOf(samplePng(PngKind::rgba), 14),
              "some.file: the image is too large (5 x 3 pixels; the limit is 14 pixels)");
    EXPECT_NE(errorOf(sampleJpeg(JpegKind::rgb), 100).find("16 x 8 pixels; the limit"),
              std::string::npos);
    EXPECT_NE(errorOf(sampleExr(ExrKind::tiled), 10).find("4 x 3 pixels; the limit"),
              std::string::npos);
    EXPECT_NE(errorOf(sampleHdr(), 31).find("16 x 2 pixels; the limit"), std::string::npos);
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    EXPECT_NE(errorOf(bytesOf(head + "-Y 99999999999 +X 99999999999\n")).find("too large"),
              std::string::npos);
    EXPECT_NE(errorOf(bytesOf(head + "-Y 16000 +X 16000\n")).find("truncated?"), std::string::npos);
    Bytes exr = sampleExr(ExrKind::rgbFloat);  // a data window of 16,384 x 16,384
    const std::string text(reinterpret_cast<const char*>(exr.data()), exr.size());
    for (const char* name : {"dataWindow", "displayWindow"}) {
        const size_t at = text.find(name) + std::strlen(name) + 1 + 6 + 4;
        exr[at + 8] = exr[at + 12] = std::byte(0xff);
        exr[at + 9] = exr[at + 13] = std::byte(0x3f);
    }
    EXPECT_NE(errorOf(exr).find("16384 x 16384 pixels, but the file has only"), std::string::npos);
}
