// Immediate mode: which triangles the primitives of OpenGL 1 are, which way they run, and whose
// colours they have.
#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "api/world.h"

namespace gp::test {
namespace {

class Immediate : public ::testing::Test {
protected:
    Immediate() : device(newNullDevice()), im(gpNewImmediate(device)) {}
    ~Immediate() override { gpReleaseDevice(device); }

    // `count` vertices whose x and red are their numbers.
    void vertices(GpPrimitive primitive, int count) {
        ASSERT_EQ(gpBegin(im, primitive), GP_SUCCESS);
        for (int i = 0; i < count; ++i) {
            gpColor4f(im, float(i), 0, 0, 1);
            ASSERT_EQ(gpVertex3f(im, float(i), 0, 0), GP_SUCCESS);
        }
        ASSERT_EQ(gpEnd(im), GP_SUCCESS);
    }
    const float* floats(const float* base, size_t stride, uint32_t i) const {
        return reinterpret_cast<const float*>(reinterpret_cast<const char*>(base) + stride * i);
    }
    // Numbers of the corners of all triangles, by positions; with `colors` by colours.
    std::vector<int> corners(bool colors = false) {
        GpDrawDesc d{};
        EXPECT_EQ(gpGetImmediateDraw(im, &d), GP_SUCCESS);
        std::vector<int> result;
        for (uint32_t i = 0; i < d.indexCount; ++i)
            result.push_back(int(colors ? *floats(d.colors, d.colorStride, d.indices[i])
                                        : *floats(d.positions, d.positionStride, d.indices[i])));
        return result;
    }

    GpDevice device;
    GpImmediate im;
};

// Triangles as lists of corners, each turned so that its smallest number comes first: the same
// triangle, the same way round.
std::vector<int> turned(std::vector<int> corners) {
    for (size_t i = 0; i + 2 < corners.size(); i += 3)
        while (corners[i] > corners[i + 1] || corners[i] > corners[i + 2])
            std::rotate(corners.begin() + long(i), corners.begin() + long(i) + 1,
                        corners.begin() + long(i) + 3);
    return corners;
}

// [OpenGL 2.1 specification, section 2.6.1]
TEST_F(Immediate, PrimitivesAreTheTrianglesOfOpenGl) {
    const struct {
        GpPrimitive primitive;
        int vertices;
        std::vector<int> corners;
    } cases[] = {
        {GP_TRIANGLES, 6, {0, 1, 2, 3, 4, 5}},
        {GP_TRIANGLE_STRIP, 6, {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}},
        {GP_TRIANGLE_FAN, 5, {0, 1, 2, 0, 2, 3, 0, 3, 4}},
        {GP_QUADS, 8, {0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7}},
        {GP_QUAD_STRIP, 6, {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4}},
        {GP_POLYGON, 5, {0, 1, 2, 0, 2, 3, 0, 3, 4}},
    };
    for (const auto& c : cases) {
        gpClearImmediate(im);
        vertices(c.primitive, c.vertices);
        EXPECT_EQ(turned(corners()), c.corners) << "primitive " << c.primitive;
    }
}

// [OpenGL 2.1 specification, section 2.14.7]: counted from 1, vertex 3i of triangle i, i + 2 of
// strips and fans, 4i of quads, 2i + 2 of quad strips, 1 of polygons.
TEST_F(Immediate, FlatFacesHaveTheColourOfTheirProvokingVertex) {
    const struct {
        GpPrimitive primitive;
        int vertices;
        std::vector<int> provoking;  // of each triangle
    } cases[] = {
        {GP_TRIANGLES, 6, {2, 5}},           {GP_TRIANGLE_STRIP, 6, {2, 3, 4, 5}},
        {GP_TRIANGLE_FAN, 5, {2, 3, 4}},     {GP_QUADS, 8, {3, 3, 7, 7}},
        {GP_QUAD_STRIP, 6, {3, 3, 5, 5}},    {GP_POLYGON, 5, {0, 0, 0}},
    };
    for (const auto& c : cases) {
        gpClearImmediate(im);
        gpShadeModel(im, GP_SHADE_SMOOTH);
        vertices(c.primitive, c.vertices);
        const std::vector<int> smooth = corners();
        EXPECT_EQ(corners(true), smooth) << "smooth: every corner has its own colour";
        gpClearImmediate(im);
        gpShadeModel(im, GP_SHADE_FLAT);
        vertices(c.primitive, c.vertices);
        EXPECT_EQ(corners(), smooth) << "the same triangles";
        const std::vector<int> colors = corners(true);
        for (size_t i = 0; i < colors.size(); ++i)
            EXPECT_EQ(colors[i], c.provoking[i / 3]) << "primitive " << c.primitive;
    }
}

TEST_F(Immediate, IncompletePrimitivesAreLeftOut) {
    const std::array<int, 6> least = {3, 3, 3, 4, 4, 3};
    for (int p = 0; p < 6; ++p) {
        const auto primitive = anyEnum<GpPrimitive>(p);
        GpDrawDesc d{};
        gpClearImmediate(im);
        vertices(primitive, least[size_t(p)] - 1);
        EXPECT_EQ(gpGetImmediateDraw(im, &d), GP_ERROR_INVALID_OPERATION) << p;
        gpClearImmediate(im);
        vertices(primitive, least[size_t(p)]);
        EXPECT_EQ(gpGetImmediateDraw(im, &d), GP_SUCCESS) << p;
        const uint32_t one = d.indexCount;
        gpClearImmediate(im);
        vertices(primitive, least[size_t(p)] + 1);
        EXPECT_EQ(gpGetImmediateDraw(im, &d), GP_SUCCESS) << p;
        const bool grows = primitive == GP_TRIANGLE_STRIP || primitive == GP_TRIANGLE_FAN ||
                           primitive == GP_POLYGON;
        EXPECT_EQ(d.indexCount, grows ? one + 3 : one) << p;
    }
    gpGetError(device, nullptr);
}

TEST_F(Immediate, SeveralPrimitivesFollowEachOther) {
    vertices(GP_QUADS, 4);
    vertices(GP_TRIANGLES, 4);  // one vertex too many
    gpShadeModel(im, GP_SHADE_FLAT);
    vertices(GP_TRIANGLE_FAN, 4);
    EXPECT_EQ(turned(corners()),
              (std::vector<int>{0, 1, 3, 1, 2, 3, 0, 1, 2, 0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(corners(true), (std::vector<int>{0, 1, 3, 1, 2, 3, 0, 1, 2, 2, 2, 2, 3, 3, 3}));
}

TEST_F(Immediate, AttributesStayUntilTheyAreSetAgain) {
    gpBegin(im, GP_TRIANGLES);
    gpVertex3f(im, 0, 0, 0);
    gpNormal3f(im, 1, 0, 0);
    gpTexCoord2f(im, 0.25f, 0.75f);
    gpVertex3f(im, 1, 0, 0);
    gpVertex3f(im, 0, 1, 0);
    gpEnd(im);
    GpMeshDesc m{};
    m.id = 17;
    ASSERT_EQ(gpGetImmediateMesh(im, &m), GP_SUCCESS);
    EXPECT_EQ(m.id, 17u) << "other fields stay";
    EXPECT_EQ(m.vertexCount, 3u);
    EXPECT_EQ(m.indexCount, 3u);
    EXPECT_EQ(m.colors, nullptr) << "never set";
    const float* first = floats(m.normals, m.normalStride, 0);
    EXPECT_TRUE(first[0] == 0 && first[1] == 0 && first[2] == 1) << "the normal at first";
    for (uint32_t i = 1; i < 3; ++i) {
        EXPECT_EQ(floats(m.normals, m.normalStride, i)[0], 1);
        EXPECT_EQ(floats(m.texCoords[0], m.texCoordStride[0], i)[1], 0.75f);
    }
    // What is filled in is what gpNewMesh and gpDraw take.
    EXPECT_NE(gpNewMesh(device, &m), nullptr);
    GpDrawDesc d{};
    ASSERT_EQ(gpGetImmediateDraw(im, &d), GP_SUCCESS);
    const GpFrameDesc size = {4, 4, GP_MODE_REFERENCE};
    EXPECT_EQ(gpDraw(gpNewFrame(device, &size), &d), GP_SUCCESS);
}

}  // namespace
}  // namespace gp::test
