// Files that stand in the place of textures by name, as a picture shows them.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "render/stage.h"

namespace gp::test {
namespace {

namespace fs = std::filesystem;

// IEC 61966-2-1, the other way round than gpSaveImage encodes: a PNG then holds these very bytes.
float decoded(float c) {
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

class TextureOverrides : public ::testing::TestWithParam<Variant> {
protected:
    // Each test is a process of its own, and several run at once.
    TextureOverrides()
        : stage(GetParam()),
          folder(::testing::TempDir() + "gp_overrides" + std::to_string(getpid())) {
        fs::remove_all(folder);
        fs::create_directories(folder + "/walls");
        GpTextureOverrides overrides{};
        overrides.folder = folder.c_str();
        stage.check(gpSetTextureOverrides(stage.device, &overrides));
    }
    ~TextureOverrides() override { fs::remove_all(folder); }

    // One colour, as the numbers of a file; `texels` wide.
    void write(const std::string& name, glm::vec4 value, uint32_t texels = 1) {
        std::vector<glm::vec4> pixels(texels * texels, glm::vec4(decoded(value.x),
                                      decoded(value.y), decoded(value.z), value.w));
        const GpImage image = {texels, texels, &pixels[0].x, 0};
        stage.check(gpSaveImage(stage.device, (folder + "/" + name).c_str(), &image));
    }
    // A grey texture of the application.
    GpTexture texture(const char* name) {
        static const uint8_t grey[4] = {188, 188, 188, 255};  // 0.5029 in linear light
        GpTextureDesc d{};
        d.width = d.height = 1, d.pixels = grey, d.name = name;
        return stage.texture(d);
    }
    struct Look {
        glm::vec3 albedo, emission, normal, roughnessMetallic;
    };
    Look look(const GpMaterialDesc& desc) {
        Triangles t;
        t.quad({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0});
        const GpInstance instance = stage.add(t, stage.material(desc));
        const GpFrame frame = stage.frame(2, 2);
        const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 1, 0.1f);
        const GpRenderOptions one = stage.options(1);
        stage.check(gpRender(frame, stage.scene, &camera, &one));
        const auto image = [&](GpFrameImage i) {
            return glm::vec3(stage.read<glm::vec4>(frame, i, 4)[0]);
        };
        const Look l = {image(GP_IMAGE_ALBEDO), image(GP_IMAGE_EMISSION), image(GP_IMAGE_NORMAL),
                        image(GP_IMAGE_ROUGHNESS)};
        stage.check(gpRemoveInstance(instance));
        return l;
    }
    GpMaterialDesc materialOf(const char* name) {
        GpMaterialDesc d = lambertDesc(glm::vec3(1));
        d.baseColorTexture.texture = texture(name);
        return d;
    }
    static void expectNear(glm::vec3 got, glm::vec3 wanted, const char* what) {
        EXPECT_LT(glm::length(got - wanted), 0.006f)  // half a step of sRGB bytes, three channels
            << what << ": " << got.x << ", " << got.y << ", " << got.z;
    }

    Stage stage;
    std::string folder;
};

TEST_P(TextureOverrides, TakeThePlaceByName) {
    write("walls/brick_albedo.png", {0.8f, 0.4f, 0.2f, 1});
    expectNear(look(materialOf("walls/brick")).albedo,
               {decoded(0.8f), decoded(0.4f), decoded(0.2f)}, "brick");
    for (const char* name : {"walls/stone", "", "walls/../walls/brick"})
        expectNear(look(materialOf(name)).albedo, glm::vec3(0.5029f), name);
    expectNear(look(materialOf(nullptr)).albedo, glm::vec3(0.5029f), "no name");
    expectNear(look(materialOf((folder + "/walls/brick").c_str())).albedo, glm::vec3(0.5029f),
               "absolute");
    stage.check(gpSetTextureOverrides(stage.device, nullptr));
    expectNear(look(materialOf("walls/brick")).albedo, glm::vec3(0.5029f), "switched off");
}

TEST_P(TextureOverrides, PostfixesAreTheApplications) {
    write("walls/brick.png", {0.8f, 0.4f, 0.2f, 1});
    GpTextureOverrides overrides{};
    overrides.folder = folder.c_str();
    overrides.albedoPostfix = "";
    stage.check(gpSetTextureOverrides(stage.device, &overrides));
    expectNear(look(materialOf("walls/brick")).albedo,
               {decoded(0.8f), decoded(0.4f), decoded(0.2f)}, "brick");
}

TEST_P(TextureOverrides, ThreeMapsMakeTheMaterial) {
    write("walls/brick_albedo.png", {0.8f, 0.4f, 0.2f, 1}, 4);
    write("walls/brick_rme.png", {0.6f, 0.7f, 0.5f, 1}, 2);
    write("walls/brick_n.png", {0.75f, 0.5f, 0.9f, 1}, 2);
    const Look l = look(materialOf("walls/brick"));
    expectNear({l.roughnessMetallic.x, l.roughnessMetallic.y, 0}, {0.6f, 0.7f, 0}, "rme");
    const glm::vec3 color(decoded(0.8f), decoded(0.4f), decoded(0.2f));
    expectNear(l.emission, 0.5f * color, "emission");
    const auto n = glm::normalize(glm::vec3(0.75f, 0.5f, 0.9f) * 2.0f - 1.0f);
    EXPECT_LT(glm::length(l.normal - n), 0.02f) << l.normal.x << ", " << l.normal.y;
    // Factors multiply, where they are given.
    GpMaterialDesc d = materialOf("walls/brick");
    d.roughness = 0.5f, d.metallic = 0.5f;
    put(d.emission, {4, 2, 2});
    const Look half = look(d);
    expectNear({half.roughnessMetallic.x, half.roughnessMetallic.y, 0}, {0.3f, 0.35f, 0}, "rme");
    EXPECT_LT(glm::length(half.emission - glm::vec3(2, 1, 1) * color), 0.02f);
}

TEST_P(TextureOverrides, MapsOfTheMaterialItselfStay) {
    write("walls/brick_rme.png", {0.6f, 0.7f, 0.5f, 1});
    GpMaterialDesc d = materialOf("walls/brick");
    d.metallicRoughnessTexture.texture = d.emissionTexture.texture = texture("its own");
    const Look l = look(d);
    expectNear({l.roughnessMetallic.x, l.roughnessMetallic.y, 0}, {0.5029f, 0, 0}, "its own");
    expectNear(l.emission, glm::vec3(0), "its own");
    // Without an albedo map it glows in the colour of the texture.
    expectNear(look(materialOf("walls/brick")).emission, glm::vec3(0.5f * 0.5029f), "grey");
}

TEST_P(TextureOverrides, AFileStaysWhenThePixelsChange) {
    write("walls/brick_albedo.png", {0.8f, 0.4f, 0.2f, 1});
    const uint8_t red[4] = {255, 0, 0, 255};
    GpTextureUpdate update{};
    update.width = update.height = 1, update.pixels = red;
    EXPECT_EQ(gpUpdateTexture(texture("walls/brick"), &update), GP_ERROR_INVALID_OPERATION);
    const char* message = "";
    gpGetError(stage.device, &message);
    EXPECT_NE(std::string(message).find("brick_albedo.png stands in"), std::string::npos);
    EXPECT_EQ(gpUpdateTexture(texture("walls/stone"), &update), GP_SUCCESS);
}

INSTANTIATE_TEST_SUITE_P(Best, TextureOverrides, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
