#include "shading/shading.h"

#include "scene/sea.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "scene/bsdf_registry.h"
#include "scene/water_light.h"

namespace gp {

namespace {

// How far a viewer without a place of its own sees, in heights of its picture.
constexpr float parallelViewHeights = 1;

glm::vec3 worldFromSea(glm::vec3 v) { return {v.x, v.z, -v.y}; }

// The model's parameters but for what varies: that is filled in at each point.
std::shared_ptr<Material> waterOf(const SeaSettings& s, const Ocean& ocean) {
    auto water = std::make_shared<Material>();
    water->name = "sea";
    auto bsdf = std::make_shared<BsdfSettings>(findBsdfModel("glint"));
    bsdf->set("ior", fmt::format("{}", s.ior));
    bsdf->set("thin", "false");
    constexpr const char* methods[] = {"smooth", "dictionary", "counting"};
    bsdf->set("method", methods[size_t(s.glints)]);
    bsdf->set("density", fmt::format("{}", s.facetDensity));
    bsdf->set("masking", s.masking == SeaMasking::smith ? "smith" : "v_cavity");
    // What is prepared for a material is so for one roughness: that of the whole sea.
    const OceanMoments all = ocean.momentsAbove(0);
    const float alpha = std::clamp(std::sqrt(all.xx + all.yy), 1.0e-4f, 1.0f);
    bsdf->set("alpha_x", fmt::format("{}", alpha));
    bsdf->set("alpha_y", fmt::format("{}", alpha));
    const glm::vec3 r = s.clear ? glm::vec3(0) : seaReflectance(s);
    bsdf->set("base_color", fmt::format("{},{},{}", r.x, r.y, r.z));
    water->layers = {{.bsdf = std::move(bsdf), .weight = 1, .mask = {}, .channel = 0}};
    water->sea = s.clear ? SeaWater::clear : SeaWater::deep;
    const glm::vec3 lost = seaAttenuation(s);
    const float most = std::max({lost.x, lost.y, lost.z});
    if (most > 0) {
        water->attenuationColor = glm::exp(-lost / most);
        water->attenuationDistance = 1 / most;
    }
    return water;
}

// Where the grid's vertices are: around `centre`, moved by `shape`.
void displace(const SeaGrid& grid, const std::vector<glm::vec2>& points, glm::vec2 centre,
              float height, float level, const SeaShape& shape, glm::vec3* positions) {
    const Lattice lattice = grid.lattice();
    tbb::parallel_for(0u, lattice.rows, [&](uint32_t row) {
        const SeaShape::Detail detail = shape.detail(grid.cell(std::max(row, 1u) - 1, height));
        const size_t first = size_t(row) * lattice.columns;
        for (size_t i = first; i < first + lattice.columns; ++i) {
            const glm::vec2 rest = centre + points[i];
            const glm::vec3 p = glm::vec3(rest, 0) + SeaShape::at(rest, detail);
            positions[i] = worldFromSea(p) + glm::vec3(0, level, 0);
        }
    });
}

// Of the surface through the neighbours: outwards times around is up.
glm::vec3 normalAt(const SeaGrid& grid, const glm::vec3* p, uint32_t row, uint32_t column) {
    if (row == 0) return {0, 1, 0};
    const uint32_t n = grid.sectors;
    const auto vertex = [&](uint32_t r, uint32_t s) { return p[size_t(r) * (n + 1) + s % n]; };
    const glm::vec3 inner = vertex(row - 1, column);
    const glm::vec3 outer = vertex(std::min(row + 1, grid.rings), column);
    const glm::vec3 normal =
        glm::cross(outer - inner, vertex(row, column + 1) - vertex(row, column + n - 1));
    const float length = glm::length(normal);
    return length > 0 && normal.y > 0 ? normal / length : glm::vec3(0, 1, 0);
}

}  // namespace

glm::vec3 seaAttenuation(const SeaSettings& s) { return s.absorption + s.backscattering; }

Sea::Sea(const SeaSettings& settings)
    : settings_(settings), ocean_(settings.waves), tail_(ocean_.tail()),
      grid_(seaGrid(settings.sectors)),
      mesh_(std::make_shared<Mesh>()), instance_(std::make_shared<Instance>()) {
    mesh_->name = "sea";
    mesh_->kind = MeshKind::dynamic;
    mesh_->wanders = true;
    mesh_->material = waterOf(settings, ocean_);
    instance_->name = "sea";
    instance_->mesh = mesh_;
    instance_->ofSea = true;
}

void Sea::setTime(double seconds) {
    if (seconds == ocean_.time()) return;
    ocean_.setTime(seconds);
    ++times_;
}

bool Sea::place(const Camera& camera, bool motion) {
    const bool parallel = camera.kind == CameraKind::orthographic;
    const glm::vec3 eye = parallel ? camera.target : camera.position;
    const float above = eye.y - settings_.level;
    Placement now;
    now.place.centre = {eye.x, -eye.z};
    now.place.height = seaGridHeight(
        parallel ? std::max(std::abs(above), parallelViewHeights * camera.orthographicHeight)
                 : above);
    now.time = times_;
    if (now == placed_) return false;
    fill(now, motion && placed_.time != 0);
    return true;
}

void Sea::fill(const Placement& now, bool motion) {
    const bool later = now.time != placed_.time;
    if (later) {
        std::swap(shape_, pastShape_);
        placed_.time = 0;  // should the next line fail, nothing is known of the triangles' time
        shape_.read(ocean_);
    }
    const std::vector<glm::vec2> points = seaGridPoints(grid_, now.place.height);
    const size_t count = points.size();
    // What the mesh had last but one is written over. One more: Embree reads 16 bytes of each.
    std::vector<glm::vec3>&positions = next_.positions, &before = next_.before;
    std::vector<ShadingVertex>& vertices = next_.vertices;
    positions.resize(count + 1), before.resize(motion ? count + 1 : 0), vertices.resize(count);
    const auto [centre, height] = now.place;
    displace(grid_, points, centre, height, settings_.level, shape_, positions.data());
    if (motion && later)
        displace(grid_, points, centre, height, settings_.level, pastShape_, before.data());
    else if (motion)
        before = positions;
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
        const uint32_t columns = grid_.lattice().columns;
        const glm::vec3 normal = normalAt(grid_, positions.data(), uint32_t(i / columns),
                                          uint32_t(i % columns));
        vertices[i] = {shading::octahedral_encode(normal), 0, now.place.centre + points[i]};
    });
    if (mesh_->triangles.empty()) {
        mesh_->lattice = grid_.lattice();
        mesh_->triangles = latticeTriangles(mesh_->lattice);
        ++mesh_->topologyRevision;
    }
    mesh_->positions.swap(positions);
    mesh_->before.swap(before);
    mesh_->vertices.swap(vertices);
    mesh_->beforeRevision = mesh_->revision++;
    placed_ = now;
}

OceanSlopes Sea::slopes(glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) const {
    OceanSlopes s = ocean_.slopes(rest, d0, d1);
    s.varX += tail_.xx, s.varY += tail_.yy, s.cov += tail_.xy;
    s.foam *= settings_.foam;
    return s;
}

bool Sea::isBelow(const Camera& camera) const {
    const glm::vec3 eye = camera.position;
    return camera.kind != CameraKind::orthographic && eye.y < at(eye.x, eye.z).height;
}

SeaPoint Sea::at(float x, float z) const {
    const glm::vec2 wanted(x, -z);
    // The point at rest that came here: waves that do not fold over make this converge; of those
    // that do, it finds a point nearby.
    glm::vec2 rest = wanted;
    constexpr int steps = 12;
    for (int i = 0; i < steps; ++i) rest = wanted - glm::vec2(ocean_.displacement(rest));
    const OceanPoint point = ocean_.at(rest);
    const glm::vec2 slope = point.slope();
    SeaPoint result;
    result.height = settings_.level + point.displacement.z;
    result.normal = worldFromSea(glm::normalize(glm::vec3(-slope, 1)));
    result.foam = point.foam * settings_.foam;
    return result;
}

}  // namespace gp
