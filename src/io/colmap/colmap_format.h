// SPDX-License-Identifier: BSD-3-Clause
// The sparse models of COLMAP (Schönberger and Frahm, "Structure-from-motion revisited", 2016): folders with
// cameras, images and points3D as .bin or .txt, as documented at https://colmap.github.io/format.html. If a
// folder has both, the binary files are read, as in COLMAP.
#pragma once

#include <string>

#include "boxplus/io/file_format.h"
#include "boxplus/io/sparse_model.h"

namespace boxplus {

FileFormat colmap_format();
FileFormat colmap_text_format();

/// The model in a folder that one of these formats recognizes. Throws what read_graph() throws.
SparseModel read_colmap(const std::string& folder);

}  // namespace boxplus
