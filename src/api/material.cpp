#include "api/check.h"
#include "api/pixels.h"
#include "io/bsdf_source.h"

namespace gp::api {

namespace {

constexpr uint32_t layerLimit = 16;
constexpr uint32_t textureLayerLimit = 2;
constexpr uint32_t slopeMapLimit = 4;

static_assert(GP_SLOPE_MAP_NORMAL == int(SlopeMapKind::normal) &&
              GP_SLOPE_MAP_HEIGHT == int(SlopeMapKind::height) &&
              GP_SLOPE_MAP_DISPLACEMENT == int(SlopeMapKind::displacement));

static_assert(GP_LAYER_ALPHA == int(LayerBlend::alpha) && GP_LAYER_ADD == int(LayerBlend::add) &&
              GP_LAYER_SHADE == int(LayerBlend::shade));
static_assert(GP_ALPHA_MASK == int(AlphaMode::mask) && GP_ALPHA_BLEND == int(AlphaMode::blend));

// Reads one descriptor; the defaults of fields that are not given stand in gp::Material.
class MaterialReader {
public:
    MaterialReader(DeviceObject& device, const GpMaterialDesc& desc)
        : device_(device), desc_(desc) {}

    Material read() {
        if (desc_.given & ~uint32_t(GP_GIVEN_ALL_MATERIAL))
            fail(GP_ERROR_INVALID_ARGUMENT, "given has unknown bits: {:#x}", desc_.given);
        material_.name = nameOr(desc_.name);
        readBase();
        readSpecular();
        readCoatAndSheen();
        readTransmission();
        readDirectional();
        readLayers();
        readTextureLayers();
        readSlopeMaps();
        readCompanions();
        return std::move(material_);
    }

private:
    bool given(uint32_t bit) const { return bit != 0 && (desc_.given & bit) != 0; }

    // A factor in 0..1. Zero means the default unless its bit is set; without a bit the default
    // is zero itself.
    void factor(float& target, float value, const char* field, uint32_t bit = 0) {
        checkRange(value, 0, 1, field);
        if (value != 0 || given(bit)) target = value;
    }

    void color(glm::vec3& target, const float* value, const char* field, uint32_t bit = 0) {
        checkRange(value, 3, 0, 1, field);
        if (!allZero(value, 3) || given(bit)) target = vec3From(value);
    }

    void scale(float& target, float value, const char* field, uint32_t bit) {
        checkFinite(value, field);
        if (value != 0 || given(bit)) target = value;
    }

    void indexOfRefraction(float& target, float value, const char* field) {
        checkFinite(value, field);
        if (value == 0) return;
        checkRange(value, 1, 10, field);
        target = value;
    }

    void texture(TextureUse& target, const GpTextureUse& use, const char* field) {
        if (use.texCoord > 1)
            fail(GP_ERROR_OUT_OF_RANGE, "{}.texCoord is {}, but only 0 and 1 exist", field,
                 use.texCoord);
        checkFinite(use.transform, 6, fmt::format("{}.transform", field));
        if (!use.texture) return;
        target.texture = resolve(device_, use.texture, fmt::format("{}.texture", field))->texture;
        target.texCoord = use.texCoord;
        if (allZero(use.transform, 6)) return;
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 3; ++column)
                target.uvTransform[column][row] = use.transform[row * 3 + column];
    }

    void readBase() {
        const GpMaterialDesc& d = desc_;
        checkRange(d.baseColor, 4, 0, 1, "baseColor");
        if (!allZero(d.baseColor, 4) || given(GP_GIVEN_BASE_COLOR))
            material_.baseColor = {vec3From(d.baseColor), d.baseColor[3]};
        texture(material_.baseColorTexture, d.baseColorTexture, "baseColorTexture");
        factor(material_.metallic, d.metallic, "metallic");
        factor(material_.roughness, d.roughness, "roughness", GP_GIVEN_ROUGHNESS);
        texture(material_.metallicRoughnessTexture, d.metallicRoughnessTexture,
                "metallicRoughnessTexture");
        texture(material_.normalTexture, d.normalTexture, "normalTexture");
        scale(material_.normalScale, d.normalScale, "normalScale", GP_GIVEN_NORMAL_SCALE);
        checkNotNegative(d.emission, 3, "emission");
        material_.emission = vec3From(d.emission);
        texture(material_.emissionTexture, d.emissionTexture, "emissionTexture");
        material_.alphaMode = AlphaMode(checkEnum(d.alphaMode, 3, "alphaMode"));
        factor(material_.alphaCutoff, d.alphaCutoff, "alphaCutoff", GP_GIVEN_ALPHA_CUTOFF);
        material_.doubleSided = d.doubleSided != 0;
        material_.unlit = d.unlit != 0;
    }

    void readSpecular() {
        const GpMaterialDesc& d = desc_;
        indexOfRefraction(material_.ior, d.ior, "ior");
        factor(material_.specular, d.specular, "specular", GP_GIVEN_SPECULAR);
        texture(material_.specularTexture, d.specularTexture, "specularTexture");
        color(material_.specularColor, d.specularColor, "specularColor", GP_GIVEN_SPECULAR_COLOR);
        texture(material_.specularColorTexture, d.specularColorTexture, "specularColorTexture");
    }

    void readCoatAndSheen() {
        const GpMaterialDesc& d = desc_;
        factor(material_.coat, d.coat, "coat");
        texture(material_.coatTexture, d.coatTexture, "coatTexture");
        factor(material_.coatRoughness, d.coatRoughness, "coatRoughness");
        texture(material_.coatRoughnessTexture, d.coatRoughnessTexture, "coatRoughnessTexture");
        texture(material_.coatNormalTexture, d.coatNormalTexture, "coatNormalTexture");
        scale(material_.coatNormalScale, d.coatNormalScale, "coatNormalScale",
              GP_GIVEN_COAT_NORMAL_SCALE);
        color(material_.sheenColor, d.sheenColor, "sheenColor");
        texture(material_.sheenColorTexture, d.sheenColorTexture, "sheenColorTexture");
        factor(material_.sheenRoughness, d.sheenRoughness, "sheenRoughness");
        texture(material_.sheenRoughnessTexture, d.sheenRoughnessTexture, "sheenRoughnessTexture");
    }

    void readTransmission() {
        const GpMaterialDesc& d = desc_;
        factor(material_.transmission, d.transmission, "transmission");
        texture(material_.transmissionTexture, d.transmissionTexture, "transmissionTexture");
        material_.thinWalled = d.solid == 0;
        color(material_.attenuationColor, d.attenuationColor, "attenuationColor",
              GP_GIVEN_ATTENUATION_COLOR);
        checkNotNegative(d.attenuationDistance, "attenuationDistance");
        if (d.attenuationDistance != 0) material_.attenuationDistance = d.attenuationDistance;
    }

    void readDirectional() {
        const GpMaterialDesc& d = desc_;
        factor(material_.anisotropy, d.anisotropy, "anisotropy");
        checkFinite(d.anisotropyRotation, "anisotropyRotation");
        material_.anisotropyRotation = d.anisotropyRotation;
        texture(material_.anisotropyTexture, d.anisotropyTexture, "anisotropyTexture");
        factor(material_.iridescence, d.iridescence, "iridescence");
        texture(material_.iridescenceTexture, d.iridescenceTexture, "iridescenceTexture");
        indexOfRefraction(material_.iridescenceIor, d.iridescenceIor, "iridescenceIor");
        thickness(material_.iridescenceThicknessMinNm, d.iridescenceThicknessMinNm,
                  "iridescenceThicknessMinNm");
        thickness(material_.iridescenceThicknessMaxNm, d.iridescenceThicknessMaxNm,
                  "iridescenceThicknessMaxNm");
        texture(material_.iridescenceThicknessTexture, d.iridescenceThicknessTexture,
                "iridescenceThicknessTexture");
    }

    void thickness(float& target, float value, const char* field) {
        checkNotNegative(value, field);
        if (value != 0 || given(GP_GIVEN_IRIDESCENCE_THICKNESS)) target = value;
    }

    void readTextureLayers() {
        const GpMaterialDesc& d = desc_;
        if (d.textureLayerCount > textureLayerLimit)
            fail(GP_ERROR_TOO_LARGE, "textureLayerCount is {}, more than {}", d.textureLayerCount,
                 textureLayerLimit);
        if (d.textureLayerCount > 0) checkPointer(d.textureLayers, "textureLayers");
        for (uint32_t i = 0; i < d.textureLayerCount; ++i) {
            const GpTextureLayer& source = d.textureLayers[i];
            const std::string field = fmt::format("textureLayers[{}]", i);
            TextureLayer layer;
            texture(layer.texture, source.texture, (field + ".texture").c_str());
            checkRange(source.color, 4, 0, 1, field + ".color");
            if (!allZero(source.color, 4)) layer.color = {vec3From(source.color), source.color[3]};
            layer.blend = LayerBlend(checkEnum(source.blend, 4, (field + ".blend").c_str()));
            material_.textureLayers.push_back(std::move(layer));
        }
    }

    void readSlopeMaps() {
        const GpMaterialDesc& d = desc_;
        if (d.slopeMapCount > slopeMapLimit)
            fail(GP_ERROR_TOO_LARGE, "slopeMapCount is {}, more than {}", d.slopeMapCount,
                 slopeMapLimit);
        if (d.slopeMapCount > 0) checkPointer(d.slopeMaps, "slopeMaps");
        for (uint32_t i = 0; i < d.slopeMapCount; ++i)
            material_.slopeMaps.push_back(
                slopeMap(d.slopeMaps[i], fmt::format("slopeMaps[{}]", i)));
    }

    SlopeMapUse slopeMap(const GpSlopeMap& source, const std::string& field) {
        SlopeMapUse map;
        resolve(device_, source.texture.texture, field + ".texture.texture");
        texture(map.texture, source.texture, (field + ".texture").c_str());
        map.kind = SlopeMapKind(checkEnum(source.kind, 3, (field + ".kind").c_str()));
        checkFinite(source.scale, (field + ".scale").c_str());
        if (source.scale != 0) map.scale = source.scale;
        checkFinite(source.extent, 2, field + ".extent");
        if (!allZero(source.extent, 2)) {
            if (map.kind != SlopeMapKind::displacement)
                fail(GP_ERROR_INVALID_ARGUMENT,
                     "{}.extent counts for displacement maps only: it must be zero", field);
            if (!(source.extent[0] > 0 && source.extent[1] > 0))
                fail(GP_ERROR_OUT_OF_RANGE, "{}.extent is ({:g}, {:g}), but must be above 0", field,
                     source.extent[0], source.extent[1]);
            map.extent = {source.extent[0], source.extent[1]};
        }
        if (const char* why = whyNotSlopes(map); why)
            fail(GP_ERROR_UNSUPPORTED, "{}.texture {}", field, why);
        return map;
    }

    // A map of gpSetTextureOverrides, where the descriptor has none of its own.
    bool companion(TextureUse& target, const std::shared_ptr<const Texture>& map) const {
        if (!map || target.texture) return false;
        target = material_.baseColorTexture;
        target.texture = map;
        return true;
    }

    void readCompanions() {
        if (!desc_.baseColorTexture.texture) return;
        const auto base = resolve(device_, desc_.baseColorTexture.texture, "baseColorTexture");
        companion(material_.normalTexture, base->normal);
        if (companion(material_.emissionTexture, base->emission) &&
            material_.emission == glm::vec3(0))
            material_.emission = glm::vec3(1);
        if (!material_.layers.empty()) return;  // models of the library have their own roughness
        if (companion(material_.metallicRoughnessTexture, base->metallicRoughness) &&
            material_.metallic == 0)
            material_.metallic = 1;
    }

    // ------------------------------------------------------------ models of the library

    void readLayers() {
        const GpMaterialDesc& d = desc_;
        if (d.preset) return readPreset();
        if (!d.bsdf) {
            if (d.layerCount > 0)
                fail(GP_ERROR_INVALID_ARGUMENT, "layers lie over bsdf, which is NULL");
            return;
        }
        refuseGltfFields();
        MaterialLayer bottom;
        bottom.bsdf = resolve(device_, d.bsdf, "bsdf")->settings;
        material_.layers.push_back(std::move(bottom));
        checkBaseColor();
        if (d.layerCount > layerLimit)
            fail(GP_ERROR_TOO_LARGE, "layerCount is {}, more than {}", d.layerCount, layerLimit);
        if (d.layerCount > 0) checkPointer(d.layers, "layers");
        for (uint32_t i = 0; i < d.layerCount; ++i) readLayer(d.layers[i], i);
    }

    void readPreset() {
        if (desc_.bsdf || desc_.layerCount > 0)
            fail(GP_ERROR_INVALID_ARGUMENT, "preset stands in the place of bsdf and layers");
        refuseGltfFields();
        try {
            for (io::PresetLayer& source : io::stackFromName(desc_.preset).layers) {
                MaterialLayer layer;
                layer.bsdf = std::make_shared<const BsdfSettings>(std::move(source.bsdf));
                layer.weight = source.weight;
                layer.channel = source.channel;
                if (!source.maskPath.empty()) layer.mask.texture = maskFrom(source.maskPath);
                material_.layers.push_back(std::move(layer));
            }
        } catch (const BsdfError& error) {
            fail(GP_ERROR_INVALID_ARGUMENT, "preset: {}", error.what());
        }
        checkBaseColor();
    }

    static std::shared_ptr<const Texture> maskFrom(const std::string& path) {
        TextureDesc mask;
        mask.name = path;
        mask.colorSpace = ColorSpace::linear;
        mask.image = readImageFile(path).image;
        return makeTexture(std::move(mask));
    }

    void checkBaseColor() const {
        const BsdfModelInfo& model = *material_.layers[0].bsdf->model;
        if (material_.baseColorTexture.texture && !model.hasBaseColor())
            fail(GP_ERROR_INVALID_ARGUMENT,
                 "baseColorTexture multiplies base_color, which the model {} has not got",
                 model.name);
    }

    void readLayer(const GpMaterialLayer& source, uint32_t index) {
        const std::string field = fmt::format("layers[{}]", index);
        MaterialLayer layer;
        layer.bsdf = resolve(device_, source.bsdf, field + ".bsdf")->settings;
        if (const std::string why = whyNotBlended(*material_.layers[0].bsdf, *layer.bsdf);
            !why.empty())
            fail(GP_ERROR_INVALID_ARGUMENT, "{}: {}", field, why);
        checkRange(source.weight, 0, 1, (field + ".weight").c_str());
        if (source.weight != 0) layer.weight = source.weight;
        texture(layer.mask, source.mask, (field + ".mask").c_str());
        if (source.maskChannel > 3)
            fail(GP_ERROR_OUT_OF_RANGE, "{}.maskChannel is {}, but a texture has four: 0 to 3",
                 field, source.maskChannel);
        layer.channel = source.maskChannel;
        material_.layers.push_back(std::move(layer));
    }

    // What has no effect beside a model of the library is no option then.
    void refuseGltfFields() const {
        const GpMaterialDesc& d = desc_;
        const std::pair<const char*, bool> fields[] = {
            {"metallic", d.metallic != 0},
            {"roughness", d.roughness != 0 || given(GP_GIVEN_ROUGHNESS)},
            {"metallicRoughnessTexture", d.metallicRoughnessTexture.texture},
            {"ior", d.ior != 0},
            {"specular", d.specular != 0 || given(GP_GIVEN_SPECULAR)},
            {"specularTexture", d.specularTexture.texture},
            {"specularColor", !allZero(d.specularColor, 3) || given(GP_GIVEN_SPECULAR_COLOR)},
            {"specularColorTexture", d.specularColorTexture.texture},
            {"coat", d.coat != 0},
            {"coatTexture", d.coatTexture.texture},
            {"coatRoughness", d.coatRoughness != 0},
            {"coatRoughnessTexture", d.coatRoughnessTexture.texture},
            {"coatNormalTexture", d.coatNormalTexture.texture},
            {"sheenColor", !allZero(d.sheenColor, 3)},
            {"sheenColorTexture", d.sheenColorTexture.texture},
            {"sheenRoughness", d.sheenRoughness != 0},
            {"sheenRoughnessTexture", d.sheenRoughnessTexture.texture},
            {"transmission", d.transmission != 0},
            {"transmissionTexture", d.transmissionTexture.texture},
            {"solid", d.solid != 0},
            {"anisotropy", d.anisotropy != 0},
            {"anisotropyTexture", d.anisotropyTexture.texture},
            {"iridescence", d.iridescence != 0},
            {"iridescenceTexture", d.iridescenceTexture.texture},
            {"iridescenceIor", d.iridescenceIor != 0},
            {"iridescenceThicknessMinNm", d.iridescenceThicknessMinNm != 0},
            {"iridescenceThicknessMaxNm", d.iridescenceThicknessMaxNm != 0},
            {"iridescenceThicknessTexture", d.iridescenceThicknessTexture.texture},
        };
        for (const auto& [name, isSet] : fields)
            if (isSet)
                fail(GP_ERROR_INVALID_ARGUMENT,
                     "{} is of glTF's material and has no effect beside bsdf: it must be zero",
                     name);
    }

    DeviceObject& device_;
    const GpMaterialDesc& desc_;
    Material material_;
};

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpMaterial gpNewMaterial(GpDevice device, const GpMaterialDesc* desc) {
    return enter("gpNewMaterial", "device", device, [&](DeviceObject& d) {
        auto object = std::make_shared<MaterialObject>(d);
        object->material = d.defaultMaterial;
        if (desc)
            object->material =
                std::make_shared<const gp::Material>(MaterialReader(d, *desc).read());
        return publish<GpMaterial>(object);
    });
}

GpError gpReleaseMaterial(GpMaterial material) {
    return enter("gpReleaseMaterial", "material", material,
                 [&](MaterialObject&) { handles().remove(bitsOf(material)); });
}

}  // extern "C"
