// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA neon
#define BOXPLUS_NEON
#include "kernels/isa_table.h"
