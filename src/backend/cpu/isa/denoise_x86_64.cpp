#define GP_ISA_SYMBOL kernelsX86_64
#include "backend/cpu/isa/denoise.inc"
