// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/abi.h"

extern "C" const char BOXPLUS_ABI_SYMBOL = 1;
