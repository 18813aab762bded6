// A living room late in the day. It is closed: light enters through the window in the left wall
// and comes from the lamps, nowhere else. Inside, x is in [-2.6, 2.6], y in [0, 2.7] and z in
// [-2.1, 2.1], in metres.
#include "landscape.h"
#include "noise.h"
#include "room.h"
#include "scenes.h"
#include "shapes.h"
#include "still_life.h"
#include "textures.h"

#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float halfX = 2.6f, halfZ = 2.1f, height = 2.7f, thick = 0.3f;
constexpr float windowLow = 0.72f, windowHigh = 2.28f, windowBack = -1.35f, windowFront = 0.75f;

int plain(GlbBuilder& glb, const char* name, glm::vec3 color, float roughness, float metallic = 0)
{
    Material material;
    material.name = name;
    material.color = color;
    material.roughness = roughness;
    material.metallic = metallic;
    return glb.addMaterial(material);
}

int lampMaterial(GlbBuilder& glb, const char* name, glm::vec3 radiance)
{
    Material material;
    material.name = name;
    material.color = glm::vec3(0.8f);
    material.emission = radiance;
    return glb.addMaterial(material);
}

struct Woods {
    int oak, walnut;
};
Woods addWoods(GlbBuilder& glb)
{
    const auto make = [&](const char* name, WoodColors colors, std::uint32_t seed) {
        Material material;
        material.name = name;
        glb.setMaps(material, bake({{768, 256}, {1.2f, 0.4f}}, wood(colors, seed)));
        return glb.addMaterial(material);
    };
    return {make("oak boards", {srgb(0xc79a68), srgb(0x92683c), 0.42f}, 1u),
            make("walnut", {srgb(0x9c6b45), srgb(0x603c25), 0.36f}, 2u)};
}

// A block from corner to corner, textured in metres.
void addBlock(Mesh& mesh, glm::vec3 low, glm::vec3 high, float edge = 0.0f)
{
    Mesh block = box(high - low, edge, 2);
    block.scaleUv(glm::vec2(0.5f), glm::vec2(low.x + low.z, low.y) * 0.5f);
    mesh.append(block.transform(translation(0.5f * (low + high))));
}

void addShell(GlbBuilder& glb)
{
    Material paint;
    paint.name = "wall plaster";
    glb.setMaps(paint, bake({{256, 256}, {2, 2}}, plaster(srgb(0xe2d8c6), 7u)));
    const float x = halfX + thick, z = halfZ + thick;
    Mesh walls;
    addBlock(walls, {-x, -thick, -z}, {x, height + thick, -halfZ});
    addBlock(walls, {-x, -thick, halfZ}, {x, height + thick, z});
    addBlock(walls, {halfX, -thick, -z}, {x, height + thick, z});
    // The window wall, around the opening. The blocks meet face to face: overlapping ones would
    // show two surfaces in one place.
    addBlock(walls, {-x, -thick, -z}, {-halfX, windowLow, z});
    addBlock(walls, {-x, windowHigh, -z}, {-halfX, height + thick, z});
    addBlock(walls, {-x, windowLow, -z}, {-halfX, windowHigh, windowBack});
    addBlock(walls, {-x, windowLow, windowFront}, {-halfX, windowHigh, z});
    glb.add("walls", walls, glb.addMaterial(paint));
    Mesh ceiling;
    addBlock(ceiling, {-x, height, -z}, {x, height + thick, z});
    glb.add("ceiling", ceiling, plain(glb, "ceiling", srgb(0xeeeae0), 0.95f));

    Mesh trim;
    for (const float side : {-1.0f, 1.0f}) {
        addBlock(trim, {-halfX, 0, side * (halfZ - 0.008f) - 0.010f},
                 {halfX, 0.11f, side * (halfZ - 0.008f) + 0.010f}, 0.003f);
        addBlock(trim, {side * (halfX - 0.008f) - 0.010f, 0, -halfZ},
                 {side * (halfX - 0.008f) + 0.010f, 0.11f, halfZ}, 0.003f);
    }
    glb.add("skirting", trim, plain(glb, "white paint", srgb(0xe9e6df), 0.35f));
}

void addFloor(GlbBuilder& glb, int oak)
{
    Mesh slab;
    addBlock(slab, {-halfX - thick, -thick, -halfZ - thick},
             {halfX + thick, -0.012f, halfZ + thick});
    glb.add("floor slab", slab, plain(glb, "slab", glm::vec3(0.03f), 0.9f));
    Mesh boards;
    Random random(3u);
    const float width = 0.14f;
    for (int row = 0; row < 30; ++row) {
        const float z = -halfZ + width * (static_cast<float>(row) + 0.5f);
        float x = -halfX - random.uniform(0.0f, 1.2f);
        while (x < halfX) {
            const float length = random.uniform(1.2f, 2.2f);
            Mesh board = box({length - 0.0012f, 0.02f, width - 0.0012f}, 0.0015f, 1);
            grainUv(board, {random.uniform(), random.uniform()});
            boards.append(board.transform(translation(x + 0.5f * length, -0.01f, z)));
            x += length;
        }
    }
    glb.add("floor boards", boards, oak);
}

void addWindow(GlbBuilder& glb)
{
    const int white = plain(glb, "window paint", srgb(0xf0eee8), 0.3f);
    const float x = -halfX - 0.17f, bar = 0.055f;  // the frame sits in the depth of the wall
    Mesh frame;
    const auto upright = [&](float z, float half) {
        addBlock(frame, {x - 0.03f, windowLow, z - half}, {x + 0.03f, windowHigh, z + half},
                 0.005f);
    };
    const auto across = [&](float y, float half) {
        addBlock(frame, {x - 0.029f, y - half, windowBack}, {x + 0.029f, y + half, windowFront},
                 0.005f);
    };
    upright(windowBack + bar / 2, bar / 2);
    upright(windowFront - bar / 2, bar / 2);
    upright(0.5f * (windowBack + windowFront), 0.04f);
    across(windowLow + bar / 2, bar / 2);
    across(windowHigh - bar / 2, bar / 2);
    across(windowLow + 0.68f * (windowHigh - windowLow), 0.016f);
    addBlock(frame, {-halfX - thick, windowLow - 0.03f, windowBack - 0.06f},
             {-halfX + 0.10f, windowLow + 0.012f, windowFront + 0.06f}, 0.006f);
    glb.add("window frame", frame, white);

    const float rod = windowHigh + 0.16f, place = -halfX + 0.11f;
    glb.add("curtain rod",
            make_scene::bar({place, rod, windowBack - 0.45f}, {place, rod, windowFront + 0.45f},
                            0.011f, 20),
            plain(glb, "brass", glm::vec3(0.82f, 0.62f, 0.32f), 0.25f, 1.0f));
    Material linen;
    linen.name = "linen";
    linen.color = srgb(0xcfc0a4);
    linen.roughness = 0.9f;
    linen.sheenColor = glm::vec3(0.14f);
    linen.sheenRoughness = 0.5f;
    linen.doubleSided = true;
    const int cloth = glb.addMaterial(linen);
    for (const float z : {windowBack - 0.20f, windowFront + 0.20f}) {
        Mesh drape = curtain(0.46f, rod - 0.03f, z < 0 ? 5u : 6u);
        drape.transform(translation(place, rod, z) * rotationY(pi / 2));
        glb.add(z < 0 ? "curtain back" : "curtain front", drape, cloth);
    }
}

void addDining(GlbBuilder& glb, int walnut)
{
    const glm::vec3 centre(-0.55f, 0, 0.05f);
    const glm::mat4 place = translation(centre) * rotationY(0.06f);
    glb.addNode("table", glb.addMesh("table", diningTable(), walnut), place);
    const int seat = glb.addMesh("chair", chair(), walnut);
    const glm::mat4 seats[] = {
        place * translation(-0.42f, 0, -0.62f) * rotationY(0.12f),
        place * translation(0.40f, 0, -0.58f) * rotationY(-0.10f),
        place * translation(1.12f, 0, 0.10f) * rotationY(-pi / 2 - 0.45f),
        place * translation(-0.30f, 0, 0.66f) * rotationY(pi + 0.15f)};
    for (const glm::mat4& seatPlace : seats)
        glb.addNode("chair", seat, seatPlace);

    Mesh rug = box({2.4f, 0.012f, 1.6f}, 0.003f, 1);
    rug.scaleUv({1 / 2.4f, 1 / 1.6f}, glm::vec2(0.5f));
    Material wool;
    wool.name = "rug";
    wool.colorTexture = glb.addTexture("rug colour", rugPattern());
    wool.sheenColor = glm::vec3(0.08f);
    wool.sheenRoughness = 0.6f;
    glb.addNode("rug", glb.addMesh("rug", rug, glb.addMaterial(wool)),
                translation(centre + glm::vec3(0.1f, 0.006f, 0)) * rotationY(0.04f));

    Material glaze;
    glaze.name = "glazed bowl";
    glaze.colorTexture = glb.addTexture("bowl colour", bowlPainting());
    glaze.roughness = 0.4f;
    glaze.clearcoat = 1.0f;
    const glm::mat4 top = place * translation(0, 0.74f, 0);
    glb.addNode("bowl", glb.addMesh("bowl", bowl(), glb.addMaterial(glaze)),
                top * translation(0.12f, 0, 0.03f));
    Material skin;
    skin.name = "green apple";
    skin.color = srgb(0x9db338);
    skin.roughness = 0.3f;
    const int fruit = glb.addMesh("apple", apple(), glb.addMaterial(skin));
    glb.addNode("apple 1", fruit, top * translation(0.07f, 0.044f, 0.05f) * rotationZ(0.3f));
    glb.addNode("apple 2", fruit, top * translation(0.165f, 0.043f, 0.035f) * rotationZ(-0.4f));
    glb.addNode("apple 3", fruit, top * translation(0.11f, 0.044f, -0.035f) * rotationX(-0.4f));
    const Book reading = book();
    glb.addNode("book", glb.addMesh("book cover", reading.cover,
                                    plain(glb, "book cloth", srgb(0x27505a), 0.6f)),
                top * translation(-0.42f, 0, 0.16f) * rotationY(0.7f));
    glb.addNode("book pages", glb.addMesh("book pages", reading.pages,
                                          plain(glb, "paper", srgb(0xe6dcc0), 0.9f)),
                top * translation(-0.42f, 0, 0.16f) * rotationY(0.7f));
}

void addShelf(GlbBuilder& glb, int walnut)
{
    const glm::mat4 place = translation(1.25f, 0, -halfZ + 0.005f);
    glb.addNode("shelf", glb.addMesh("shelf", shelf(), walnut), place);
    const std::uint32_t colors[bookColors] = {0x7d2a25, 0x2e4a3a, 0x29395e, 0xb8893f,
                                              0xd6c8a8, 0x4a2f3d, 0x2b2b2e};
    const auto books = shelfBooks(17u);
    for (std::size_t i = 0; i < bookColors; ++i) {
        const std::string name = "books " + std::to_string(i + 1);
        const int cover = plain(glb, name.c_str(), srgb(colors[i]), 0.55f);
        glb.addNode(name, glb.addMesh(name, books[i], cover), place);
    }
    const int gold = plain(glb, "gold ornament", glm::vec3(1.0f, 0.766f, 0.336f), 0.12f, 1.0f);
    glb.addNode("ornament", glb.addMesh("ornament", goblet(), gold),
                place * translation(0.42f, 1.612f + 0.0f, 0.16f));
}

void addWallPieces(GlbBuilder& glb, int walnut)
{
    const float wall = -halfZ;
    Mesh mirror = cylinder(0.36f, 0.0f, 0.02f, 96, 0.002f);
    mirror.transform(translation(-0.72f, 1.62f, wall) * rotationX(pi / 2));
    glb.add("mirror", mirror, plain(glb, "mirror", glm::vec3(0.95f), 0.0f, 1.0f));
    Mesh ring = torus(0.372f, 0.019f, 96, 20);
    ring.transform(translation(-0.72f, 1.62f, wall + 0.018f) * rotationX(pi / 2));
    glb.add("mirror frame", ring, plain(glb, "gilt frame", glm::vec3(0.85f, 0.64f, 0.3f), 0.3f, 1));

    Material oil;
    oil.name = "painting";
    oil.colorTexture = glb.addTexture("painting colour", landscapePainting(), false);
    oil.roughness = 0.5f;
    oil.clearcoat = 0.4f;
    oil.clearcoatRoughness = 0.25f;
    const glm::vec3 middle(0.16f, 1.62f, wall + 0.016f);
    glb.add("painting", quad(middle, {0.24f, 0, 0}, {0, 0.18f, 0}), glb.addMaterial(oil));
    Mesh frame;
    for (const float side : {-1.0f, 1.0f}) {
        Mesh rail = box({0.54f, 0.032f, 0.03f}, 0.006f, 2);
        grainUv(rail, {0.1f, 0.2f});
        frame.append(rail.transform(translation(middle + glm::vec3(0, side * 0.194f, 0))));
        Mesh stile = box({0.032f, 0.36f, 0.028f}, 0.006f, 2);
        grainUv(stile, {0.4f, 0.3f});
        frame.append(stile.transform(translation(middle + glm::vec3(side * 0.254f, 0, 0))));
    }
    glb.add("painting frame", frame, walnut);

    Mesh door = box({0.05f, 2.05f, 0.88f}, 0.004f, 2);
    door.transform(translation(halfX - 0.01f, 1.025f, 0.9f));
    for (const float y : {0.55f, 1.5f}) {
        Mesh panel = box({0.05f, 0.75f, 0.62f}, 0.012f, 2);
        door.append(panel.transform(translation(halfX - 0.022f, y, 0.9f)));
    }
    glb.add("door", door, plain(glb, "door paint", srgb(0x5b6f6a), 0.4f));
}

void addLamps(GlbBuilder& glb)
{
    const int brass = plain(glb, "lamp brass", glm::vec3(0.75f, 0.56f, 0.3f), 0.3f, 1.0f);
    const glm::vec3 warm(1.0f, 0.62f, 0.30f);
    const FloorLamp lamp = floorLamp();
    const glm::mat4 corner = translation(-2.05f, 0, -1.62f);
    glb.addNode("lamp stand", glb.addMesh("lamp stand", lamp.metal, brass), corner);
    glb.addNode("lamp shade", glb.addMesh("lamp shade", lamp.shade,
                                          lampMaterial(glb, "lit shade", warm * 8.0f)), corner);
    glb.addNode("lamp bulb", glb.addMesh("lamp bulb", lamp.bulb,
                                         lampMaterial(glb, "bulb", warm * 400.0f)), corner);

    const int opal = glb.addMesh("globe", sphere(0.085f, 48, 24),
                                 lampMaterial(glb, "opal globe", warm * 24.0f));
    const float drop[] = {1.78f, 1.62f, 1.86f};
    Mesh cords;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 at(-0.95f + 0.40f * static_cast<float>(i), drop[i], 0.05f);
        glb.addNode("globe " + std::to_string(i + 1), opal, translation(at));
        cords.append(bar(at + glm::vec3(0, 0.075f, 0), {at.x, height, at.z}, 0.003f, 10));
        Mesh cap = cylinder(0.026f, 0.078f, 0.112f, 28, 0.004f);
        cords.append(cap.transform(translation(at)));
    }
    glb.add("globe cords", cords, brass);
}

void addPlant(GlbBuilder& glb)
{
    const PottedPlant plant = pottedPlant(9u);
    const glm::mat4 place = translation(-2.12f, 0, 1.05f);
    Material leaf;
    leaf.name = "leaves";
    leaf.color = srgb(0x3f6b35);
    leaf.roughness = 0.4f;
    leaf.doubleSided = true;
    glb.addNode("leaves", glb.addMesh("leaves", plant.leaves, glb.addMaterial(leaf)), place);
    const int clay = plain(glb, "terracotta", srgb(0xb0623f), 0.8f);
    glb.addNode("pot", glb.addMesh("pot", plant.pot, clay), place);
    glb.addNode("soil", glb.addMesh("soil", plant.soil, plain(glb, "soil", srgb(0x2e2119), 1.0f)),
                place);
}

}  // namespace

void buildRoom(GlbBuilder& glb, const Parameters&)
{
    const Woods woods = addWoods(glb);
    addShell(glb);
    addFloor(glb, woods.oak);
    addWindow(glb);
    addLandscape(glb, -0.8f);
    addDining(glb, woods.walnut);
    addShelf(glb, woods.walnut);
    addWallPieces(glb, woods.walnut);
    addLamps(glb);
    addPlant(glb);
    glb.addCamera({"corner", {2.15f, 1.48f, 1.92f}, {-0.78f, 0.98f, -0.85f}, 50.0f, 16.0f / 9.0f});
    glb.addCamera({"table", {0.75f, 1.30f, 1.30f}, {-0.65f, 0.85f, -0.25f}, 42.0f, 16.0f / 9.0f});
}

}  // namespace gp::make_scene
