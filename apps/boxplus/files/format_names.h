// SPDX-License-Identifier: BSD-3-Clause
// Lists of file formats for help texts and messages.
#pragma once

#include <string>
#include <vector>

namespace boxplus::app {

/// Returns the formats that boxplus can read: ".g2o, TORO's .graph, …".
std::string readable_formats();

/// Returns the help text of an argument that is the file name of a graph.
std::string graph_to_read();

/// Returns the formats that boxplus can write: ".g2o, BAL's .bal, … or .ply".
std::string writable_formats();

/// Returns the names of the formats that boxplus can write, in lower case: "g2o", "bal", …. Each can be
/// changed to the name in default_formats() by format_name().
std::vector<std::string> writable_names();
std::string format_name(const std::string& in_lower_case);

/// Throws InvalidArgument if `path` has the extension of a format that boxplus can read but not write.
void require_writable_format(const std::string& path);

}  // namespace boxplus::app
