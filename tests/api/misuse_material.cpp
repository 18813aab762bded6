#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

using Change = void (*)(World&, GpMaterialDesc&);

Row row(const char* what, GpError expected, const char* message, Change change) {
    return {"gpNewMaterial", what, expected, message, [change](World& w) {
                GpMaterialDesc desc{};
                change(w, desc);
                return made(gpNewMaterial(w.device, &desc));
            }};
}

// Every factor of 0..1, one below and one above its range and one that is no number.
void addFactorRows(Rows& rows) {
    struct Field {
        const char* name;
        float GpMaterialDesc::*member;
    };
    static constexpr Field fields[] = {
        {"metallic", &GpMaterialDesc::metallic},
        {"roughness", &GpMaterialDesc::roughness},
        {"alphaCutoff", &GpMaterialDesc::alphaCutoff},
        {"specular", &GpMaterialDesc::specular},
        {"coat", &GpMaterialDesc::coat},
        {"coatRoughness", &GpMaterialDesc::coatRoughness},
        {"sheenRoughness", &GpMaterialDesc::sheenRoughness},
        {"transmission", &GpMaterialDesc::transmission},
        {"anisotropy", &GpMaterialDesc::anisotropy},
        {"iridescence", &GpMaterialDesc::iridescence},
    };
    const auto add = [&](const Field& field, float value, GpError expected, const char* what) {
        rows.push_back({"gpNewMaterial", std::string(field.name) + what, expected, field.name,
                        [member = field.member, value](World& w) {
                            GpMaterialDesc desc{};
                            desc.*member = value;
                            return made(gpNewMaterial(w.device, &desc));
                        }});
    };
    for (const Field& field : fields) {
        add(field, -0.01f, GP_ERROR_OUT_OF_RANGE, " below 0");
        add(field, 1.01f, GP_ERROR_OUT_OF_RANGE, " above 1");
        add(field, nan, GP_ERROR_NOT_FINITE, " is NaN");
    }
}

void addTextureRows(Rows& rows) {
    rows.push_back(row("texture was released", GP_ERROR_INVALID_HANDLE,
                       "baseColorTexture.texture was released", [](World& w, GpMaterialDesc& d) {
                           d.baseColorTexture.texture = w.released.texture;
                       }));
    rows.push_back(row("texture of another device", GP_ERROR_INVALID_HANDLE,
                       "normalTexture.texture belongs to another device",
                       [](World& w, GpMaterialDesc& d) {
                           d.normalTexture.texture = w.foreign.texture;
                       }));
    rows.push_back(row("texture is a mesh", GP_ERROR_INVALID_HANDLE,
                       "emissionTexture.texture is a handle of another type",
                       [](World& w, GpMaterialDesc& d) {
                           d.emissionTexture.texture = reinterpret_cast<GpTexture>(w.mesh);
                       }));
    rows.push_back(row("third set of coordinates", GP_ERROR_OUT_OF_RANGE,
                       "coatTexture.texCoord is 2", [](World& w, GpMaterialDesc& d) {
                           d.coatTexture.texture = w.texture;
                           d.coatTexture.texCoord = 2;
                       }));
    rows.push_back(row("texture transform is NaN", GP_ERROR_NOT_FINITE,
                       "transmissionTexture.transform[5] is nan", [](World& w, GpMaterialDesc& d) {
                           d.transmissionTexture.texture = w.texture;
                           d.transmissionTexture.transform[5] = nan;
                       }));
    rows.push_back(row("texture transform without a texture is infinite", GP_ERROR_NOT_FINITE,
                       "anisotropyTexture.transform[0]", [](World&, GpMaterialDesc& d) {
                           d.anisotropyTexture.transform[0] = inf;
                       }));
}

// Models of the library in the place of glTF's: World::bsdf is a lambert.
void addLibraryRows(Rows& rows) {
    static GpMaterialLayer layer;  // each row fills it anew
    const auto layered = [&](const char* what, GpError expected, const char* message,
                             void (*change)(World&, GpMaterialLayer&)) {
        rows.push_back({"gpNewMaterial", what, expected, message, [change](World& w) {
                            layer = {};
                            layer.bsdf = w.bsdf;
                            change(w, layer);
                            GpMaterialDesc desc{};
                            desc.bsdf = w.bsdf, desc.layers = &layer, desc.layerCount = 1;
                            return made(gpNewMaterial(w.device, &desc));
                        }});
    };
    rows.push_back(row("bsdf was released", GP_ERROR_INVALID_HANDLE, "bsdf was released",
                       [](World& w, GpMaterialDesc& d) { d.bsdf = w.released.bsdf; }));
    rows.push_back(row("bsdf of another device", GP_ERROR_INVALID_HANDLE,
                       "bsdf belongs to another device",
                       [](World& w, GpMaterialDesc& d) { d.bsdf = w.foreign.bsdf; }));
    rows.push_back(row("metallic beside bsdf", GP_ERROR_INVALID_ARGUMENT,
                       "metallic is of glTF's material", [](World& w, GpMaterialDesc& d) {
                           d.bsdf = w.bsdf, d.metallic = 1;
                       }));
    rows.push_back(row("a roughness of 0 beside bsdf", GP_ERROR_INVALID_ARGUMENT,
                       "roughness is of glTF's material", [](World& w, GpMaterialDesc& d) {
                           d.bsdf = w.bsdf, d.given = GP_GIVEN_ROUGHNESS;
                       }));
    rows.push_back(row("layers over nothing", GP_ERROR_INVALID_ARGUMENT, "bsdf, which is NULL",
                       [](World&, GpMaterialDesc& d) { d.layerCount = 1; }));
    rows.push_back(row("no layers at all", GP_ERROR_INVALID_ARGUMENT, "layers is NULL",
                       [](World& w, GpMaterialDesc& d) { d.bsdf = w.bsdf, d.layerCount = 1; }));
    rows.push_back(row("too many layers", GP_ERROR_TOO_LARGE, "layerCount is 17",
                       [](World& w, GpMaterialDesc& d) {
                           d.bsdf = w.bsdf, d.layers = &layer, d.layerCount = 17;
                       }));
    rows.push_back(row("an unknown preset", GP_ERROR_INVALID_ARGUMENT,
                       "preset: unknown model 'golt' (did you mean gold?)",
                       [](World&, GpMaterialDesc& d) { d.preset = "golt"; }));
    rows.push_back(row("a preset and a bsdf", GP_ERROR_INVALID_ARGUMENT,
                       "preset stands in the place of bsdf", [](World& w, GpMaterialDesc& d) {
                           d.preset = "gold", d.bsdf = w.bsdf;
                       }));
    rows.push_back(row("a preset's file that is not there", GP_ERROR_FILE_NOT_FOUND,
                       "nowhere.toml", [](World&, GpMaterialDesc& d) {
                           d.preset = "nowhere.toml#gold";
                       }));
    rows.push_back(row("a texture for what the model has not got", GP_ERROR_INVALID_ARGUMENT,
                       "baseColorTexture multiplies base_color", [](World& w, GpMaterialDesc& d) {
                           d.preset = "soap_film", d.baseColorTexture.texture = w.texture;
                       }));
    layered("a layer without bsdf", GP_ERROR_INVALID_HANDLE, "layers[0].bsdf is NULL",
            [](World&, GpMaterialLayer& l) { l.bsdf = nullptr; });
    layered("a layer of another model", GP_ERROR_INVALID_ARGUMENT,
            "layers[0]: ward cannot be blended over lambert", [](World& w, GpMaterialLayer& l) {
                GpBsdfDesc ward{};
                ward.model = "ward";
                l.bsdf = gpNewBsdf(w.device, &ward);
            });
    layered("a layer's weight above 1", GP_ERROR_OUT_OF_RANGE, "layers[0].weight is 1.5",
            [](World&, GpMaterialLayer& l) { l.weight = 1.5f; });
    layered("a layer's mask was released", GP_ERROR_INVALID_HANDLE,
            "layers[0].mask.texture was released",
            [](World& w, GpMaterialLayer& l) { l.mask.texture = w.released.texture; });
    layered("a fifth channel", GP_ERROR_OUT_OF_RANGE, "layers[0].maskChannel is 4",
            [](World&, GpMaterialLayer& l) { l.maskChannel = 4; });
    rows.push_back({"gpReplaceMaterial", "material was released", GP_ERROR_INVALID_HANDLE,
                    "material was released", [](World& w) {
                        return gpReplaceMaterial(w.scene, nullptr, w.released.material, nullptr);
                    }});
    rows.push_back({"gpReplaceMaterial", "no scene", GP_ERROR_INVALID_HANDLE, "scene is NULL",
                    [](World& w) {
                        return gpReplaceMaterial(nullptr, nullptr, w.material, nullptr);
                    }});
    addHandleRows<GpMaterial>(rows, "gpReplaceMaterialModel", "material",
                              [](World& w, GpMaterial m) {
                                  return gpReplaceMaterialModel(w.scene, nullptr, m, 0, nullptr);
                              });
    rows.push_back({"gpReplaceMaterialModel", "no scene", GP_ERROR_INVALID_HANDLE, "scene is NULL",
                    [](World& w) {
                        return gpReplaceMaterialModel(nullptr, nullptr, w.material, 0, nullptr);
                    }});
    rows.push_back({"gpReplaceMaterialModel", "maps that cannot be kept", GP_ERROR_INVALID_ARGUMENT,
                    "keep has unknown bits: 0x80", [](World& w) {
                        GpReplacedMaterials replaced = {7, 7, 7};
                        const GpError error = gpReplaceMaterialModel(
                            w.scene, nullptr, w.material, GP_MAP_OTHERS, &replaced);
                        return replaced.instances == 7 ? error : GP_ERROR_UNKNOWN;
                    }});
    rows.push_back({"gpReplaceMaterialModel", "an animated material", GP_ERROR_INVALID_ARGUMENT,
                    "material is animated", [](World& w) {
                        const GpMaterial animated = gpNewAnimatedMaterial(w.device, &w.material, 1);
                        return gpReplaceMaterialModel(w.scene, nullptr, animated, 0, nullptr);
                    }});
}

}  // namespace

Rows materialRows() {
    Rows rows = {
        row("unknown given bits", GP_ERROR_INVALID_ARGUMENT, "given has unknown bits: 0x200",
            [](World&, GpMaterialDesc& d) { d.given = 1u << 9; }),
        row("baseColor above 1", GP_ERROR_OUT_OF_RANGE, "baseColor[1] is 1.5",
            [](World&, GpMaterialDesc& d) { d.baseColor[1] = 1.5f; }),
        row("baseColor alpha is NaN", GP_ERROR_NOT_FINITE, "baseColor[3]",
            [](World&, GpMaterialDesc& d) { d.baseColor[3] = nan; }),
        row("emission below 0", GP_ERROR_OUT_OF_RANGE, "emission[2] is -1",
            [](World&, GpMaterialDesc& d) { d.emission[2] = -1; }),
        row("emission is infinite", GP_ERROR_NOT_FINITE, "emission[0] is inf",
            [](World&, GpMaterialDesc& d) { d.emission[0] = inf; }),
        row("normalScale is NaN", GP_ERROR_NOT_FINITE, "normalScale",
            [](World&, GpMaterialDesc& d) { d.normalScale = nan; }),
        row("coatNormalScale is infinite", GP_ERROR_NOT_FINITE, "coatNormalScale",
            [](World&, GpMaterialDesc& d) { d.coatNormalScale = -inf; }),
        row("unknown alphaMode", GP_ERROR_INVALID_ARGUMENT, "alphaMode is 3",
            [](World&, GpMaterialDesc& d) { d.alphaMode = anyEnum<GpAlphaMode>(3); }),
        row("ior below 1", GP_ERROR_OUT_OF_RANGE, "ior is 0.9, outside of 1..10",
            [](World&, GpMaterialDesc& d) { d.ior = 0.9f; }),
        row("ior above 10", GP_ERROR_OUT_OF_RANGE, "ior",
            [](World&, GpMaterialDesc& d) { d.ior = 10.5f; }),
        row("ior is NaN", GP_ERROR_NOT_FINITE, "ior",
            [](World&, GpMaterialDesc& d) { d.ior = nan; }),
        row("specularColor above 1", GP_ERROR_OUT_OF_RANGE, "specularColor[0]",
            [](World&, GpMaterialDesc& d) { d.specularColor[0] = 2; }),
        row("sheenColor below 0", GP_ERROR_OUT_OF_RANGE, "sheenColor[1]",
            [](World&, GpMaterialDesc& d) { d.sheenColor[1] = -0.5f; }),
        row("attenuationColor is NaN", GP_ERROR_NOT_FINITE, "attenuationColor[2]",
            [](World&, GpMaterialDesc& d) { d.attenuationColor[2] = nan; }),
        row("attenuationDistance below 0", GP_ERROR_OUT_OF_RANGE, "attenuationDistance",
            [](World&, GpMaterialDesc& d) { d.attenuationDistance = -1; }),
        row("attenuationDistance is infinite", GP_ERROR_NOT_FINITE, "attenuationDistance",
            [](World&, GpMaterialDesc& d) { d.attenuationDistance = inf; }),
        row("anisotropyRotation is NaN", GP_ERROR_NOT_FINITE, "anisotropyRotation",
            [](World&, GpMaterialDesc& d) { d.anisotropyRotation = nan; }),
        row("iridescenceIor below 1", GP_ERROR_OUT_OF_RANGE, "iridescenceIor",
            [](World&, GpMaterialDesc& d) { d.iridescenceIor = 0.5f; }),
        row("iridescence thickness below 0", GP_ERROR_OUT_OF_RANGE, "iridescenceThicknessMinNm",
            [](World&, GpMaterialDesc& d) { d.iridescenceThicknessMinNm = -1; }),
        row("iridescence thickness is NaN", GP_ERROR_NOT_FINITE, "iridescenceThicknessMaxNm",
            [](World&, GpMaterialDesc& d) { d.iridescenceThicknessMaxNm = nan; }),
    };
    addFactorRows(rows);
    addTextureRows(rows);
    addLibraryRows(rows);
    addHandleRows<GpDevice>(rows, "gpNewMaterial", "device",
                            [](World&, GpDevice d) { return made(gpNewMaterial(d, nullptr)); });
    addHandleRows<GpMaterial>(rows, "gpReleaseMaterial", "material",
                              [](World&, GpMaterial m) { return gpReleaseMaterial(m); });
    return rows;
}

}  // namespace gp::test
