// SPDX-License-Identifier: BSD-3-Clause
// In libg2o_stuff and in libg2o_core, which clients may link alone; weak, because some link all members of
// both.
#include "g2o/config.h"

extern "C" __attribute__((weak)) const char G2O_ABI_SYMBOL = 1;
