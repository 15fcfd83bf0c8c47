// SPDX-License-Identifier: BSD-3-Clause
// The look of --help: 100 columns, one group of options after the other.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

class HelpFormat final : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace boxplus::app
