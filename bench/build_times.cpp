#include "build_times.h"

#include <cmath>

#include "spread.h"

namespace gp::bench {
namespace {

// The mesh alone in a scene, white, so that building is all that there is to do.
struct LoneMesh {
    Scene scene;
    std::shared_ptr<Mesh> mesh;

    LoneMesh(const Mesh& source, MeshKind kind) : mesh(std::make_shared<Mesh>(source)) {
        mesh->kind = kind;
        mesh->material = std::make_shared<Material>();
        auto instance = std::make_shared<Instance>();
        instance->mesh = mesh;
        scene.instances.push_back(std::move(instance));
        scene.revision = 1;
    }
    void changed() { ++mesh->revision, ++scene.revision; }
};

double millisecondsOfUpdate(BackendScene& target, const Scene& scene) {
    const Stopwatch watch;
    target.update(scene);
    return 1e3 * watch.wall();
}

double buildStatic(Backend& backend, const Mesh& source, int runs) {
    const LoneMesh lone(source, MeshKind::staticMesh);
    std::vector<double> times;
    for (int i = 0; i < runs; ++i)
        times.push_back(millisecondsOfUpdate(*backend.newScene(), lone.scene));
    return median(times);
}

double rebuildDynamic(Backend& backend, const Mesh& source, int runs) {
    LoneMesh lone(source, MeshKind::dynamic);
    const auto target = backend.newScene();
    target->update(lone.scene);
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        for (glm::vec3& p : lone.mesh->positions) p.y += 0.01f * std::sin(p.x + float(i));
        lone.changed();
        times.push_back(millisecondsOfUpdate(*target, lone.scene));
    }
    return median(times);
}

}  // namespace

nlohmann::ordered_json buildTimes(Backend& backend, const Mesh& mesh, int runs) {
    nlohmann::ordered_json json;
    json["triangles"] = mesh.triangles.size();
    json["static_ms"] = buildStatic(backend, mesh, runs);
    json["dynamic_ms"] = rebuildDynamic(backend, mesh, runs);
    return json;
}

Mesh makeWaves(size_t triangles) {
    const auto side = uint32_t(std::max(1.0, std::round(std::sqrt(double(triangles) / 2))));
    MeshData data;
    for (uint32_t z = 0; z <= side; ++z)
        for (uint32_t x = 0; x <= side; ++x) {
            const float u = 10 * float(x) / float(side), v = 10 * float(z) / float(side);
            data.positions.emplace_back(u, 0.3f * std::sin(3 * u) * std::cos(2 * v), v);
        }
    data.normals.assign(data.positions.size(), glm::vec3(0, 1, 0));
    for (uint32_t z = 0; z < side; ++z)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = z * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            data.indices.insert(data.indices.end(), {a, c, b, b, c, d});
        }
    Mesh mesh;
    fillMesh(mesh, std::move(data), {});
    mesh.revision = 1;
    return mesh;
}

const Mesh* largestMesh(const Scene& scene) {
    const Mesh* largest = nullptr;
    for (const auto& instance : scene.instances) {
        const Mesh* m = instance->mesh.get();
        if (!largest || m->triangles.size() > largest->triangles.size()) largest = m;
    }
    return largest;
}

}  // namespace gp::bench
