// Frame images as they are seen: known numbers become known bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "view/image_view.h"

namespace gp::test {
namespace {

using namespace tool::view;
using Bytes = std::vector<std::uint8_t>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

GpImageInfo infoOf(const char* name) {
    return imageNamed(name)->info;
}

template <class T>
Bytes seen(const GpImageInfo& info, const std::vector<T>& values, float ev = 0) {
    const std::size_t count = values.size() * sizeof(T) / info.bytesPerPixel;
    return visiblePixels(info, values.data(), count, ev);
}

TEST(ImageView, EveryImageOfTheLibraryHasARule) {
    std::set<std::string> names;
    for (const ImageName& image : allImages()) {
        const ImageScale scale = scaleOf(image.info);
        if (image.kind) {
            EXPECT_NE(scale, ImageScale::range) << image.info.name << " has no rule of its own";
        }
        EXPECT_FALSE(explanationOf(scale).empty());
        EXPECT_TRUE(names.insert(image.info.name).second) << image.info.name << " comes twice";
    }
    EXPECT_EQ(imageNamed("nothing"), nullptr);
    EXPECT_EQ(imageNamed("display")->kind, GP_IMAGE_DISPLAY);
}

TEST(ImageView, RealTimeFramesHaveLayersBeside) {
    const ImageName* motion = imageNamed("motion");
    ASSERT_NE(motion, nullptr);
    EXPECT_FALSE(motion->kind);
    EXPECT_TRUE(hasImage(GP_MODE_REALTIME, *motion));
    EXPECT_FALSE(hasImage(GP_MODE_REFERENCE, *motion));
    EXPECT_FALSE(hasImage(GP_MODE_REALTIME, *imageNamed("variance")));
    EXPECT_TRUE(hasImage(GP_MODE_LOCAL, *imageNamed("variance")));
}

TEST(ImageView, HeatGoesFromBlackToYellow) {
    EXPECT_TRUE(needsHeatMaps("heat_rays"));
    EXPECT_TRUE(needsHeatMaps("heat_time"));
    EXPECT_FALSE(needsHeatMaps("heat_variance"));
    EXPECT_FALSE(needsHeatMaps("display"));
    std::vector<float> rays;
    for (const float v : {0.0f, 2.0f, 4.0f}) {
        rays.insert(rays.end(), {v, v, v, 1.0f});
    }
    const HeatScale scale = heatScaleOf("heat_rays", rays.data(), 3);
    EXPECT_EQ(scale.high, 4);
    EXPECT_EQ(scale.unit, "rays");
    const Bytes pixels = seen<float>(infoOf("heat_rays"), rays);
    const auto sum = [&pixels](std::size_t i) {
        return pixels[4 * i] + pixels[4 * i + 1] + pixels[4 * i + 2];
    };
    EXPECT_LT(sum(0), 10);
    EXPECT_GT(sum(1), sum(0) + 100);
    EXPECT_GT(sum(2), sum(1) + 100);
    // Of a variance the root is shown; what is no number is nothing.
    const float variance[] = {9, 1, 1, 1, std::nanf(""), 1, 1, 1};
    EXPECT_EQ(heatScaleOf("heat_variance", variance, 1).high, 3);
    EXPECT_EQ(heatScaleOf("heat_variance", variance + 4, 1).high, 0);
    const std::vector<float> nothing(8, 0.0f);
    EXPECT_EQ(seen<float>(infoOf("heat_time"), nothing).size(), 8u);
}

TEST(ImageView, LightIsEncodedAndExposed) {
    // sRGB of 0.5 is 0.7354 [IEC 61966-2-1], 188 of 255.
    EXPECT_EQ(seen<float>(infoOf("direct"), {0.5f, 1.0f, 4.0f, 1.0f}), (Bytes{188, 255, 255, 255}));
    EXPECT_EQ(seen<float>(infoOf("direct"), {1.0f, 2.0f, 0.0f, 1.0f}, -1.0f),
              (Bytes{188, 255, 0, 255}));
    // Reflectance has no exposure, and no NaN shows as anything but white.
    EXPECT_EQ(seen<float>(infoOf("albedo"), {0.5f, 0.5f, 0.5f, 1.0f}, 5.0f),
              (Bytes{188, 188, 188, 255}));
    EXPECT_EQ(seen<float>(infoOf("color"), {std::nanf(""), kInfinity, -1.0f, 1.0f}),
              (Bytes{255, 255, 0, 255}));
    // Variance shows as the deviation: the root of 0.25.
    EXPECT_EQ(seen<float>(infoOf("variance"), {0.25f, 0.0f, 1.0f, 0.0f}),
              (Bytes{188, 0, 255, 255}));
}

TEST(ImageView, NormalsAndData) {
    EXPECT_EQ(seen<float>(infoOf("normal"), {1.0f, 0.0f, -1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f}),
              (Bytes{255, 128, 0, 255, 0, 0, 0, 255}));
    EXPECT_EQ(seen<float>(infoOf("roughness"), {0.2f, 1.0f, 0.0f, 0.0f}),
              (Bytes{51, 255, 0, 255}));
}

TEST(ImageView, NearIsBrightAndNothingIsBlack) {
    const Bytes depth = seen<float>(infoOf("depth"), {1.0f, 2.0f, 4.0f, kInfinity});
    EXPECT_EQ(depth[0], 255);
    EXPECT_GT(depth[4], depth[8]);
    EXPECT_GT(depth[8], 10);  // the farthest surface is no nothing
    EXPECT_EQ(depth[12], 0);
    // Powers: 2 lies in the middle between 1 and 4.
    EXPECT_NEAR(depth[4], 0.5 * (depth[0] + depth[8]), 1.0);
    EXPECT_EQ(seen<float>(infoOf("depth"), {kInfinity, kInfinity})[0], 0);
    EXPECT_EQ(seen<float>(infoOf("depth"), {3.0f, 3.0f})[0], 255);
}

TEST(ImageView, NumbersHaveColorsApart) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < 40; ++i) {
        numbers.push_back(i);
    }
    const Bytes colors = seen(infoOf("instance"), numbers);
    EXPECT_EQ(Bytes(colors.begin(), colors.begin() + 4), (Bytes{0, 0, 0, 255}));
    std::set<Bytes> different;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto at = colors.begin() + static_cast<std::ptrdiff_t>(4 * i);
        different.insert(Bytes(at, at + 3));
    }
    EXPECT_EQ(different.size(), numbers.size());
}

TEST(ImageView, ImagesWithoutARuleAreScaledByTheirLargest) {
    GpImageInfo info = infoOf("color");
    info.name = "something new";
    EXPECT_EQ(seen<float>(info, {-2.0f, 0.0f, 2.0f, 99.0f, 1.0f, std::nanf(""), 0.0f, 0.0f}),
              (Bytes{0, 128, 255, 255, 191, 128, 128, 255}));
    EXPECT_EQ(seen<float>(info, {0.0f, 0.0f, 0.0f, 0.0f}), (Bytes{128, 128, 128, 255}));
}

TEST(ImageView, ThePictureIsOpaque) {
    EXPECT_EQ(seen<std::uint8_t>(infoOf("display"), {1, 2, 3, 0}), (Bytes{1, 2, 3, 255}));
}

}  // namespace
}  // namespace gp::test
