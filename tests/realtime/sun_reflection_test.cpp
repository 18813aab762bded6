// What facets of slopes reflect of suns is kept out of the denoiser: it has no noise, nothing is
// counted twice, and nothing else changes.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 36, height = 24;
constexpr size_t pixelCount = width * height;

struct Facets {
    const char* name;
    const char *metallic, *method, *transmission;
};

// A floor of facets, and a plate before the sun that hides a part of it.
struct Glitter {
    Stage stage;
    GpFrame frame = nullptr;
    GpLight sun = nullptr;
    GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0.6f, 0.8f}, 6, 2.5f);
    GpRenderOptions options{};

    explicit Glitter(GpFrameMode mode = GP_MODE_REALTIME) : stage([&] {
        Variant v = bestFullVariant().front();
        v.mode = mode;
        return v;
    }()) {
        stage.surround({0.3f, 0.4f, 0.5f});
        frame = stage.frame(width, height);
        options = stage.options(0);
        if (mode == GP_MODE_REALTIME) options.realtime.antiAliasing = GP_AA_NONE;
    }
    GpInstance addFacets(const Facets& f, glm::vec3 corner, float side) {
        const GpBsdfParameter parameters[] = {
            {"alpha_x", "0.2"}, {"alpha_y", "0.2"}, {"metallic", f.metallic},
            {"method", f.method}, {"transmission", f.transmission}, {"density", "2000"},
            {"thin", "1"}, {"base_color", "0.9,0.6,0.3"}};
        GpBsdfDesc bsdf{};
        bsdf.model = "glint", bsdf.parameters = parameters;
        bsdf.parameterCount = uint32_t(std::size(parameters));
        GpMaterialDesc desc{};
        desc.bsdf = gpNewBsdf(stage.device, &bsdf);
        if (!desc.bsdf) stage.check(gpGetError(stage.device, nullptr));
        Triangles floor;
        floor.quad(corner, {side, 0, 0}, {0, 0, -side});
        return stage.add(floor, stage.material(desc));
    }
    void addSun(float radius, glm::vec3 direction = {0, -0.7f, 0.7f}) {
        GpLightDesc d{};
        d.kind = GP_LIGHT_DIRECTIONAL, d.intensity = 2, d.angularRadius = radius;
        put(d.direction, direction);
        sun = gpNewLight(stage.scene, &d);
    }
    void addBall() {
        Triangles ball;
        ball.sphere({-0.6f, 0.5f, 0}, 0.5f, 12, false, true);
        stage.add(ball, stage.lambert({0.8f, 0.4f, 0.2f}));
    }
    void render() { stage.check(gpRender(frame, stage.scene, &camera, &options)); }
    GpError read(const char* name, std::vector<glm::vec4>& pixels) {
        pixels.resize(pixelCount);
        return gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16);
    }
    std::vector<glm::vec4> layer(const char* name) {
        std::vector<glm::vec4> pixels;
        stage.check(read(name, pixels));
        return pixels;
    }
    std::vector<glm::vec4> color() {
        return stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, pixelCount);
    }
};

constexpr Facets metal{"metal", "1", "dictionary", "0"}, paint{"paint", "0", "smooth", "0"},
    sheet{"sheet", "0", "smooth", "0.9"};
constexpr glm::vec3 wholeFloor(-5, 0, 5);

// Lit from the viewer's side and, through the sheet, from the other one; with a penumbra.
TEST(SunReflection, TheMeanOfFramesIsTheReference) {
    for (const Facets& f : {metal, paint, sheet})
        for (const float y : {-0.7f, 0.7f}) {
            if (y > 0 && std::string(f.transmission) == "0") continue;
            glm::dvec3 mean[2]{};
            for (const bool realtime : {false, true}) {
                Glitter g(realtime ? GP_MODE_REALTIME : GP_MODE_REFERENCE);
                g.addFacets(f, wholeFloor, 10), g.addBall();
                g.addSun(0.05f, {0, y, 0.7f});
                const uint32_t frames = effort(96);
                for (uint32_t i = 0; i < (realtime ? frames : 1); ++i) {
                    g.options = g.stage.options(realtime ? 0 : 2 * frames);
                    g.options.seed = i, g.options.maxBounces = 1;
                    if (!realtime) {
                        g.options.pixelFilter = GP_PIXEL_BOX;
                    } else {
                        g.options.realtime.antiAliasing = GP_AA_JITTER;
                        g.options.realtime.denoiser = GP_DENOISER_NONE;
                        g.options.realtime.resetHistory = 1;
                    }
                    g.render();
                    for (const glm::vec4& p : g.color())
                        mean[realtime] += glm::dvec3(p) / double(pixelCount * (realtime ? frames
                                                                                        : 1));
                }
            }
            // Noise of both, and that a Gaussian stands for the disc.
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(mean[1][c] / mean[0][c], 1, 0.01) << f.name << ' ' << y;
        }
}

// Also at the pixels that repeat others for A-SVGF: from frame to frame no bit changes, and no
// denoiser has a say.
TEST(SunReflection, NothingOfItIsChance) {
    std::vector<glm::vec4> first;
    for (const GpDenoiser denoiser : {GP_DENOISER_NONE, GP_DENOISER_ASVGF, GP_DENOISER_BMFR}) {
        Glitter g;
        g.addFacets(metal, wholeFloor, 10), g.addSun(0.02f);
        g.options.realtime.denoiser = denoiser;
        for (int i = 0; i < 5; ++i) {
            g.options.seed = uint64_t(i);
            g.render();
            const std::vector<glm::vec4> sun = g.layer("sun");
            if (first.empty()) first = sun;
            ASSERT_EQ(sun, first) << denoiser << ' ' << i;
        }
        // The layers add up to the picture.
        const auto color = g.color();
        const auto emission = g.stage.read<glm::vec4>(g.frame, GP_IMAGE_EMISSION, pixelCount);
        const auto direct = g.stage.read<glm::vec4>(g.frame, GP_IMAGE_DIRECT, pixelCount);
        const auto indirect = g.stage.read<glm::vec4>(g.frame, GP_IMAGE_INDIRECT, pixelCount);
        double light = 0;
        for (size_t i = 0; i < color.size(); ++i) {
            light += double(first[i].y) / double(pixelCount);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(color[i][c], emission[i][c] + direct[i][c] + indirect[i][c],
                            2e-3 * color[i][c]);
        }
        EXPECT_GT(light, 0.05);
    }
}

// Behind the plate it is dark; its matte base's light has stayed in the denoiser.
TEST(SunReflection, ThingsHideIt) {
    Glitter g;
    g.addFacets(paint, wholeFloor, 10), g.addSun(0.01f);
    g.render();
    const auto open = g.layer("sun");
    Triangles plate;
    plate.quad({-4, 3, -5.5f}, {8, 0, 0}, {0, 0, 2.5f});
    g.stage.add(plate, g.stage.lambert(glm::vec3(0.5f)));
    g.render();
    const auto hidden = g.layer("sun");
    size_t lit = 0, dark = 0;
    for (size_t i = 0; i < pixelCount; ++i) {
        lit += open[i].y > 0, dark += open[i].y > 0 && hidden[i].y == 0;
        EXPECT_TRUE(hidden[i].y == 0 || hidden[i] == open[i]);
    }
    EXPECT_GT(lit, pixelCount / 2);
    EXPECT_GT(dark, lit / 10);
    EXPECT_LT(dark, lit);
}

// Whether a scene has facets somewhere makes no difference to what has none.
TEST(SunReflection, OtherSurfacesAreTheSameBitByBit) {
    std::vector<glm::vec4> pictures[2];
    for (const bool facets : {false, true}) {
        Glitter g;
        Triangles floor;
        floor.quad(wholeFloor, {10, 0, 0}, {0, 0, -10});
        GpMaterialDesc gloss{};
        gloss.given = GP_GIVEN_ROUGHNESS, gloss.roughness = 0.3f, gloss.metallic = 1;
        g.stage.add(floor, g.stage.material(gloss));
        g.addBall(), g.addSun(0.02f);
        if (facets) g.addFacets(metal, {-1, -3, 1}, 2);  // under the floor
        g.options.realtime.antiAliasing = GP_AA_TEMPORAL;
        for (int i = 0; i < 4; ++i) g.render();
        pictures[facets] = g.color();
        std::vector<glm::vec4> pixels;
        EXPECT_EQ(g.read("sun", pixels),
                  facets ? GP_SUCCESS : GP_ERROR_INVALID_OPERATION);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

// Four bytes a pixel more, where they are needed, and no frame begins anew for that.
TEST(SunReflection, ItsImageComesWithoutForgetting) {
    Glitter g;
    g.addBall(), g.addSun(0.02f);
    for (int i = 0; i < 9; ++i) g.render();
    const auto bytes = [&] {
        GpFrameStatistics s{};
        g.stage.check(gpGetFrameStatistics(g.frame, &s));
        return s.frameBytes;
    };
    const auto frames = [&] {
        const auto length = g.layer("history_length"), depth = g.layer("depth");
        float most = 0;
        for (size_t i = 0; i < pixelCount; ++i)
            if (depth[i].x < 1e29f) most = std::max(most, 255 * length[i].x);
        return most;
    };
    EXPECT_GT(frames(), 6);
    const uint64_t before = bytes();
    const GpInstance floor = g.addFacets(metal, {-1, -3, 1}, 2);
    g.render();
    EXPECT_GT(frames(), 7);
    EXPECT_EQ(bytes(), before + 4 * pixelCount);
    g.stage.check(gpRemoveInstance(floor));
    g.render();
    EXPECT_GT(frames(), 8);
    std::vector<glm::vec4> pixels;
    EXPECT_EQ(g.read("sun", pixels), GP_ERROR_INVALID_OPERATION);
    g.addFacets(metal, {-1, -3, 1}, 2);
    g.render();
    EXPECT_GT(frames(), 9);
    EXPECT_EQ(g.read("sun", pixels), GP_SUCCESS);
    g.stage.check(gpRemoveLight(g.sun));
    g.render();
    EXPECT_EQ(g.read("sun", pixels), GP_ERROR_INVALID_OPERATION);
}

}  // namespace
}  // namespace gp::test
