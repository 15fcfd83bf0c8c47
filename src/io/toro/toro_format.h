// SPDX-License-Identifier: BSD-3-Clause
// TORO's .graph format. Its lines look like the lines of a .g2o file, but have other tags.
#pragma once

#include "boxplus/io/file_format.h"
#include "boxplus/io/registry.h"

namespace boxplus {

FileFormat toro_format();

/// The tags with which files of TORO and of Gm2dl are written.
const Registry& toro_registry();
const Registry& gm2dl_registry();

/// Writes the poses and edges of a graph with these tags. The files have no place for parameters, so these
/// are left out (parameter_losses). Throws InvalidArgument if an edge uses a parameter, or if an element has
/// no tag.
void write_pose_graph(const GraphFileView& file, const Registry& tags, TextSink sink);
std::vector<std::string> parameter_losses(const GraphFileView& file);

}  // namespace boxplus
