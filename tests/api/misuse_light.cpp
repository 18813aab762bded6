// Lights, environments, the sky.
#include <cstdint>
#include <fstream>
#include <limits>
#include <vector>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

// The same mistake in a new light and in an old one.
void add(Rows& rows, const char* what, GpError expected, const char* message, GpLightKind kind,
         void (*change)(GpLightDesc&)) {
    const auto descOf = [kind, change] {
        GpLightDesc desc{};
        desc.kind = kind;
        desc.intensity = 1;
        desc.edgeU[0] = desc.edgeV[1] = 1;
        change(desc);
        return desc;
    };
    rows.push_back({"gpNewLight", what, expected, message, [descOf](World& w) {
                        const GpLightDesc desc = descOf();
                        return made(gpNewLight(w.scene, &desc));
                    }});
    rows.push_back({"gpSetLight", what, expected, message, [descOf](World& w) {
                        const GpLightDesc desc = descOf();
                        return gpSetLight(w.light, &desc);
                    }});
}

Row environmentRow(const char* what, GpError expected, const char* message,
                   void (*change)(GpEnvironmentDesc&)) {
    return {"gpSetEnvironment", what, expected, message, [change](World& w) {
                static const float pixels[8] = {1, 1, 1, 1, 2, 2, 2, 1};
                GpEnvironmentDesc desc{};
                desc.width = 2;
                desc.height = 1;
                desc.pixels = pixels;
                change(desc);
                return gpSetEnvironment(w.scene, &desc);
            }};
}

// Six faces of 2 x 2 pixels, then what is wrong.
Row cubemapRow(const char* what, GpError expected, const char* message,
               void (*change)(World&, GpCubemapDesc&)) {
    return {"gpSetCubemap", what, expected, message, [change](World& w) {
                GpCubemapDesc desc{};
                for (GpTexture& face : desc.faces) face = w.texture;
                change(w, desc);
                return gpSetCubemap(w.scene, &desc);
            }};
}

GpTexture floatTexture(World& w, uint32_t width, uint32_t height, float value) {
    const std::vector<float> pixels(size_t(width) * height * 4, value);
    GpTextureDesc desc{};
    desc.width = width, desc.height = height, desc.format = GP_FORMAT_RGBA32F;
    desc.pixels = pixels.data();
    return gpNewTexture(w.device, &desc);
}

Rows cubemapRows() {
    Rows rows = {
        {"gpSetCubemap", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return gpSetCubemap(w.scene, nullptr); }},
        {"gpSetCubemap", "a descriptor of zeros", GP_ERROR_INVALID_HANDLE, "faces[0] is NULL",
         [](World& w) {
             const GpCubemapDesc zeros{};
             return gpSetCubemap(w.scene, &zeros);
         }},
        cubemapRow("a face is missing", GP_ERROR_INVALID_HANDLE, "faces[4] is NULL",
                   [](World&, GpCubemapDesc& d) { d.faces[4] = nullptr; }),
        cubemapRow("a face was released", GP_ERROR_INVALID_HANDLE, "faces[1] was released",
                   [](World& w, GpCubemapDesc& d) { d.faces[1] = w.released.texture; }),
        cubemapRow("a face of another device", GP_ERROR_INVALID_HANDLE,
                   "faces[5] belongs to another device",
                   [](World& w, GpCubemapDesc& d) { d.faces[5] = w.foreign.texture; }),
        cubemapRow("a face is no square", GP_ERROR_INVALID_ARGUMENT, "faces[2] has 4 x 2 pixels",
                   [](World& w, GpCubemapDesc& d) { d.faces[2] = floatTexture(w, 4, 2, 1); }),
        cubemapRow("sizes differ", GP_ERROR_INVALID_ARGUMENT,
                   "faces[3] is 4 pixels wide, but faces[0] 2",
                   [](World& w, GpCubemapDesc& d) { d.faces[3] = floatTexture(w, 4, 4, 1); }),
        cubemapRow("a pixel below 0", GP_ERROR_OUT_OF_RANGE, "pixel 0 of faces[5] is -1",
                   [](World& w, GpCubemapDesc& d) { d.faces[5] = floatTexture(w, 2, 2, -1); }),
        cubemapRow("color below 0", GP_ERROR_OUT_OF_RANGE, "color[2]",
                   [](World&, GpCubemapDesc& d) { d.color[2] = -1; }),
        cubemapRow("color is infinite", GP_ERROR_NOT_FINITE, "color[0]",
                   [](World&, GpCubemapDesc& d) { d.color[0] = inf; }),
        cubemapRow("a matrix that is NaN", GP_ERROR_NOT_FINITE, "worldFromCube[4] is nan",
                   [](World&, GpCubemapDesc& d) { d.worldFromCube[4] = nan; }),
        cubemapRow("a matrix that scales", GP_ERROR_OUT_OF_RANGE, "worldFromCube",
                   [](World&, GpCubemapDesc& d) {
                       d.worldFromCube[0] = d.worldFromCube[4] = d.worldFromCube[8] = 2;
                   }),
    };
    addHandleRows<GpScene>(rows, "gpSetCubemap", "scene", [](World& w, GpScene s) {
        GpCubemapDesc desc{};
        for (GpTexture& face : desc.faces) face = w.texture;
        return gpSetCubemap(s, &desc);
    });
    return rows;
}

Row skyRow(const char* what, GpError expected, const char* message, float azimuth, float elevation,
           float lux) {
    return {"gpSetSky", what, expected, message, [=](World& w) {
                return gpSetSky(w.scene, azimuth, elevation, lux);
            }};
}

void addLightFieldRows(Rows& rows) {
    add(rows, "unknown kind", GP_ERROR_INVALID_ARGUMENT, "kind is 5", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.kind = anyEnum<GpLightKind>(5); });
    add(rows, "unknown unit", GP_ERROR_INVALID_ARGUMENT, "unit is 4", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.unit = anyEnum<GpLightUnit>(4); });
    add(rows, "the power of the sun", GP_ERROR_INVALID_ARGUMENT, "unit is a power",
        GP_LIGHT_DIRECTIONAL, [](GpLightDesc& d) { d.unit = GP_UNIT_POWER_W; });
    add(rows, "color below 0", GP_ERROR_OUT_OF_RANGE, "color[0] is -1", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.color[0] = -1; });
    add(rows, "color is NaN", GP_ERROR_NOT_FINITE, "color[2] is nan", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.color[2] = nan; });
    add(rows, "intensity below 0", GP_ERROR_OUT_OF_RANGE, "intensity", GP_LIGHT_SPOT,
        [](GpLightDesc& d) { d.intensity = -0.1f; });
    add(rows, "intensity is infinite", GP_ERROR_NOT_FINITE, "intensity is inf", GP_LIGHT_SPOT,
        [](GpLightDesc& d) { d.intensity = inf; });
    add(rows, "intensity times color overflows", GP_ERROR_OUT_OF_RANGE, "intensity times color[1]",
        GP_LIGHT_SPHERE, [](GpLightDesc& d) {
            d.intensity = 3e38f;
            d.color[1] = 1e10f;
        });
    add(rows, "position is NaN", GP_ERROR_NOT_FINITE, "position[1]", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.position[1] = nan; });
    add(rows, "direction is infinite", GP_ERROR_NOT_FINITE, "direction[0]", GP_LIGHT_DIRECTIONAL,
        [](GpLightDesc& d) { d.direction[0] = inf; });
    add(rows, "angular radius above pi/2", GP_ERROR_OUT_OF_RANGE, "angularRadius",
        GP_LIGHT_DIRECTIONAL, [](GpLightDesc& d) { d.angularRadius = 1.6f; });
    add(rows, "radius below 0", GP_ERROR_OUT_OF_RANGE, "radius", GP_LIGHT_SPHERE,
        [](GpLightDesc& d) { d.radius = -1; });
    add(rows, "outer angle above pi/2", GP_ERROR_OUT_OF_RANGE, "outerAngle", GP_LIGHT_SPOT,
        [](GpLightDesc& d) { d.outerAngle = 1.6f; });
    add(rows, "inner angle above the outer", GP_ERROR_OUT_OF_RANGE, "innerAngle", GP_LIGHT_SPOT,
        [](GpLightDesc& d) {
            d.outerAngle = 0.5f;
            d.innerAngle = 0.6f;
        });
    add(rows, "a rectangle without area", GP_ERROR_OUT_OF_RANGE, "span no area",
        GP_LIGHT_RECTANGLE, [](GpLightDesc& d) {
            d.edgeV[1] = 0;
            d.edgeV[0] = 2;
        });
    add(rows, "an edge that is NaN", GP_ERROR_NOT_FINITE, "edgeU[2]", GP_LIGHT_RECTANGLE,
        [](GpLightDesc& d) { d.edgeU[2] = nan; });
}

// A second handle of a light that was removed through its first.
GpLight leftOver(World& w) {
    const GpLightDesc zeros{};
    const GpLight extra = gpNewLight(w.scene, &zeros);
    GpSceneInfo info{};
    gpGetSceneInfo(w.scene, &info);
    GpLightDesc desc{};
    GpLight other = nullptr;
    gpGetSceneLight(w.scene, uint32_t(info.lights - 1), &desc, &other);
    gpRemoveLight(extra);
    return other;
}

void addSceneLightRows(Rows& rows) {
    rows.push_back({"gpGetSceneLight", "past the end", GP_ERROR_OUT_OF_RANGE,
                    "index is 1000, but the scene has", [](World& w) {
                        GpLightDesc desc{};
                        return gpGetSceneLight(w.scene, 1000, &desc, nullptr);
                    }});
    rows.push_back({"gpGetSceneLight", "no place for it", GP_ERROR_INVALID_ARGUMENT,
                    "desc is NULL",
                    [](World& w) { return gpGetSceneLight(w.scene, 0, nullptr, nullptr); }});
    rows.push_back({"gpSetLight", "removed through another handle", GP_ERROR_INVALID_OPERATION,
                    "no longer in its scene", [](World& w) {
                        const GpLightDesc zeros{};
                        return gpSetLight(leftOver(w), &zeros);
                    }});
    rows.push_back({"gpRemoveLight", "removed through another handle", GP_ERROR_INVALID_OPERATION,
                    "no longer in its scene", [](World& w) { return gpRemoveLight(leftOver(w)); }});
    addHandleRows<GpScene>(rows, "gpGetSceneLight", "scene", [](World&, GpScene s) {
        GpLightDesc desc{};
        return gpGetSceneLight(s, 0, &desc, nullptr);
    });
}

}  // namespace

Rows lightRows() {
    Rows rows = {
        {"gpNewLight", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewLight(w.scene, nullptr)); }},
        {"gpSetLight", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return gpSetLight(w.light, nullptr); }},
        {"gpNewLight", "an id twice", GP_ERROR_DUPLICATE_ID, "id 7",
         [](World& w) {
             GpLightDesc desc{};
             desc.id = 7;
             return made(gpNewLight(w.scene, &desc));
         }},
        {"gpRemoveLight", "twice", GP_ERROR_INVALID_HANDLE, "was released",
         [](World& w) {
             const GpLightDesc zeros{};
             const GpLight extra = gpNewLight(w.scene, &zeros);
             gpRemoveLight(extra);
             return gpRemoveLight(extra);
         }},
    };
    addLightFieldRows(rows);
    addSceneLightRows(rows);
    addHandleRows<GpScene>(rows, "gpNewLight", "scene", [](World&, GpScene s) {
        const GpLightDesc zeros{};
        return made(gpNewLight(s, &zeros));
    });
    addHandleRows<GpLight>(rows, "gpSetLight", "light", [](World&, GpLight l) {
        const GpLightDesc zeros{};
        return gpSetLight(l, &zeros);
    });
    addHandleRows<GpLight>(rows, "gpRemoveLight", "light",
                           [](World&, GpLight l) { return gpRemoveLight(l); });
    addHandleRows<GpLight>(rows, "gpReleaseLight", "light",
                           [](World&, GpLight l) { return gpReleaseLight(l); });
    return rows;
}

Rows environmentRows() {
    Rows rows = {
        environmentRow("a height without a width", GP_ERROR_INVALID_ARGUMENT, "width is 0",
                       [](GpEnvironmentDesc& d) { d.width = 0; }),
        environmentRow("a width without a height", GP_ERROR_INVALID_ARGUMENT, "height is 0",
                       [](GpEnvironmentDesc& d) { d.height = 0; }),
        environmentRow("pixels without a size", GP_ERROR_INVALID_ARGUMENT, "pixels is not NULL",
                       [](GpEnvironmentDesc& d) { d.width = d.height = 0; }),
        environmentRow("a size without pixels", GP_ERROR_INVALID_ARGUMENT, "pixels is NULL",
                       [](GpEnvironmentDesc& d) { d.pixels = nullptr; }),
        environmentRow("too wide", GP_ERROR_TOO_LARGE, "width is 40000",
                       [](GpEnvironmentDesc& d) { d.width = 40000; }),
        environmentRow("too many pixels", GP_ERROR_TOO_LARGE, "pixels",
                       [](GpEnvironmentDesc& d) { d.width = d.height = 32768; }),
        environmentRow("a pixel that is NaN", GP_ERROR_NOT_FINITE, "pixels[5] is nan",
                       [](GpEnvironmentDesc& d) {
                           static const float pixels[8] = {1, 1, 1, 1, 2, nan, 2, 1};
                           d.pixels = pixels;
                       }),
        environmentRow("a pixel below 0", GP_ERROR_OUT_OF_RANGE, "pixels[0] is -1",
                       [](GpEnvironmentDesc& d) {
                           static const float pixels[8] = {-1, 1, 1, 1, 2, 2, 2, 1};
                           d.pixels = pixels;
                       }),
        environmentRow("color below 0", GP_ERROR_OUT_OF_RANGE, "color[1]",
                       [](GpEnvironmentDesc& d) { d.color[1] = -1; }),
        environmentRow("rotation is NaN", GP_ERROR_NOT_FINITE, "rotation",
                       [](GpEnvironmentDesc& d) { d.rotation = nan; }),
        {"gpSetEnvironmentFromFile", "no path", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
         [](World& w) { return gpSetEnvironmentFromFile(w.scene, nullptr, nullptr); }},
        {"gpSetEnvironmentFromFile", "no such file", GP_ERROR_FILE_NOT_FOUND, "nowhere.hdr",
         [](World& w) { return gpSetEnvironmentFromFile(w.scene, "nowhere.hdr", nullptr); }},
        {"gpSetEnvironmentFromFile", "not an image", GP_ERROR_FILE_INVALID, "gp_misuse_env.hdr",
         [](World& w) {
             const std::string path = w.folder + "gp_misuse_env.hdr";
             std::ofstream(path) << "#?RADIANCE\nno more\n";
             return gpSetEnvironmentFromFile(w.scene, path.c_str(), nullptr);
         }},
        {"gpSetEnvironmentFromFile", "a PNG", GP_ERROR_FILE_INVALID, "neither",
         [](World& w) {
             const std::string path = w.folder + "gp_misuse_env.png";
             float pixel[4] = {1, 1, 1, 1};
             const GpImage image = {1, 1, pixel, 0};
             if (gpSaveImage(w.device, path.c_str(), &image) != GP_SUCCESS) return GP_ERROR_UNKNOWN;
             return gpSetEnvironmentFromFile(w.scene, path.c_str(), nullptr);
         }},
        {"gpSetEnvironmentFromFile", "color is NaN", GP_ERROR_NOT_FINITE, "color[0]",
         [](World& w) {
             GpEnvironmentDesc desc{};
             desc.color[0] = nan;
             return gpSetEnvironmentFromFile(w.scene, "nowhere.hdr", &desc);
         }},
        skyRow("azimuth is NaN", GP_ERROR_NOT_FINITE, "sunAzimuth", nan, 1, 0),
        skyRow("elevation is infinite", GP_ERROR_NOT_FINITE, "sunElevation", 0, inf, 0),
        skyRow("the sun below the horizon", GP_ERROR_OUT_OF_RANGE, "sunElevation", 0, -0.1f, 0),
        skyRow("the sun beyond the zenith", GP_ERROR_OUT_OF_RANGE, "sunElevation", 0, 1.6f, 0),
        skyRow("lux below 0", GP_ERROR_OUT_OF_RANGE, "sunLux", 0, 1, -5),
        skyRow("lux is NaN", GP_ERROR_NOT_FINITE, "sunLux", 0, 1, nan),
    };
    addHandleRows<GpScene>(rows, "gpSetEnvironment", "scene",
                           [](World&, GpScene s) { return gpSetEnvironment(s, nullptr); });
    addHandleRows<GpScene>(rows, "gpSetEnvironmentFromFile", "scene", [](World&, GpScene s) {
        return gpSetEnvironmentFromFile(s, "nowhere.hdr", nullptr);
    });
    addHandleRows<GpScene>(rows, "gpSetSky", "scene",
                           [](World&, GpScene s) { return gpSetSky(s, 0, 1, 0); });
    const Rows cubemaps = cubemapRows();
    rows.insert(rows.end(), cubemaps.begin(), cubemaps.end());
    return rows;
}

}  // namespace gp::test
