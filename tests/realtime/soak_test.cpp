// Thousands of frames of a scene in which anything may happen between two of them: everything stays
// finite, wrong calls change nothing, and memory does not grow.
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>
#include <unistd.h>

#include "render/stage.h"

#if defined(__SANITIZE_ADDRESS__)
// What was freed is kept for a while by the sanitizer; by default so much that it looks like
// growth.
extern "C" [[gnu::visibility("default")]] const char* __asan_default_options() {
    return "quarantine_size_mb=8";
}
#endif

namespace gp::test {
namespace {

double residentMiB() {
    long pages = 0, resident = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (!file) return 0;
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

class Soak {
public:
    Soak() : stage_(variant()) {
        Triangles floor;
        floor.quad({-4, -1, -4}, {0, 0, 8}, {8, 0, 0});
        stage_.add(floor, stage_.lambert(glm::vec3(0.6f)));
        stage_.surround(glm::vec3(0.2f));
        for (int i = 0; i < 3; ++i) {
            GpMaterialDesc d{};
            d.given = GP_GIVEN_ROUGHNESS;
            d.metallic = float(i % 2), d.roughness = 0.5f * float(i);
            d.transmission = i == 2 ? 1.0f : 0.0f;
            materials_[i] = stage_.material(d);
        }
        frame_ = stage_.frame(20, 12);
    }

    void step() {
        switch (pick(8)) {
            case 0: addThing(); break;
            case 1: removeThing(); break;
            case 2: moveThing(); break;
            case 3: changeLights(); break;
            case 4: wrongCalls(); break;
            case 5: resize(); break;
            case 6: stage_.surround(glm::vec3(0.3f * uniform())); break;
            default: break;
        }
        render();
    }

private:
    struct Thing {
        GpMesh mesh;
        GpInstance instance;
    };

    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    uint32_t pick(uint32_t n) { return uint32_t(random_()) % n; }
    float uniform() { return float(random_() % 10000) / 10000; }

    Triangles shape() {
        Triangles t;
        const float size = pick(10) == 0 ? 0.0f : 0.2f + 0.5f * uniform();  // of nothing, at times
        t.sphere({0, 0, 0}, size, 3 + pick(3), false, false);
        if (t.positions.empty()) t.positions.assign(3, glm::vec3(0));
        t.normals.clear(), t.uv0.clear();
        return t;
    }
    void place(float* m) {
        const float scale = pick(40) == 0 ? 1e6f : 1.0f;
        const float rows[12] = {scale, 0, 0, 4 * uniform() - 2, 0, scale, 0, uniform(),
                                0, 0, scale, 4 * uniform() - 2};
        std::copy_n(rows, 12, m);
    }
    void addThing() {
        if (things_.size() > 12) return;
        const Triangles t = shape();
        GpMeshDesc mesh = meshDesc(t, materials_[pick(3)]);
        mesh.kind = pick(2) ? GP_MESH_DYNAMIC : GP_MESH_MOVABLE;
        Thing thing{};
        thing.mesh = gpNewMesh(stage_.device, &mesh);
        GpInstanceDesc desc{};
        desc.mesh = thing.mesh, desc.id = pick(20);  // ids are used again, or taken
        place(desc.worldFromObject);
        thing.instance = gpNewInstance(stage_.scene, &desc);
        if (thing.instance) things_.push_back(thing);
        else stage_.check(gpReleaseMesh(thing.mesh));
        gpGetError(stage_.device, nullptr);
    }
    void removeThing() {
        if (things_.empty()) return;
        const size_t i = pick(uint32_t(things_.size()));
        stage_.check(gpRemoveInstance(things_[i].instance));
        stage_.check(gpReleaseMesh(things_[i].mesh));
        things_.erase(things_.begin() + long(i));
    }
    void moveThing() {
        if (things_.empty()) return;
        const Thing& thing = things_[pick(uint32_t(things_.size()))];
        float m[12];
        place(m);
        stage_.check(gpSetInstanceTransform(thing.instance, m));
        const Triangles t = shape();
        const GpMeshDesc desc = meshDesc(t, nullptr);
        gpUpdateMesh(thing.mesh, &desc);  // refused for those that are not dynamic
        gpGetError(stage_.device, nullptr);
    }
    void changeLights() {
        while (lights_.size() > 6 || (!lights_.empty() && pick(3) == 0)) {
            stage_.check(gpRemoveLight(lights_.back()));
            lights_.pop_back();
        }
        GpLightDesc desc{};
        desc.kind = pick(2) ? GP_LIGHT_SPHERE : GP_LIGHT_DIRECTIONAL;
        desc.id = 1 + pick(5);
        desc.intensity = pick(5) == 0 ? 0.0f : 3 * uniform();
        desc.radius = pick(2) ? 0.0f : 0.2f;  // of no size, at times
        put(desc.position, {2 * uniform() - 1, 1, 2 * uniform() - 1});
        if (const GpLight light = gpNewLight(stage_.scene, &desc)) lights_.push_back(light);
        gpGetError(stage_.device, nullptr);
    }
    void wrongCalls() {
        const float nan = std::nanf("");
        const float broken[12] = {nan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        if (!things_.empty()) {
            EXPECT_EQ(gpSetInstanceTransform(things_[0].instance, broken), GP_ERROR_NOT_FINITE);
        }
        GpRenderOptions o{};
        o.realtime.renderScale = nan;
        EXPECT_EQ(gpRender(frame_, stage_.scene, nullptr, &o), GP_ERROR_NOT_FINITE);
        const GpFrameDesc nothing{0, 0, GP_MODE_REALTIME};
        EXPECT_EQ(gpNewFrame(stage_.device, &nothing), nullptr);
        gpGetError(stage_.device, nullptr);
    }
    void resize() {
        stage_.check(gpReleaseFrame(frame_));
        width_ = 1 + pick(24), height_ = 1 + pick(16);
        frame_ = stage_.frame(width_, height_);
    }
    void render() {
        GpRenderOptions o{};
        o.realtime.denoiser = GpDenoiser(pick(4));
        o.realtime.lightReuse = GpLightReuse(pick(3));
        o.realtime.indirectReuse = GpLightReuse(pick(3));
        o.realtime.antiAliasing = GpAntiAliasing(pick(3));
        o.realtime.renderScale = pick(4) == 0 ? 0.6f : 1.0f;
        o.realtime.resetHistory = pick(20) == 0;
        GpCameraDesc camera{};
        put(camera.position, {uniform(), 0.6f, 4});
        stage_.check(gpRender(frame_, stage_.scene, &camera, &o));
        const auto color = stage_.read<glm::vec4>(frame_, GP_IMAGE_COLOR, width_ * height_);
        for (const glm::vec4& c : color)
            ASSERT_TRUE(std::isfinite(c.x + c.y + c.z) && c.x >= 0 && c.y >= 0 && c.z >= 0);
    }

    Stage stage_;
    std::minstd_rand random_{7};
    GpMaterial materials_[3];
    GpFrame frame_;
    uint32_t width_ = 20, height_ = 12;
    std::vector<Thing> things_;
    std::vector<GpLight> lights_;
};

TEST(RealtimeSoak, AnythingBetweenFrames) {
    Soak soak;
    const uint32_t frames = effort(2000);  // 32,000 with GP_LONG_TESTS=1
    double early = 0;
    for (uint32_t i = 0; i < frames; ++i) {
        soak.step();
        if (::testing::Test::HasFailure()) return;
        if (i == frames / 4) early = residentMiB();
    }
    EXPECT_LT(residentMiB() - early, 16) << "MiB more than after a quarter of the frames";
}

class ManyLights {
public:
    explicit ManyLights(uint32_t count) : stage_(variant()) {
        Triangles floor;
        floor.quad({-4, -1, -4}, {0, 0, 8}, {8, 0, 0});
        stage_.add(floor, stage_.lambert(glm::vec3(0.6f)));
        for (uint32_t i = 0; i < count; ++i) {
            const GpLightDesc d = lamp(i);
            lights_.push_back(gpNewLight(stage_.scene, &d));
            EXPECT_NE(lights_.back(), nullptr);
        }
    }

    void changeAll() {
        for (uint32_t i = 0; i < lights_.size(); ++i) {
            const GpLightDesc d = lamp(i);
            stage_.check(gpSetLight(lights_[i], &d));
        }
    }

    void wrongCalls() {
        const float nan = std::nanf("");
        const float sliver[9] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
        GpLightDesc wrong = lamp(7);
        wrong.id = 0, wrong.kind = GP_LIGHT_POLYGON, wrong.corners = sliver, wrong.cornerCount = 3;
        EXPECT_EQ(gpSetLight(lights_[7], &wrong), GP_ERROR_OUT_OF_RANGE);  // no area
        EXPECT_EQ(gpNewLight(stage_.scene, &wrong), nullptr);
        wrong = lamp(8), wrong.position[1] = nan;
        EXPECT_EQ(gpSetLight(lights_[8], &wrong), GP_ERROR_NOT_FINITE);
        wrong = lamp(9), wrong.intensity = nan;
        EXPECT_EQ(gpSetLight(lights_[9], &wrong), GP_ERROR_NOT_FINITE);
        wrong = lamp(10);
        EXPECT_EQ(gpNewLight(stage_.scene, &wrong), nullptr);  // its id is taken
        gpGetError(stage_.device, nullptr);
    }

    // Every `step`th from the end, of those that are left.
    void remove(uint32_t step) {
        for (size_t i = lights_.size(); i-- > 0;)
            if (lights_[i] && i % step == 0) {
                stage_.check(gpRemoveLight(lights_[i]));
                lights_[i] = nullptr;
            }
    }

    // The sum of a frame without a past.
    float render() {
        const GpFrame frame = stage_.frame(20, 12);
        GpCameraDesc camera{};
        put(camera.position, {0, 0.6f, 4});
        stage_.check(gpRender(frame, stage_.scene, &camera, nullptr));
        stage_.check(gpRender(frame, stage_.scene, &camera, nullptr));
        float sum = 0;
        for (const glm::vec4& c : stage_.read<glm::vec4>(frame, GP_IMAGE_COLOR, 20 * 12))
            sum += c.x + c.y + c.z;
        stage_.check(gpReleaseFrame(frame));
        return sum;
    }

private:
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    float uniform() { return float(random_() % 10000) / 10000; }
    GpLightDesc lamp(uint32_t i) {
        GpLightDesc d{};
        d.kind = i % 3 == 0 ? GP_LIGHT_SPOT : GP_LIGHT_SPHERE;
        d.id = i + 1, d.intensity = uniform() < 0.1f ? 0.0f : 1e-3f * uniform();
        d.radius = i % 2 ? 0.0f : 0.01f;
        put(d.position, {8 * uniform() - 4, 2 * uniform(), 8 * uniform() - 4});
        return d;
    }

    Stage stage_;
    std::minstd_rand random_{3};
    std::vector<GpLight> lights_;
};

// A hundred thousand lights that all change between frames, wrong calls among them, until they are
// all taken away again.
TEST(RealtimeSoak, AHundredThousandLights) {
    ManyLights many(100000);
    for (int step = 0; step < 3; ++step) {
        many.changeAll();
        many.wrongCalls();
        const float sum = many.render();
        ASSERT_TRUE(std::isfinite(sum) && sum > 1e-3f) << sum;
    }
    many.remove(2);
    EXPECT_GT(many.render(), 1e-3f);
    many.remove(1);
    EXPECT_EQ(many.render(), 0);
}

}  // namespace
}  // namespace gp::test
