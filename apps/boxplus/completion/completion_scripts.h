// SPDX-License-Identifier: BSD-3-Clause
// Generates one script per shell. Each script completes command lines of boxplus.
#pragma once

#include <string>

#include "command_line/description.h"

namespace boxplus::app {

std::string bash_completion(const CommandDescription& root);
std::string zsh_completion(const CommandDescription& root);
std::string fish_completion(const CommandDescription& root);

}  // namespace boxplus::app
