// Makes one table of differential/*.def a translation unit. CMake generates a file per table that
// defines GP_TABLE_NAME and GP_TABLE_FILE and includes this.
#include "shading/shading.h"

#include "shading/differential.h"

GP_SHADING_BEGIN

float in_f(int k) { return gp::test::readFloat(k); }
uint in_u(int k) { return gp::test::readUint(k); }
vec2 in_v2(int k) { return vec2(in_f(k), in_f(k + 1)); }
vec3 in_v3(int k) { return vec3(in_f(k), in_f(k + 1), in_f(k + 2)); }
vec4 in_v4(int k) { return vec4(in_f(k), in_f(k + 1), in_f(k + 2), in_f(k + 3)); }
uvec2 in_table() { return gp::test::tableAddress(); }
uvec2 in_glints() { return gp::test::glintAddress(); }
void put_u(int k, uint v) { gp::test::writeUint(k, v); }
void put_f(int k, float v) { gp::test::writeFloats(k, &v, 1); }
void put_v2(int k, vec2 v) { gp::test::writeFloats(k, &v.x, 2); }
void put_v3(int k, vec3 v) { gp::test::writeFloats(k, &v.x, 3); }
void put_v4(int k, vec4 v) { gp::test::writeFloats(k, &v.x, 4); }

#define DIFF(name, domain, tolerance, ...) void diff_##name() __VA_ARGS__
#include GP_TABLE_FILE
#undef DIFF

using gp::test::exactly;
using gp::test::within;
const gp::test::DifferentialRow diffRows[] = {
#define DIFF(name, domain, tolerance, ...) {#name, domain, tolerance, diff_##name, #__VA_ARGS__},
#include GP_TABLE_FILE
#undef DIFF
};
[[maybe_unused]] const bool diffRegistered = gp::test::registerTable(
    {GP_TABLE_NAME, diffRows, sizeof(diffRows) / sizeof(diffRows[0])});

GP_SHADING_END
