// A box of the Cornell kind against a stored picture of 65,536 samples a pixel, pixel by pixel.
//
//     GP_UPDATE_REFERENCES=1 build/release/bin/test_render --gtest_filter='*Cornell*'
//
// makes data/cornell.exr and data/cornell_sigma.exr (its standard deviations) anew: some minutes. A
// failure leaves cornell_image.exr, cornell_reference.exr and cornell_z.exr in the build folder.
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t size = 24, referenceSamples = 65536;
const std::string folder = std::string(GP_SOURCE_DIR) + "/tests/render/data/";

void block(Triangles& t, glm::vec3 centre, glm::vec3 half, float angle) {
    Triangles box;
    box.box(-half, half);
    const float c = std::cos(angle), s = std::sin(angle);
    for (const glm::vec3 p : box.positions)
        t.positions.push_back(centre + glm::vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x));
}

void furnish(Stage& stage) {
    const glm::vec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    Triangles white, red, green, lamp;
    white.quad({-1, 0, -1}, z, x);  // floor, ceiling, back wall
    white.quad({-1, 2, -1}, x, z);
    white.quad({-1, 0, -1}, x, y);
    white.uv0.clear();
    block(white, {-0.34f, 0.6f, -0.35f}, {0.3f, 0.6f, 0.3f}, 0.314f);
    block(white, {0.36f, 0.3f, 0.3f}, {0.3f, 0.3f, 0.3f}, -0.297f);
    red.quad({-1, 0, -1}, y, z);
    green.quad({1, 0, -1}, z, y);
    lamp.quad({-0.25f, 1.995f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f});
    stage.add(white, stage.lambert(glm::vec3(0.73f)));
    stage.add(red, stage.lambert({0.6f, 0.06f, 0.05f}));
    stage.add(green, stage.lambert({0.12f, 0.45f, 0.1f}));
    stage.add(lamp, stage.lambert(glm::vec3(0), glm::vec3(17, 14.5f, 10.2f)));
}

Picture render(const Variant& variant, uint32_t samples, uint64_t seed) {
    Stage stage(variant);
    furnish(stage);
    GpCameraDesc c{};
    put(c.position, {0, 1, 4.6f});
    put(c.target, {0, 1, 0});
    c.verticalFov = 0.5585f;
    GpRenderOptions o = stage.options(samples);
    o.seed = seed, o.maxBounces = 8;
    return stage.render(size, size, c, o);
}

// Written and read by the library's own functions.
void save(const std::string& path, std::vector<glm::vec4> pixels) {
    Stage stage(fullVariants().back());
    GpImage image{};
    image.width = image.height = size, image.pixels = &pixels[0].x;
    stage.check(gpSaveImage(stage.device, path.c_str(), &image));
}

std::vector<glm::vec4> load(const std::string& path) {
    Stage stage(fullVariants().back());
    GpImage image{};
    stage.check(gpLoadImage(stage.device, path.c_str(), &image));
    const auto* first = reinterpret_cast<const glm::vec4*>(image.pixels);
    std::vector<glm::vec4> pixels(first, first + size_t(image.width) * image.height);
    gpFreeImage(&image);
    return pixels;
}

// How far one of n normal numbers may be off so that all are within in 99 of 100 cases.
// [Sidak 1967, "Rectangular Confidence Regions", JASA 62(318)]
double largestZ(double n) {
    const double one = 1 - std::pow(0.99, 1 / n);
    double lo = 0, hi = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = (lo + hi) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > one ? lo : hi) = middle;
    }
    return hi;
}

class Cornell : public ::testing::TestWithParam<Variant> {};

TEST_P(Cornell, AgreesWithTheReference) {
    if (const char* update = std::getenv("GP_UPDATE_REFERENCES");
        update && std::string(update) == "1") {
        if (GetParam().name != fullVariants().back().name) GTEST_SKIP() << "one variant makes it";
        Picture p = render(GetParam(), referenceSamples, 20261);
        for (glm::vec4& v : p.variance) v = glm::sqrt(v);
        save(folder + "cornell.exr", p.color);
        save(folder + "cornell_sigma.exr", p.variance);
        return;
    }
    const std::vector<glm::vec4> reference = load(folder + "cornell.exr");
    const std::vector<glm::vec4> sigma = load(folder + "cornell_sigma.exr");
    ASSERT_EQ(reference.size(), size_t(size) * size);
    ASSERT_EQ(sigma.size(), reference.size());
    const Picture p = render(GetParam(), effort(2048), 7);
    std::vector<glm::vec4> zs(reference.size());
    const double limit = largestZ(3.0 * size * size);
    double sum = 0, squares = 0, difference = 0, total = 0;
    size_t beyond = 0;
    for (size_t i = 0; i < reference.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            // Files of half floats: 11 bits.
            const double rounding = reference[i][c] / 2048 / std::sqrt(3.0), s = sigma[i][c];
            const double variance = p.variance[i][c] + s * s + rounding * rounding;
            const double d = p.color[i][c] - reference[i][c];
            const double z = variance > 0 ? d / std::sqrt(variance) : 0;
            zs[i][c] = float(z);
            sum += variance, squares += z * z, difference += d, total += reference[i][c];
            beyond += std::abs(z) > limit;
        }
    EXPECT_EQ(beyond, 0u) << "values beyond " << limit << " standard deviations";
    EXPECT_LT(squares / (3 * double(zs.size())), 1.2) << "the picture as a whole";
    EXPECT_LT(std::abs(difference), 4 * std::sqrt(sum) + 1e-4 * total)
        << "its mean: " << difference / total;
    EXPECT_LT(4 * std::sqrt(sum), 0.01 * total) << "too few samples";
    if (HasFailure()) {
        const std::string build = GP_BINARY_DIR;
        save(build + "/cornell_image.exr", p.color);
        save(build + "/cornell_reference.exr", reference);
        save(build + "/cornell_z.exr", zs);
    }
}

INSTANTIATE_TEST_SUITE_P(Best, Cornell, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
