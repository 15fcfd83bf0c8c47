// SPDX-License-Identifier: BSD-3-Clause
// The commands that a page sends (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "settings/run_settings.h"
#include "viewer/workspace/edits.h"

namespace boxplus::viewer {

struct Command {
  enum class Kind : std::uint8_t {
    kOptimize,
    kStep,
    kGuess,
    kEdit,
    kRemoveFalseEdges,
    kCovariances,
    kReset,
    kStop
  };
  Kind kind;
  Settings settings = {};       ///< of kOptimize and kStep
  std::string start = {};       ///< of kGuess
  std::uint64_t structure = 0;  ///< of kEdit: the number of the structure that the page shows
  Edit edit = {};               ///< of kEdit
};

/// Reads a command, which is a JSON object. Throws InvalidArgument if it is malformed or unknown. The values
/// of settings are not checked.
Command parse_command(std::string_view text);

}  // namespace boxplus::viewer
