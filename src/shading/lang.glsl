// The GLSL side of the shading language (the C++ side is lang.h). Included first by every shader.
#ifndef GP_LANG_GLSL
#define GP_LANG_GLSL
#define IN(T) in T
#define INOUT(T) inout T
#define LET_REF(T) T
#define OUT_OF_LINE
#define IN_LOOPS
#define CONST_TABLE const

// Numbers in memory, see lang.h. A compiler without buffer references (WebGL's) has no tables.
#ifdef GL_EXT_buffer_reference_uvec2
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer TableWords {
    float words[];
};
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer TableUints {
    uint words[];
};
bool table_exists(uvec2 table) { return (table.x | table.y) != 0u; }
float table_float(uvec2 table, uint index) { return TableWords(table).words[index]; }
uvec2 table_uint2(uvec2 table, uint index) {
    return uvec2(TableUints(table).words[index], TableUints(table).words[index + 1u]);
}
#else
bool table_exists(uvec2 table) { return false; }
float table_float(uvec2 table, uint index) { return 0.0f; }
uvec2 table_uint2(uvec2 table, uint index) { return uvec2(0u); }
#endif
#endif
