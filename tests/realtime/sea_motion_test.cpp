// The triangles of the sea go with the camera, and yet motion vectors, gradients and histories are
// those of the water.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 40, height = 30;
constexpr double fov = 0.9;

struct View {
    glm::dvec3 position{0, 3, 0}, forward{0, -0.45, -1};

    GpCameraDesc desc() const {
        GpCameraDesc c{};
        put(c.position, position), put(c.target, position + forward);
        c.verticalFov = float(fov);
        return c;
    }
    glm::dvec3 f() const { return glm::normalize(forward); }
    glm::dvec3 right() const { return glm::normalize(glm::cross(f(), glm::dvec3(0, 1, 0))); }
    // Through a point of the picture, in pixels; unit depth.
    glm::dvec3 ray(glm::dvec2 pixel) const {
        const double half = std::tan(fov / 2) / (height / 2.0);
        return f() + right() * ((pixel.x - width / 2.0) * half) +
               glm::cross(right(), f()) * ((height / 2.0 - pixel.y) * half);
    }
    glm::dvec2 project(glm::dvec3 p) const {
        const glm::dvec3 d = p - position;
        const double half = glm::dot(d, f()) * std::tan(fov / 2) / (height / 2.0);
        return {width / 2.0 + glm::dot(d, right()) / half,
                height / 2.0 - glm::dot(d, glm::cross(right(), f())) / half};
    }
};

struct SeaScene {
    Stage stage;
    GpFrame frame;
    GpRenderOptions options{};

    explicit SeaScene(const GpOceanDesc& desc) : stage(variant()) {
        frame = stage.frame(width, height);
        stage.surround(glm::vec3(1));
        stage.check(gpSetOcean(stage.scene, &desc));
        options.realtime.denoiser = GP_DENOISER_NONE;
        options.realtime.antiAliasing = GP_AA_NONE;
    }
    static Variant variant() {
        Variant v = bestFullVariant().front();
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    void render(const View& view) {
        const GpCameraDesc camera = view.desc();
        stage.check(gpRender(frame, stage.scene, &camera, &options));
    }
    std::vector<glm::vec4> layer(const char* name) {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }
    std::vector<glm::vec4> motion(const View& view) {
        render(view);
        return layer("motion");
    }
};

TEST(SeaMotion, OfCalmWaterIsThatOfThePlane) {
    GpOceanDesc desc{};
    desc.given = GP_GIVEN_WIND;
    desc.resolution = 64;
    SeaScene sea(desc);
    View before, now;
    now.position = {0.7, 3.4, -0.5}, now.forward = {0.05, -0.43, -1};
    sea.motion(before);
    const std::vector<glm::vec4> motion = sea.motion(now);
    double longest = 0;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec2 pixel(x + 0.5, y + 0.5);
            const glm::dvec3 ray = now.ray(pixel);
            if (ray.y > -0.1) continue;
            const glm::dvec3 p = now.position - ray * (now.position.y / ray.y);
            const glm::dvec2 expected = before.project(p) - pixel;
            const glm::vec4 found = motion[y * width + x];
            longest = std::max(longest, glm::length(expected));
            ASSERT_NEAR(found.x, expected.x, 0.05) << x << ' ' << y;
            ASSERT_NEAR(found.y, expected.y, 0.05) << x << ' ' << y;
        }
    EXPECT_GT(longest, 5);
}

TEST(SeaMotion, WavesMoveAndAreKnown) {
    GpOceanDesc desc{};
    desc.wind = 12;
    desc.resolution = 64;
    SeaScene sea(desc);
    const View view;
    sea.stage.check(gpSetOceanTime(sea.stage.scene, 5));
    sea.motion(view);
    sea.stage.check(gpSetOceanTime(sea.stage.scene, 5.1));
    const std::vector<glm::vec4> moving = sea.motion(view);
    const std::vector<glm::vec4> still = sea.motion(view);
    double sum = 0, rest = 0;
    for (size_t i = width * (height - 10); i < moving.size(); ++i) {
        sum += double(std::hypot(moving[i].x, moving[i].y));
        rest += double(std::hypot(still[i].x, still[i].y));
    }
    EXPECT_GT(sum / (10 * width), 0.05);  // pixels; a tenth of a second of metre-high waves
    EXPECT_LT(rest / (10 * width), 0.01);
}

// The water of the lower half of the picture after some frames of A-SVGF.
struct Remembered {
    double frames = 0;  // of specular light
    double change = 0;  // of it, as gradients say
};

Remembered after(int frames, glm::dvec3 step) {
    GpOceanDesc desc{};
    desc.resolution = 64;
    SeaScene sea(desc);
    sea.options.realtime.denoiser = GP_DENOISER_ASVGF;
    View view;
    for (int i = 0; i < frames; ++i) {
        sea.render(view);
        view.position += step;
    }
    const auto length = sea.layer("history_length"), gradient = sea.layer("gradient");
    Remembered mean;
    const size_t first = width * (height / 2);
    for (size_t i = first; i < length.size(); ++i) {
        mean.frames += 255 * double(length[i].y) / double(length.size() - first);
        mean.change += double(gradient[i].z) / double(length.size() - first);
    }
    return mean;
}

// Without waves that move nothing changes but the view, and that by little.
TEST(SeaMotion, HistoriesLastUnderAMovingCamera) {
    constexpr int frames = 12;
    const Remembered still = after(frames, {0, 0, 0});
    EXPECT_GT(still.frames, 0.85 * frames);
    for (const glm::dvec3 step : {glm::dvec3(0.02, 0, -0.03), glm::dvec3(0, 0.03, 0)}) {
        const Remembered moving = after(frames, step);
        EXPECT_GT(moving.frames, 0.6 * still.frames);
        EXPECT_LT(moving.change, 0.05);
    }
}

// What a trough shows is often another wave, which shows the sky.
TEST(SeaMotion, LightBouncesTwiceUnlessToldOtherwise) {
    GpOceanDesc desc{};
    desc.wind = 15;
    const auto colors = [&](int bounces) -> std::vector<glm::vec4> {
        SeaScene sea(desc);
        sea.options.maxBounces = bounces;
        sea.render({{0, 3, 0}, {0, -0.1, -1}});
        return sea.stage.read<glm::vec4>(sea.frame, GP_IMAGE_COLOR, width * height);
    };
    const auto light = [](const std::vector<glm::vec4>& pixels) {
        double sum = 0;
        for (const glm::vec4& c : pixels) sum += double(c.y);
        return sum;
    };
    const auto byDefault = colors(0);
    EXPECT_EQ(byDefault, colors(2));
    EXPECT_GT(light(byDefault), 1.01 * light(colors(1)));
}

}  // namespace
}  // namespace gp::test
