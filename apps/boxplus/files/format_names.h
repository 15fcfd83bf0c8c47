// SPDX-License-Identifier: BSD-3-Clause
// File formats, as help texts and messages list them.
#pragma once

#include <string>

namespace boxplus::app {

/// ".g2o, TORO's .graph": the formats that can be read.
std::string readable_formats();

/// The help text of an argument that names a graph.
std::string graph_to_read();

/// ".g2o": the formats that can be written.
std::string writable_formats();

/// Throws InvalidArgument if a path has the extension of a read-only format.
void require_writable_format(const std::string& path);

}  // namespace boxplus::app
