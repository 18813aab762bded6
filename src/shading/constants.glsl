// Numbers that more than one file needs. Macros, because a constant at namespace scope would become
// a data member where kernels are included inside a C++ struct.
#ifndef GP_SHADING_CONSTANTS_GLSL
#define GP_SHADING_CONSTANTS_GLSL

#define PI 3.14159265358979323846f
#define TWO_PI 6.28318530717958647692f
#define FOUR_PI 12.5663706143591729538f
#define HALF_PI 1.57079632679489661923f
#define INV_PI 0.318309886183790671538f
#define INV_TWO_PI 0.159154943091895335769f
#define INV_FOUR_PI 0.0795774715459476678844f
#define SQRT_TWO 1.41421356237309504880f

// The largest float below 1: what a uniform variate in [0, 1) may reach.
#define ONE_MINUS_EPSILON 0.999999940395355224609f
// The largest finite float; also the t_max of a ray without an end.
#define FLOAT_MAX 3.402823466e38f

// 2^-24 and 2^-32: an integer of as many bits becomes a float in [0, 1) or [0, 1].
#define EXP2_MINUS_24 5.9604644775390625e-8f
#define EXP2_MINUS_32 2.3283064365386962890625e-10f

#endif
