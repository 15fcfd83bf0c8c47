// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA avx2
#include "kernels/isa_table.h"
