// SPDX-License-Identifier: BSD-3-Clause
// Formats the output of --help: 100 columns wide, with one section for each group of options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

class HelpFormat final : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace boxplus::app
