// Measured files as materials of scenes, on every backend.
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/merl.h"
#include "render/stage.h"
#include "scene/bsdf_evaluate.h"
#include "statistics/measured_example.h"

namespace gp::test {
namespace {

class MeasuredMaterial : public ::testing::TestWithParam<Variant> {
protected:
    void TearDown() override { std::filesystem::remove(path_); }

    // A file of one test's own, with the cells of statistics/measured_example.h times `factor`.
    std::string file(float factor) {
        path_ = (std::filesystem::temp_directory_path()
                 / fmt::format("gp-test-measured-{}.binary", getpid())).string();
        std::vector<float> cells;
        for (std::size_t i = 0; i < 3 * merl::cellCount; ++i)
            cells.push_back(measuredExample()->words[i] * factor);
        io::writeMerl(path_, cells);
        return path_;
    }

private:
    std::string path_;
};

GpBsdf newBsdf(Stage& stage, const std::string& path) {
    GpBsdfDesc desc{};
    desc.model = path.c_str();
    const GpBsdf bsdf = gpNewBsdf(stage.device, &desc);
    EXPECT_NE(bsdf, nullptr) << path;
    return bsdf;
}

Picture squareOf(Stage& stage, GpMaterial material, glm::vec3 towardsCamera) {
    Triangles t;
    t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    stage.add(t, material);
    stage.surround(glm::vec3(1));
    GpRenderOptions o = stage.options(effort(256));
    o.maxBounces = GP_NO_BOUNCES;
    return stage.render(16, 8, lookFrom({0, 0, 0}, towardsCamera, 3, 0.2f), o);
}

// In a uniform surrounding a surface shows its albedo, here by quadrature over the table itself.
// The file and the handle are gone when the picture is made: the material has the table.
TEST_P(MeasuredMaterial, ShowsItsAlbedo) {
    Stage stage(GetParam());
    const glm::dvec3 wo = glm::normalize(glm::dvec3(0, -0.8, 1));
    const std::string path = file(1.0f);
    const GpBsdf bsdf = newBsdf(stage, path);
    GpMaterialDesc desc{};
    desc.bsdf = bsdf;
    const GpMaterial material = stage.material(desc);
    stage.check(gpReleaseBsdf(bsdf));
    std::filesystem::remove(path);
    const Picture p = squareOf(stage, material, glm::vec3(wo));

    // By the law of the mean over cosines; the example's highlight is 0.1 rad wide.
    BsdfSettings settings(findBsdfModel("measured"));
    settings.measured = measuredExample();
    const PreparedBsdf bsdfAlone(settings);
    glm::dvec3 albedo(0);
    constexpr int rings = 300, sectors = 600;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            const double sine2 = (i + 0.5) / rings, phi = 2 * M_PI * (j + 0.5) / sectors;
            const glm::vec3 wi(glm::dvec3(std::sqrt(sine2) * std::cos(phi),
                                          std::sqrt(sine2) * std::sin(phi),
                                          std::sqrt(1 - sine2)));
            albedo += glm::dvec3(bsdfAlone.evaluate(wi, glm::vec3(wo)).f)
                    * (M_PI / (rings * sectors));
        }
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(p.mean()[c], albedo[c], 0.01 * albedo[c] + 4 * p.sigma()[c]);
    EXPECT_GT(albedo.x, 0.3);
}

// The library refuses it before there is a backend: one variant tells.
class MeasuredLayers : public MeasuredMaterial {};

TEST_P(MeasuredLayers, TwoFilesHaveNothingInBetween) {
    Stage stage(GetParam());
    const std::string path = file(0.5f), copy = path + ".other.binary";
    std::filesystem::copy_file(path, copy);
    const GpBsdf dark = newBsdf(stage, path);
    GpMaterialLayer layer{};
    layer.bsdf = newBsdf(stage, copy);
    layer.weight = 0.5f;
    std::filesystem::remove(copy);
    GpMaterialDesc desc{};
    desc.bsdf = dark;
    desc.layers = &layer;
    desc.layerCount = 1;
    EXPECT_EQ(gpNewMaterial(stage.device, &desc), nullptr);
    const char* message = nullptr;
    EXPECT_EQ(gpGetError(stage.device, &message), GP_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(message).find("is another file than"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(All, MeasuredMaterial, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });
INSTANTIATE_TEST_SUITE_P(Best, MeasuredLayers, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
