#include "render/stage.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

namespace gp::test {

namespace {

constexpr float pi = 3.14159265f;

bool isHere(const char* instructionSet) {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_CPU;
    desc.threads = 1;
    desc.instructionSet = instructionSet;
    const GpDevice device = gpNewDevice(&desc);
    if (device) gpReleaseDevice(device);
    gpGetError(nullptr, nullptr);
    return device != nullptr;
}

}  // namespace

std::vector<Variant> fullVariants() {
    static const std::vector<Variant> variants = [] {
        std::vector<Variant> found;
        for (const char* set : {"x86-64", "avx2", "avx512"}) {
            if (!isHere(set)) continue;
            Variant v;
            v.instructionSet = set;
            v.name = std::string("reference_cpu_") + set;
            for (char& c : v.name) c = c == '-' ? '_' : c;
            found.push_back(v);
        }
        return found;
    }();
    return variants;
}

std::vector<Variant> allVariants() {
    std::vector<Variant> variants = fullVariants();
    Variant diffuse = variants.back();
    diffuse.shading = GP_SHADING_DIFFUSE;
    diffuse.name += "_diffuse";
    variants.push_back(diffuse);
    return variants;
}

std::vector<Variant> bestVariants() { return {fullVariants().back(), allVariants().back()}; }

std::vector<Variant> bestFullVariant() { return {fullVariants().back()}; }

std::vector<Variant> localVariants() {
    std::vector<Variant> variants = fullVariants();
    for (Variant& v : variants) {
        v.mode = GP_MODE_LOCAL;
        v.name.replace(0, std::string("reference").size(), "local");
    }
    return variants;
}

std::string variantName(const Variant& variant) { return variant.name; }

void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

uint32_t effort(uint32_t samples) {
    const char* text = std::getenv("GP_LONG_TESTS");
    return text && std::string(text) == "1" ? samples * 16 : samples;
}

void put(float* to, glm::vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

GpCameraDesc lookFrom(glm::vec3 target, glm::vec3 from, float distance, float height) {
    GpCameraDesc camera{};
    camera.kind = GP_CAMERA_ORTHOGRAPHIC;
    put(camera.target, target);
    put(camera.position, target + from * distance);
    camera.orthographicHeight = height;
    return camera;
}

GpMaterialDesc lambertDesc(glm::vec3 albedo) {
    GpMaterialDesc desc{};
    desc.given = GP_GIVEN_BASE_COLOR | GP_GIVEN_SPECULAR;
    put(desc.baseColor, albedo);
    desc.baseColor[3] = 1;
    return desc;
}

// ---------------------------------------------------------------------------------- pictures

glm::dvec3 Picture::mean() const {
    glm::dvec3 sum{0};
    for (const glm::vec4& c : color) sum += glm::dvec3(c);
    return sum / double(color.size());
}

glm::dvec3 Picture::sigma() const {
    glm::dvec3 sum{0};
    for (const glm::vec4& v : variance) sum += glm::dvec3(v);
    return glm::sqrt(sum) / double(variance.size());
}

void expectMean(const Picture& picture, glm::dvec3 expected, const std::string& what) {
    constexpr double rounding = 2e-4;  // of the whole chain in floats, relative
    const glm::dvec3 mean = picture.mean(), sigma = picture.sigma();
    for (int c = 0; c < 3; ++c) {
        if (expected[c] > 0) {
            EXPECT_LT(4 * sigma[c], 0.01 * expected[c])
                << what << ": too few samples, channel " << c;
        }
        EXPECT_NEAR(mean[c], expected[c], 4 * sigma[c] + rounding * expected[c])
            << what << ": channel " << c << ", sigma " << sigma[c] << ", ratio "
            << mean[c] / expected[c];
    }
}

void expectMean(const Picture& picture, double expected, const std::string& what) {
    expectMean(picture, glm::dvec3(expected), what);
}

// ---------------------------------------------------------------------------------- geometry

void Triangles::quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
    for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        positions.push_back(corner + u * at.x + v * at.y);
        uv0.push_back(at);
    }
}

void Triangles::box(glm::vec3 lo, glm::vec3 hi) {
    const glm::vec3 d = hi - lo, x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
    quad(lo, y, x), quad(lo, z, y), quad(lo, x, z);
    quad(hi, -x, -y), quad(hi, -y, -z), quad(hi, -z, -x);
}

void Triangles::sphere(glm::vec3 centre, float radius, uint32_t rings, bool inwards, bool smooth) {
    const auto at = [&](uint32_t i, uint32_t j) {  // the same floats for the same point
        const float theta = pi * float(i) / float(rings);
        const float phi = pi * float(j % (2 * rings)) / float(rings);
        const float s = i == 0 || i == rings ? 0.0f : std::sin(theta);
        return glm::vec3(s * std::cos(phi), std::cos(theta), s * std::sin(phi));
    };
    const auto corner = [&](glm::vec3 d) {
        positions.push_back(centre + radius * d);
        if (smooth) normals.push_back(inwards ? -d : d);
    };
    const auto triangle = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        if (a == b || b == c || c == a) return;
        corner(a), corner(inwards ? c : b), corner(inwards ? b : c);
    };
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < 2 * rings; ++j) {
            const glm::vec3 a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1), d = at(i + 1, j);
            triangle(a, b, c), triangle(a, c, d);
        }
}

// ---------------------------------------------------------------------------------- the stage

Stage::Stage(const Variant& v, uint32_t threads) : variant(v) {
    GpDeviceDesc desc{};
    desc.backend = v.backend;
    desc.threads = threads;
    desc.instructionSet = v.instructionSet.empty() ? nullptr : v.instructionSet.c_str();
    device = gpNewDevice(&desc);
    if (!device) throw std::runtime_error("no device for " + v.name);
    scene = gpNewScene(device);
}

Stage::~Stage() { gpReleaseDevice(device); }

void Stage::check(GpError result) const {
    if (result == GP_SUCCESS) return;
    const char* message = "";
    gpGetError(device, &message);
    throw std::runtime_error(std::string(gpErrorName(result)) + ": " + message);
}

GpMaterial Stage::material(const GpMaterialDesc& desc) {
    const GpMaterial result = gpNewMaterial(device, &desc);
    if (!result) check(gpGetError(device, nullptr));
    return result;
}

GpMaterial Stage::lambert(glm::vec3 albedo, glm::vec3 emission) {
    GpMaterialDesc desc = lambertDesc(albedo);
    put(desc.emission, emission);
    return material(desc);
}

GpTexture Stage::texture(const GpTextureDesc& desc) {
    const GpTexture result = gpNewTexture(device, &desc);
    if (!result) check(gpGetError(device, nullptr));
    return result;
}

GpMeshDesc meshDesc(const Triangles& t, GpMaterial material) {
    GpMeshDesc mesh{};
    mesh.material = material;
    mesh.vertexCount = uint32_t(t.positions.size());
    mesh.positions = &t.positions[0].x;
    if (!t.normals.empty()) mesh.normals = &t.normals[0].x;
    if (t.uv0.size() == t.positions.size()) mesh.texCoords[0] = &t.uv0[0].x;
    if (!t.uv1.empty()) mesh.texCoords[1] = &t.uv1[0].x;
    if (!t.colors.empty()) mesh.colors = &t.colors[0].x;
    return mesh;
}

GpInstance Stage::add(const Triangles& t, GpMaterial material, uint32_t invisibleTo,
                      const float* worldFromObject) {
    const GpMeshDesc mesh = meshDesc(t, material);
    const GpMesh handle = gpNewMesh(device, &mesh);
    if (!handle) check(gpGetError(device, nullptr));
    GpInstanceDesc desc{};
    desc.mesh = handle;
    desc.invisibleTo = invisibleTo;
    if (worldFromObject) std::copy_n(worldFromObject, 12, desc.worldFromObject);
    const GpInstance result = gpNewInstance(scene, &desc);
    if (!result) check(gpGetError(device, nullptr));
    return result;
}

void Stage::light(const GpLightDesc& desc) {
    if (!gpNewLight(scene, &desc)) check(gpGetError(device, nullptr));
}

void Stage::surround(glm::vec3 radiance) {
    GpEnvironmentDesc desc{};
    put(desc.color, radiance);
    check(gpSetEnvironment(scene, &desc));
}

GpRenderOptions Stage::options(uint32_t samples) const {
    GpRenderOptions o{};
    o.samplesPerPixel = samples;
    o.shading = variant.shading;
    return o;
}

GpFrame Stage::frame(uint32_t width, uint32_t height) {
    GpFrameDesc desc{};
    desc.width = width;
    desc.height = height;
    desc.mode = variant.mode;
    const GpFrame result = gpNewFrame(device, &desc);
    if (!result) check(gpGetError(device, nullptr));
    return result;
}

Picture Stage::render(uint32_t width, uint32_t height, const GpCameraDesc& camera,
                      const GpRenderOptions& options) {
    const GpFrame f = frame(width, height);
    check(gpRender(f, scene, &camera, &options));
    Picture picture;
    picture.width = width, picture.height = height;
    picture.color = read<glm::vec4>(f, GP_IMAGE_COLOR, size_t(width) * height);
    picture.variance = read<glm::vec4>(f, GP_IMAGE_VARIANCE, size_t(width) * height);
    check(gpReleaseFrame(f));
    return picture;
}

}  // namespace gp::test
