// SPDX-License-Identifier: BSD-3-Clause
#define BOXPLUS_ISA baseline
#include "types/ba/reproject.h"
