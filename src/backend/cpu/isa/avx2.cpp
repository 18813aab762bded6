#define GP_ISA_NAME "avx2"
#define GP_ISA_SYMBOL kernelsAvx2
#include "backend/cpu/isa/isa.inc"
