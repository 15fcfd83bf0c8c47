// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/config.h"

#define G2O_TYPES_SBA_API G2O_API_EXPORT
