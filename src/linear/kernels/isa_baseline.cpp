// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA baseline
#include "linear/kernels/isa_table.h"
