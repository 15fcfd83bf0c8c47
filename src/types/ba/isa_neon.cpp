// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA neon
#define BOXPLUS_NEON
#include "types/ba/reproject.h"
