// Lights that are not triangles. Emissive triangles are lights by themselves.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

struct EnvironmentTable;  // scene/environment_table.h

enum class LightKind : uint8_t { directional, sphere, spot, rectangle, polygon };

struct Light {
    uint64_t id = 0;
    std::string name;
    LightKind kind = LightKind::directional;
    // directional: perpendicular irradiance, W/m^2; sphere, spot: radiant intensity, W/sr;
    // rectangle, polygon: radiance, W/(m^2 sr).
    glm::vec3 emission{1};
    glm::vec3 position{0};
    glm::vec3 direction{0, 0, -1};  // of the light's travel; unit length
    float radius = 0;               // sphere, spot: metres; 0 = a point
    float angularRadius = 0;        // directional: radians; 0 = parallel rays
    float cosInner = 1, cosOuter = 0.7071068f;  // spot
    glm::vec3 edgeU{1, 0, 0}, edgeV{0, 1, 0};   // rectangle: full edges from the corner `position`;
                                                // light leaves on the side of cross(edgeU, edgeV)
    std::vector<glm::vec3> corners; // polygon: convex, flat, none on the line between its
                                    // neighbours (scene/polygon.h); light leaves along `direction`,
                                    // its normal. Triangles (0, i, i + 1) make it up
    bool twoSided = false;          // rectangle, polygon
    bool visible = true;            // camera rays see spheres, rectangles and polygons
    bool inScene = true;            // false: removed, while a handle is still there
    bool ofSky = false;             // the sun of setSky, which goes when its sky is replaced
};

// Light from infinitely far in every direction. Latitude-longitude, shading/light/environment.glsl.
struct Environment {
    std::shared_ptr<const EnvironmentTable> table;  // an image; null: constant `color`
    glm::vec3 color{0};  // multiplies the image; alone: a uniform surrounding, W/(m^2 sr)
    float rotation = 0;  // radians about world up, counter-clockwise seen from above
};

}  // namespace gp
