// SPDX-License-Identifier: BSD-3-Clause
// The commands that a page sends (PROTOCOL.md).
#pragma once

#include <string_view>

#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {

/// Carries out a command, which is a JSON object. Throws InvalidArgument if it is malformed, unknown or
/// refused.
void carry_out(std::string_view command, Workspace& workspace);

}  // namespace boxplus::viewer
