// What the tests of whole pictures share: a scene built through the C interface on one of the ways
// in which a picture can be made, and the picture with the noise that it admits to.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "glitterpath/glitterpath.h"

namespace gp::test {

// One way of making pictures. A new integrator, backend or instruction set is one row in stage.cpp.
struct Variant {
    std::string name;  // of the test case
    GpBackend backend = GP_BACKEND_CPU;
    GpFrameMode mode = GP_MODE_REFERENCE;
    std::string instructionSet;  // "": the best
    GpShading shading = GP_SHADING_FULL;
};

std::vector<Variant> allVariants();   // that this machine has, plain-diffuse shading among them
std::vector<Variant> fullVariants();  // those with whole materials
std::vector<Variant> bestVariants();     // the fastest of each shading, for tests that cost much
std::vector<Variant> bestFullVariant();  // ... with whole materials
std::vector<Variant> localVariants();    // GP_MODE_LOCAL on each instruction set
std::string variantName(const Variant& variant);
void PrintTo(const Variant& variant, std::ostream* out);
uint32_t effort(uint32_t samples);  // 16 times as many with GP_LONG_TESTS=1

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<glm::vec4> color, variance;
    glm::dvec3 mean() const;
    glm::dvec3 sigma() const;  // of mean(), by the variances that the frame tells
    glm::vec3 at(uint32_t x, uint32_t y) const { return glm::vec3(color[size_t(y) * width + x]); }
};

// The picture's mean is `expected` within four standard deviations, and those are below 1 % of it.
void expectMean(const Picture& picture, glm::dvec3 expected, const std::string& what = {});
void expectMean(const Picture& picture, double expected, const std::string& what = {});

// Vertices in order, three a triangle.
struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    // may be empty, as the next three
    std::vector<glm::vec2> uv0, uv1;
    std::vector<glm::vec4> colors;
    void quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v);  // front: u x v; uv0 runs along u and v
    void box(glm::vec3 lo, glm::vec3 hi);                   // front: outside
    void sphere(glm::vec3 centre, float radius, uint32_t rings, bool inwards, bool smooth);
};

struct Stage {
    explicit Stage(const Variant& variant, uint32_t threads = 0);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    GpMaterial material(const GpMaterialDesc& desc);
    GpMaterial lambert(glm::vec3 albedo, glm::vec3 emission = glm::vec3(0));
    GpTexture texture(const GpTextureDesc& desc);
    GpInstance add(const Triangles& triangles, GpMaterial material, uint32_t invisibleTo = 0,
                   const float* worldFromObject = nullptr);
    void light(const GpLightDesc& desc);
    void surround(glm::vec3 radiance);

    GpRenderOptions options(uint32_t samples) const;  // of the variant
    GpFrame frame(uint32_t width, uint32_t height);   // lives as long as the stage
    Picture render(uint32_t width, uint32_t height, const GpCameraDesc& camera,
                   const GpRenderOptions& options);
    template <class T>
    std::vector<T> read(GpFrame frame, GpFrameImage image, size_t pixels) const {
        std::vector<T> values(pixels);
        check(gpReadFrameImage(frame, image, values.data(), pixels * sizeof(T)));
        return values;
    }
    void check(GpError result) const;  // a failing call ends the test with the library's own line

    Variant variant;
    GpDevice device = nullptr;
    GpScene scene = nullptr;
};

GpMeshDesc meshDesc(const Triangles& triangles, GpMaterial material);  // points into `triangles`
GpMaterialDesc lambertDesc(glm::vec3 albedo);  // no interface above the diffuse base
// Looks at `target` from `distance` along the unit vector `from`, `height` metres of it.
GpCameraDesc lookFrom(glm::vec3 target, glm::vec3 from, float distance, float height);
void put(float* to, glm::vec3 v);

}  // namespace gp::test
