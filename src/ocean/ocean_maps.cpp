// The sea as images, for other programs.
#include <fmt/format.h>

#include "ocean/ocean_parts.h"

namespace gp {

namespace {

struct MapKind {
    const char* name;
    uint32_t channels;
    void (*write)(const OceanPoint& point, float* texel);  // `channels` floats
};

void writeDisplacement(const OceanPoint& p, float* texel) {
    texel[0] = p.displacement.x;
    texel[1] = p.displacement.y;
    texel[2] = p.displacement.z;
}

void writeNormal(const OceanPoint& p, float* texel) {
    const glm::vec2 s = p.slope();
    const glm::vec3 normal = glm::normalize(glm::vec3(-s, 1.0f));
    texel[0] = normal.x;
    texel[1] = normal.y;
    texel[2] = normal.z;
}

void writeFoam(const OceanPoint& p, float* texel) { texel[0] = p.foam; }

// As LEAN wants them for ordinary texture filtering. [Olano and Baker 2010, section 3]
void writeMoments(const OceanPoint& p, float* texel) {
    const glm::vec2 s = p.slope();
    texel[0] = s.x;
    texel[1] = s.y;
    texel[2] = s.x * s.x;
    texel[3] = s.y * s.y;
    texel[4] = s.x * s.y;
}

constexpr MapKind kinds[] = {{"displacement", 3, writeDisplacement},
                             {"normal", 3, writeNormal},
                             {"foam", 1, writeFoam},
                             {"moments", 5, writeMoments}};

}  // namespace

std::vector<OceanMap> Ocean::maps() const {
    std::vector<OceanMap> maps;
    const uint32_t n = settings().size;
    for (uint32_t c = 0; c < settings().cascades; ++c) {
        for (const MapKind& kind : kinds) {
            OceanMap map{fmt::format("{}_{}", kind.name, c), n, kind.channels,
                         std::vector<float>(size_t(n) * n * kind.channels)};
            for (uint32_t row = 0; row < n; ++row) {
                for (uint32_t x = 0; x < n; ++x) {
                    kind.write(parts_->cascades[c].point(int(x), int(n - 1 - row)),
                               &map.texels[(size_t(row) * n + x) * kind.channels]);
                }
            }
            maps.push_back(std::move(map));
        }
    }
    return maps;
}

}  // namespace gp
