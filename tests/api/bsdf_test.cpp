// Models through the C interface: samples against values, and many at once against one by one.
#include <glitterpath/glitterpath.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace gp::test {
namespace {

// Multiples of the golden ratio and its like: as even as random numbers, and the same every time.
std::vector<float> evenNumbers(size_t count) {
    std::vector<float> u;
    for (size_t i = 0; i < count; ++i) {
        for (const double step : {0.8191725133961645, 0.6710436067037893, 0.5497004779019703}) {
            u.push_back(static_cast<float>(std::fmod(step * double(i + 1), 1.0) * 0.9999));
        }
    }
    return u;
}

std::vector<float> views(size_t count, float z) {
    std::vector<float> wo;
    for (size_t i = 0; i < count; ++i) wo.insert(wo.end(), {std::sqrt(1 - z * z), 0.0f, z});
    return wo;
}

std::vector<GpBsdfSample> draw(const Bsdf& bsdf, size_t count, float z) {
    std::vector<GpBsdfSample> samples(count);
    bsdf.sample(count, views(count, z).data(), evenNumbers(count).data(), samples.data());
    return samples;
}

TEST(BsdfSample, OfLambertIsItsCosine) {
    const Device device;
    const std::vector<GpBsdfParameter> parameters = {{"base_color", "0.5,0.25,0"}};
    const Bsdf bsdf(device, "lambert", parameters);
    double cosines = 0.0;
    const std::vector<GpBsdfSample> samples = draw(bsdf, 5000, 0.6f);
    for (const GpBsdfSample& s : samples) {
        ASSERT_NEAR(s.pdf, s.wi[2] / M_PI, 1e-6);
        ASSERT_NEAR(s.weight[0], 0.5, 1e-6);
        ASSERT_NEAR(s.weight[1], 0.25, 1e-6);
        ASSERT_EQ(s.weight[2], 0.0f);
        ASSERT_EQ(s.lobe, uint32_t(GP_LOBE_DIFFUSE));
        cosines += s.wi[2];
    }
    EXPECT_NEAR(cosines / 5000, 2.0 / 3.0, 0.01);
}

TEST(BsdfSample, AgreesWithValues) {
    const Device device;
    const Bsdf bsdf(device, "ward");
    constexpr size_t count = 20'000;
    const std::vector<GpBsdfSample> samples = draw(bsdf, count, 0.7f);
    std::vector<float> wi;
    for (const GpBsdfSample& s : samples) {
        const bool failed = s.pdf == 0.0f;
        for (const float x : s.wi) wi.push_back(failed ? 1.0f : x);
    }
    std::vector<GpBsdfValue> values(count);
    bsdf.evaluate(count, wi.data(), views(count, 0.7f).data(), values.data());
    size_t failed = 0;
    for (size_t i = 0; i < count; ++i) {
        const GpBsdfSample& s = samples[i];
        if (s.pdf == 0.0f) {
            ++failed;
            EXPECT_EQ(s.weight[0] + s.wi[0] + s.wi[1] + s.wi[2], 0.0f);
            EXPECT_EQ(s.lobe, 0u);
            continue;
        }
        ASSERT_NEAR(values[i].pdf, s.pdf, 1e-4f * s.pdf);
        ASSERT_NEAR(values[i].f[1] * s.wi[2], s.weight[1] * s.pdf, 1e-4f * s.pdf);
    }
    EXPECT_LT(failed, count / 4);
}

TEST(BsdfSample, TellsWhatGoesThrough) {
    const Device device;
    const Bsdf bsdf(device, "ggx_dielectric");
    size_t through = 0;
    for (const GpBsdfSample& s : draw(bsdf, 5000, 0.8f)) {
        if (s.pdf == 0.0f) continue;
        ASSERT_EQ((s.lobe & GP_LOBE_TRANSMISSION) != 0, s.wi[2] < 0.0f);
        through += s.wi[2] < 0.0f;
    }
    EXPECT_GT(through, 4000u);
    EXPECT_LT(through, 5000u);
}

TEST(BsdfSample, ManyAreTheSameOnAnyNumberOfThreads) {
    GpDeviceDesc one{}, three{};
    one.threads = 1;
    three.threads = 3;
    const Device first(one), second(three);
    const Bsdf a(first, "disney"), b(second, "disney");
    const std::vector<GpBsdfSample> samplesA = draw(a, 10'000, 0.3f);
    const std::vector<GpBsdfSample> samplesB = draw(b, 10'000, 0.3f);
    EXPECT_EQ(std::memcmp(samplesA.data(), samplesB.data(), 10'000 * sizeof(GpBsdfSample)), 0);
    GpBsdfSample alone{};
    const std::vector<float> u = evenNumbers(10'000);
    a.sample(1, views(1, 0.3f).data(), u.data() + 3 * 9'999, &alone);
    EXPECT_EQ(std::memcmp(&alone, &samplesA.back(), sizeof alone), 0);
}

TEST(BsdfSample, WrapperThrows) {
    const Device device;
    EXPECT_THROW(Bsdf(device, "lambrt"), Error);
    const Bsdf bsdf(device, "lambert");
    GpBsdfSample sample{};
    const float up[3] = {0, 0, 1}, u[3] = {2, 0, 0};
    try {
        bsdf.sample(1, up, u, &sample);
        FAIL() << "took a random number of 2";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), GP_ERROR_OUT_OF_RANGE);
    }
}

}  // namespace
}  // namespace gp::test
