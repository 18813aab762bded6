#include "api/check.h"

namespace gp::api {

namespace {

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
