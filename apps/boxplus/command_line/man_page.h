// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "command_line/description.h"

namespace boxplus::app {

/// The manual page of the whole command (section 1), for man: see man(7) for the language.
std::string man_page(const CommandDescription& root);

}  // namespace boxplus::app
