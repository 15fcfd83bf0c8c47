// SPDX-License-Identifier: BSD-3-Clause
// This file is part of both libg2o_stuff and libg2o_core, because a client may link only one of the two
// libraries. The symbol is weak, because some clients link all members of both static libraries.
#include "g2o/config.h"

extern "C" __attribute__((weak)) const char G2O_ABI_SYMBOL = 1;
