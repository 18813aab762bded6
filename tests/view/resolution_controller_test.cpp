// Sizes that hold a frame time, on machines that are simulated.
#include <gtest/gtest.h>

#include <cmath>

#include "view/resolution_controller.h"
#include "view/time_history.h"

namespace gp::test {
namespace {

using tool::view::RenderSize;
using tool::view::ResolutionController;

// A machine on which a frame of full size takes `full` seconds and one of no size `fixed`.
double frameTime(const ResolutionController& c, double full, double fixed = 0) {
    return fixed + full * c.scale() * c.scale();
}

void run(ResolutionController& c, double full, int frames, double fixed = 0) {
    for (int i = 0; i < frames; ++i) {
        c.record(frameTime(c, full, fixed));
    }
}

TEST(ResolutionController, HoldsTheTimeOnAnyMachine) {
    // From one that draws sixty full pictures a second to one that needs two seconds for one.
    for (const double full : {0.016, 0.05, 0.2, 0.7, 2.0}) {
        ResolutionController c;
        run(c, full, 200);
        EXPECT_LE(frameTime(c, full), 1.15 / 30.0) << full;
        // A step is a factor of sqrt(2) in time, and quick enough is 0.9 of what is wanted.
        if (c.scale() < 1) {
            EXPECT_GE(frameTime(c, full), 0.9 / 30.0 / std::sqrt(2.0)) << full;
        }
    }
    ResolutionController quick;
    run(quick, 0.001, 200);
    EXPECT_EQ(quick.scale(), 1.0);
    ResolutionController slow;
    run(slow, 1000, 200);
    EXPECT_EQ(slow.scale(), 1.0 / 16);
}

TEST(ResolutionController, ComesToRest) {
    for (const double fixed : {0.0, 0.01, 0.02}) {
        ResolutionController c;
        run(c, 0.3, 100, fixed);
        const double scale = c.scale();
        run(c, 0.3, 1000, fixed);
        EXPECT_EQ(c.scale(), scale) << fixed;
    }
}

TEST(ResolutionController, OneSlowFrameChangesNothingTwoDo) {
    ResolutionController c;
    run(c, 0.3, 100);
    const double scale = c.scale();
    c.record(1.0);
    EXPECT_EQ(c.scale(), scale);
    c.record(frameTime(c, 0.3));
    EXPECT_EQ(c.scale(), scale);
    c.record(1.0);
    c.record(1.0);
    EXPECT_LT(c.scale(), 0.3 * scale);
    run(c, 0.3, 200);
    EXPECT_EQ(c.scale(), scale);
}

TEST(ResolutionController, TheTargetCounts) {
    ResolutionController c;
    run(c, 0.3, 200);
    const double at30 = c.scale();
    c.setTarget(1.0 / 10.0);
    run(c, 0.3, 200);
    EXPECT_GT(c.scale(), at30);
    EXPECT_LE(frameTime(c, 0.3), 0.1);
}

TEST(ResolutionController, SizesAreNeverNothing) {
    ResolutionController c;
    run(c, 1000, 100);
    EXPECT_EQ(c.sizeFor({1280, 720}), (RenderSize{80, 45}));
    EXPECT_EQ(c.sizeFor({100, 3}), (RenderSize{16, 3}));
    EXPECT_EQ(c.sizeFor({1, 1}), (RenderSize{1, 1}));
    EXPECT_EQ(c.sizeFor({0, 0}), (RenderSize{0, 0}));
    run(c, 0.001, 1000);
    EXPECT_EQ(c.sizeFor({1281, 719}), (RenderSize{1281, 719}));
}

TEST(ResolutionController, FewerRaysComeBeforeSmallerPictures) {
    ResolutionController c;
    c.setMostRenderScale(1.0);
    run(c, 0.001, 200);
    EXPECT_EQ(c.renderScale(), 1.0);
    EXPECT_EQ(c.sizeScale(), 1.0);
    // Half of the time of a full frame: rays alone.
    run(c, 2.0 / 30.0, 200);
    EXPECT_NEAR(c.renderScale(), std::exp2(-0.5), 1e-12);
    EXPECT_EQ(c.sizeFor({1280, 720}), (RenderSize{1280, 720}));
    // A hundredth: rays cannot be fewer than half along each side of the frame.
    run(c, 100.0 / 30.0, 200);
    EXPECT_EQ(c.renderScale(), 0.5);
    EXPECT_NEAR(c.sizeScale(), std::exp2(-2.5), 1e-12);
    EXPECT_LE(frameTime(c, 100.0 / 30.0), 1.15 / 30.0);
    // Back again in the other order.
    run(c, 2.0 / 30.0, 200);
    EXPECT_EQ(c.sizeScale(), 1.0);
    EXPECT_GT(c.renderScale(), 0.5);
    // A mode that has no such scale goes on with as many rays.
    const double rays = c.scale();
    c.setMostRenderScale(std::nullopt);
    EXPECT_EQ(c.renderScale(), 1.0);
    EXPECT_EQ(c.sizeScale(), rays);
}

TEST(ResolutionController, APersonMayLimitTheRays) {
    ResolutionController c;
    c.setMostRenderScale(0.6);
    run(c, 0.001, 200);
    EXPECT_EQ(c.renderScale(), 0.6);
    EXPECT_EQ(c.sizeScale(), 1.0);
    run(c, 0.3, 200);
    EXPECT_LE(frameTime(c, 0.3), 1.15 / 30.0);
    const double scale = c.scale();
    run(c, 0.3, 500);
    EXPECT_EQ(c.scale(), scale);  // at rest
}

TEST(TimeHistory, MeanAndPercentiles) {
    tool::view::TimeHistory times;
    EXPECT_EQ(times.mean(), 0);
    EXPECT_EQ(times.percentile(95), 0);
    for (int i = 1; i <= 20; ++i) {
        times.add(0.001 * i);
    }
    EXPECT_NEAR(times.mean(), 10.5, 1.0e-4);
    EXPECT_NEAR(times.percentile(50), 10, 1.0e-4);
    EXPECT_NEAR(times.percentile(95), 19, 1.0e-4);
    EXPECT_NEAR(times.percentile(0), 1, 1.0e-4);
    EXPECT_NEAR(times.percentile(100), 20, 1.0e-4);
    for (int i = 0; i < 500; ++i) {
        times.add(0.002);
    }
    EXPECT_EQ(times.milliseconds().size(), tool::view::TimeHistory::kLongest);
    EXPECT_NEAR(times.percentile(100), 2, 1.0e-4);
}

}  // namespace
}  // namespace gp::test
