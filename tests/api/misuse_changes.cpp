// What applications change: animated materials, texture layers, coordinates, instances, polygons.
#include <cmath>
#include <cstdint>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

GpMaterial animated(World& w) { return gpNewAnimatedMaterial(w.device, &w.material, 1); }

void addAnimatedRows(Rows& rows) {
    const Rows more = {
        {"gpNewAnimatedMaterial", "no frames", GP_ERROR_INVALID_ARGUMENT, "count is 0",
         [](World& w) { return made(gpNewAnimatedMaterial(w.device, &w.material, 0)); }},
        {"gpNewAnimatedMaterial", "frames NULL", GP_ERROR_INVALID_ARGUMENT, "frames is NULL",
         [](World& w) { return made(gpNewAnimatedMaterial(w.device, nullptr, 2)); }},
        {"gpNewAnimatedMaterial", "too many frames", GP_ERROR_TOO_LARGE, "count is 65537",
         [](World& w) { return made(gpNewAnimatedMaterial(w.device, &w.material, 65537)); }},
        {"gpNewAnimatedMaterial", "an animated frame", GP_ERROR_INVALID_ARGUMENT,
         "frames[1] is animated itself", [](World& w) {
             const GpMaterial frames[2] = {w.material, animated(w)};
             return made(gpNewAnimatedMaterial(w.device, frames, 2));
         }},
        {"gpNewAnimatedMaterial", "a frame of another device", GP_ERROR_INVALID_HANDLE,
         "frames[1] belongs to another device", [](World& w) {
             const GpMaterial frames[2] = {w.material, w.foreign.material};
             return made(gpNewAnimatedMaterial(w.device, frames, 2));
         }},
        {"gpSetMaterialFrame", "past the end", GP_ERROR_OUT_OF_RANGE,
         "frame is 1, but the material has 1",
         [](World& w) { return gpSetMaterialFrame(animated(w), 1); }},
        {"gpSetMaterialFrame", "a material that is not animated", GP_ERROR_INVALID_OPERATION,
         "gpNewAnimatedMaterial", [](World& w) { return gpSetMaterialFrame(w.material, 0); }},
    };
    rows.insert(rows.end(), more.begin(), more.end());
    addHandleRows<GpDevice>(rows, "gpNewAnimatedMaterial", "device", [](World& w, GpDevice d) {
        return made(gpNewAnimatedMaterial(d, &w.material, 1));
    });
    addHandleRows<GpMaterial>(rows, "gpSetMaterialFrame", "material",
                              [](World&, GpMaterial m) { return gpSetMaterialFrame(m, 0); });
}

void addTextureLayer(Rows& rows, const char* what, GpError expected, const char* message,
                     uint32_t count, void (*change)(World&, GpTextureLayer&)) {
    rows.push_back({"gpNewMaterial", what, expected, message, [count, change](World& w) {
                        GpTextureLayer layers[2] = {};
                        change(w, layers[1]);
                        GpMaterialDesc desc{};
                        desc.textureLayers = layers, desc.textureLayerCount = count;
                        return made(gpNewMaterial(w.device, &desc));
                    }});
}

void addTextureLayerRows(Rows& rows) {
    addTextureLayer(rows, "a third texture layer", GP_ERROR_TOO_LARGE, "textureLayerCount is 3", 3,
                    [](World&, GpTextureLayer&) {});
    addTextureLayer(rows, "an unknown layer blend", GP_ERROR_INVALID_ARGUMENT,
                    "textureLayers[1].blend is 4", 2, [](World&, GpTextureLayer& l) {
                        l.blend = anyEnum<GpLayerBlend>(4);
                    });
    addTextureLayer(rows, "a layer colour above 1", GP_ERROR_OUT_OF_RANGE,
                    "textureLayers[1].color[2] is 2", 2,
                    [](World&, GpTextureLayer& l) { l.color[2] = 2; });
    addTextureLayer(rows, "a layer texture that was released", GP_ERROR_INVALID_HANDLE,
                    "textureLayers[1].texture.texture was released", 2,
                    [](World& w, GpTextureLayer& l) { l.texture.texture = w.released.texture; });
    addTextureLayer(rows, "a third set of layer coordinates", GP_ERROR_OUT_OF_RANGE,
                    "textureLayers[1].texture.texCoord is 2", 2,
                    [](World&, GpTextureLayer& l) { l.texture.texCoord = 2; });
    rows.push_back({"gpNewMaterial", "texture layers NULL", GP_ERROR_INVALID_ARGUMENT,
                    "textureLayers is NULL", [](World& w) {
                        GpMaterialDesc desc{};
                        desc.textureLayerCount = 1;
                        return made(gpNewMaterial(w.device, &desc));
                    }});
}

void addSlopeMap(Rows& rows, const char* what, GpError expected, const char* message,
                 void (*change)(World&, GpSlopeMap&)) {
    rows.push_back({"gpNewMaterial", what, expected, message, [change](World& w) {
                        GpSlopeMap maps[2] = {};
                        maps[0].texture.texture = maps[1].texture.texture = w.texture;
                        change(w, maps[1]);
                        GpMaterialDesc desc{};
                        desc.slopeMaps = maps, desc.slopeMapCount = 2;
                        return made(gpNewMaterial(w.device, &desc));
                    }});
}

void addSlopeMapRows(Rows& rows) {
    addSlopeMap(rows, "a slope map without a texture", GP_ERROR_INVALID_HANDLE,
                "slopeMaps[1].texture.texture is NULL",
                [](World&, GpSlopeMap& m) { m.texture.texture = nullptr; });
    addSlopeMap(rows, "a slope map that was released", GP_ERROR_INVALID_HANDLE,
                "slopeMaps[1].texture.texture was released",
                [](World& w, GpSlopeMap& m) { m.texture.texture = w.released.texture; });
    addSlopeMap(rows, "a third set of slope coordinates", GP_ERROR_OUT_OF_RANGE,
                "slopeMaps[1].texture.texCoord is 2",
                [](World&, GpSlopeMap& m) { m.texture.texCoord = 2; });
    addSlopeMap(rows, "an unknown kind of slope map", GP_ERROR_INVALID_ARGUMENT,
                "slopeMaps[1].kind is 3",
                [](World&, GpSlopeMap& m) { m.kind = anyEnum<GpSlopeMapKind>(3); });
    addSlopeMap(rows, "a slope map's scale that is NaN", GP_ERROR_NOT_FINITE,
                "slopeMaps[1].scale is nan", [](World&, GpSlopeMap& m) { m.scale = nan; });
    addSlopeMap(rows, "a slope map's extent that is NaN", GP_ERROR_NOT_FINITE,
                "slopeMaps[1].extent[1] is nan", [](World&, GpSlopeMap& m) { m.extent[1] = nan; });
    addSlopeMap(rows, "an extent of heights", GP_ERROR_INVALID_ARGUMENT,
                "slopeMaps[1].extent counts for displacement maps only", [](World&, GpSlopeMap& m) {
                    m.kind = GP_SLOPE_MAP_HEIGHT, m.extent[0] = m.extent[1] = 1;
                });
    addSlopeMap(rows, "an extent of nothing", GP_ERROR_OUT_OF_RANGE,
                "slopeMaps[1].extent is (1, 0), but must be above 0", [](World&, GpSlopeMap& m) {
                    m.kind = GP_SLOPE_MAP_DISPLACEMENT, m.extent[0] = 1;
                });
    addSlopeMap(rows, "mirrored heights", GP_ERROR_UNSUPPORTED,
                "slopeMaps[1].texture is repeated in mirror images", [](World& w, GpSlopeMap& m) {
                    const uint8_t pixel[4] = {};
                    GpTextureDesc d{};
                    d.width = d.height = 1, d.pixels = pixel, d.wrapV = GP_WRAP_MIRROR;
                    m.texture.texture = gpNewTexture(w.device, &d);
                    m.kind = GP_SLOPE_MAP_HEIGHT;
                });
    rows.push_back({"gpNewMaterial", "slope maps NULL", GP_ERROR_INVALID_ARGUMENT,
                    "slopeMaps is NULL", [](World& w) {
                        GpMaterialDesc desc{};
                        desc.slopeMapCount = 1;
                        return made(gpNewMaterial(w.device, &desc));
                    }});
    rows.push_back({"gpNewMaterial", "a fifth slope map", GP_ERROR_TOO_LARGE, "slopeMapCount is 5",
                    [](World& w) {
                        GpMaterialDesc desc{};
                        desc.slopeMapCount = 5;
                        return made(gpNewMaterial(w.device, &desc));
                    }});
}

void addTexCoordRows(Rows& rows) {
    const Rows more = {
        {"gpUpdateTexCoords", "a third set", GP_ERROR_OUT_OF_RANGE, "set is 2",
         [](World& w) { return gpUpdateTexCoords(w.mesh, 2, trianglePositions, 0); }},
        {"gpUpdateTexCoords", "a coordinate that is NaN", GP_ERROR_NOT_FINITE, "uv[2][1] is nan",
         [](World& w) {
             const float uv[6] = {0, 0, 1, 0, 1, nan};
             return gpUpdateTexCoords(w.staticMesh, 0, uv, 0);
         }},
        {"gpUpdateTexCoords", "a stride below an element", GP_ERROR_OUT_OF_RANGE, "stride is 4",
         [](World& w) { return gpUpdateTexCoords(w.mesh, 0, trianglePositions, 4); }},
        {"gpUpdateTexCoords", "a stride that overflows", GP_ERROR_TOO_LARGE, "stride",
         [](World& w) { return gpUpdateTexCoords(w.mesh, 1, trianglePositions, SIZE_MAX / 2); }},
    };
    rows.insert(rows.end(), more.begin(), more.end());
    addHandleRows<GpMesh>(rows, "gpUpdateTexCoords", "mesh", [](World&, GpMesh m) {
        return gpUpdateTexCoords(m, 0, trianglePositions, 0);
    });
}

void addInstanceRows(Rows& rows) {
    const Rows more = {
        {"gpNewInstance", "an unknown visibility by name", GP_ERROR_INVALID_ARGUMENT,
         "visibility is 4", [](World& w) {
             GpInstanceDesc desc{};
             desc.mesh = w.mesh;
             desc.visibility = anyEnum<GpVisibility>(4);
             return made(gpNewInstance(w.scene, &desc));
         }},
        {"gpNewInstance", "a colour above 1", GP_ERROR_OUT_OF_RANGE, "color[3] is 1.5",
         [](World& w) {
             GpInstanceDesc desc{};
             desc.mesh = w.mesh;
             desc.color[3] = 1.5f;
             return made(gpNewInstance(w.scene, &desc));
         }},
        {"gpSetInstanceColor", "a colour that is NaN", GP_ERROR_NOT_FINITE, "color[1] is nan",
         [](World& w) {
             const float color[4] = {1, nan, 1, 1};
             return gpSetInstanceColor(w.instance, color);
         }},
        {"gpSetInstanceVisibility", "an unknown name", GP_ERROR_INVALID_ARGUMENT,
         "visibility is 4294967295", [](World& w) {
             return gpSetInstanceVisibility(w.instance, anyEnum<GpVisibility>(-1), 0);
         }},
        {"gpSetInstanceVisibility", "unknown bits", GP_ERROR_INVALID_ARGUMENT, "0x10",
         [](World& w) {
             return gpSetInstanceVisibility(w.instance, GP_VISIBILITY_WORLD, 16);
         }},
        {"gpSetInstanceMaterial", "a material that was released", GP_ERROR_INVALID_HANDLE,
         "material was released",
         [](World& w) { return gpSetInstanceMaterial(w.instance, w.released.material); }},
        {"gpSetInstanceMaterial", "a material of another device", GP_ERROR_INVALID_HANDLE,
         "material belongs to another device",
         [](World& w) { return gpSetInstanceMaterial(w.instance, w.foreign.material); }},
    };
    rows.insert(rows.end(), more.begin(), more.end());
    addHandleRows<GpInstance>(
        rows, "gpSetInstanceMaterial", "instance",
        [](World& w, GpInstance i) { return gpSetInstanceMaterial(i, w.material); });
    addHandleRows<GpInstance>(rows, "gpSetInstanceColor", "instance",
                              [](World&, GpInstance i) { return gpSetInstanceColor(i, nullptr); });
    addHandleRows<GpInstance>(
        rows, "gpSetInstanceVisibility", "instance", [](World&, GpInstance i) {
            return gpSetInstanceVisibility(i, GP_VISIBILITY_WORLD, 0);
        });
}

// The same mistake in a new light and in an old one.
void addPolygon(Rows& rows, const char* what, GpError expected, const char* message,
                std::vector<float> corners, uint32_t count) {
    const auto descOf = [](const std::vector<float>& points, uint32_t n) {
        GpLightDesc desc{};
        desc.kind = GP_LIGHT_POLYGON;
        desc.intensity = 1;
        desc.corners = points.empty() ? nullptr : points.data(), desc.cornerCount = n;
        return desc;
    };
    rows.push_back({"gpNewLight", what, expected, message, [=](World& w) {
                        const GpLightDesc desc = descOf(corners, count);
                        return made(gpNewLight(w.scene, &desc));
                    }});
    rows.push_back({"gpSetLight", what, expected, message, [=](World& w) {
                        const GpLightDesc desc = descOf(corners, count);
                        return gpSetLight(w.light, &desc);
                    }});
}

void addPolygonRows(Rows& rows) {
    addPolygon(rows, "two corners", GP_ERROR_INVALID_ARGUMENT, "cornerCount is 2",
               {0, 0, 0, 1, 0, 0}, 2);
    addPolygon(rows, "too many corners", GP_ERROR_TOO_LARGE, "cornerCount is 1025", {0, 0, 0},
               1025);
    addPolygon(rows, "no corners", GP_ERROR_INVALID_ARGUMENT, "corners is NULL", {}, 3);
    addPolygon(rows, "a corner that is NaN", GP_ERROR_NOT_FINITE, "corners[7] is nan",
               {0, 0, 0, 1, 0, 0, 0, nan, 0}, 3);
    addPolygon(rows, "corners on a line", GP_ERROR_OUT_OF_RANGE, "span no area",
               {0, 0, 0, 1, 1, 1, 3, 3, 3}, 3);
    addPolygon(rows, "corners in no plane", GP_ERROR_OUT_OF_RANGE, "outside of the plane",
               {0, 0, 0, 1, 0, 0, 1, 1, 0.1f, 0, 1, 0}, 4);
    addPolygon(rows, "a concave polygon", GP_ERROR_OUT_OF_RANGE, "corners[2] makes the polygon",
               {0, 0, 0, 2, 0, 0, 0.5f, 0.5f, 0, 0, 2, 0}, 4);
    std::vector<float> star;  // a pentagram turns to the left at each of its five corners
    for (const float angle : {0.0f, 2.5132741f, 5.0265482f, 7.5398224f, 10.0530965f})
        star.insert(star.end(), {std::cos(angle), std::sin(angle), 0});
    addPolygon(rows, "a star", GP_ERROR_OUT_OF_RANGE, "cross each other", star, 5);
}

}  // namespace

Rows changeRows() {
    Rows rows;
    addAnimatedRows(rows);
    addTextureLayerRows(rows);
    addSlopeMapRows(rows);
    addTexCoordRows(rows);
    addInstanceRows(rows);
    addPolygonRows(rows);
    return rows;
}

}  // namespace gp::test
