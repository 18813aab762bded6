// The files of gpSaveOceanMaps, read back: what the sea is at their texels.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "glitterpath/glitterpath.h"
#include "ocean/ocean.h"

namespace gp {
namespace {

struct OceanMapFiles : testing::Test {
    GpDevice device = nullptr;
    GpScene scene = nullptr;
    std::string folder = (std::filesystem::temp_directory_path() /
                          ("gp_maps_" + std::to_string(getpid()))).string();

    void SetUp() override {
        GpDeviceDesc desc{};
        desc.backend = GP_BACKEND_NULL;
        device = gpNewDevice(&desc), scene = gpNewScene(device);
        std::filesystem::create_directory(folder);
        GpOceanDesc sea{};
        sea.wind = 12, sea.seed = 5, sea.cascades = 2;
        ASSERT_EQ(gpSetOcean(scene, &sea), GP_SUCCESS);
        ASSERT_EQ(gpSetOceanTime(scene, 3.25), GP_SUCCESS);
        ASSERT_EQ(gpSaveOceanMaps(scene, folder.c_str()), GP_SUCCESS);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder);
        gpReleaseScene(scene), gpReleaseDevice(device);
    }

    // RGBA by the library's own reader.
    std::vector<float> read(const std::string& name) {
        GpImage image{};
        EXPECT_EQ(gpLoadImage(device, (folder + "/" + name).c_str(), &image), GP_SUCCESS) << name;
        if (!image.pixels) return std::vector<float>(4 * 256 * 256);
        EXPECT_EQ(image.width, 256u);
        EXPECT_EQ(image.height, 256u);
        std::vector<float> texels(image.pixels, image.pixels + 4 * 256 * 256);
        gpFreeImage(&image);
        return texels;
    }
    // One channel, which need not be a colour.
    std::vector<float> channel(const std::string& name, const char* letter) {
        Imf::InputFile file((folder + "/" + name).c_str());
        EXPECT_TRUE(file.header().channels().findChannel(letter)) << name << ' ' << letter;
        std::vector<float> texels(256 * 256);
        Imf::FrameBuffer frame;
        frame.insert(letter, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(texels.data()), 4,
                                        4 * 256));
        file.setFrameBuffer(frame);
        file.readPixels(0, 255);
        return texels;
    }
};

TEST_F(OceanMapFiles, HoldTheSeaAtTheirTexels) {
    OceanSettings settings;
    settings.windSpeed = 12, settings.seed = 5, settings.cascades = 2;
    settings.windDirection = float(std::numbers::pi / 2);  // -Z
    Ocean ocean(settings);
    ocean.setTime(3.25);
    double foamiest = 0;
    for (uint32_t c = 0; c < 2; ++c) {
        const std::string end = "_" + std::to_string(c) + ".exr";
        const auto displacement = read("displacement" + end), normal = read("normal" + end);
        const auto moments = read("moments" + end), foam = read("foam" + end);
        const auto product = channel("moments" + end, "X");
        for (size_t i = 0; i < 256 * 256; i += 37) {
            const int x = int(i % 256), y = 255 - int(i / 256);  // the upper edge is towards +y
            const OceanPoint p = ocean.gridPoint(c, x, y);
            const glm::vec2 s = p.slope();
            const glm::vec3 n = glm::normalize(glm::vec3(-s, 1));
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(displacement[4 * i + size_t(k)], p.displacement[k], 1e-6f);
                ASSERT_NEAR(normal[4 * i + size_t(k)], n[k], 1e-6f);
            }
            const float expected[] = {s.x, s.y, s.x * s.x, s.y * s.y};
            for (size_t k = 0; k < 4; ++k)
                ASSERT_NEAR(moments[4 * i + k], expected[k], 1e-6f + 1e-6f * std::abs(expected[k]));
            ASSERT_NEAR(product[i], s.x * s.y, 1e-6f + 1e-6f * std::abs(s.x * s.y));
            ASSERT_NEAR(foam[4 * i], p.foam, 1e-6f);
            foamiest = std::max(foamiest, double(p.foam));
        }
    }
    EXPECT_GT(foamiest, 0.1);  // there was something to compare
}

}  // namespace
}  // namespace gp
