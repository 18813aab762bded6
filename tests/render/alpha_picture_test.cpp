// Files of pictures: opaque, or with alpha and straight colours; what hideBackground leaves out.
#include <array>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t w = 16, h = 16;
constexpr glm::vec3 paint(0.5f, 0.25f, 0.125f);

// Unlit, so that what a pixel shows of it is known: paint, times how much of the pixel it covers.
GpMaterialDesc painted(GpAlphaMode mode = GP_ALPHA_OPAQUE, float alpha = 1) {
    GpMaterialDesc d{};
    put(d.baseColor, paint);
    d.baseColor[3] = alpha;
    d.alphaMode = mode;
    d.unlit = 1;
    return d;
}

Triangles leftHalf() {
    Triangles t;
    t.quad({-0.5f, -0.5f, 0}, {0.5f, 0, 0}, {0, 1, 0});
    return t;
}

GpCameraDesc front() { return lookFrom({0, 0, 0}, {0, 0, 1}, 5, 1); }

GpRenderOptions display(const Stage& stage, uint32_t samples = 16) {
    GpRenderOptions o = stage.options(samples);
    o.tonemap = GP_TONEMAP_NONE;
    o.pixelFilter = GP_PIXEL_BOX;
    return o;
}

// A picture file as it is read again, and PNG's colour type in its header.
struct SavedPicture {
    std::vector<glm::vec4> pixels;
    int colorType = -1;
    glm::vec4 at(uint32_t x, uint32_t y) const { return pixels[y * w + x]; }
};

SavedPicture saved(const Stage& stage, GpFrame frame, int alpha, const char* ending = "png") {
    const std::string path = std::string(GP_BINARY_DIR "/alpha_picture.") + ending;
    GpSaveOptions options{};
    options.alpha = alpha;
    stage.check(gpSaveFrame(frame, path.c_str(), &options));
    SavedPicture picture;
    std::array<unsigned char, 26> header{};
    if (std::FILE* file = std::fopen(path.c_str(), "rb")) {
        EXPECT_EQ(std::fread(header.data(), 1, header.size(), file), header.size());
        std::fclose(file);
    }
    picture.colorType = header[25];  // of IHDR, which is the first chunk
    GpImage image{};
    stage.check(gpLoadImage(stage.device, path.c_str(), &image));
    EXPECT_EQ(image.width * image.height, w * h);
    for (size_t i = 0; i < w * h; ++i)
        picture.pixels.emplace_back(image.pixels[4 * i], image.pixels[4 * i + 1],
                                    image.pixels[4 * i + 2], image.pixels[4 * i + 3]);
    gpFreeImage(&image);
    std::remove(path.c_str());
    return picture;
}

// A step of 8 bits is at most this in linear light.
constexpr float byteStep = 0.005f;

void expectNear(glm::vec4 value, glm::vec4 expected, float tolerance, const char* what) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << what << c;
}

GpFrame rendered(Stage& stage, const GpRenderOptions& o) {
    const GpFrame frame = stage.frame(w, h);
    const GpCameraDesc camera = front();
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    return frame;
}

TEST(AlphaPicture, FilesAreOpaqueAsTheyLook) {
    Stage stage(bestFullVariant().front());
    stage.surround({0.25f, 0.5f, 1});
    stage.add(leftHalf(), stage.material(painted()));
    const GpFrame frame = rendered(stage, display(stage));
    const SavedPicture picture = saved(stage, frame, 0);
    EXPECT_EQ(picture.colorType, 2) << "RGB";
    expectNear(picture.at(3, 8), glm::vec4(paint, 1), byteStep, "surface ");
    expectNear(picture.at(12, 8), {0.25f, 0.5f, 1, 1}, byteStep, "sky ");
}

TEST(AlphaPicture, WithoutSurroundingsTheyAreBlack) {
    Stage stage(bestFullVariant().front());
    stage.add(leftHalf(), stage.material(painted()));
    const SavedPicture picture = saved(stage, rendered(stage, display(stage)), 0);
    expectNear(picture.at(12, 8), {0, 0, 0, 1}, 0, "nothing ");
}

// By chance, a ray in three or so passes: what a pixel has of the paint varies, its colour not.
TEST(AlphaPicture, ColoursAreDividedByCoverage) {
    for (const float ev : {0.0f, 1.0f}) {
        Stage stage(bestFullVariant().front());
        stage.surround(glm::vec3(7));
        stage.add(leftHalf(), stage.material(painted(GP_ALPHA_BLEND, 0.6f)));
        GpRenderOptions o = display(stage);
        o.hideBackground = 1;
        const GpFrame frame = rendered(stage, o);
        stage.check(gpTonemapFrame(frame, ev, GP_TONEMAP_NONE));
        const std::vector<glm::vec4> color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, w * h);
        const SavedPicture picture = saved(stage, frame, 1);
        EXPECT_EQ(picture.colorType, 6) << "RGBA";
        uint32_t between = 0;
        for (uint32_t i = 0; i < w * h; ++i) {
            const float alpha = color[i].w;
            between += alpha > 0.2f && alpha < 0.9f;
            const glm::vec4 expected =
                alpha > 0 ? glm::vec4(glm::min(paint * std::exp2(ev), 1.0f), alpha) : glm::vec4(0);
            expectNear(picture.pixels[i], expected, byteStep, "pixel ");
        }
        EXPECT_GT(between, w * h / 3);
        // Half floats keep them multiplied.
        const SavedPicture exr = saved(stage, frame, 1, "exr");
        for (uint32_t i = 0; i < w * h; ++i)
            expectNear(exr.pixels[i], glm::vec4(paint * color[i].w, color[i].w), 1e-3f, "exr ");
    }
}

TEST(AlphaPicture, TheOverlayIsOverNothing) {
    Stage stage(bestFullVariant().front());
    stage.add(leftHalf(), stage.material(painted()));
    const GpFrame frame = stage.frame(w, h);
    const float corners[] = {0, 0, 0, 16, 0, 0, 16, 8, 0, 0, 0, 0, 16, 8, 0, 0, 8, 0};
    GpDrawDesc panel{};
    panel.target = GP_DRAW_OVERLAY;
    panel.vertexCount = 6;
    panel.positions = corners;
    panel.color[0] = 1, panel.color[3] = 0.5f;
    panel.blend = 1;
    stage.check(gpDraw(frame, &panel));
    GpRenderOptions o = display(stage);
    o.hideBackground = 1;
    const GpCameraDesc camera = front();
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    const SavedPicture picture = saved(stage, frame, 1);
    // Red as it was given, half of it; over the paint halfway, in what a display is sent.
    expectNear(picture.at(12, 3), {1, 0, 0, 0.5f}, 0.01f, "over nothing ");
    const SavedPicture opaque = saved(stage, frame, 0);
    expectNear(picture.at(3, 3), opaque.at(3, 3), byteStep, "over paint ");
    EXPECT_GT(picture.at(3, 3).x, paint.x + 0.1f);
    expectNear(picture.at(12, 12), glm::vec4(0), 0, "below the panel ");
    expectNear(picture.at(3, 12), glm::vec4(paint, 1), byteStep, "below the panel ");
}

std::vector<Variant> modes() {
    std::vector<Variant> all = fullVariants();
    for (Variant v : bestFullVariant()) {
        for (const GpFrameMode mode : {GP_MODE_LOCAL, GP_MODE_REALTIME}) {
            v.mode = mode;
            v.name = mode == GP_MODE_LOCAL ? "local" : "realtime";
            all.push_back(v);
        }
    }
    return all;
}

class HiddenBackground : public ::testing::TestWithParam<Variant> {
protected:
    // Half of the picture is a mirror that shows what is behind the camera; in the other half are
    // sky, sky geometry, or a sun of which that is the middle.
    static std::vector<glm::vec4> picture(bool hidden, bool skyGeometry) {
        Stage stage(GetParam());
        stage.surround({0.25f, 0.5f, 1});
        GpMaterialDesc mirror{};
        mirror.given = GP_GIVEN_ROUGHNESS;
        mirror.metallic = 1;
        stage.add(leftHalf(), stage.material(mirror));
        GpLightDesc sun{};
        sun.intensity = 3;
        sun.angularRadius = 0.5f;
        put(sun.direction, {0, 0, 1});
        stage.light(sun);
        if (skyGeometry) {
            Triangles wall;
            wall.quad({-9, -9, -3}, {18, 0, 0}, {0, 18, 0});
            const GpInstance hill = stage.add(wall, stage.material(painted()));
            stage.check(gpSetInstanceVisibility(hill, GP_VISIBILITY_SKY, 0));
        }
        GpRenderOptions o = stage.options(GetParam().mode == GP_MODE_REALTIME ? 0 : 4);
        o.hideBackground = hidden;
        return stage.read<glm::vec4>(rendered(stage, o), GP_IMAGE_COLOR, w * h);
    }
};

TEST_P(HiddenBackground, IsBlackAndEverythingElseStays) {
    for (const bool skyGeometry : {false, true}) {
        const auto seen = picture(false, skyGeometry), hidden = picture(true, skyGeometry);
        uint32_t surfaces = 0, nothing = 0;
        for (uint32_t i = 0; i < w * h; ++i) {
            EXPECT_EQ(seen[i].w, hidden[i].w);
            if (seen[i].w == 1) {
                surfaces += seen[i].x + seen[i].y + seen[i].z > 0.1f;
                EXPECT_EQ(seen[i], hidden[i]) << i;
            } else if (seen[i].w == 0) {
                nothing += seen[i].x > 0.1f;
                EXPECT_EQ(hidden[i], glm::vec4(0)) << i;
            }
        }
        EXPECT_GT(nothing, 80u) << "there was something to be hidden";
        EXPECT_GT(surfaces, GetParam().mode == GP_MODE_LOCAL ? 0u : 80u);
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, HiddenBackground, ::testing::ValuesIn(modes()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
