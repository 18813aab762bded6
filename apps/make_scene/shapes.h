// Solids and surfaces from which the scenes are put together, made around the origin.
#pragma once

#include "mesh.h"

#include <functional>
#include <vector>

namespace gp::make_scene {

// A profile for the lathe: x is the radius, y the height. Going up along the outside and, for a
// vessel, down again along the inside keeps the surface on the right, facing out.
struct ProfilePoint {
    float radius = 0.0f;
    float height = 0.0f;
    bool sharp = false;  // a crease: the normals of the two sides are not blended
};
using Profile = std::vector<ProfilePoint>;

// A curve through the control points (Catmull-Rom); creases stay creases.
Profile smoothProfile(const Profile& controlPoints, int stepsPerSpan);
// u runs once around (counter-clockwise seen from above), v along the profile by arc length.
Mesh lathe(const Profile& profile, int segments);
Mesh sphere(float radius, int segments, int rings);
Mesh cylinder(float radius, float bottom, float top, int segments, float bevel = 0.0f);

// A cube blown up to a unit sphere: 12 n^2 triangles of about one size.
Mesh cubeSphere(int n);

// A box of full size `size` whose edges are rounded with `radius` (0: sharp). UVs are planar and
// in metres, u along the longer side of each face, so that wood grain follows the plank.
Mesh box(glm::vec3 size, float radius = 0.0f, int bevelSteps = 3);

// A surface over the unit square; smooth normals facing dP/du x dP/dv.
Mesh surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& position);

// A quad centred at `centre`, sides 2 `halfU` and 2 `halfV`, facing halfU x halfV.
Mesh quad(glm::vec3 centre, glm::vec3 halfU, glm::vec3 halfV, glm::vec2 uvSize = glm::vec2(1.0f));

// A round bar along a path, closed with flat ends; `radii` has one entry or one a point.
Mesh tube(const std::vector<glm::vec3>& path, const std::vector<float>& radii, int segments);
Mesh bar(glm::vec3 from, glm::vec3 to, float radius, int segments);
// A ring around the Y axis.
Mesh torus(float ringRadius, float tubeRadius, int segments, int tubeSegments);

}  // namespace gp::make_scene
