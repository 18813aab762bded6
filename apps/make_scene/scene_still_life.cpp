// Things of many materials on a garden table, put together as painters of still lifes did: a
// triangle whose tall corner is the carafe, light from behind on the left, a cloth that leads the
// eye in over the edge, and a soap bubble for the shortness of life. The light is the sky's.
#include "landscape.h"
#include "noise.h"
#include "scenes.h"
#include "shapes.h"
#include "still_life.h"
#include "textures.h"

#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float tableTop = 0.75f, tableEdge = 0.40f;  // metres; the edge towards the viewer

glm::mat4 onTable(float x, float z, float turn = 0.0f, float lift = 0.0f)
{
    return translation(x, tableTop + lift, z) * rotationY(turn);
}

void addTable(GlbBuilder& glb)
{
    Material oak;
    oak.name = "oak";
    const WoodColors colors{srgb(0x7d5535), srgb(0x4c2f1c), 0.46f};
    glb.setMaps(oak, bake({{1024, 512}, {1.2f, 0.4f}}, wood(colors, 1u)));
    const int material = glb.addMaterial(oak);
    Mesh table;
    const auto plank = [&](glm::vec3 size, glm::vec3 centre, glm::vec2 grain) {
        Mesh board = box(size, 0.004f, 3);
        board.scaleUv({1 / 1.2f, 1 / 0.4f}, grain);
        table.append(board.transform(translation(centre)));
    };
    Random random(5u);
    constexpr int planks = 5;
    const float width = 2 * tableEdge / planks;
    for (int i = 0; i < planks; ++i)
        plank({1.7f, 0.042f, width - 0.0015f},
              {0, tableTop - 0.021f, -tableEdge + width * (static_cast<float>(i) + 0.5f)},
              {random.uniform(), random.uniform()});
    for (const float z : {-0.33f, 0.33f})
        plank({1.5f, 0.09f, 0.024f}, {0, tableTop - 0.087f, z}, {0.3f + z, 0.1f});
    for (const float x : {-0.75f, 0.75f})
        for (const float z : {-0.33f, 0.33f})
            plank({0.07f, tableTop - 0.042f, 0.07f}, {x, 0.5f * (tableTop - 0.042f), z}, {x, z});
    glb.add("table", table, material);
}

void addTerrace(GlbBuilder& glb)
{
    Material floor;
    floor.name = "flagstones";
    glb.setMaps(floor, bake({{256, 256}, {2, 2}}, flagstones(srgb(0xa39883), 4, 3, 21u)));
    glb.add("terrace", quad({0, 0, 0}, {0, 0, 3}, {5, 0, 0}, {3, 5}), glb.addMaterial(floor));

    Material wall;
    wall.name = "parapet";
    glb.setMaps(wall, bake({{384, 384}, {2, 2}}, stoneBlocks(srgb(0xb0a389), 9, 5, 22u)));
    const int material = glb.addMaterial(wall);
    Mesh parapet = box({10, 0.86f, 0.3f});
    parapet.scaleUv(glm::vec2(0.5f)).transform(translation(0, 0.43f, -2.05f));
    glb.add("parapet", parapet, material);
    Mesh caps;
    for (int i = -4; i <= 4; ++i) {
        Mesh cap = box({1.19f, 0.07f, 0.42f}, 0.012f, 3);
        cap.scaleUv(glm::vec2(0.18f), {0.13f * static_cast<float>(i), 0.05f});
        const float x = 1.2f * static_cast<float>(i) + 0.4f;
        caps.append(cap.transform(translation(x, 0.895f, -2.05f)));
    }
    Material slab;
    slab.name = "coping";
    slab.color = srgb(0xb8ad97);
    slab.roughness = 0.85f;
    glb.add("coping", caps, glb.addMaterial(slab));
}

void addVessels(GlbBuilder& glb)
{
    const Vessel vessel = carafe();
    Material glass;
    glass.name = "glass";
    glass.roughness = 0.0f;
    glass.transmission = 1.0f;
    glass.thickness = 0.003f;
    glass.attenuationColor = glm::vec3(0.86f, 0.95f, 0.91f);
    glass.attenuationDistance = 0.02f;
    Material water = glass;
    water.name = "water";
    water.ior = 1.33f;
    water.thickness = 0.12f;
    water.attenuationColor = glm::vec3(0.45f, 0.80f, 0.82f);
    water.attenuationDistance = 0.20f;
    const glm::mat4 place = onTable(-0.185f, -0.13f);
    glb.addNode("carafe", glb.addMesh("carafe", vessel.glass, glb.addMaterial(glass)), place);
    glb.addNode("water", glb.addMesh("water", vessel.water, glb.addMaterial(water)), place);

    Material glaze;
    glaze.name = "painted glaze";
    glaze.colorTexture = glb.addTexture("painted glaze colour", bowlPainting());
    glaze.roughness = 0.55f;
    glaze.clearcoat = 1.0f;
    glaze.clearcoatRoughness = 0.04f;
    glb.addNode("bowl", glb.addMesh("bowl", bowl(), glb.addMaterial(glaze)),
                onTable(0.055f, -0.05f));

    Material silver;
    silver.name = "brushed silver";
    silver.color = glm::vec3(0.962f, 0.949f, 0.922f);
    silver.metallic = 1.0f;
    silver.roughness = 0.34f;
    silver.anisotropy = 0.85f;  // the brush went around, along the tangent
    glb.addNode("goblet", glb.addMesh("goblet", goblet(), glb.addMaterial(silver)),
                onTable(0.255f, -0.20f));
}

int addStem(GlbBuilder& glb)
{
    Material bark;
    bark.name = "stem";
    bark.color = srgb(0x4b3621);
    bark.roughness = 0.8f;
    return glb.addMesh("stem", stem(0.026f, 0.0018f), glb.addMaterial(bark));
}

void addFruit(GlbBuilder& glb)
{
    const auto skin = [&](const char* name, const TexelFunction& texel, float coat) {
        Material material;
        material.name = name;
        glb.setMaps(material, bake({{320, 160}, {0.22f, 0.11f}}, texel));
        material.clearcoat = coat;
        material.clearcoatRoughness = 0.15f;
        return glb.addMaterial(material);
    };
    const int stalk = addStem(glb);
    const int red = glb.addMesh(
        "apple", apple(), skin("red apple", appleSkin(srgb(0x9d1420), srgb(0xd3ae4a), 41u), 0.6f));
    const int pearMesh = glb.addMesh("pear", pear(), skin("pear", pearSkin(44u), 0.15f));
    const int orange = glb.addMesh("orange", sphere(0.039f, 72, 40),
                                   skin("orange", citrusSkin(srgb(0xe8780f), 0.0005f, 42u), 0.25f));
    const int yellow = glb.addMesh("lemon", lemon(),
                                   skin("lemon", citrusSkin(srgb(0xf0cb24), 0.0004f, 43u), 0.25f));
    const auto withStem = [&](const char* name, int mesh, const glm::mat4& place, float height) {
        glb.addNode(name, mesh, place);
        glb.addNode(std::string(name) + " stem", stalk, place * translation(0, height, 0));
    };
    const glm::mat4 dish = onTable(0.055f, -0.05f);
    withStem("apple in the bowl", red,
             dish * translation(-0.068f, 0.045f, 0.028f) * rotationZ(0.42f) * rotationY(0.6f),
             0.056f);
    withStem("apple behind", red,
             dish * translation(0.030f, 0.045f, -0.072f) * rotationX(-0.4f) * rotationY(2.4f),
             0.056f);
    withStem("pear", pearMesh,
             dish * translation(-0.022f, 0.068f, -0.022f) * rotationZ(0.20f) * rotationX(-0.15f),
             0.105f);
    glb.addNode("orange", orange, dish * translation(0.052f, 0.082f, 0.030f) * rotationX(0.8f));
    glb.addNode("lemon", yellow,
                onTable(-0.085f, 0.170f, 0.5f, 0.033f) * rotationZ(pi / 2) *
                    translation(0, -0.041f, 0));

    Material grape;
    grape.name = "grapes";
    grape.color = srgb(0x35112f);
    grape.roughness = 0.32f;
    grape.sheenColor = glm::vec3(0.16f, 0.17f, 0.22f);  // the bloom on the skin
    grape.sheenRoughness = 0.5f;
    const glm::mat4 bunch = onTable(0.150f, 0.190f, 0.35f);
    glb.addNode("grapes", glb.addMesh("grapes", grapes(61u), glb.addMaterial(grape)), bunch);
    Material wood;
    wood.name = "stalk";
    wood.color = srgb(0x6b6a2e);
    wood.roughness = 0.7f;
    glb.addNode("stalk", glb.addMesh("stalk", grapeStalk(), glb.addMaterial(wood)), bunch);
}

void addMetals(GlbBuilder& glb)
{
    Material gold;
    gold.name = "gold";
    gold.color = glm::vec3(1.0f, 0.766f, 0.336f);
    gold.metallic = 1.0f;
    gold.roughness = 0.06f;
    glb.addNode("gold sphere", glb.addMesh("gold sphere", sphere(0.036f, 80, 40),
                                           glb.addMaterial(gold)),
                onTable(0.345f, 0.050f, 0, 0.032f + 0.036f));
    Material copper = gold;
    copper.name = "rough copper";
    copper.color = glm::vec3(0.955f, 0.638f, 0.538f);
    copper.roughness = 0.42f;
    glb.addNode("copper sphere", glb.addMesh("copper sphere", sphere(0.027f, 80, 40),
                                             glb.addMaterial(copper)),
                onTable(0.290f, 0.235f, 0, 0.027f));
}

void addCar(GlbBuilder& glb)
{
    const ToyCar car = toyCar();
    const glm::mat4 place = onTable(-0.310f, 0.105f, 2.15f);
    Material paint;
    paint.name = "car paint";
    paint.color = srgb(0x0c5a66);
    paint.metallic = 0.55f;
    paint.roughness = 0.42f;
    paint.clearcoat = 1.0f;
    paint.clearcoatRoughness = 0.02f;
    Material dark;
    dark.name = "dark windows";
    dark.color = glm::vec3(0.012f);
    dark.roughness = 0.03f;
    Material chrome;
    chrome.name = "chrome";
    chrome.color = glm::vec3(0.55f, 0.556f, 0.554f);
    chrome.metallic = 1.0f;
    chrome.roughness = 0.08f;
    Material rubber;
    rubber.name = "rubber";
    rubber.color = glm::vec3(0.02f);
    rubber.roughness = 0.75f;
    const auto part = [&](const char* name, const Mesh& mesh, const Material& material) {
        glb.addNode(name, glb.addMesh(name, mesh, glb.addMaterial(material)), place);
    };
    part("car body", car.paint, paint);
    part("car windows", car.glass, dark);
    part("car chrome", car.chrome, chrome);
    part("car tyres", car.rubber, rubber);
}

void addBook(GlbBuilder& glb)
{
    const Book b = book();
    const glm::mat4 place = onTable(0.350f, 0.045f, 0.50f);
    Material cover;
    cover.name = "leather";
    glb.setMaps(cover, bake({{256, 256}, {0.1f, 0.1f}}, leather(srgb(0x5a1f1a), 51u)));
    Mesh boards = b.cover;
    boards.scaleUv(glm::vec2(10.0f));
    Material paper;
    paper.name = "pages";
    paper.colorTexture = glb.addTexture("pages colour", bakeColor({16, 256}, [](glm::vec2 uv) {
        const float leaf = 0.8f + 0.2f * hash01(0, static_cast<int>(uv.y * 256), 3u);
        return srgb(0xe6d9b8) * leaf;
    }));
    Mesh pages = b.pages;
    pages.scaleUv(glm::vec2(1.0f / 0.026f));
    Material gilt;
    gilt.name = "gilt bands";
    gilt.color = glm::vec3(0.9f, 0.68f, 0.3f);
    gilt.metallic = 1.0f;
    gilt.roughness = 0.3f;
    glb.addNode("book cover", glb.addMesh("book cover", boards, glb.addMaterial(cover)), place);
    glb.addNode("book pages", glb.addMesh("book pages", pages, glb.addMaterial(paper)), place);
    glb.addNode("book bands", glb.addMesh("book bands", b.bands, glb.addMaterial(gilt)), place);
}

void addCloth(GlbBuilder& glb)
{
    Material velvet;
    velvet.name = "velvet";
    glb.setMaps(velvet, bake({{256, 256}, {0.05f, 0.05f}}, weave(srgb(0x75101f), 24, 31u)));
    velvet.sheenColor = glm::vec3(0.30f, 0.07f, 0.09f);
    velvet.sheenRoughness = 0.38f;
    velvet.doubleSided = true;
    Mesh sheet = cloth(tableEdge);
    sheet.scaleUv({0.36f / 0.05f, 0.77f / 0.05f});
    glb.addNode("cloth", glb.addMesh("cloth", sheet, glb.addMaterial(velvet)), onTable(-0.11f, 0));
}

void addBubble(GlbBuilder& glb)
{
    Material film;
    film.name = "soap film";
    film.roughness = 0.0f;
    film.transmission = 1.0f;  // no thickness: a thin wall, seen through without bending
    film.ior = 1.33f;
    film.iridescence = 1.0f;
    film.iridescenceIor = 1.33f;
    film.filmThicknessMinNm = 140.0f;
    film.filmThicknessMaxNm = 620.0f;
    // The film drains downwards and swirls: thickness in the green channel.
    const auto thickness = [](glm::vec2 uv) {
        const glm::vec2 bend(0.0f, 0.35f * fbm(uv * glm::vec2(4, 3), {4, 0}, 4, 81u));
        const float swirl = fbm((uv + bend) * glm::vec2(3, 9), {3, 0}, 4, 82u);
        return glm::vec3(glm::clamp(1.0f - 0.85f * uv.y + 0.35f * swirl, 0.0f, 1.0f));
    };
    film.filmThicknessTexture =
        glb.addTexture("film thickness", bakeNumbers({256, 256}, thickness));
    glb.addNode("soap bubble", glb.addMesh("soap bubble", sphere(0.042f, 96, 48),
                                           glb.addMaterial(film)),
                onTable(0.150f, 0.05f, 0.4f, 0.265f));
}

}  // namespace

void buildStillLife(GlbBuilder& glb, const Parameters&)
{
    addTable(glb);
    addTerrace(glb);
    addLandscape(glb, -3.0f);
    addCloth(glb);
    addVessels(glb);
    addFruit(glb);
    addMetals(glb);
    addCar(glb);
    addBook(glb);
    addBubble(glb);
    glb.addCamera({"painter", {0.08f, 1.07f, 1.40f}, {0.01f, 0.850f, 0.0f}, 25.5f, 4.0f / 3.0f});
    glb.addCamera({"close", {-0.30f, 0.98f, 0.72f}, {-0.02f, 0.84f, -0.05f}, 30.0f, 4.0f / 3.0f});
}

}  // namespace gp::make_scene
