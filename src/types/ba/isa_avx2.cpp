// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA avx2
#include "types/ba/reproject.h"
