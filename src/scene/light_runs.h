// The lower levels of a light tree: lights in Morton order, cut where their codes differ most. A
// tenth of the time that weighing every cut takes, for clusters of a few dozen lights, where which
// cut is taken hardly matters.
// Based on: Lauterbach et al. 2009, "Fast BVH Construction on GPUs", Computer Graphics Forum 28(2).
#pragma once

#include <vector>

#include "scene/light_tree_writer.h"

namespace gp {

// Clusters of a few lights each, with their subtrees written, at least `least` of them where there
// are as many lights.
std::vector<LightCluster> makeLightRuns(const std::vector<LightCluster>& lights, size_t least,
                                        LightTreeWriter& writer);

}  // namespace gp
