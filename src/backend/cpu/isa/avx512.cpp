#define GP_ISA_NAME "avx512"
#define GP_ISA_SYMBOL kernelsAvx512
#include "backend/cpu/isa/isa.inc"
