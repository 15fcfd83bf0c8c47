// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA baseline
#include "kernels/isa_table.h"
