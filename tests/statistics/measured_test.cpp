// Measured materials: angles and cells against their definition in double, look-up, and what
// sampling from the data is worth.
#include <filesystem>

#include <gtest/gtest.h>

#include "io/merl.h"
#include "statistics/bsdf_cases.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

BsdfParams paramsOf(const MeasuredBrdf& brdf, float interpolation = 0.0f) {
    BsdfParams m = bsdf_params_of(MODEL_MEASURED);
    m.slot_a.x = interpolation;
    m.table = brdf.address();
    return m;
}

std::shared_ptr<const MeasuredBrdf> constant(float f) {
    LargeVector<float> cells(3 * merl::cellCount);
    for (std::size_t cell = 0; cell < merl::cellCount; ++cell) {
        const DirectionPair pair = merl::directionsOf(cell, 0.0);
        for (std::size_t c = 0; c < 3; ++c) cells[3 * cell + c] = pair.aboveHorizon() ? f : -1.0f;
    }
    return makeMeasuredBrdf("constant", std::move(cells));
}

vec3 randomAbove(Random& random) {
    const float x = random.uniform();
    vec3 w = square_to_uniform_sphere(vec2(x, random.uniform()));
    w.z = std::abs(w.z);
    return w;
}

dvec3 turned(dvec3 v, dvec3 axis, double angle) {  // [Rodrigues 1840]
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle)
         + axis * (dot(axis, v) * (1.0 - std::cos(angle)));
}

// As the definition has it: the light turned back by the half vector's azimuth and then by its
// polar angle.
// [Rusinkiewicz 1998, EGWR, "A New Change of Variables for Efficient BRDF Representation", 3]
struct DoubleAngles {
    double thetaH, thetaD, phiD;
};
DoubleAngles anglesByTurning(dvec3 wo, dvec3 wi) {
    const dvec3 h = normalize(wo + wi);
    DoubleAngles a;
    a.thetaH = std::acos(std::min(h.z, 1.0));
    const dvec3 d = turned(turned(wi, dvec3(0, 0, 1), -std::atan2(h.y, h.x)), dvec3(0, 1, 0),
                           -a.thetaH);
    a.thetaD = std::acos(std::min(d.z, 1.0));
    a.phiD = std::atan2(d.y, d.x);
    if (a.phiD < 0.0) a.phiD += M_PI;
    return a;
}

TEST(Measured, AnglesAreThoseOfTheDefinition) {
    Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const vec3 wo = randomAbove(random), wi = randomAbove(random);
        const HalfAngles a = half_angles(wo, wi);
        const DoubleAngles b = anglesByTurning(normalize(dvec3(wo)), normalize(dvec3(wi)));
        ASSERT_NEAR(2.0 * M_PI * double(a.theta_h), b.thetaH, 1e-6);
        ASSERT_NEAR(2.0 * M_PI * double(a.theta_d), b.thetaD, 1e-6);
        const double apart = std::abs(2.0 * M_PI * double(a.phi_d) - b.phiD);
        const double error = 1e-6 / std::max(std::sin(b.thetaD) * std::sin(b.thetaH), 1e-3);
        ASSERT_LT(std::min(apart, M_PI - apart), error) << i;
        const HalfAngles back = half_angles(wi, wo);
        ASSERT_NEAR(a.theta_h, back.theta_h, 1e-7f);
        ASSERT_NEAR(a.theta_d, back.theta_d, 1e-7f);
        const float turn = std::abs(a.phi_d - back.phi_d);
        ASSERT_LT(std::min(turn, 0.5f - turn), 1e-6f);
    }
}

// The peer's indices, by the description of the format: square root for theta_h, even steps else.
TEST(Measured, NearestCellIsThePeers) {
    Random random(2);
    int compared = 0;
    for (int i = 0; i < 100'000; ++i) {
        const vec3 wo = randomAbove(random), wi = randomAbove(random);
        const DoubleAngles a = anglesByTurning(normalize(dvec3(wo)), normalize(dvec3(wi)));
        const double at[3] = {90.0 * std::sqrt(a.thetaH / (0.5 * M_PI)),
                              90.0 * a.thetaD / (0.5 * M_PI), 180.0 * a.phiD / M_PI};
        bool atEdge = false;
        for (const double x : at) atEdge = atEdge || std::abs(x - std::round(x)) < 2e-3;
        if (atEdge || a.thetaD < 0.01 || a.thetaH < 0.01) continue;
        const auto row = std::size_t(at[1]) + 90 * std::size_t(at[0]);
        const std::size_t index = std::size_t(at[2]) + 180 * row;
        ASSERT_EQ(merl_nearest_index(wo, wi), index) << at[0] << " " << at[1] << " " << at[2];
        ++compared;
    }
    EXPECT_GT(compared, 90'000);
}

TEST(Measured, DegenerateDirectionsHaveThePeersCells) {
    const vec3 n(0.0f, 0.0f, 1.0f);
    EXPECT_EQ(merl_nearest_index(n, n), 0u);
    // Mirror directions, in any plane: the first row of half vectors, phi_d 0.
    for (const float phi : {0.3f, 2.0f, 4.0f}) {
        const vec3 wo(0.6f * std::cos(phi), 0.6f * std::sin(phi), 0.8f);
        EXPECT_EQ(merl_nearest_index(wo, mirror_direction(wo)), 180u * 36u) << phi;
    }
    // The light at the viewer's place: phi_d is the azimuth, counted the other way round.
    const vec3 at = normalize(vec3(std::cos(-0.5f), std::sin(-0.5f), 1.0f));
    const auto row = std::size_t(90.0 * std::sqrt(0.5));
    EXPECT_EQ(merl_nearest_index(at, at), row * 90 * 180 + std::size_t(180.0 * 0.5 / M_PI));
}

TEST(Measured, CentresOfCellsHaveTheirValues) {
    const auto& brdf = *measuredExample();
    const BsdfParams nearest = paramsOf(brdf, 1.0f), trilinear = paramsOf(brdf);
    Random random(3);
    for (int i = 0; i < 50'000; ++i) {
        const std::size_t cell = random.next() % merl::cellCount;
        const DirectionPair pair = merl::directionsOf(cell, 6.0 * double(random.uniform()));
        if (std::min(pair.wi.z, pair.wo.z) < 0.02) continue;
        const vec3 wi(pair.wi), wo(pair.wo);
        const vec3 value = merl_cell(brdf.address(), uint(cell));
        ASSERT_TRUE(merl_nearest_index(wo, wi) == cell || merl::placeOf(cell)[0] < 3) << cell;
        // Where the half vector is within 0.03 degrees of the normal the cells are 1e-4 apart.
        const float tolerance = merl::placeOf(cell)[0] < 3 ? 0.03f : 2e-3f;
        ASSERT_NEAR(bsdf_eval(trilinear, wo, wi).f_cos.x, value.x * wi.z,
                    tolerance * value.x * wi.z) << cell;
        if (merl::placeOf(cell)[0] >= 3) {
            ASSERT_FLOAT_EQ(bsdf_eval(nearest, wo, wi).f_cos.y, value.y * wi.z);
        }
    }
}

// Cells below the horizon are left out, so that nothing darkens towards it.
TEST(Measured, AConstantStaysConstantUpToTheHorizon) {
    const auto brdf = constant(0.2f);
    const BsdfParams m = paramsOf(*brdf);
    Random random(4);
    int black = 0;
    for (int i = 0; i < 200'000; ++i) {
        const vec3 wo = randomAbove(random), wi = randomAbove(random);
        const float f = bsdf_eval(m, wo, wi).f_cos.x / wi.z;
        if (f == 0.0f) {
            ++black;
            // Only where every cell around is centred below the horizon.
            ASSERT_LT(std::min(wo.z, wi.z), 0.03f);
            continue;
        }
        ASSERT_NEAR(f, 0.2f, 1e-6f);
    }
    EXPECT_LT(black, 400);
    EXPECT_NEAR(bsdf_albedo(m, 0.7f).x, 0.2 * M_PI, 2e-3);
}

TEST(Measured, WithoutATableItIsBlack) {
    const BsdfParams m = bsdf_params_of(MODEL_MEASURED);
    const vec3 wo = normalize(vec3(1, 0, 1));
    EXPECT_EQ(bsdf_eval(m, wo, wo).f_cos, vec3(0.0f));
    EXPECT_EQ(bsdf_sample(m, wo, 0.5f, vec2(0.5f)).pdf, 0.0f);
    EXPECT_EQ(bsdf_albedo(m, 0.5f), vec3(0.0f));
}

// Standard deviation of one sample over the albedo.
struct Spread {
    double byData, byCosine;
};
Spread spreadOf(const BsdfParams& m, vec3 wo) {
    Random random(5);
    const int n = 200'000;
    double sum[2] = {}, squares[2] = {};
    for (int i = 0; i < n; ++i) {
        const BsdfSample s = drawSample(m, wo, random);
        const float x = random.uniform();
        const vec3 wi = square_to_cosine_hemisphere(vec2(x, random.uniform()));
        const double w[2] = {double(s.weight.x),
                             double(bsdf_eval(m, wo, wi).f_cos.x / cosine_hemisphere_pdf(wi))};
        for (int k = 0; k < 2; ++k) {
            sum[k] += w[k];
            squares[k] += w[k] * w[k];
        }
    }
    const auto relative = [&](int k) {
        const double mean = sum[k] / n;
        return std::sqrt(std::max(squares[k] / n - mean * mean, 0.0)) / mean;
    };
    return {relative(0), relative(1)};
}

TEST(Measured, SamplingTheDataBeatsTheCosine) {
    const BsdfParams m = paramsOf(*measuredExample());
    for (const vec3& wo : viewsOf(BsdfCase{"", m})) {
        const Spread s = spreadOf(m, wo);
        fmt::print("wo.z {:.3f}: relative error at 1000 samples {:.2f} %, by the cosine {:.2f} %\n",
                   wo.z, 100.0 * s.byData / std::sqrt(1000.0), 100.0 * s.byCosine
                   / std::sqrt(1000.0));
        EXPECT_LT(s.byData, 0.2);
        EXPECT_LT(3.0 * s.byData, s.byCosine);
    }
}

const char* const goldenTable = "measured/gold-metallic-paint.nbrdf.binary";

// The peer's program on a file of the format, as columns lx … vz, r, g, b.
TEST(Measured, NearestIsThePeersOnTheGoldenFile) {
    const std::vector<GoldenRow> rows = readGolden("golden_merl_lookup.csv");
    GP_SKIP_WITHOUT(rows, "golden_merl_lookup.csv");
    const auto path = std::filesystem::path(GP_SOURCE_DIR) / ".." / "shared/golden" / goldenTable;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const auto brdf = io::readMerl(path.string());
    for (const GoldenRow& row : rows) {
        const vec3 wi = normalize(vec3(number(row, "lx"), number(row, "ly"), number(row, "lz")));
        const vec3 wo = normalize(vec3(number(row, "vx"), number(row, "vy"), number(row, "vz")));
        if (std::min(wi.z, wo.z) <= 0.0f) continue;
        const vec3 f = merl_nearest(brdf->address(), wo, wi);
        const vec3 golden = max(vec3(number(row, "r"), number(row, "g"), number(row, "b")),
                                vec3(0.0f));
        ASSERT_LE(length(f - golden), 1e-3f * length(golden) + 1e-5f) << row.at("lx");
    }
}

}  // namespace
}  // namespace gp::test
