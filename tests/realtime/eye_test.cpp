// Eye adaptation: the exposure of a picture, and the way there.
#include <cmath>

#include <gtest/gtest.h>

#include "frame/eye_adaptation.h"
#include "render/stage.h"

namespace gp::test {
namespace {

float seen(float radiance, int frames, float timeStep, float seconds, float brighter = 1) {
    Variant v;
    v.mode = GP_MODE_REALTIME;
    Stage stage(v);
    const GpFrame frame = stage.frame(16, 16);
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 4, 2);
    GpRenderOptions o{};
    o.realtime.eyeAdaptation.seconds = seconds;
    o.realtime.timeStep = timeStep;
    GpFrameStatistics statistics{};
    for (int i = 0; i < frames; ++i) {
        stage.surround(glm::vec3(i == 0 ? radiance : radiance * brighter));
        stage.check(gpRender(frame, stage.scene, &camera, &o));
        stage.check(gpGetFrameStatistics(frame, &statistics));
    }
    return statistics.exposureEv;
}

TEST(Eye, MakesOneTonedPicturesMiddleGrey) {
    for (float radiance : {0.01f, 0.18f, 1.0f, 100.0f})  // bins are half a stop wide
        EXPECT_NEAR(seen(radiance, 1, 0, 1), std::log2(0.18f / radiance), 0.26f) << radiance;
    EXPECT_EQ(seen(1, 1, 0, 0), 0);  // off
    EXPECT_NEAR(seen(5e-5f, 1, 0, 1), 10, 1e-5);  // the end of the range
    EXPECT_EQ(seen(0, 1, 0, 1), 0);
}

TEST(Eye, GoesExponentially) {
    // Four stops brighter: after one time constant 1 / e of the way is left.
    const float before = seen(1, 1, 0.5f, 1), after = seen(1, 1 + 2, 0.5f, 1, 16);
    EXPECT_NEAR(after - before, -4 * (1 - std::exp(-1.0f)), 0.02f);
}

TEST(Eye, DarknessAndLampsDoNotCount) {
    LuminanceHistogram even{}, mixed{};
    even[33] = 100;
    mixed[33] = 46, mixed[0] = 400, mixed[3] = 50, mixed[60] = 4;
    EXPECT_EQ(exposureEvFor(even, {1}), exposureEvFor(mixed, {1}));
}

}  // namespace
}  // namespace gp::test
