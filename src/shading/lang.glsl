// The GLSL side of the shading language (the C++ side is lang.h). Included first by every shader.
#ifndef GP_LANG_GLSL
#define GP_LANG_GLSL
#define IN(T) in T
#define INOUT(T) inout T
#define LET_REF(T) T
#define OUT_OF_LINE
#define CONST_TABLE const
#endif
