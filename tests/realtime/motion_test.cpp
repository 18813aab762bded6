// Motion vectors: whatever moves in a known way leaves the vectors that follow from it.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 48, height = 32;
constexpr double fov = 0.8;

Variant realtime() {
    Variant v = bestFullVariant().front();
    v.mode = GP_MODE_REALTIME;
    return v;
}

struct View {
    glm::dvec3 position{0, 0.5, 5}, target{0};

    GpCameraDesc desc() const {
        GpCameraDesc c{};
        put(c.position, position), put(c.target, target);
        c.verticalFov = float(fov);
        return c;
    }
    // Pixels, and depth along the view.
    glm::dvec3 project(glm::dvec3 p) const {
        const glm::dvec3 f = glm::normalize(target - position);
        const glm::dvec3 r = glm::normalize(glm::cross(f, glm::dvec3(0, 1, 0)));
        const glm::dvec3 u = glm::cross(r, f), d = p - position;
        const double depth = glm::dot(d, f), half = depth * std::tan(fov / 2) / (height / 2.0);
        return {width / 2.0 + glm::dot(d, r) / half, height / 2.0 - glm::dot(d, u) / half, depth};
    }
};

// One thing of the scene, in the world: corners now and in the last frame.
struct Thing {
    std::vector<glm::vec3> now, before;
};

glm::vec3 turned(glm::vec3 p, float angle, glm::vec3 shift) {
    const float c = std::cos(angle), s = std::sin(angle);
    return glm::vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x) + shift;
}

void transformOf(float angle, glm::vec3 shift, float* m) {
    const float c = std::cos(angle), s = std::sin(angle);
    const float rows[12] = {c, 0, s, shift.x, 0, 1, 0, shift.y, -s, 0, c, shift.z};
    std::copy_n(rows, 12, m);
}

struct Scene {
    Stage stage{realtime()};
    GpFrame frame = stage.frame(width, height);
    std::vector<Thing> things;  // by index of the instance
    GpRenderOptions options{};

    Scene() {
        stage.surround(glm::vec3(1));
        // A-SVGF lets one pixel in nine show the very point that it showed in the last frame.
        options.realtime.denoiser = GP_DENOISER_NONE;
    }

    GpMesh mesh(const Triangles& t, GpMeshKind kind) {
        GpMeshDesc desc = meshDesc(t, stage.lambert(glm::vec3(0.5f)));
        desc.kind = kind;
        const GpMesh m = gpNewMesh(stage.device, &desc);
        if (!m) stage.check(gpGetError(stage.device, nullptr));
        return m;
    }
    GpInstance show(GpMesh m, uint64_t id, float angle = 0, glm::vec3 shift = glm::vec3(0)) {
        GpInstanceDesc desc{};
        desc.mesh = m, desc.id = id;
        transformOf(angle, shift, desc.worldFromObject);
        const GpInstance i = gpNewInstance(stage.scene, &desc);
        if (!i) stage.check(gpGetError(stage.device, nullptr));
        return i;
    }
    void render(const View& view) {
        const GpCameraDesc camera = view.desc();
        stage.check(gpRender(frame, stage.scene, &camera, &options));
    }
    std::vector<glm::vec4> layer(const char* name) {
        std::vector<glm::vec4> pixels(width * height);
        stage.check(gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }

    // Compares every pixel; returns how many pixels show each thing.
    std::vector<int> expectMotion(const View& now, const View& before) {
        const auto hit = layer("hit"), bary = layer("barycentrics"), motion = layer("motion"),
                   depth = layer("depth");
        std::vector<int> seen(things.size());
        for (size_t i = 0; i < hit.size(); ++i) {
            if (hit[i].x >= float(things.size())) continue;
            const Thing& t = things[size_t(hit[i].x)];
            const size_t first = 3 * size_t(hit[i].y);
            const auto at = [&](const std::vector<glm::vec3>& p) {
                return glm::dvec3(p[first]) * (1.0 - bary[i].x - bary[i].y) +
                       glm::dvec3(p[first + 1]) * double(bary[i].x) +
                       glm::dvec3(p[first + 2]) * double(bary[i].y);
            };
            const glm::dvec3 here = now.project(at(t.now)), there = before.project(at(t.before));
            const glm::dvec3 expected = there - here;
            const double close = 0.01 + 1e-3 * glm::length(glm::dvec2(expected));
            EXPECT_NEAR(motion[i].x, expected.x, close) << "pixel " << i;
            EXPECT_NEAR(motion[i].y, expected.y, close) << "pixel " << i;
            EXPECT_NEAR(motion[i].z, expected.z, 2e-3 + 1e-3 * std::abs(expected.z));
            EXPECT_NEAR(depth[i].x, here.z, 1e-3 * here.z);
            // The ray of this pixel went through it.
            EXPECT_NEAR(here.x, double(i % width) + 0.5, 0.51);
            EXPECT_NEAR(here.y, double(i / width) + 0.5, 0.51);
            ++seen[size_t(hit[i].x)];
        }
        return seen;
    }
};

Triangles ball(glm::vec3 centre) {
    Triangles t;
    t.sphere(centre, 0.8f, 8, false, true);
    t.uv0.clear();
    return t;
}

Thing still(const Triangles& t) { return {t.positions, t.positions}; }

TEST(RealtimeMotion, OfAMovingCamera) {
    Scene s;
    const Triangles b = ball({0.3f, 0, 0});
    s.show(s.mesh(b, GP_MESH_STATIC), 0);
    s.things = {still(b)};
    const View first, second{{0.4, 0.2, 4.5}, {0.1, 0, 0}};
    s.render(first);
    s.render(second);
    EXPECT_GT(s.expectMotion(second, first)[0], 100);
    s.render(second);
    EXPECT_GT(s.expectMotion(second, second)[0], 100);  // which now rests
}

TEST(RealtimeMotion, OfTurningInstancesInShuffledOrder) {
    Scene s;
    const Triangles b = ball({0, 0, 0});
    const GpMesh m = s.mesh(b, GP_MESH_MOVABLE);
    const float angle[2][2] = {{0.1f, -0.2f}, {0.4f, 0.5f}};  // of each, before and now
    const glm::vec3 shift[2][2] = {{{-0.9f, 0, 0}, {0.9f, 0, 0}}, {{-1, 0.2f, 0.3f}, {1, 0, -1}}};
    GpInstance old[2];
    for (int i = 0; i < 2; ++i) old[i] = s.show(m, uint64_t(5 + i), angle[0][i], shift[0][i]);
    const View view;
    s.render(view);
    for (GpInstance i : old) s.stage.check(gpRemoveInstance(i));
    for (int i : {1, 0}) {
        s.show(m, uint64_t(5 + i), angle[1][i], shift[1][i]);
        Thing t;
        for (glm::vec3 p : b.positions) {
            t.before.push_back(turned(p, angle[0][i], shift[0][i]));
            t.now.push_back(turned(p, angle[1][i], shift[1][i]));
        }
        s.things.push_back(t);
    }
    s.render(view);
    for (int seen : s.expectMotion(view, view)) EXPECT_GT(seen, 50);
}

TEST(RealtimeMotion, OfDynamicVerticesUnderAMovingInstance) {
    Scene s;
    const Triangles b = ball({0, 0, 0});
    const GpMesh m = s.mesh(b, GP_MESH_DYNAMIC);
    const GpInstance i = s.show(m, 0);
    Triangles bent = b;
    for (glm::vec3& p : bent.positions) p += glm::vec3(0.3f * p.y * p.y, 0.1f * p.x, 0);
    const View view;
    s.render(view);
    const GpMeshDesc desc = meshDesc(bent, nullptr);
    s.stage.check(gpUpdateMesh(m, &desc));
    float transform[12];
    transformOf(0.2f, {0.1f, 0, 0}, transform);
    s.stage.check(gpSetInstanceTransform(i, transform));
    Thing t;
    t.before = b.positions;
    for (glm::vec3 p : bent.positions) t.now.push_back(turned(p, 0.2f, {0.1f, 0, 0}));
    s.things = {t};
    s.render(view);
    EXPECT_GT(s.expectMotion(view, view)[0], 100);
}

TEST(RealtimeMotion, InAPlaneMirror) {
    // A mirror at z = 0 that fills the view; what it shows moves behind the camera.
    Scene s;
    GpMaterialDesc metal{};
    metal.given = GP_GIVEN_ROUGHNESS;
    metal.metallic = 1;
    Triangles pane;
    pane.quad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    s.stage.add(pane, s.stage.material(metal));
    const Triangles b = ball({0, 0, 8});
    const GpMesh m = s.mesh(b, GP_MESH_MOVABLE);
    const GpInstance i = s.show(m, 3);
    const View first{{0, 0.5, 4}, {0, 0, 0}}, second{{0.2, 0.4, 4}, {0.1, 0, 0}};
    s.render(first);
    float transform[12];
    transformOf(0.3f, {0.5f, 0.2f, 0}, transform);
    s.stage.check(gpSetInstanceTransform(i, transform));
    Thing t;
    const glm::vec3 image(1, 1, -1);  // what the mirror makes of a point
    for (glm::vec3 p : b.positions) {
        t.before.push_back(p * image);
        t.now.push_back(turned(p, 0.3f, {0.5f, 0.2f, 0}) * image);
    }
    s.things = {Thing{}, t};
    s.render(second);
    const std::vector<int> seen = s.expectMotion(second, first);
    EXPECT_EQ(seen[0], 0);  // the mirror itself is not what pixels show
    EXPECT_GT(seen[1], 20);
    EXPECT_EQ(s.layer("material")[width * (height / 2) + width / 2].w, 1);  // mirrors on the way
}

TEST(RealtimeMotion, NothingIsKnownOfWhatIsNewOrAfterACut) {
    constexpr int noHistory = 2;
    Scene s;
    const Triangles b = ball({0, 0, 0});
    const GpMesh m = s.mesh(b, GP_MESH_MOVABLE);
    s.show(m, 1, 0, {-1, 0, 0});
    const View view;
    s.render(view);
    s.show(m, 2, 0, {1, 0, 0});
    s.render(view);
    const auto known = [&](float instance) {
        const auto hit = s.layer("hit"), material = s.layer("material");
        int count = 0;
        for (size_t i = 0; i < hit.size(); ++i)
            if (hit[i].x == instance) count += (int(material[i].z) & noHistory) == 0 ? 1 : -1;
        return count;
    };
    EXPECT_GT(known(0), 50);
    EXPECT_LT(known(1), -50);
    GpRenderOptions cut{};
    cut.realtime.resetHistory = 1;
    const GpCameraDesc camera = view.desc();
    s.stage.check(gpRender(s.frame, s.stage.scene, &camera, &cut));
    EXPECT_LT(known(0), -50);
}

}  // namespace
}  // namespace gp::test
