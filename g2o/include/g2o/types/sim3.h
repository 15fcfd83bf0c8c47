// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in sim3/, because older clients include this path.
#pragma once

#include "g2o/types/sim3/sim3.h"
