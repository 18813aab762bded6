// A vaulted corridor under an old house, lit by torches alone, and by the pale night behind the
// grate at its far end. Walls and vault close it all around. It runs along -Z from z = 2.5.
#include "corridor.h"
#include "noise.h"
#include "scenes.h"
#include "shapes.h"
#include "textures.h"

#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float nearEnd = 2.5f, farEnd = -33.0f, grateAt = -30.0f, length = 32.0f;

struct Surfaces {
    int wall, floor, rib, oak, iron;
};

Surfaces addSurfaces(GlbBuilder& glb)
{
    const auto make = [&](const char* name, const BakeOptions& options, const TexelFunction& f) {
        Material material;
        material.name = name;
        glb.setMaps(material, bake(options, f));
        return glb.addMaterial(material);
    };
    Surfaces s;
    s.wall = make("hewn stone", {{768, 768}, {2, 2}}, stoneBlocks(srgb(0x8c8376), 7, 4, 11u));
    s.floor = make("flagstones", {{512, 512}, {2, 2}}, flagstones(srgb(0x6f685e), 4, 3, 12u));
    s.rib = make("dressed stone", {{256, 256}, {2, 2}}, [](glm::vec2 uv) {
        const float grain = fbm(uv * 30.0f, {30, 30}, 4, 13u);
        const float stain = fbm(uv * 3.0f, {3, 3}, 4, 14u);
        Texel t;
        t.color = srgb(0x9a8f7d) * (1 + 0.35f * grain + 0.5f * stain);
        t.height = 0.007f * grain;
        t.roughness = glm::clamp(0.85f + 0.2f * grain, 0.0f, 1.0f);
        return t;
    });
    s.oak = make("old oak", {{512, 256}, {1.2f, 0.4f}},
                 wood({srgb(0x8a6440), srgb(0x4a3020), 0.6f}, 15u));
    Material iron;
    iron.name = "black iron";
    iron.color = glm::vec3(0.16f, 0.15f, 0.14f);
    iron.metallic = 1.0f;
    iron.roughness = 0.48f;
    s.iron = glb.addMaterial(iron);
    return s;
}

void addShell(GlbBuilder& glb, const Surfaces& s)
{
    const float middle = 0.5f * (nearEnd + farEnd), half = 0.5f * (nearEnd - farEnd);
    const float w = corridorHalfWidth, h = corridorSpring;
    Mesh walls;
    walls.append(quad({-w, h / 2, middle}, {0, 0, -half}, {0, h / 2, 0}, {half, h / 2}));
    walls.append(quad({w, h / 2, middle}, {0, 0, half}, {0, h / 2, 0}, {half, h / 2}));
    walls.append(quad({0, 0.5f * (h + w), nearEnd}, {-w, 0, 0}, {0, 0.5f * (h + w), 0},
                      {w, 0.5f * (h + w)}));
    Mesh vault = surface(49, 2, [=](glm::vec2 uv) {
        const float angle = pi * uv.x;
        return glm::vec3(w * std::cos(angle), h + w * std::sin(angle),
                         glm::mix(nearEnd, farEnd, uv.y));
    });
    // The texture's u runs along the corridor, so that courses lie level.
    for (glm::vec2& uv : vault.uvs)
        uv = glm::vec2(uv.y * half, uv.x * pi * w / 2.0f);
    vault.flip();
    walls.append(vault);
    for (std::size_t i = 0; i < walls.normals.size(); ++i)
        walls.normals[i] = glm::normalize(walls.normals[i]);
    glb.add("walls", walls, s.wall);
    glb.add("floor", quad({0, 0, middle}, {0, 0, half}, {w, 0, 0}, {half, w}), s.floor);

    Material night;
    night.name = "night";
    night.color = glm::vec3(0.0f);
    night.emission = glm::vec3(0.45f, 0.75f, 1.25f) * 0.9f;
    glb.add("night", quad({0, 0.5f * (h + w), farEnd}, {w, 0, 0}, {0, 0.5f * (h + w), 0}),
            glb.addMaterial(night));
    Material bars;
    bars.name = "grate";
    const MaterialImages images = grateImages();
    glb.setMaps(bars, images);
    bars.alphaMode = "MASK";
    bars.doubleSided = true;
    glb.add("grate", quad({0, 0.5f * (h + w), grateAt}, {w, 0, 0}, {0, 0.5f * (h + w), 0},
                          {2 * w / 0.75f, (h + w) / 0.75f}),
            glb.addMaterial(bars));
}

void addRibsAndTorches(GlbBuilder& glb, const Surfaces& s, int count)
{
    Material fire;
    fire.name = "fire";
    fire.color = glm::vec3(0.0f);
    fire.specular = 0.0f;
    fire.emission = glm::vec3(420.0f);
    fire.emissionTexture = glb.addTexture("flame", flameGradient(), false);
    const int burning = glb.addMaterial(fire);
    constexpr std::uint32_t variants = 3;
    int ribs[variants], iron[variants], shafts[variants], flames[variants];
    for (std::uint32_t i = 0; i < variants; ++i) {
        ribs[i] = glb.addMesh("rib", stoneRib(i + 1), s.rib);
        const Torch t = torch(i + 1);
        iron[i] = i == 0 ? glb.addMesh("torch iron", t.iron, s.iron) : iron[0];
        shafts[i] = i == 0 ? glb.addMesh("torch shaft", t.shaft, s.oak) : shafts[0];
        flames[i] = glb.addMesh("flame", t.flame, burning);
    }
    const float pitch = length / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const float z = -pitch * (static_cast<float>(i) + 0.35f);
        const std::size_t variant = static_cast<std::size_t>(i) % variants;
        std::string number(" ");
        number += std::to_string(i + 1);
        glb.addNode("rib" + number, ribs[variant],
                    translation(0, 0, z) * rotationY(i % 2 ? pi : 0));
        const float side = i % 2 == 0 ? -1.0f : 1.0f;
        // On the face of the pier, turned towards the middle.
        const glm::mat4 place = translation(side * (corridorHalfWidth - 0.215f), 1.36f, z) *
                                rotationY(side > 0 ? pi : 0);
        glb.addNode("torch iron" + number, iron[variant], place);
        glb.addNode("torch shaft" + number, shafts[variant], place);
        glb.addNode("flame" + number, flames[variant], place);
    }
}

void addDoors(GlbBuilder& glb, const Surfaces& s)
{
    const Door d = door(4u);
    const int planks = glb.addMesh("door planks", d.planks, s.oak);
    const int iron = glb.addMesh("door iron", d.iron, s.iron);
    const int frame = glb.addMesh("door frame", d.frame, s.rib);
    // Between two ribs at the standard pitch of 2.67 m, alternately left and right.
    const float pitch = length / 12.0f;
    for (const int bay : {1, 3, 6, 9}) {
        const float side = bay % 2 == 1 ? 1.0f : -1.0f;
        const float z = -pitch * (static_cast<float>(bay) + 0.85f);
        const glm::mat4 place = translation(side * corridorHalfWidth, 0, z) *
                                rotationY(side > 0 ? pi : 0);
        const std::string name = "door " + std::to_string(bay);
        glb.addNode(name + " planks", planks, place);
        glb.addNode(name + " iron", iron, place);
        glb.addNode(name + " frame", frame, place);
    }
}

void addPuddles(GlbBuilder& glb)
{
    Material water;
    water.name = "puddle";
    glb.setMaps(water, puddleImages());
    water.ior = 1.33f;
    water.alphaMode = "BLEND";
    const int mesh = glb.addMesh("puddle", quad({0, 0, 0}, {0.8f, 0, 0}, {0, 0, -0.8f}),
                                 glb.addMaterial(water));
    struct Place {
        float x, z, turn, across, along;
    };
    const Place places[] = {{-0.15f, -1.5f, 0.4f, 1.25f, 1.5f}, {0.55f, -4.0f, 2.1f, 0.9f, 1.2f},
                            {-0.45f, -6.3f, 1.2f, 1.1f, 1.5f},  {0.30f, -9.6f, 3.0f, 1.3f, 1.8f},
                            {-0.30f, -14.0f, 0.2f, 1.2f, 2.4f}, {0.35f, -20.0f, 1.7f, 1.4f, 2.2f}};
    float height = 0.004f;  // no two in one plane, should they touch
    for (const Place& p : places) {
        glb.addNode("puddle", mesh,
                    translation(p.x, height, p.z) * scaling({p.across, 1, p.along}) *
                        rotationY(p.turn));
        height += 0.0002f;
    }
}

void addThings(GlbBuilder& glb, const Surfaces& s)
{
    const Barrel b = barrel();
    const int staves = glb.addMesh("barrel", b.staves, s.oak);
    const int hoops = glb.addMesh("barrel hoops", b.hoops, s.iron);
    const glm::mat4 barrels[] = {translation(-1.13f, 0, -2.05f) * rotationY(0.5f),
                                 translation(-1.10f, 0, -2.72f) * rotationY(1.9f),
                                 translation(1.12f, 0, -8.4f) * rotationY(2.2f)};
    for (const glm::mat4& place : barrels) {
        glb.addNode("barrel", staves, place);
        glb.addNode("barrel hoops", hoops, place);
    }
    const int box = glb.addMesh("crate", crate(), s.oak);
    glb.addNode("crate", box, translation(1.05f, 0, -2.25f) * rotationY(-0.25f));
    glb.addNode("crate", box, translation(1.08f, 0.562f, -2.30f) * rotationY(0.20f) *
                                  scaling(glm::vec3(0.72f)));
    glb.addNode("crate", box, translation(-1.05f, 0, -10.3f) * rotationY(0.15f));
}

void addIvy(GlbBuilder& glb)
{
    Material leaves;
    leaves.name = "ivy";
    glb.setMaps(leaves, bake({{192, 768}, {0.3f, 1.2f}, true}, ivy(5u)));
    leaves.alphaMode = "MASK";
    leaves.doubleSided = true;
    // A hanging card, bent so that it has some depth from every side.
    Mesh card = surface(5, 9, [](glm::vec2 uv) {
        const float a = uv.x - 0.5f;
        return glm::vec3(0.34f * a, -1.2f * uv.y, 0.16f * a * a + 0.05f * std::sin(5 * uv.y));
    });
    const int mesh = glb.addMesh("ivy", card, glb.addMaterial(leaves));
    Random random(8u);
    const float pitch = length / 12.0f;
    for (int i = 0; i < 44; ++i) {
        // It hangs from the edges of the first ribs and thins out with the daylight it lacks.
        const int rib = i < 26 ? 0 : (i < 36 ? 2 : 11);
        const float angle = pi * random.uniform(0.10f, 0.90f);
        const float radius = corridorHalfWidth - 0.10f;
        const float z = -pitch * (static_cast<float>(rib) + 0.35f) + random.uniform(0.16f, 0.30f);
        const float size = random.uniform(0.35f, 0.85f);
        glb.addNode("ivy", mesh, translation(radius * std::cos(angle),
                                             corridorSpring + radius * std::sin(angle), z) *
                                     rotationY(random.uniform(-0.8f, 0.8f)) *
                                     scaling(glm::vec3(0.8f, size, 0.8f)));
    }
}

}  // namespace

void buildCorridor(GlbBuilder& glb, const Parameters& parameters)
{
    const Surfaces surfaces = addSurfaces(glb);
    addShell(glb, surfaces);
    addRibsAndTorches(glb, surfaces, static_cast<int>(parameters.at("torches")));
    addDoors(glb, surfaces);
    addPuddles(glb);
    addThings(glb, surfaces);
    addIvy(glb);
    glb.addCamera({"entrance", {0.18f, 1.42f, 2.0f}, {-0.06f, 1.34f, -6.0f}, 52.0f, 16.0f / 9.0f});
    glb.addCamera({"floor", {-0.5f, 0.35f, -0.2f}, {0.25f, 1.0f, -7.0f}, 48.0f, 16.0f / 9.0f});
}

}  // namespace gp::make_scene
