// Materials, textures, lights and cameras of glTF files.
#include "shading/shading.h"

#include "io/load_helpers.h"
#include "scene/bsdf_registry.h"

using namespace gp;
using namespace gp::test;

namespace {

// A triangle with the given material.
GltfBuilder withMaterial(const nlohmann::json& material) {
    GltfBuilder b;
    nlohmann::json& p = b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    p["attributes"]["TEXCOORD_0"] = b.vec2s({{0, 0}, {1, 0}, {0, 1}});
    p["material"] = 0;
    b.json["materials"] = nlohmann::json::array({material});
    const std::string png = "data:image/png;base64," + base64(samplePng(PngKind::rgba));
    b.json["images"] = {{{"uri", png}}, {{"uri", png}}};
    b.json["textures"] = {{{"source", 0}}, {{"source", 1}, {"sampler", 0}}};
    b.json["samplers"] = {
        {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9729}}};
    return b;
}

Material loaded(const nlohmann::json& material) {
    return load(withMaterial(material)).instances.at(0)->surface();
}

nlohmann::json extension(const char* name, const nlohmann::json& content) {
    nlohmann::json m;
    m["extensions"][name] = content;
    return m;
}

nlohmann::json withGlints(const nlohmann::json& glints) {
    return {{"pbrMetallicRoughness", {{"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}},
            {"extras", {{"glitterpath", {{"glints", glints}}}}}};
}

double settingOf(const Material& m, const char* name) {
    const BsdfSettings& s = *m.layers.at(0).bsdf;
    const BsdfParameterInfo& p = findBsdfParameter(*s.model, name);
    return double(s.values[size_t(&p - s.model->parameters.data())].x);
}

}  // namespace

TEST(GltfMaterial, DefaultsAreThoseOfGltf) {
    GltfBuilder b;
    b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    for (const Material& m : {load(b).instances[0]->surface(), loaded(nlohmann::json::object())}) {
        EXPECT_EQ(m.metallic, 1);
        EXPECT_EQ(m.roughness, 1);
        EXPECT_EQ(m.baseColor, glm::vec4(1));
        EXPECT_EQ(m.alphaMode, AlphaMode::opaque);
        EXPECT_FALSE(m.doubleSided);
    }
}

TEST(GltfMaterial, Glints) {
    const Material m =
        loaded(withGlints({{"density", 2e7}, {"area", 0.5}, {"method", "counting"}}));
    ASSERT_EQ(m.layers.size(), 1u);
    EXPECT_EQ(m.layers[0].bsdf->model->name, "glint");
    EXPECT_FLOAT_EQ(float(settingOf(m, "density")), 2e7f);
    EXPECT_EQ(settingOf(m, "area"), 0.5);
    EXPECT_EQ(settingOf(m, "method"), 2);
    EXPECT_EQ(settingOf(m, "jitter"), 0);
    EXPECT_EQ(settingOf(m, "metallic"), 0.25);
    EXPECT_EQ(settingOf(m, "alpha_x"), 0.25);
    EXPECT_EQ(settingOf(m, "alpha_y"), 0.25);
    // Extras of other programs, of any kind, say nothing.
    for (const nlohmann::json& other : {nlohmann::json("text"), nlohmann::json(7),
                                        nlohmann::json{{"glints", 1}},
                                        nlohmann::json{{"glitterpath", {{"other", 1}}}}})
        EXPECT_TRUE(loaded({{"extras", other}}).layers.empty());
}

// Coat, sheen and film with the material's own factors, and as they are without any.
TEST(GltfMaterial, GlintsUnderLayers) {
    nlohmann::json file = withGlints({{"density", 1e6}});
    const Material plain = loaded(file);
    EXPECT_EQ(settingOf(plain, "coat"), 0);
    EXPECT_EQ(settingOf(plain, "sheen_color"), 0);
    EXPECT_EQ(settingOf(plain, "iridescence"), 0);
    file["extensions"] = {
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.5}}},
        {"KHR_materials_sheen",
         {{"sheenColorFactor", {0.5, 0.25, 0.125}}, {"sheenRoughnessFactor", 0.75}}},
        {"KHR_materials_iridescence",
         {{"iridescenceFactor", 0.875}, {"iridescenceIor", 1.75},
          {"iridescenceThicknessMaximum", 650}}}};
    const Scene scene = load(withMaterial(file));
    EXPECT_TRUE(scene.warnings.empty());
    const Material& m = scene.instances.at(0)->surface();
    EXPECT_EQ(settingOf(m, "coat"), 0.75);
    EXPECT_EQ(settingOf(m, "coat_alpha"), 0.25);
    EXPECT_EQ(settingOf(m, "sheen_color"), 0.5);
    EXPECT_EQ(settingOf(m, "sheen_alpha"), 0.5625);
    EXPECT_EQ(settingOf(m, "iridescence"), 0.875);
    EXPECT_EQ(settingOf(m, "iridescence_ior"), 1.75);
    EXPECT_EQ(settingOf(m, "iridescence_thickness_nm"), 650);
}

// Textures of the factors that glints take stay with the material; what is left out is said.
TEST(GltfMaterial, GlintsWithTexturesAndWithoutSpecular) {
    nlohmann::json textured = withGlints({{"density", 1e6}});
    textured["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 0;
    const Scene quiet = load(withMaterial(textured));
    EXPECT_TRUE(quiet.instances.at(0)->surface().metallicRoughnessTexture.texture);
    EXPECT_TRUE(quiet.warnings.empty());
    textured["extensions"]["KHR_materials_clearcoat"] = {
        {"clearcoatFactor", 1}, {"clearcoatTexture", {{"index", 0}}}};
    const Scene coated = load(withMaterial(textured));
    EXPECT_TRUE(coated.instances.at(0)->surface().coatTexture.texture);
    EXPECT_TRUE(coated.warnings.empty());
    textured["extensions"]["KHR_materials_specular"]["specularFactor"] = 0.5;
    const Scene dull = load(withMaterial(textured));
    ASSERT_EQ(dull.warnings.size(), 1u);
    EXPECT_NE(dull.warnings[0].find("the material's specular is left out"), std::string::npos);
}

TEST(GltfMaterial, GlintsThatAreWrong) {
    const auto error = [](const nlohmann::json& glints) {
        return errorOf(withMaterial(withGlints(glints)).gltf());
    };
    const std::string at = "materials[0].extras.glitterpath.glints";
    EXPECT_EQ(error({{"area", 1}}), at + ": 'density' is missing");
    EXPECT_EQ(error({{"density", -3}}), at + ".density: is -3, but must be 0.001 to 1e+20");
    EXPECT_EQ(error({{"density", 1e6}, {"area", 1.5}}), at + ".area: is 1.5, but must be 0 to 1");
    EXPECT_EQ(error({{"density", 1e6}, {"method", "magic"}}),
              at + ".method: must be one of smooth, dictionary, counting, zirr");
    EXPECT_EQ(error({{"density", 1e6}, {"denisty", 1}}),
              at + ": 'denisty' is none of density, area, jitter, seed, method, masking, "
                   "correlation");
    EXPECT_EQ(error(3), at + ": must be an object");
    EXPECT_NE(error({{"density", "many"}}).find(at + ".density: "), std::string::npos);
}

static nlohmann::json withSlopeMaps(const nlohmann::json& maps) {
    return {{"extras", {{"glitterpath", {{"slopeMaps", maps}}}}}};
}

TEST(GltfMaterial, SlopeMaps) {
    const nlohmann::json first = {{"index", 0}};
    nlohmann::json repeated = {{"index", 1}};
    repeated["extensions"]["KHR_texture_transform"]["scale"] = {8, 4};
    const Material m = loaded(withSlopeMaps(nlohmann::json::array(
        {{{"kind", "height"}, {"texture", first}, {"scale", -0.02}},
         {{"kind", "displacement"}, {"texture", first}, {"extent", {2, 3}}},
         {{"kind", "normal"}, {"texture", repeated}}})));
    ASSERT_EQ(m.slopeMaps.size(), 3u);
    EXPECT_EQ(m.slopeMaps[0].kind, SlopeMapKind::height);
    EXPECT_EQ(m.slopeMaps[0].scale, -0.02f);
    EXPECT_EQ(m.slopeMaps[0].texture.texture->colorSpace, ColorSpace::linear);
    EXPECT_EQ(m.slopeMaps[0].texture.texture->levels[0].width, 5u);
    EXPECT_EQ(m.slopeMaps[1].kind, SlopeMapKind::displacement);
    EXPECT_EQ(m.slopeMaps[1].extent, glm::vec2(2, 3));
    EXPECT_EQ(m.slopeMaps[2].kind, SlopeMapKind::normal);
    EXPECT_EQ(m.slopeMaps[2].texture.uvTransform[0][0], 8);
    EXPECT_EQ(m.slopeMaps[2].texture.uvTransform[1][1], 4);
}

TEST(GltfMaterial, SlopeMapsThatAreWrong) {
    const auto errorOfAll = [](const nlohmann::json& maps) {
        return errorOf(withMaterial(withSlopeMaps(maps)).gltf());
    };
    const auto error = [&](const nlohmann::json& map) {
        return errorOfAll(nlohmann::json::array({map}));
    };
    const std::string all = "materials[0].extras.glitterpath.slopeMaps", at = all + "[0]";
    const nlohmann::json good = {{"kind", "height"}, {"texture", {{"index", 0}}}};
    const auto changed = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json map = good;
        map[key] = value;
        return error(map);
    };
    EXPECT_EQ(changed("kind", "bump"), at + ".kind: must be one of normal, height, displacement");
    EXPECT_EQ(error({{"texture", {{"index", 0}}}}), at + ": 'kind' is missing");
    EXPECT_EQ(error({{"kind", "height"}}), at + ": 'texture' is missing");
    EXPECT_EQ(changed("heightScale", 1),
              at + ": 'heightScale' is none of kind, texture, scale, extent");
    EXPECT_EQ(changed("scale", 0), at + ".scale: must not be 0");
    EXPECT_EQ(changed("extent", {1, 1}), at + ".extent: counts for displacement maps only");
    nlohmann::json flat = good;
    flat["kind"] = "displacement", flat["extent"] = {1, 0};
    EXPECT_EQ(error(flat), at + ".extent: must be above 0");
    EXPECT_EQ(changed("texture", {{"index", 1}}),
              "materials[0]: extras.glitterpath.slopeMaps: the texture of map 0 is repeated in "
              "mirror images, which heights and displacements cannot be");
    EXPECT_EQ(errorOfAll(nlohmann::json::array({1, 2, 3, 4, 5})), all + ": has more than 4 maps");
    EXPECT_EQ(errorOfAll(3), all + ": must be an array");
}

TEST(GltfMaterial, Core) {
    const Material m =
        loaded({{"name", "paint"},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                  {"metallicFactor", 0.5},
                  {"roughnessFactor", 0.25},
                  {"baseColorTexture", {{"index", 0}}},
                  {"metallicRoughnessTexture", {{"index", 1}}}}},
                {"emissiveFactor", {1, 0.5, 0}},
                {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}},
                {"alphaMode", "MASK"},
                {"alphaCutoff", 0.3},
                {"doubleSided", true}});
    EXPECT_EQ(m.name, "paint");
    EXPECT_EQ(m.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.emission, glm::vec3(8, 4, 0));
    EXPECT_EQ(m.alphaMode, AlphaMode::mask);
    EXPECT_EQ(m.alphaCutoff, 0.3f);
    EXPECT_TRUE(m.doubleSided);
    const Texture& base = *m.baseColorTexture.texture;
    EXPECT_EQ(base.colorSpace, ColorSpace::srgb);
    EXPECT_EQ(base.wrapU, Wrap::repeat);
    EXPECT_TRUE(base.mipmapped);
    EXPECT_EQ(base.levels[0].width, 5u);
    const Texture& rough = *m.metallicRoughnessTexture.texture;
    EXPECT_EQ(rough.colorSpace, ColorSpace::linear);
    EXPECT_EQ(rough.wrapU, Wrap::clampToEdge);
    EXPECT_EQ(rough.wrapV, Wrap::mirroredRepeat);
    EXPECT_EQ(rough.magFilter, Filter::nearest);
    EXPECT_EQ(rough.minFilter, Filter::linear);
    EXPECT_FALSE(rough.mipmapped);
}

TEST(GltfMaterial, Extensions) {
    EXPECT_TRUE(loaded(extension("KHR_materials_unlit", nlohmann::json::object())).unlit);
    EXPECT_EQ(loaded(extension("KHR_materials_ior", {{"ior", 1.33}})).ior, 1.33f);
    const Material specular = loaded(extension(
        "KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 2, 3}},
                                   {"specularTexture", {{"index", 0}}}}));
    EXPECT_EQ(specular.specular, 0.5f);
    EXPECT_EQ(specular.specularColor, glm::vec3(1, 2, 3));
    EXPECT_EQ(specular.specularTexture.texture->colorSpace, ColorSpace::linear);
    const Material coat = loaded(extension(
        "KHR_materials_clearcoat", {{"clearcoatFactor", 0.7}, {"clearcoatRoughnessFactor", 0.2},
                                    {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.4}}}}));
    EXPECT_EQ(coat.coat, 0.7f);
    EXPECT_EQ(coat.coatRoughness, 0.2f);
    EXPECT_EQ(coat.coatNormalScale, 0.4f);
    EXPECT_TRUE(coat.coatNormalTexture.texture);
    const Material sheen = loaded(extension(
        "KHR_materials_sheen", {{"sheenColorFactor", {0, 1, 0}}, {"sheenRoughnessFactor", 0.6}}));
    EXPECT_EQ(sheen.sheenColor, glm::vec3(0, 1, 0));
    EXPECT_EQ(sheen.sheenRoughness, 0.6f);
    const Material thin =
        loaded(extension("KHR_materials_transmission", {{"transmissionFactor", 0.9}}));
    EXPECT_EQ(thin.transmission, 0.9f);
    EXPECT_TRUE(thin.thinWalled);
    const Material solid = loaded(extension(
        "KHR_materials_volume", {{"thicknessFactor", 0.1}, {"attenuationDistance", 2.5},
                                 {"attenuationColor", {0.5, 1, 1}}}));
    EXPECT_FALSE(solid.thinWalled);
    EXPECT_EQ(solid.attenuationDistance, 2.5f);
    EXPECT_EQ(solid.attenuationColor, glm::vec3(0.5f, 1, 1));
    const Material brushed = loaded(extension(
        "KHR_materials_anisotropy", {{"anisotropyStrength", 0.8}, {"anisotropyRotation", 1.5}}));
    EXPECT_EQ(brushed.anisotropy, 0.8f);
    EXPECT_EQ(brushed.anisotropyRotation, 1.5f);
    const Material film = loaded(extension(
        "KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceIor", 1.8},
                                      {"iridescenceThicknessMinimum", 200},
                                      {"iridescenceThicknessMaximum", 800}}));
    EXPECT_EQ(film.iridescence, 1);
    EXPECT_EQ(film.iridescenceIor, 1.8f);
    EXPECT_EQ(film.iridescenceThicknessMinNm, 200);
    EXPECT_EQ(film.iridescenceThicknessMaxNm, 800);
}

TEST(GltfMaterial, TextureTransformOverridesTheSet) {
    const Material m = loaded(
        {{"pbrMetallicRoughness",
          {{"baseColorTexture",
            {{"index", 0},
             {"texCoord", 0},
             {"extensions", {{"KHR_texture_transform",
                              {{"offset", {10, 20}}, {"rotation", 1.5707963267948966},
                               {"scale", {2, 3}}, {"texCoord", 1}}}}}}}}}});
    EXPECT_EQ(m.baseColorTexture.texCoord, 1u);
    // (1, 0) is scaled to (2, 0) and turned to (0, -2): counter-clockwise with v downwards.
    expectNear({m.baseColorTexture.uvTransform * glm::vec3(1, 0, 1), 0}, {10, 18, 0});
    expectNear({m.baseColorTexture.uvTransform * glm::vec3(0, 1, 1), 0}, {13, 20, 0});
}

TEST(GltfMaterial, OneTextureForOneImageAndUse) {
    GltfBuilder b = withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                  {"emissiveTexture", {{"index", 0}}},
                                  {"normalTexture", {{"index", 0}}}});
    const Scene s = load(b);
    const Material& m = s.instances[0]->surface();
    EXPECT_EQ(m.baseColorTexture.texture, m.emissionTexture.texture);
    EXPECT_NE(m.baseColorTexture.texture, m.normalTexture.texture);  // one is sRGB, one linear
}

TEST(GltfMaterial, NormalMapBringsTangents) {
    const auto tangent = [](const nlohmann::json& material) {
        GltfBuilder b = withMaterial(material);
        auto& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
        attributes["TEXCOORD_1"] = b.vec2s({{0, 0}, {0, 1}, {-1, 0}});  // u along +Y turned: -Y
        const auto mesh = load(b).instances[0]->mesh;
        return shading::tangent_decode(mesh->vertices[0].tangentOct);
    };
    expectNear(tangent({{"normalTexture", {{"index", 0}}}}), {1, 0, 0}, 1e-3f);
    expectNear(tangent({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}}), {0, -1, 0}, 1e-3f);
    expectNear(tangent(extension("KHR_materials_anisotropy",
                                 {{"anisotropyTexture", {{"index", 0}, {"texCoord", 1}}}})),
               {0, -1, 0}, 1e-3f);
    expectNear(tangent(extension("KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}})),
               {1, 0, 0}, 1e-3f);
}

TEST(GltfLight, AllKinds) {
    GltfBuilder b;
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 683}, {"color", {1, 0.5, 0}}},
        {{"type", "point"}, {"intensity", 1366}, {"name", "lamp"}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}}};
    for (size_t i = 0; i < 3; ++i) {
        b.json["nodes"].push_back({{"translation", {i, 2, 3}}, {"scale", {2, 2, 2}}});
        b.json["nodes"][i]["extensions"]["KHR_lights_punctual"]["light"] = i;
    }
    b.json["nodes"][0]["rotation"] = {-0.70710678, 0, 0, 0.70710678};  // -Z to -Y
    const Scene s = load(b);
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0]->kind, LightKind::directional);
    expectNear(s.lights[0]->emission, {1, 0.5f, 0});
    expectNear(s.lights[0]->direction, {0, -1, 0});
    EXPECT_EQ(s.lights[1]->kind, LightKind::sphere);
    EXPECT_EQ(s.lights[1]->name, "lamp");
    expectNear(s.lights[1]->emission, glm::vec3(2));
    expectNear(s.lights[1]->position, {1, 2, 3});
    EXPECT_EQ(s.lights[1]->radius, 0);
    EXPECT_EQ(s.lights[2]->kind, LightKind::spot);
    expectNear(s.lights[2]->emission, glm::vec3(1 / 683.0f));
    EXPECT_FLOAT_EQ(s.lights[2]->cosInner, std::cos(0.2f));
    EXPECT_FLOAT_EQ(s.lights[2]->cosOuter, std::cos(0.5f));
    expectNear(s.lights[2]->direction, {0, 0, -1});
    EXPECT_NE(s.lights[0]->id, s.lights[1]->id);
}

TEST(GltfCamera, BothKinds) {
    GltfBuilder b;
    b.json["cameras"] = {
        {{"type", "perspective"},
         {"perspective", {{"yfov", 0.7}, {"aspectRatio", 3}, {"znear", 1}}}},
        {{"type", "orthographic"}, {"name", "plan"}, {"orthographic", {{"xmag", 9}, {"ymag", 4}}}}};
    b.json["nodes"] = {{{"camera", 0}, {"name", "eye"}, {"translation", {1, 2, 3}}},
                       {{"camera", 1}, {"rotation", {-0.70710678, 0, 0, 0.70710678}}}};
    const Scene s = load(b);
    ASSERT_EQ(s.cameras.size(), 2u);
    EXPECT_EQ(s.cameras[0].name, "eye");
    EXPECT_EQ(s.cameras[0].kind, CameraKind::perspective);
    EXPECT_EQ(s.cameras[0].verticalFov, 0.7f);
    expectNear(s.cameras[0].position, {1, 2, 3});
    expectNear(s.cameras[0].target, {1, 2, 2});
    EXPECT_EQ(s.cameras[1].name, "plan");
    EXPECT_EQ(s.cameras[1].kind, CameraKind::orthographic);
    EXPECT_EQ(s.cameras[1].orthographicHeight, 8);
    expectNear(s.cameras[1].target - s.cameras[1].position, {0, -1, 0});
    expectNear(s.cameras[1].up, {0, 0, -1});
}

TEST(GltfRich, LoadsWithEverything) {
    io::GltfOptions options;
    options.time = 1;
    const Scene s = load(richGltf().glb(), options);
    EXPECT_EQ(s.instances.size(), 3u);
    EXPECT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.cameras.size(), 1u);
    EXPECT_EQ(s.instances[0]->mesh->kind, MeshKind::dynamic);
    const Material& m = s.instances[0]->surface();
    EXPECT_TRUE(m.baseColorTexture.texture->hasAlpha);
    EXPECT_EQ(m.normalTexture.texture->levels[0].width, 16u);
    EXPECT_EQ(s.instances[0]->mesh->colors[0], glm::u8vec4(255, 0, 0, 255));
}
