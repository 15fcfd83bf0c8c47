// SPDX-License-Identifier: BSD-3-Clause
// Gm2dl: pose graphs in the plane with laser scans. Its lines look like those of TORO, with older names of
// the tags (VERTEX, EDGE), and have lines ROBOTLASER1 (io/data.h) behind their vertices.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat gm2dl_format();

}  // namespace boxplus
