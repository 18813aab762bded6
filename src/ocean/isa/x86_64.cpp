#define GP_ISA_NAME "x86-64"
#define GP_ISA_SYMBOL kernelsX86_64
#define GP_LANES 4
#include "ocean/isa/waves.inc"
