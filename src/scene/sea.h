// The sea of a scene: waves, water, and the triangles that one camera sees of them.
// The sea's own frame has x towards +X, y towards -Z and z up; its plane at rest lies at `level`.
#pragma once

#include <memory>
#include <vector>

#include "ocean/ocean.h"
#include "scene/scene.h"
#include "scene/sea_grid.h"
#include "scene/sea_shape.h"

namespace gp {

// What the smallest facets are: words of the model `glint`.
enum class SeaGlints : uint8_t { smooth, dictionary, counting };
enum class SeaMasking : uint8_t { vCavity, smith };

struct SeaSettings {
    OceanSettings waves;
    float level = 0;                // y of the water at rest, metres
    uint32_t sectors = 384;         // of the grid: seaSectorsLeast..seaSectorsMost
    glm::vec3 absorption{0};        // 1/m
    glm::vec3 backscattering{0};    // 1/m
    float ior = 1.333f;
    float foam = 1;                 // times what the waves say
    SeaGlints glints = SeaGlints::smooth;
    float facetDensity = 1e6f;      // a square metre of the water at rest
    SeaMasking masking = SeaMasking::vCavity;
    bool clear = false;             // rays go on into the water; else nothing below it is seen
};

// What of the sea is above or below a point.
struct SeaPoint {
    float height = 0;               // y
    glm::vec3 normal{0, 1, 0};
    float foam = 0;
};

// Where the triangles are: around `centre` (x, y of the sea's frame), for a viewer of this height.
struct SeaPlace {
    glm::vec2 centre{0};
    float height = 0;
    bool operator==(const SeaPlace&) const = default;
};

class Sea {
public:
    // Settings must be without fault. Throws std::bad_alloc.
    explicit Sea(const SeaSettings& settings);

    // The waves `seconds` after their beginning.
    void setTime(double seconds);
    // Brings the triangles to where `camera` sees them now, and says whether they have changed.
    // `motion`: they will also be asked where they were at their last revision.
    bool place(const Camera& camera, bool motion);
    // Of the surface at the time of setTime, not of triangles.
    SeaPoint at(float x, float z) const;
    // Whether the view starts in the water. That of parallel views starts nowhere: never.
    bool isBelow(const Camera& camera) const;
    // Over a footprint, as Ocean::slopes, with the waves below its grids and the foam of settings.
    OceanSlopes slopes(glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) const;

    const SeaSettings& settings() const { return settings_; }
    const Ocean& ocean() const { return ocean_; }
    const std::shared_ptr<Instance>& instance() const { return instance_; }
    const SeaGrid& grid() const { return grid_; }
    const SeaPlace& placed() const { return placed_.place; }

private:
    struct Placement {
        SeaPlace place;
        uint64_t time = 0;          // as times_
        bool operator==(const Placement&) const = default;
    };
    void fill(const Placement& now, bool motion);

    SeaSettings settings_;
    Ocean ocean_;
    OceanMoments tail_;
    SeaGrid grid_;
    std::shared_ptr<Mesh> mesh_;
    std::shared_ptr<Instance> instance_;
    uint64_t times_ = 1;            // how often time has been set
    Placement placed_;              // time 0: never
    SeaShape shape_, pastShape_;    // of placed_.time, and of another time that was placed before
    struct {
        std::vector<glm::vec3> positions, before;
        std::vector<ShadingVertex> vertices;
    } next_;                        // memory for the mesh
};

// What the water takes of light on its way, 1/m: absorbed, or scattered back.
glm::vec3 seaAttenuation(const SeaSettings& settings);

}  // namespace gp
