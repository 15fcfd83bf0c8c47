// SPDX-License-Identifier: BSD-3-Clause
// Lists of file formats for help texts and messages.
#pragma once

#include <string>

namespace boxplus::app {

/// Returns the formats that boxplus can read: ".g2o, TORO's .graph, BAL's .bal".
std::string readable_formats();

/// Returns the help text of an argument that is the file name of a graph.
std::string graph_to_read();

/// Returns the formats that boxplus can write: ".g2o or BAL's .bal".
std::string writable_formats();

/// Throws InvalidArgument if `path` has the extension of a format that boxplus can read but not write.
void require_writable_format(const std::string& path);

}  // namespace boxplus::app
