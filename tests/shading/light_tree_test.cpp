// The importance of light-tree nodes against the light that comes from them by brute force.
#include "shading/shading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/random.h"

namespace gp::shading {
namespace {

using test::Random;

// A small light at a point: full power along its normal, less by the cosine, none beyond theta_e.
struct Emitter {
    vec3 position;
    vec3 normal;
};

struct Group {
    LightNode node;
    vec3 size;  // half of the box that the emitters are in
    std::vector<Emitter> emitters;
};

vec3 direction(Random& random) {
    const float x = random.uniform();
    return square_to_uniform_sphere(vec2(x, random.uniform()));
}

// Random emitters within a box, normals within a cone; theta_e at random: a spot's up to a lamp's.
Group makeGroup(Random& random, int count) {
    Group g;
    LightNode& n = g.node;
    g.size = vec3(random.uniform(), random.uniform(), random.uniform()) * 2.0f;
    n.centre = vec3(0.0f);
    n.radius2 = dot(g.size, g.size);
    n.phi = float(count);
    n.w = direction(random);
    n.cos_theta_o = random.uniform() < 0.2f ? -1.0f : 2.0f * random.uniform() - 1.0f;
    n.cos_theta_e = random.uniform() < 0.5f ? 0.0f : random.uniform();
    n.two_sided = random.uniform() < 0.3f ? 1u : 0u;
    const Frame frame = frame_from_normal(n.w);
    for (int i = 0; i < count; ++i) {
        Emitter e;
        const vec3 place = vec3(random.uniform(), random.uniform(), random.uniform());
        e.position = g.size * (2.0f * place - 1.0f);
        const float x = random.uniform();
        const vec3 local =
            square_to_uniform_cone(vec2(x, random.uniform()), 1.0f - n.cos_theta_o);
        e.normal = world_from_local(frame, local);
        g.emitters.push_back(e);
    }
    return g;
}

// What one emitter of power 1 gives to p; `ng` zero: in a medium.
float illumination(const LightNode& n, const Emitter& e, vec3 p, vec3 ng, uint transmissive) {
    const vec3 d = p - e.position;
    const float d2 = dot(d, d);
    const vec3 w = d / std::sqrt(d2);
    float cosLight = dot(e.normal, w);
    cosLight = n.two_sided != 0 ? std::abs(cosLight) : cosLight;
    if (cosLight <= n.cos_theta_e || cosLight <= 0.0f) {
        return 0.0f;
    }
    float cosine = 1.0f;
    if (dot(ng, ng) > 0.0f) {
        cosine = -dot(w, ng);
        cosine = transmissive != 0 ? std::abs(cosine) : std::max(cosine, 0.0f);
    }
    return cosLight * cosine / d2;
}

TEST(LightTree, NeverZeroWhereThereIsLight) {
    Random random(1);
    int lit = 0;
    int rejected = 0;
    for (int i = 0; i < 20000; ++i) {
        const Group g = makeGroup(random, 8);
        const vec3 p = direction(random) * (0.1f + 8.0f * random.uniform());
        const vec3 ng = i % 3 == 0 ? vec3(0.0f) : direction(random);
        const uint transmissive = i % 3 == 1 ? 1u : 0u;
        float total = 0.0f;
        for (const Emitter& e : g.emitters) {
            total += illumination(g.node, e, p, ng, transmissive);
        }
        const float importance = light_node_importance(g.node, p, ng, transmissive);
        ASSERT_TRUE(std::isfinite(importance) && importance >= 0.0f);
        if (total > 0.0f) {
            ++lit;
            ASSERT_GT(importance, 0.0f) << "case " << i << " receives " << total;
        }
        rejected += importance == 0.0f ? 1 : 0;
    }
    EXPECT_GT(lit, 5000);
    EXPECT_GT(rejected, 1000);  // and it does tell groups that cannot matter
}

// Far from a group the bound of its angles is tight: within a small factor of what it gives.
TEST(LightTree, BoundsTheLightOfAGroup) {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const Group g = makeGroup(random, 8);
        const float radius = length(g.size);
        const float d = radius * (2.0f + 8.0f * random.uniform());
        const vec3 p = direction(random) * d;
        const vec3 ng = direction(random);
        float total = 0.0f;
        for (const Emitter& e : g.emitters) {
            total += illumination(g.node, e, p, ng, 0u);
        }
        const float importance = light_node_importance(g.node, p, ng, 0u);
        // All cosines bounded by 1 above; from below by the nearest that an emitter may be.
        EXPECT_LE(importance, g.node.phi / (d * d) * 1.0001f);
        const float nearest = (d - radius) * (d - radius) / (d * d);
        EXPECT_GE(importance, total * nearest * 0.999f) << "case " << i;
    }
}

// A node of one emitter is exact: power, both cosines and the squared distance.
TEST(LightTree, LeafEqualsItsLight) {
    Random random(3);
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        Group g = makeGroup(random, 1);
        const Emitter& e = g.emitters.front();
        g.node.centre = e.position;
        g.node.radius2 = 0.0f;
        g.node.w = e.normal;
        g.node.cos_theta_o = 1.0f;
        const vec3 p = direction(random) * 4.0f;
        const vec3 ng = direction(random);
        const float expected = illumination(g.node, e, p, ng, 0u);
        if (expected * 16.0f > 0.01f) {  // apart from the margins that keep rounding from zero
            EXPECT_NEAR(light_node_importance(g.node, p, ng, 0u) / expected, 1.0f, 0.05f);
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(LightTree, SurvivesDegenerateNodes) {
    LightNode n;
    n.centre = vec3(1.0f);
    n.radius2 = 0.0f;
    n.phi = 3.0f;
    n.w = vec3(0.0f, 0.0f, 1.0f);
    n.cos_theta_o = 1.0f;
    n.cos_theta_e = 0.0f;
    n.two_sided = 0;
    EXPECT_TRUE(std::isfinite(light_node_importance(n, vec3(1.0f), vec3(0, 1, 0), 0u)));
    n.phi = 0.0f;
    EXPECT_EQ(light_node_importance(n, vec3(0.0f, 0.0f, 5.0f), vec3(0.0f), 0u), 0.0f);
}

}  // namespace
}  // namespace gp::shading
