#define GP_ISA_SYMBOL kernelsAvx512
#include "backend/cpu/isa/denoise.inc"
