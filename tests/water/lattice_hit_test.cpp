// Hits of lattices, which Embree holds as grids, against the triangles that shading reads.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_scene.h"

namespace gp::cpu {
namespace {

using shared::Hit;

#include "backend/cpu/lattice_hit.h"

// A bumpy sheet over (0, 0) to (columns - 1, rows - 1).
std::shared_ptr<Mesh> sheet(Lattice lattice) {
    auto mesh = std::make_shared<Mesh>();
    mesh->kind = MeshKind::dynamic;
    mesh->lattice = lattice;
    mesh->material = std::make_shared<Material>();
    for (uint32_t row = 0; row < lattice.rows; ++row)
        for (uint32_t column = 0; column < lattice.columns; ++column) {
            const float x = float(column), y = float(row);
            mesh->positions.emplace_back(x, y, 0.4f * std::sin(1.7f * x) * std::cos(2.3f * y));
            mesh->vertices.push_back({});
        }
    mesh->positions.emplace_back();  // Embree reads 16 bytes
    mesh->triangles = latticeTriangles(lattice);
    return mesh;
}

class LatticeHits : public testing::TestWithParam<Lattice> {};

TEST_P(LatticeHits, NameTheTriangleAndThePlaceInIt) {
    const Lattice lattice = GetParam();
    const auto backend = newCpuBackend({});
    const auto built = backend->newScene();
    Scene scene;
    auto instance = std::make_shared<Instance>();
    instance->mesh = sheet(lattice);
    scene.instances.push_back(instance);
    ++scene.revision;
    built->update(scene);
    const SceneView& view = static_cast<const CpuScene&>(*built).view();
    const GeometryView& g = view.geometries[0];
    std::mt19937 random(5);
    std::uniform_real_distribution<float> u01;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 origin(u01(random) * float(lattice.columns - 1),
                               u01(random) * float(lattice.rows - 1), 5);
        RTCRayHit ray{};
        ray.ray.org_x = origin.x, ray.ray.org_y = origin.y, ray.ray.org_z = origin.z;
        ray.ray.dir_z = -1, ray.ray.tfar = 100, ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        QueryContext query;
        initQuery(query, &view, nullptr, false);
        intersect1(view.scene, query, ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;  // on an edge
        Hit h;
        h.primitive = ray.hit.primID, h.u = ray.hit.u, h.v = ray.hit.v;
        latticeHit(g, h);
        ASSERT_LT(h.primitive, instance->mesh->triangles.size());
        const glm::uvec3 t = g.triangles[h.primitive];
        const glm::vec3 p = g.positions[t.x] * (1 - h.u - h.v) + g.positions[t.y] * h.u +
                            g.positions[t.z] * h.v;
        EXPECT_NEAR(p.x, origin.x, 2e-4) << i;
        EXPECT_NEAR(p.y, origin.y, 2e-4) << i;
        EXPECT_NEAR(p.z, 5 - ray.ray.tfar, 2e-4) << i;
        EXPECT_GE(std::min({h.u, h.v, 1 - h.u - h.v}), -1e-5) << i;
        const glm::vec3 side = glm::cross(g.positions[t.y] - g.positions[t.x],
                                          g.positions[t.z] - g.positions[t.x]);
        EXPECT_LT(side.z, 0) << "rows follow columns counter-clockwise here";
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LatticeHits,
                         testing::Values(Lattice{2, 2}, Lattice{3, 5}, Lattice{6, 4},
                                         Lattice{17, 2}, Lattice{65, 40}));

}  // namespace
}  // namespace gp::cpu
