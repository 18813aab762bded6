#include "scene/cube_map.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "scene/texel_decoder.h"
#include "shading/shading.h"

namespace gp {
namespace {

void decodeFace(const Texture& texture, glm::vec3* texels) {
    const MipLevel& face = texture.levels[0];
    const TexelDecoder decoder(texture);
    for (size_t i = 0; i < size_t(face.width) * face.height; ++i) texels[i] = decoder.at(face, i);
}

class CubeReader {
public:
    explicit CubeReader(const CubeMap& cube) : cube_(cube), size_(int(cube.size)) {}

    // Bilinear.
    glm::vec3 at(const glm::vec3& direction) const {
        const shading::CubePoint p = shading::cube_point(direction);
        const float x = p.st.x * float(size_) - 0.5f, y = p.st.y * float(size_) - 0.5f;
        const int ix = int(x + 1) - 1, iy = int(y + 1) - 1;  // neither is below -0.5
        const float ax = x - float(ix), ay = y - float(iy);
        if (ix >= 0 && iy >= 0 && ix + 1 < size_ && iy + 1 < size_) {
            const glm::vec3* t = face(p.face) + size_t(iy) * cube_.size + size_t(ix);
            return glm::mix(glm::mix(t[0], t[1], ax),
                            glm::mix(t[cube_.size], t[cube_.size + 1], ax), ay);
        }
        return glm::mix(
            glm::mix(beyond(p.face, ix, iy), beyond(p.face, ix + 1, iy), ax),
            glm::mix(beyond(p.face, ix, iy + 1), beyond(p.face, ix + 1, iy + 1), ax), ay);
    }

private:
    const glm::vec3* face(uint32_t i) const {
        return cube_.texels.data() + size_t(i) * cube_.size * cube_.size;
    }
    glm::vec3 texel(uint32_t i, int x, int y) const {
        return face(i)[size_t(std::clamp(y, 0, size_ - 1)) * cube_.size +
                       size_t(std::clamp(x, 0, size_ - 1))];
    }
    // A texel that may lie behind an edge: then the nearest one of the face that lies there.
    glm::vec3 beyond(uint32_t i, int x, int y) const {
        if (x >= 0 && y >= 0 && x < size_ && y < size_) return texel(i, x, y);
        const glm::vec2 st((float(x) + 0.5f) / float(size_), (float(y) + 0.5f) / float(size_));
        const shading::CubePoint p = shading::cube_point(shading::cube_direction(i, st));
        return texel(p.face, int(p.st.x * float(size_)), int(p.st.y * float(size_)));
    }

    const CubeMap& cube_;
    int size_;
};

// So many samples along each side of a pixel that the texels of a face's corner, half as wide as
// those of its middle, all count.
uint32_t samplesAcross(uint32_t size, uint32_t width) {
    return std::max(2u, (8 * size + width - 1) / width);
}

void resample(const CubeMap& cube, const glm::mat3& cubeFromImage, uint32_t n,
              LatLongImage& image) {
    const CubeReader reader(cube);
    // Directions on the image's equator; a row only makes them shorter, and adds height.
    std::vector<glm::vec3> columns(size_t(image.width) * n);
    for (size_t i = 0; i < columns.size(); ++i) {
        const float u = (float(i) + 0.5f) / float(columns.size());
        columns[i] = cubeFromImage * shading::environment_direction_from_uv({u, 0.5f});
    }
    tbb::parallel_for(0u, image.height, [&](uint32_t y) {
        glm::vec4* row = &image.pixels[size_t(y) * image.width];
        std::fill(row, row + image.width, glm::vec4(0, 0, 0, 1));
        const double rows = double(image.height) * n;
        const auto top = [&](uint32_t j) { return std::cos(M_PI * (double(y) * n + j) / rows); };
        for (uint32_t j = 0; j < n; ++j) {
            // Of a pixel at a pole the far side has nearly all of the solid angle.
            const auto share = float((top(j) - top(j + 1)) / ((top(0) - top(n)) * n));
            const float v = float((double(y) * n + j + 0.5) / rows);
            const shading::SinCos polar = shading::sincos_turns(0.5f * v);
            const glm::vec3 up = cubeFromImage[1] * polar.c;
            for (size_t i = 0; i < columns.size(); ++i)
                row[i / n] += glm::vec4(reader.at(columns[i] * polar.s + up) * share, 0);
        }
    });
}

}  // namespace

CubeMap cubeMapOf(const std::array<const Texture*, 6>& faces) {
    CubeMap cube;
    cube.size = faces[0]->levels[0].width;
    const size_t count = size_t(cube.size) * cube.size;
    cube.texels.resize(6 * count);
    tbb::parallel_for(size_t(0), size_t(6),
                      [&](size_t i) { decodeFace(*faces[i], &cube.texels[i * count]); });
    return cube;
}

void latLongFromCube(const CubeMap& cube, const glm::mat3& cubeFromImage, LatLongImage& image) {
    resample(cube, cubeFromImage, 1, image);
}

LatLongImage latLongFromCube(const CubeMap& cube, const glm::mat3& cubeFromImage) {
    LatLongImage image;
    image.width = std::clamp(4 * cube.size, leastLatLongWidth, mostLatLongWidth);
    image.height = image.width / 2;
    image.pixels.resize(size_t(image.width) * image.height);
    resample(cube, cubeFromImage, samplesAcross(cube.size, image.width), image);
    return image;
}

}  // namespace gp
