// The light tree as it is built: complete, bounding all that is below each node, and good enough
// for choosing by where it was made in the quick way.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "scene/light_table.h"
#include "scene/light_tree.h"
#include "shading/shading.h"
#include "statistics/random.h"

namespace gp {
namespace {

using shared::LightTreeNode;
using test::Random;

enum class Kind { spheres, spots, triangles };

struct Lights {
    Scene scene;
    LightTable table;
};

glm::vec3 randomPoint(Random& random, float size) {
    const float x = random.uniform(), y = random.uniform();
    return size * (2.0f * glm::vec3(x, y, random.uniform()) - 1.0f);
}

std::shared_ptr<Light> randomLight(Random& random, Kind kind, float size) {
    auto light = std::make_shared<Light>();
    light->emission = glm::vec3(0.1f + random.uniform());
    light->position = randomPoint(random, size);
    if (kind == Kind::triangles) {
        light->kind = LightKind::polygon;
        const glm::vec3 u = randomPoint(random, 0.05f), v = randomPoint(random, 0.05f);
        light->corners = {light->position, light->position + u, light->position + v};
        light->direction = glm::normalize(glm::cross(u, v));
        light->twoSided = random.uniform() < 0.3f;
        return light;
    }
    light->kind = kind == Kind::spots ? LightKind::spot : LightKind::sphere;
    light->direction = glm::normalize(randomPoint(random, 1.0f) + glm::vec3(0, 1e-3f, 0));
    light->radius = random.uniform() < 0.5f ? 0.0f : 0.02f;
    return light;
}

Lights makeLights(size_t count, Kind kind, float size = 10) {
    Lights l;
    Random random(unsigned(count) + 7 * unsigned(kind));
    for (size_t i = 0; i < count; ++i) l.scene.lights.push_back(randomLight(random, kind, size));
    fillLightTable(l.scene, l.table);
    return l;
}

shading::LightNode childOf(const LightTreeNode& n, int i) {
    shading::LightNode c;
    c.centre = {n.centre_x[i], n.centre_y[i], n.centre_z[i]};
    c.radius2 = n.radius2[i], c.phi = n.phi[i];
    c.w = {n.axis_x[i], n.axis_y[i], n.axis_z[i]};
    c.cos_theta_o = n.cos_theta_o[i], c.cos_theta_e = n.cos_theta_e[i];
    c.two_sided = n.child[i] & LIGHT_TREE_TWO_SIDED;
    return c;
}

// The lights below a node, each found where its record says; what bounds them bounds each.
class Walk {
public:
    explicit Walk(const LightTable& table) : table_(table), seen_(table.lights.size()) {}

    void node(uint32_t index) {
        ++nodes_;
        for (int i = 0; i < LIGHT_TREE_WIDTH; ++i) {
            const LightTreeNode& n = table_.tree[index];
            if (n.phi[i] == 0) continue;
            const uint32_t child = n.child[i] & LIGHT_TREE_INDEX;
            const uint32_t place = index * LIGHT_TREE_WIDTH + uint32_t(i);
            above_.push_back(childOf(n, i));
            if ((n.child[i] & LIGHT_TREE_LEAF) != 0) {
                EXPECT_EQ(table_.lights[child].leaf, place);
                ++seen_[child];
                for (const shading::LightNode& bound : above_) expectBounds(bound, above_.back());
            } else {
                EXPECT_EQ(table_.tree[child].parent, place);
                node(child);
            }
            above_.pop_back();
        }
    }

    void expectComplete() const {
        EXPECT_EQ(nodes_, table_.tree.size());
        for (size_t i = table_.directionalCount; i < seen_.size(); ++i) EXPECT_EQ(seen_[i], 1);
    }

private:
    static void expectBounds(const shading::LightNode& outer, const shading::LightNode& inner) {
        const float slack = 1e-3f;
        EXPECT_LE(glm::distance(outer.centre, inner.centre),
                  std::sqrt(outer.radius2) * 1.00001f + slack);
        EXPECT_GE(outer.phi, inner.phi * 0.999f);
        EXPECT_LE(outer.cos_theta_e, inner.cos_theta_e + slack);
        const float between =
            std::acos(std::clamp(glm::dot(outer.w, inner.w), -1.0f, 1.0f)) +
            std::acos(inner.cos_theta_o);
        const bool all = outer.cos_theta_o < -0.999f;
        EXPECT_TRUE(all || between <= std::acos(outer.cos_theta_o) + 0.02f);
    }

    const LightTable& table_;
    std::vector<int> seen_;
    std::vector<shading::LightNode> above_;
    size_t nodes_ = 0;
};

TEST(LightTreeBuild, HoldsEveryLightOnceWithinItsBounds) {
    for (const Kind kind : {Kind::spheres, Kind::spots, Kind::triangles})
        for (const size_t count : {1u, 2u, 3u, 8u, 9u, 100u, 4096u, 4097u, 20000u}) {
            const Lights l = makeLights(count, kind);
            Walk walk(l.table);
            walk.node(0);
            walk.expectComplete();
            ASSERT_FALSE(::testing::Test::HasFailure()) << count << " of kind " << int(kind);
        }
}

// All in one point, or in a row with ever wider gaps: nothing to cut by, or one light at a time.
TEST(LightTreeBuild, SurvivesPlacesThatCannotBeCut) {
    for (const size_t count : {9u, 300u, 6000u}) {
        Lights l = makeLights(count, Kind::spheres, 0);
        Walk point(l.table);
        point.node(0);
        point.expectComplete();
        for (size_t i = 0; i < count; ++i)
            l.scene.lights[i]->position = {std::exp2(float(i) * 60.0f / float(count)), 0, 0};
        fillLightTable(l.scene, l.table);
        Walk row(l.table);
        row.node(0);
        row.expectComplete();
    }
}

TEST(LightTreeBuild, NoLightsNoNodes) {
    Lights l = makeLights(0, Kind::spheres);
    EXPECT_TRUE(l.table.tree.empty());
    l = makeLights(3, Kind::spheres);
    l.scene.lights.clear();
    fillLightTable(l.scene, l.table);  // over what was there before
    EXPECT_TRUE(l.table.tree.empty());
    EXPECT_TRUE(l.table.lights.empty());
}

// With what chance each light is chosen from p: the product of its shares up to the root.
double chance(const LightTable& table, uint32_t light, glm::vec3 p, glm::vec3 normal) {
    double pmf = 1;
    for (uint32_t place = table.lights[light].leaf;;) {
        const uint32_t node = place / LIGHT_TREE_WIDTH;
        double sum = 0, own = 0;
        for (int i = 0; i < LIGHT_TREE_WIDTH; ++i) {
            const double w =
                shading::light_node_importance(childOf(table.tree[node], i), p, normal, 0);
            sum += w;
            if (uint32_t(i) == place % LIGHT_TREE_WIDTH) own = w;
        }
        if (!(own > 0)) return 0;
        pmf *= own / sum;
        if (node == 0) return pmf;
        place = table.tree[node].parent;
    }
}

// Relative variance of the irradiance from one chosen lamp, without shadows.
double variance(const LightTable& table, Random& random, float size) {
    double sum = 0;
    int points = 0;
    while (points < 24) {
        const glm::vec3 p = randomPoint(random, size);
        const glm::vec3 n = glm::normalize(randomPoint(random, 1.0f));
        double all = 0, squares = 0;
        for (uint32_t i = 0; i < table.lights.size(); ++i) {
            const glm::dvec3 d = glm::dvec3(table.lights[i].position - p);
            const double d2 = std::max(glm::dot(d, d), 1e-2);
            const double e = std::max(0.0, glm::dot(d, glm::dvec3(n))) /
                             (d2 * std::sqrt(d2)) * table.lights[i].emission.x;
            if (e == 0) continue;
            const double pmf = chance(table, i, p, n);
            EXPECT_GT(pmf, 0);
            all += e, squares += e * e / pmf;
        }
        if (all == 0) continue;  // turned away from all of them
        sum += squares / (all * all) - 1;
        ++points;
    }
    return sum / points;
}

// The quick tree of many lights against a tree whose every cut is weighed: nearly as little noise.
TEST(LightTreeBuild, TheQuickTreeIsNearlyAsGood) {
    constexpr size_t count = 10000;
    Lights l;
    Random random(5);
    for (size_t i = 0; i < count; ++i) {
        // In heaps, as lamps of a town are.
        auto light = randomLight(random, Kind::spheres, 0.4f);
        light->radius = 0;
        Random heap(unsigned(i % 50));
        light->position += randomPoint(heap, 10);
        l.scene.lights.push_back(std::move(light));
    }
    fillLightTable(l.scene, l.table);
    LightTable weighed = l.table;
    std::vector<LightCluster> clusters = l.table.clusters;
    makeWeighedLightTree(clusters, weighed.lights, weighed.tree);
    Random a(9), b(9);
    const double quick = variance(l.table, a, 10), slow = variance(weighed, b, 10);
    ::testing::Test::RecordProperty("relative_variance", std::to_string(quick / slow));
    std::printf("variance of one lamp: quick tree %.2f, weighed tree %.2f\n", quick, slow);
    EXPECT_LT(quick, 1.25 * slow);
}

}  // namespace
}  // namespace gp
