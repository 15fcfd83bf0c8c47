// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA avx512
#include "kernels/isa_table.h"
