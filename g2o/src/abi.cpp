// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/config.h"

extern "C" const char G2O_ABI_SYMBOL = 1;
