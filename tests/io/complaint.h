// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {

/// The message of the exception that parse_graph() throws for a bad text.
inline std::string complaint(const std::string& text) {
  try {
    parse_graph(text, "g");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

}  // namespace boxplus
