#define GP_ISA_SYMBOL kernelsAvx2
#include "backend/cpu/isa/denoise.inc"
