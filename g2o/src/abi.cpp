// SPDX-License-Identifier: BSD-3-Clause
// This file is part of both libg2o_stuff and libg2o_core, because a client may link only one of the two
// libraries. The symbol is weak, because a client that links all members of both static libraries has two
// definitions of it.
#include "g2o/config.h"

extern "C" __attribute__((weak)) const char G2O_ABI_SYMBOL = 1;
