#define GP_ISA_NAME "avx2"
#define GP_ISA_SYMBOL kernelsAvx2
#define GP_LANES 8
#include "ocean/isa/waves.inc"
