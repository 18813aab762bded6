#define GP_ISA_NAME "x86-64"
#define GP_ISA_SYMBOL kernelsX86_64
#include "backend/cpu/isa/isa.inc"
