// Textures under rasterised geometry: the fast way against the plain one, the choice of the smaller
// copies, colour spaces, and perspective.
#include <cmath>
#include <random>

#include "backend/cpu/raster_view.h"
#include "backend/cpu/texture_view.h"
#include "render/canvas.h"

namespace gp::cpu::raster {
extern const RasterKernels kernelsX86_64, kernelsAvx2, kernelsAvx512;
}

namespace gp::test {
namespace {

class RasterTexture : public ::testing::TestWithParam<std::string> {};

const cpu::RasterKernels& kernelsOf(const std::string& set) {
    if (set == "avx512") return cpu::raster::kernelsAvx512;
    return set == "avx2" ? cpu::raster::kernelsAvx2 : cpu::raster::kernelsX86_64;
}

std::vector<glm::u8vec4> randomTexels(size_t count, uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<glm::u8vec4> texels(count);
    for (glm::u8vec4& t : texels)
        t = {uint8_t(random()), uint8_t(random()), uint8_t(random()), uint8_t(random())};
    return texels;
}

TEST_P(RasterTexture, TheFastWayIsThePlainWay) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> coordinate(-3, 4);
    std::vector<float> u(1000), v(1000);
    for (size_t i = 0; i < u.size(); ++i) u[i] = coordinate(random), v[i] = coordinate(random);
    // Borders of texels and of the image, and what is no place at all.
    const float special[] = {0, 1, -1, 2, 0.5f, 1.0f / 7, -1e-9f, 1 - 1e-7f, -0.0f};
    for (size_t i = 0; i < std::size(special); ++i) u[i] = special[i], v[i * 3 + 20] = special[i];
    for (Wrap wrap : {Wrap::repeat, Wrap::clampToEdge, Wrap::mirroredRepeat})
        for (ColorSpace space : {ColorSpace::linear, ColorSpace::srgb})
            for (const auto& [w, h] : {std::pair{7u, 5u}, {64u, 32u}, {1u, 1u}, {1u, 9u}}) {
                const auto texture = byteTexture(w, h, randomTexels(w * h, w), Filter::linear,
                                                 space, true, wrap);
                const cpu::TextureView view = cpu::textureView(*texture);
                for (uint32_t level = 0; level < view.levelCount; ++level) {
                    std::vector<glm::vec4> fast(u.size()), plain(u.size());
                    const auto& kernels = kernelsOf(GetParam());
                    kernels.sampleRow(view, level, u.data(), v.data(), u.size(), true, fast.data());
                    kernels.sampleRow(view, level, u.data(), v.data(), u.size(), false,
                                      plain.data());
                    // Coordinates are reduced another way: 1e-6 of a texel of 64 and of its steps.
                    for (size_t i = 0; i < u.size(); ++i)
                        for (int c = 0; c < 4; ++c)
                            ASSERT_NEAR(fast[i][c], plain[i][c], 1e-4)
                                << w << " x " << h << ", level " << level << ", wrap "
                                << int(wrap) << ", at " << u[i] << ", " << v[i];
                }
            }
}

TEST_P(RasterTexture, CoordinatesThatAreNoPlaceReadSomeTexel) {
    const auto texture = byteTexture(4, 4, std::vector<glm::u8vec4>(16, {51, 51, 51, 51}),
                                     Filter::linear);
    const cpu::TextureView view = cpu::textureView(*texture);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> u = {nan, inf, -inf, 3e38f, -3e38f, 1e9f, -1e9f};
    std::vector<glm::vec4> texels(u.size());
    kernelsOf(GetParam()).sampleRow(view, 0, u.data(), u.data(), u.size(), true, texels.data());
    for (const glm::vec4& t : texels) EXPECT_NEAR(t.x, 0.2f, 1e-6);
}

TEST_P(RasterTexture, TexelsStandWhereTheyShould) {
    // Nearest, a texel a pixel: the picture is the texture.
    const auto texels = randomTexels(16 * 8, 9);
    Canvas canvas(16, 8, GetParam());
    DrawCommand d = rectangleDraw({0, 0}, {16, 8});
    d.texture = byteTexture(16, 8, texels, Filter::nearest);
    canvas.draw({d}, true);
    for (size_t i = 0; i < texels.size(); ++i) ASSERT_EQ(canvas.display[i], texels[i]) << i;
    // Bilinear at the middles of texels is the same.
    d.texture = byteTexture(16, 8, texels, Filter::linear);
    canvas.display.assign(texels.size(), glm::u8vec4(0));
    canvas.draw({d}, true);
    for (size_t i = 0; i < texels.size(); ++i) ASSERT_EQ(canvas.display[i], texels[i]) << i;
}

TEST_P(RasterTexture, RadianceIsDecodedAndDisplaysAreNot) {
    Canvas canvas(4, 4, GetParam());
    DrawCommand d = rectangleDraw({0, 0}, {4, 4});
    d.texture = byteTexture(1, 1, {{188, 188, 10, 128}}, Filter::linear, ColorSpace::srgb);
    canvas.draw(d);
    EXPECT_NEAR(canvas.at(1, 1).x, shading::srgb_decode_1(188 / 255.0f), 1e-6);
    EXPECT_NEAR(canvas.at(1, 1).z, shading::srgb_decode_1(10 / 255.0f), 1e-6);
    EXPECT_NEAR(canvas.at(1, 1).w, 128 / 255.0f, 1e-6);
    canvas.draw({d}, true);
    EXPECT_EQ(canvas.display[5], glm::u8vec4(188, 188, 10, 128));
    // Floats are linear: encoded for a display.
    TextureDesc floats;
    floats.image.width = floats.image.height = 1;
    floats.image.format = PixelFormat::rgba32f;
    floats.image.pixels.resize(16);
    floats.colorSpace = ColorSpace::linear;
    const float linear = shading::srgb_decode_1(188 / 255.0f);
    for (int c = 0; c < 4; ++c) floats.image.floats()[c] = c == 3 ? 0.5f : linear;
    d.texture = makeTexture(std::move(floats));
    canvas.draw({d}, true);
    EXPECT_EQ(canvas.display[5], glm::u8vec4(188, 188, 188, 128));
}

// Far away a chessboard is grey, and between its copies brightness changes smoothly.
TEST_P(RasterTexture, SmallerCopiesAreTakenByTheSizeOfPixels) {
    std::vector<glm::u8vec4> board(64 * 64);
    for (uint32_t i = 0; i < board.size(); ++i)
        board[i] = glm::u8vec4((i + i / 64) % 2 ? 255 : 0);
    Canvas canvas(16, 16, GetParam());
    DrawCommand d = rectangleDraw({0, 0}, {16, 16});
    for (Filter filter : {Filter::linear, Filter::nearest}) {
        // 4 texels a pixel: the third copy, in which the board is its mean everywhere.
        d.texture = byteTexture(64, 64, board, filter, ColorSpace::linear, true);
        canvas.draw(d);
        for (const glm::vec4& c : canvas.color) ASSERT_NEAR(c.x, 128 / 255.0f, 1e-5);
    }
    // Without copies single texels show.
    d.texture = byteTexture(64, 64, board, Filter::nearest, ColorSpace::linear, false);
    canvas.draw(d);
    for (const glm::vec4& c : canvas.color) ASSERT_TRUE(c.x == 0 || c.x == 1);
    // Copies that tell which they are: level 1 of a one-coloured image cannot, so of one whose rows
    // are white and black in pairs of 2: level 1 alternates by rows, level 2 is grey.
    for (uint32_t i = 0; i < board.size(); ++i) board[i] = glm::u8vec4(i / 64 % 4 < 2 ? 255 : 0);
    d.texture = byteTexture(64, 64, board, Filter::linear, ColorSpace::linear, true);
    const auto contrast = [&](float texelsPerPixel) {
        for (glm::vec2& uv : d.texCoords)
            uv = glm::vec2(uv.x > 0 ? 1 : 0, uv.y > 0 ? 1 : 0) * (texelsPerPixel * 16 / 64);
        canvas.draw(d);
        float least = 1, most = 0;
        for (uint32_t y = 0; y < 16; ++y) {
            least = std::min(least, canvas.at(8, y).x);
            most = std::max(most, canvas.at(8, y).x);
        }
        return most - least;
    };
    EXPECT_NEAR(contrast(2), 1, 0.01) << "level 1 exactly";
    EXPECT_NEAR(contrast(4), 0, 0.01) << "level 2 exactly";
    EXPECT_GT(contrast(2.8f), 0.2) << "half way";
    EXPECT_LT(contrast(2.8f), 0.8) << "half way";
}

// A floor into the distance: coordinates are those of the point that the pixel's ray meets.
TEST_P(RasterTexture, PerspectiveIsCorrected) {
    Canvas canvas(64, 48, GetParam());
    canvas.camera.position = {0.2f, 1, 0};
    canvas.camera.target = {0.5f, 0.4f, -1};
    DrawCommand d = pixelDraw({});
    d.view = DrawView::camera;
    d.positions = {{-40, 0, 3, 1}, {40, 0, 3, 1}, {40, 0, -30, 1}, {-40, 0, -30, 1}};
    d.indices = {0, 1, 2, 0, 2, 3};
    d.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};  // (x, z) on the floor
    canvas.draw(d);
    const glm::vec3 forward = glm::normalize(canvas.camera.target - canvas.camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    const glm::vec3 up = glm::cross(right, forward);
    const float half = std::tan(0.5f * canvas.camera.verticalFov);
    size_t checked = 0;
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const float fx = (2 * (float(x) + 0.5f) / 64 - 1) * half * 64 / 48;
            const float fy = (1 - 2 * (float(y) + 0.5f) / 48) * half;
            const glm::vec3 ray = forward + right * fx + up * fy;
            if (ray.y > -0.01f) continue;
            const glm::vec3 p = canvas.camera.position - ray * (canvas.camera.position.y / ray.y);
            if (std::abs(p.x) > 39 || p.z < -29 || p.z > 2) continue;
            ++checked;
            ASSERT_NEAR(canvas.at(x, y).x, (p.x + 40) / 80, 2e-5) << x << ", " << y;
            ASSERT_NEAR(canvas.at(x, y).y, (3 - p.z) / 33, 2e-5) << x << ", " << y;
        }
    EXPECT_GT(checked, 1000u);
}

INSTANTIATE_TEST_SUITE_P(All, RasterTexture, ::testing::ValuesIn(instructionSetsHere()),
                         instructionSetName);

}  // namespace
}  // namespace gp::test
