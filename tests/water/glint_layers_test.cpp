// Coat, sheen and a thin film over facets: furnaces, and the same layers as over glTF's material.
#include <cmath>

#include <gtest/gtest.h>

#include "scene/glint_dictionary.h"
#include "shading/shading.h"
#include "statistics/random.h"

GP_SHADING_BEGIN
#include "shading/bsdf/glint_sun.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

struct Layered {
    const char* name;
    float coat, coatAlpha, sheen, film;
};

const Layered kinds[] = {{"coat", 1, 0.0001f, 0, 0}, {"rough_coat", 0.8f, 0.2f, 0, 0},
                         {"sheen", 0, 0.1f, 0.7f, 0}, {"both", 1, 0.05f, 0.5f, 0},
                         {"film", 0, 0.1f, 0, 1}, {"all", 1, 0.1f, 0.3f, 0.8f}};

BsdfParams layered(BsdfParams m, const Layered& l) {
    m.coat = l.coat, m.coat_alpha = l.coatAlpha;
    m.sheen_color = vec3(l.sheen), m.sheen_alpha = 0.3f;
    m.iridescence = l.film;
    return m;
}

BsdfParams facets(float alpha, float metallic, const Layered& l, uint method = GLINT_SMOOTH) {
    BsdfParams m = layered(bsdf_params_of(MODEL_GLINT), l);
    m.metallic = metallic;
    m.alpha_x = m.alpha_y = alpha;
    m.slot_b.x = float(method);
    m.slot_a.w = 3e6f;
    m.table = glintDictionary();
    return bsdf_prepared(m);
}

vec3 viewAt(float z) { return vec3(std::sqrt(1.0f - z * z), 0.0f, z); }

BsdfSample drawn(const BsdfParams& m, vec3 wo, Random& random) {
    const float lobe = random.uniform();
    const float x = random.uniform();
    return bsdf_sample(m, wo, lobe, vec2(x, random.uniform()));
}

// Of white light: mean, and its error.
struct Returned {
    double mean, error;
};

Returned furnace(const BsdfParams& m, vec3 wo, int samples = 40'000) {
    Random random(41);
    double sum = 0, squares = 0;
    for (int i = 0; i < samples; ++i) {
        const double w = double(max_component(drawn(m, wo, random).weight));
        sum += w / samples, squares += w * w / samples;
    }
    return {sum, std::sqrt(std::max(squares - sum * sum, 0.0) / samples)};
}

// White metal and white paint under everything: never more than came in, and little less. What is
// lost is what a layer throws back inside, once, into what is below it.
TEST(GlintLayers, WhiteStaysNearlyWhite) {
    for (const Layered& l : kinds)
        for (const float metallic : {0.0f, 1.0f})
            for (const uint method : {GLINT_SMOOTH, GLINT_DICTIONARY})
                for (const float z : {1.0f, 0.6f, 0.2f}) {
                    if (method == GLINT_DICTIONARY && z != 0.6f) continue;
                    const BsdfParams m = facets(0.2f, metallic, l, method);
                    const Returned r = furnace(m, viewAt(z));
                    EXPECT_LT(r.mean, 1.0 + 4 * r.error + 0.002) << l.name << metallic << z;
                    EXPECT_GT(r.mean, 0.9) << l.name << metallic << z;
                }
}

// What they add, and what they leave of the base, is what it is for glTF's material.
TEST(GlintLayers, AreThoseOfGltf) {
    Random random(43);
    for (const Layered& l : kinds) {
        if (l.film > 0) continue;
        const BsdfParams glint = facets(0.3f, 1, l);
        const BsdfParams bare = facets(0.3f, 1, {"none", 0, 0.1f, 0, 0});
        BsdfParams gltf = layered(bsdf_params_of(MODEL_GLTF), l);
        gltf.metallic = 1, gltf.alpha_x = gltf.alpha_y = 0.3f;
        BsdfParams bareGltf = gltf;
        bareGltf.coat = 0, bareGltf.sheen_color = vec3(0.0f);
        for (int i = 0; i < 2000; ++i) {
            const float x = random.uniform(), y = random.uniform();
            const vec3 wo = square_to_cosine_hemisphere(vec2(x, random.uniform()));
            const vec3 wi = i % 2 ? square_to_cosine_hemisphere(vec2(y, random.uniform()))
                                  : drawn(glint, wo, random).wi;
            if (!(wo.z > 0 && wi.z > 0)) continue;
            const float through = layers_through(glint, layers_seen(glint, wo), wi);
            const vec3 under = bsdf_eval(bare, wo, wi).f_cos * through;
            const vec3 underGltf = bsdf_eval(bareGltf, wo, wi).f_cos * through;
            const vec3 all = bsdf_eval(glint, wo, wi).f_cos;
            const vec3 allGltf = bsdf_eval(gltf, wo, wi).f_cos;
            const float size = all.x + allGltf.x + 0.01f;
            ASSERT_NEAR(all.x - under.x, allGltf.x - underGltf.x, 1e-4f * size) << l.name;
        }
    }
}

// A coat and a sheen go with the mean slope, and a coat by its own normal where it has one.
TEST(GlintLayers, LieOnTheMesosurface) {
    const Layered& l = kinds[3];
    BsdfParams tilted = facets(0.2f, 1, l);
    tilted.slot_a.x = 0.3f, tilted.slot_a.y = -0.2f;
    const vec2 mean = glint_mean(tilted);
    const Frame f = mesosurface_frame(mean);
    const BsdfParams flat = facets(0.2f, 1, l);
    const auto added = [](const BsdfParams& m, vec3 wo, vec3 wi) {
        return slopes_part_without_facets(m, 0, wo, wi).y;
    };
    Random random(47);
    for (int i = 0; i < 1000; ++i) {
        const float x = random.uniform(), y = random.uniform();
        const vec3 o = square_to_cosine_hemisphere(vec2(x, random.uniform()));
        const vec3 w = square_to_cosine_hemisphere(vec2(y, random.uniform()));
        const vec3 wo = world_from_local(f, o), wi = world_from_local(f, w);
        ASSERT_NEAR(added(tilted, wo, wi), added(flat, o, w), 1e-3f * added(flat, o, w) + 1e-6f);
    }
    // Its normal back to that of the geometry: the mirror of a view from above is above.
    tilted.coat_normal = local_from_world(f, vec3(0, 0, 1));
    const vec3 wo = normalize(vec3(0.2f, 0.1f, 1));
    const vec3 mirror = vec3(-wo.x, -wo.y, wo.z);
    tilted.sheen_color = vec3(0.0f);
    EXPECT_GT(added(tilted, wo, mirror), 0.5f);
    EXPECT_LT(added(tilted, wo, normalize(mirror + vec3(-0.6f, 0.4f, 0))), 0.01f);
}

// The far field: over many places a layered glint is its smooth self.
TEST(GlintLayers, TheMeanOfManyPlacesIsTheSmoothSurface) {
    const vec3 wo = viewAt(0.8f), wi = normalize(vec3(-0.5f, 0.1f, 0.75f));
    for (const Layered& l : kinds) {
        const double expected = double(bsdf_eval(facets(0.3f, 0.7f, l), wo, wi).f_cos.x);
        for (const uint method : {GLINT_DICTIONARY, GLINT_COUNTING}) {
            BsdfParams m = facets(0.3f, 0.7f, l, method);
            Random random(53);
            double sum = 0, squares = 0;
            constexpr int n = 20'000;
            for (int i = 0; i < n; ++i) {
                m.slot_c.x = 100.0f * random.uniform();
                m.slot_c.y = 100.0f * random.uniform();
                const double r = double(bsdf_eval(m, wo, wi).f_cos.x) / expected;
                sum += r / n, squares += r * r / n;
            }
            const double error = std::sqrt(std::max(squares - sum * sum, 0.0) / n);
            EXPECT_GT(error, 2e-4) << "no glints";
            EXPECT_NEAR(sum, 1.0, 4 * error + 0.01) << l.name << " " << method;
        }
    }
}

// All that a coat reflects of a sun, over all places of the sun, is its albedo, be it smoother than
// the disc (then the disc is seen, sharp) or rougher.
TEST(GlintLayers, ACoatMirrorsTheDisc) {
    const float disc = 5e-5f;  // a radius of 0.01
    for (const float alpha : {0.0001f, 0.003f, 0.05f}) {
        const BsdfParams m = facets(0.3f, 1, {"coat", 1, alpha, 0, 0});
        const vec3 wo = viewAt(0.5f);
        const vec3 mirror = vec3(-wo.x, -wo.y, wo.z);
        Random random(59);
        double sum = 0, largest = 0;
        constexpr int n = 200'000;
        // A cone that has the disc, or nearly all of the lobe.
        const float cone = alpha < 0.005f ? 4 * disc : 0.5f;
        const Frame about = frame_from_normal(mirror);
        for (int i = 0; i < n; ++i) {
            const float x = random.uniform();
            const vec3 local = square_to_uniform_cone(vec2(x, random.uniform()), cone);
            const vec3 wi = world_from_local(about, local);
            const double f = double(coat_eval_disc(m, wo, wi, disc).f_cos.x);
            sum += f * TWO_PI * double(cone) / n, largest = std::max(largest, f);
        }
        const double albedo = 1.0 - double(coat_through(m, wo));
        // The fit of GGX's albedo is off by up to 0.006.
        EXPECT_NEAR(sum, albedo, alpha < 0.005f ? 0.03 * albedo : 0.006) << alpha;
        // No brighter than the disc itself in a mirror.
        EXPECT_LE(largest, 1.1 * albedo / (TWO_PI * double(disc))) << alpha;
    }
}

}  // namespace
}  // namespace gp::test
