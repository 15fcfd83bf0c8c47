// SPDX-License-Identifier: BSD-3-Clause
// File formats, as help texts and messages list them.
#pragma once

#include <string>

namespace boxplus::app {

/// ".g2o, TORO's .graph": the formats that can be read.
std::string readable_formats();

/// The help text of an argument that names a graph.
std::string graph_to_read();

/// ".g2o": those that can be written.
std::string writable_formats();

/// Throws InvalidArgument if the ending of a path is that of a format that is only read.
void require_writable_format(const std::string& path);

}  // namespace boxplus::app
