#include "brdf/spheres.h"

#include <fmt/format.h>

#include <cmath>

#include "brdf/studio.h"
#include "commands.h"
#include "exposure.h"
#include "interrupt.h"
#include "metrics/color.h"
#include "parse.h"
#include "progress_bar.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Material = Owner<GpMaterialImpl, &gpReleaseMaterial>;
using Mesh = Owner<GpMeshImpl, &gpReleaseMesh>;
using Instance = Owner<GpInstanceImpl, &gpReleaseInstance>;
using Light = Owner<GpLightImpl, &gpReleaseLight>;

constexpr float kPi = 3.14159265f;
constexpr unsigned kRows = 180, kColumns = 360;
// The sphere's radius is 1: a little room around it.
constexpr float kPictureHeight = 2.1f;

template <class Owned, class Handle>
Owned owned(GpDevice device, Handle handle) {
    Owned result(handle);
    if (!result) {
        check(device, GP_ERROR_UNKNOWN);
    }
    return result;
}

struct SphereVertices {
    std::vector<float> positions, tangents, texCoords;
    std::vector<std::uint32_t> indices;
};

// Tangents run east; the poles lie at the upper and lower rim as the camera sees them. Texture
// coordinates go once around and once from pole to pole.
SphereVertices makeSphere() {
    SphereVertices sphere;
    for (unsigned row = 0; row <= kRows; ++row) {
        const float theta = kPi * static_cast<float>(row) / kRows;
        for (unsigned column = 0; column <= kColumns; ++column) {
            const float phi = 2 * kPi * static_cast<float>(column) / kColumns;
            const float s = std::sin(theta);
            sphere.positions.insert(sphere.positions.end(),
                                    {s * std::sin(phi), std::cos(theta), s * std::cos(phi)});
            sphere.tangents.insert(sphere.tangents.end(), {std::cos(phi), 0, -std::sin(phi), 1});
            sphere.texCoords.insert(sphere.texCoords.end(),
                                    {static_cast<float>(column) / kColumns,
                                     static_cast<float>(row) / kRows});
        }
    }
    constexpr unsigned stride = kColumns + 1;
    for (unsigned row = 0; row < kRows; ++row) {
        for (unsigned column = 0; column < kColumns; ++column) {
            const unsigned a = row * stride + column, b = a + stride;
            sphere.indices.insert(sphere.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    }
    return sphere;
}

// The scene without the sphere's material, which changes from picture to picture.
class Stage {
public:
    Stage(GpDevice device, const SphereSettings& settings)
        : m_device(device), m_scene(newScene(device)) {
        const SphereVertices sphere = makeSphere();
        GpMeshDesc desc{};
        desc.vertexCount = static_cast<std::uint32_t>(sphere.positions.size() / 3);
        desc.positions = desc.normals = sphere.positions.data();
        desc.tangents = sphere.tangents.data();
        desc.texCoords[0] = sphere.texCoords.data();
        desc.indices = sphere.indices.data();
        desc.indexCount = static_cast<std::uint32_t>(sphere.indices.size());
        m_mesh = owned<Mesh>(device, gpNewMesh(device, &desc));
        GpInstanceDesc instance{};
        instance.mesh = m_mesh.get();
        m_instance = owned<Instance>(device, gpNewInstance(m_scene.get(), &instance));
        light(settings);
    }

    void show(GpBsdf model) {
        GpMaterialDesc desc{};
        desc.bsdf = model;
        const Material material = owned<Material>(m_device, gpNewMaterial(m_device, &desc));
        check(m_device, gpReplaceMaterial(m_scene.get(), nullptr, material.get(), nullptr));
    }

    GpScene scene() const { return m_scene.get(); }

private:
    void light(const SphereSettings& settings) {
        if (settings.light) {
            const float azimuth = (*settings.light)[0] * kPi / 180;
            const float elevation = (*settings.light)[1] * kPi / 180;
            GpLightDesc desc{};
            desc.kind = GP_LIGHT_DIRECTIONAL;
            desc.intensity = kPi;  // white matte surfaces that face it have radiance 1
            desc.direction[0] = -std::sin(azimuth) * std::cos(elevation);
            desc.direction[1] = -std::sin(elevation);
            desc.direction[2] = -std::cos(azimuth) * std::cos(elevation);
            m_light = owned<Light>(m_device, gpNewLight(m_scene.get(), &desc));
        }
        if (!settings.environmentPath.empty()) {
            check(m_device, gpSetEnvironmentFromFile(m_scene.get(),
                                                     settings.environmentPath.c_str(), nullptr));
        } else if (!settings.light) {
            const Surroundings studio = makeStudio();
            GpEnvironmentDesc desc{};
            desc.width = studio.width;
            desc.height = studio.height;
            desc.pixels = studio.rgba.data();
            check(m_device, gpSetEnvironment(m_scene.get(), &desc));
        }
    }

    GpDevice m_device;
    Scene m_scene;
    Mesh m_mesh;
    Instance m_instance;
    Light m_light;
};

// All pictures are one task for whoever waits.
struct Waiting {
    ProgressBar bar{stderrIsTerminal()};
    std::size_t done = 0, count = 1;
};

int onProgress(void* user, const GpProgress* progress) {
    Waiting& waiting = *static_cast<Waiting*>(user);
    GpProgress whole = *progress;
    whole.fraction = (static_cast<double>(waiting.done) + progress->fraction) /
                     static_cast<double>(waiting.count);
    whole.secondsRemaining = -1;  // of this picture only: no help
    waiting.bar.show(whole);
    return interrupted() ? 1 : 0;
}

// False when it was cancelled.
bool trace(GpDevice device, GpFrame frame, const Stage& stage, const SphereSettings& settings,
           Waiting& waiting) {
    GpCameraDesc camera{};
    camera.kind = GP_CAMERA_ORTHOGRAPHIC;
    camera.position[2] = 4;
    camera.orthographicHeight = kPictureHeight;
    GpRenderOptions options{};
    options.samplesPerPixel = settings.samples;
    options.progress = &onProgress;
    options.progressUser = &waiting;
    const GpError error = gpRender(frame, stage.scene(), &camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(device, nullptr);
        return false;
    }
    check(device, error);
    return true;
}

std::array<float, 2> parseLight(const std::string& word) {
    const std::vector<std::string> parts = splitAtCommas(word);
    if (parts.size() != 2) {
        throw UsageError(fmt::format("--light: '{}' is not AZIMUTH,ELEVATION", word));
    }
    return {static_cast<float>(parseNumber("--light", parts[0], -360, 360)),
            static_cast<float>(parseNumber("--light", parts[1], -90, 90))};
}

}  // namespace

const char* const kSphereNotes =
    "Unit spheres before an orthographic camera; the tangent runs to the right. Without --env and\n"
    "--light they stand in a studio with soft lamps. --light AZ,EL is a lamp far away, in degrees\n"
    "from the camera to the right and upwards; a white matte surface that faces it shows as 1.\n"
    "Colours are radiance times 2^exposure, clipped at 1. --exposure is 0, automatic with --env.";

void addSphereOptions(CLI::App& app, SphereSettings& settings) {
    SphereSettings& s = settings;
    addWord(app, "--env", "FILE", "Light from an environment image (.hdr, .exr)",
            [&s](const std::string& word) { s.environmentPath = word; });
    addWord(app, "--light", "AZ,EL", "Light from far away, degrees from the camera",
            [&s](const std::string& word) { s.light = parseLight(word); });
    addWord(app, "--exposure", "EV", "Brighter by this many stops", [&s](const std::string& word) {
        s.exposureEv = parseNumber("--exposure", word, -40, 40);
    });
    addWord(app, "--size", "N", "Pixels of a side of a picture; 192", [&s](const std::string& w) {
        s.size = static_cast<unsigned>(parseInteger("--size", w, 16, 4096));
    });
    addWord(app, "--samples", "N", "Paths a pixel; 256", [&s](const std::string& word) {
        s.samples = static_cast<unsigned>(parseInteger("--samples", word, 1, 1u << 20));
    });
}

Device newSphereDevice() {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_CPU;
    return newDevice(desc);
}

std::vector<SpherePicture> renderSpheres(GpDevice device, const std::vector<GpBsdf>& models,
                                         const SphereSettings& settings) {
    const InterruptGuard guard(device);
    Stage stage(device, settings);
    Waiting waiting;
    waiting.count = models.size();
    GpFrameDesc desc{};
    desc.width = desc.height = settings.size;
    const Frame frame = newFrame(device, desc);
    std::vector<SpherePicture> pictures;
    for (const GpBsdf model : models) {
        stage.show(model);
        if (interrupted() || !trace(device, frame.get(), stage, settings, waiting)) {
            return {};
        }
        SpherePicture picture;
        picture.size = settings.size;
        picture.rgba.resize(std::size_t{4} * settings.size * settings.size);
        check(device, gpReadFrameImage(frame.get(), GP_IMAGE_COLOR, picture.rgba.data(),
                                       picture.rgba.size() * sizeof(float)));
        pictures.push_back(std::move(picture));
        ++waiting.done;
    }
    return pictures;
}

std::vector<GridPicture> displayed(const std::vector<SpherePicture>& spheres,
                                   const SphereSettings& settings) {
    std::vector<float> all;
    for (const SpherePicture& sphere : spheres) {
        all.insert(all.end(), sphere.rgba.begin(), sphere.rgba.end());
    }
    const double automatic = settings.environmentPath.empty()
                                 ? 0.0
                                 : automaticExposureEv(all.data(), all.size() / 4);
    const auto scale = static_cast<float>(std::exp2(settings.exposureEv.value_or(automatic)));
    std::vector<GridPicture> pictures;
    for (const SpherePicture& sphere : spheres) {
        GridPicture picture;
        picture.width = picture.height = sphere.size;
        for (std::size_t i = 0; i < sphere.rgba.size(); i += 4) {
            const glm::vec3 linear(sphere.rgba[i], sphere.rgba[i + 1], sphere.rgba[i + 2]);
            picture.pixels.push_back(rgb8FromSrgb(
                metrics::srgbFromLinear(glm::clamp(scale * linear, 0.0f, 1.0f))));
        }
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace gp::tool
