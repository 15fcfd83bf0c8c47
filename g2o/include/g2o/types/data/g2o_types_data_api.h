// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_G2O_TYPES_DATA_API_H
#define G2O_G2O_TYPES_DATA_API_H
#ifndef G2O_TYPES_DATA_API_H
#define G2O_TYPES_DATA_API_H

#include "g2o/config.h"

#define G2O_TYPES_DATA_API G2O_API_EXPORT

#endif  // G2O_TYPES_DATA_API_H

#endif  // G2O_G2O_TYPES_DATA_API_H
