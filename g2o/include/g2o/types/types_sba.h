// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in sba/, because older clients include this path.
#pragma once

#include "g2o/types/sba/types_sba.h"
