// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA avx512
#include "types/ba/reproject.h"
