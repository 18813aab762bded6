// How long acceleration structures take to build, through the backend that the renderer uses.
#pragma once

#include <nlohmann/json.hpp>

#include "backend/backend.h"

namespace gp::bench {

// Milliseconds, medians of `runs`, of one mesh alone: built once for good (static), or built anew
// because its vertices moved (dynamic).
nlohmann::ordered_json buildTimes(Backend& backend, const Mesh& mesh, int runs);

// A wavy square of about `triangles` triangles, ten metres a side.
Mesh makeWaves(size_t triangles);

// Null where the scene is empty.
const Mesh* largestMesh(const Scene& scene);

}  // namespace gp::bench
