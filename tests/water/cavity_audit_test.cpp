// The audit of the V-cavities of earlier work (docs/water.md), reproduced: its tables T1, T2 and T3
// in ../shared/golden/glint/vcavity_results.txt, computed independently of this project, and a
// few of their numbers here, for when the file is missing.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/slope/sheared_cavity.glsl"
#include "shading/slope/tilted_cavity.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

// A single V-groove of two facets, `half` to each side of `tilt`, degrees: what wo sees of it by
// the tilted masking, over cos theta.
double tiltedGroove(double tilt, double half, double theta) {
    const vec3 wo = directionAt(theta, 0);
    double visible = 0.0;
    for (const double side : {-half, half}) {
        const vec2 s = slope_of(directionAt(tilt + side, 0));
        visible += 0.5 * double(tilted_cavity_g1(s, wo) * std::max(slope_facing(s, wo), 0.0f));
    }
    return visible / double(wo.z);
}

// The same of the pair of facets that a shear makes of the groove, over A(wo).
double shearedGroove(double tilt, double half, double theta) {
    const vec3 wo = directionAt(theta, 0);
    const vec2 mean = slope_of(directionAt(tilt, 0));
    double visible = 0.0;
    for (const double side : {-1.0, 1.0}) {
        const vec2 s = mean + vec2(float(side * std::tan(half * M_PI / 180.0)), 0.0f);
        visible += 0.5 * double(sheared_cavity_g1(mean, s, wo) *
                                std::max(slope_facing(s, wo), 0.0f));
    }
    return visible / double(slope_facing(mean, wo));
}

struct VisibleArea {
    double tilted;   // over the horizontal area
    double sheared;
    double facing;   // A(wo)
};

VisibleArea visibleArea(const Slopes& d, vec3 wo, SlopeGrid grid = {}) {
    VisibleArea v;
    v.facing = double(slope_facing(d.mean, wo));
    v.tilted = meanOverSlopes(d, [&](vec2 s) {
        return tilted_cavity_g1(s, wo) * std::max(slope_facing(s, wo), 0.0f);
    }, grid);
    v.sheared = meanOverSlopes(d, [&](vec2 s) {
        return sheared_cavity_g1(d.mean, s, wo) * std::max(slope_facing(s, wo), 0.0f);
    }, grid);
    return v;
}

// Light that a white mirror sends up, with the masking of both directions as a product, as the
// audit has it.
double separableAlbedo(const Slopes& d, vec3 wo) {
    const double sum = meanOverSlopes(d, [&](vec2 s) {
        const vec3 wi = reflect(-wo, facet_of(s));
        if (wi.z <= 0.0f) return 0.0f;
        return std::max(slope_facing(s, wo), 0.0f) * sheared_cavity_g1(d.mean, s, wo)
             * sheared_cavity_g1(d.mean, s, wi);
    }, {700, 7.0});
    const double facing = double(slope_facing(d.mean, wo));
    return facing > 0.0 ? sum / facing : 0.0;
}

// What the shipped shader of the earlier work makes of it.
double shippedAlbedo(float sigma, vec2 mean, vec3 wo) {
    return meanOverSlopes(slopesOf(0, 0, sigma, sigma, 0), [&](vec2 s) {
        const vec3 h = facet_of(s);
        return std::max(slope_facing(s, wo), 0.0f)
             * shipped_cavity_g2(mean, h, wo, reflect(-wo, h));
    }, {700, 7.0});
}

std::vector<std::string> auditLines(const std::string& start) {
    std::ifstream in(std::filesystem::path(GP_SOURCE_DIR) / ".." / "shared" / "golden" / "glint" /
                     "vcavity_results.txt");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(start)) lines.push_back(line);
    }
    return lines;
}

#define SKIP_WITHOUT_AUDIT(lines) \
    if ((lines).empty()) GTEST_SKIP() << "../shared/golden/glint/vcavity_results.txt is not there"

// T1: printed to three digits.
TEST(CavityAudit, GroovesAsPublished) {
    const std::vector<std::string> lines = auditLines("tilt ");
    SKIP_WITHOUT_AUDIT(lines);
    const double views[] = {-75, -60, -45, -20, 0, 20, 45, 60, 75};
    ASSERT_EQ(lines.size(), 15u);
    for (const std::string& line : lines) {
        double tilt = 0, half = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "tilt %lf groove %lf", &tilt, &half), 2);
        std::istringstream numbers(line.substr(line.find("75: ") + 3));
        for (const double view : views) {
            double published = -1;
            ASSERT_TRUE(numbers >> published) << line;
            EXPECT_NEAR(tiltedGroove(tilt, half, view), published, 6e-4) << line << " at " << view;
        }
    }
}

// T2: four digits of the tilted form, five of the sheared one.
TEST(CavityAudit, VisibleAreasAsPublished) {
    const std::vector<std::string> lines = auditLines("sig 0.");
    SKIP_WITHOUT_AUDIT(lines);
    int compared = 0;
    for (const std::string& line : lines) {
        float sx, sy, rho, mx, my;
        double theta, phi, tilted, relative, facing;
        if (std::sscanf(line.c_str(), "sig %f %f rho %f mean (%f,%f) view %lf/%lf: thesis "
                        "I/cos=%lf", &sx, &sy, &rho, &mx, &my, &theta, &phi, &tilted) != 8) {
            continue;
        }
        const vec3 wo = directionAt(theta, phi);
        const VisibleArea v = visibleArea(slopesOf(mx, my, sx, sy, rho), wo);
        EXPECT_NEAR(v.tilted / double(wo.z), tilted, 1.5e-4) << line;
        const std::size_t cosine = line.find("(A/cos=");
        ASSERT_EQ(std::sscanf(line.c_str() + cosine, "(A/cos=%lf", &facing), 1);
        EXPECT_NEAR(v.facing / double(wo.z), facing, 6e-4) << line;
        if (std::sscanf(line.c_str() + line.find("I/A="), "I/A=%lf", &relative) == 1) {
            EXPECT_NEAR(v.tilted / v.facing, relative, 1.5e-4) << line;
            EXPECT_NEAR(v.sheared / v.facing, 1.0, 1e-5) << line;
        } else {
            EXPECT_NE(line.find("meso backfacing"), std::string::npos);
            EXPECT_EQ(v.sheared, 0.0) << line;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 48);
}

// T3: columns a (about the mean 0), b (the shipped shader) and c (sheared). Where the horizon cuts
// the lobe, the two grids differ by 2e-4.
TEST(CavityAudit, AlbedosAsPublished) {
    const std::vector<std::string> lines = auditLines("sig 0.");
    SKIP_WITHOUT_AUDIT(lines);
    int compared = 0;
    for (const std::string& line : lines) {
        float sigma, mean;
        double theta, phi, a, b, c;
        if (std::sscanf(line.c_str(), "sig %f mean slope %f view %lf/%lf: a %lf b %lf c %lf",
                        &sigma, &mean, &theta, &phi, &a, &b, &c) != 7) {
            continue;
        }
        const vec3 wo = directionAt(theta, phi);
        EXPECT_NEAR(separableAlbedo(slopesOf(0, 0, sigma, sigma, 0), wo), a, 5e-4) << line;
        EXPECT_NEAR(shippedAlbedo(sigma, vec2(mean, 0.0f), wo), b, 5e-4) << line;
        EXPECT_NEAR(separableAlbedo(slopesOf(mean, 0, sigma, sigma, 0), wo), c, 5e-4) << line;
        ++compared;
    }
    EXPECT_EQ(compared, 36);
}

TEST(CavityAudit, InShort) {
    EXPECT_NEAR(tiltedGroove(20, 10, -75), 0.171, 6e-4);
    EXPECT_NEAR(tiltedGroove(20, 10, 75), 1.829, 6e-4);
    EXPECT_NEAR(tiltedGroove(5, 10, 75), 1.337, 6e-4);
    EXPECT_NEAR(tiltedGroove(0, 30, -60), 1.0, 1e-5);
    const Slopes d = slopesOf(0.3f, 0.0f, 0.15f, 0.15f, 0.0f);
    EXPECT_NEAR(visibleArea(d, directionAt(70, 0)).tilted / std::cos(70 * M_PI / 180), 0.267, 5e-4);
    const VisibleArea grazing = visibleArea(d, directionAt(85, 180));
    EXPECT_NEAR(grazing.tilted / grazing.facing, 0.4385, 2e-4);
    EXPECT_NEAR(grazing.sheared / grazing.facing, 1.0, 1e-5);
    EXPECT_NEAR(separableAlbedo(slopesOf(0.2f, 0, 0.1f, 0.1f, 0), directionAt(80, 180)), 0.9718,
                3e-4);
    EXPECT_NEAR(shippedAlbedo(0.05f, vec2(1.0f, 0.0f), directionAt(30, 180)), 1.1356, 5e-4);
    EXPECT_NEAR(shippedAlbedo(0.1f, vec2(0.0f), directionAt(80, 0)), 0.1616, 3e-4);
    const vec3 up(0, 0, 1);
    EXPECT_EQ(shipped_cavity_g2(vec2(0.5f, 0.1f), up, up, up), 1.0f);  // h = n is a number
}

// A groove keeps its area as a distribution does, at every tilt and view that sees it.
TEST(CavityAudit, ShearedGroovesKeepTheirArea) {
    for (const double tilt : {0.0, 5.0, 20.0, 40.0}) {
        for (const double half : {10.0, 30.0, 50.0}) {
            for (const double view : {-75.0, -45.0, 0.0, 20.0, 45.0}) {
                if (view < tilt - 89.0) continue;  // seen from behind
                EXPECT_NEAR(shearedGroove(tilt, half, view), 1.0, 1e-5)
                    << tilt << " " << half << " " << view;
            }
        }
    }
}

}  // namespace
}  // namespace gp::test
