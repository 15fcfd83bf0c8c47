// SPDX-License-Identifier: BSD-3-Clause
// TORO's .graph format. Its lines look like the lines of a .g2o file, but have other tags. The format is
// read-only.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat toro_format();

}  // namespace boxplus
