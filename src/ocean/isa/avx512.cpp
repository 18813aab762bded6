#define GP_ISA_NAME "avx512"
#define GP_ISA_SYMBOL kernelsAvx512
#define GP_LANES 16
#include "ocean/isa/waves.inc"
