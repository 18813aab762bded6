// Which denoiser is better, by how much: a scene with soft shadows and contacts, one path a pixel.
#include "realtime/denoise_scene.h"

#include <gtest/gtest.h>

#include "realtime/analytic_scene.h"

namespace gp::test {
namespace {

constexpr ivec2 size(160, 90);

double rmse(const AnalyticSequence& sequence, uint samples = 256) {
    double sum = 0, count = 0;
    sequence.s.forEach([&](ivec2 p) {
        if (!sequence.isSurface(p)) return;
        const double error = sequence.shown(p) - sequence.reference(p, samples);
        sum += error * error, count += 1;
    });
    return std::sqrt(sum / count);
}

struct Errors {
    double moving, lampMoves, lampOff;
};

// After 24 frames of a moving camera; 8 more with a moving lamp; 2 more without the lamp.
Errors errorsOf(Denoiser d) {
    AnalyticSequence sequence(size);
    Errors errors{};
    for (int i = 0; i < 34; ++i) {
        if (i >= 24) sequence.world.lampCorner.x -= 0.1f;
        if (i >= 32) sequence.world.lamp = 0;
        sequence.frame(d);
        if (i == 23) errors.moving = rmse(sequence);
        if (i == 31) errors.lampMoves = rmse(sequence);
        if (i == 33) errors.lampOff = rmse(sequence);
        if (i < 33) sequence.s.next();
    }
    return errors;
}

TEST(DenoiseQuality, BetterThanTheOthersOnAMovingScene) {
    const Errors none = errorsOf(Denoiser::none), atrous = errorsOf(Denoiser::atrous);
    const Errors svgf = errorsOf(Denoiser::svgf), asvgf = errorsOf(Denoiser::asvgf);
    const Errors bmfr = errorsOf(Denoiser::bmfr);
    const auto print = [](const char* name, const Errors& e) {
        std::printf("%s: moving camera %.4f, moving lamp %.4f, lamp off %.4f\n", name, e.moving,
                    e.lampMoves, e.lampOff);
    };
    print("none", none), print("atrous", atrous), print("svgf", svgf), print("asvgf", asvgf);
    print("bmfr", bmfr);
    EXPECT_LT(asvgf.moving, 0.2 * none.moving);
    EXPECT_LT(asvgf.moving, svgf.moving);
    EXPECT_LT(asvgf.moving, 0.5 * atrous.moving);
    EXPECT_LT(asvgf.lampMoves, 0.8 * svgf.lampMoves);
    EXPECT_LT(asvgf.lampMoves, atrous.lampMoves);
    // Smooth shadows are not in the span of the features, and fade over frames.
    EXPECT_LT(bmfr.moving, 0.5 * none.moving);
    EXPECT_LT(asvgf.moving, bmfr.moving);
    EXPECT_LT(asvgf.lampOff, 0.2 * svgf.lampOff);
}

}  // namespace
}  // namespace gp::test
