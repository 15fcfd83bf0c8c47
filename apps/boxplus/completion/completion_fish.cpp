// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion/completion_scripts.h"

namespace boxplus::app {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string option_line(const std::string& condition, const OptionDescription& option) {
  std::string line = "complete -c boxplus" + condition;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.choices.empty()) {
    line += " -x -a " + quoted(fmt::format("{}", fmt::join(option.choices, " ")));
  } else if (option.value == "FILE" || option.value == "TEXT") {
    line += " -r -F";
  } else if (!option.value.empty()) {
    line += " -x";
  }
  return line + " -d " + quoted(option.text) + "\n";
}

std::string option_lines(const std::string& condition, const CommandDescription& command) {
  std::string text;
  for (const OptionDescription& option : command.options) {
    if (!option.positional) {
      text += option_line(condition, option);
    } else if (!option.choices.empty()) {
      text += fmt::format("complete -c boxplus{} -f -a {}\n", condition,
                          quoted(fmt::format("{}", fmt::join(option.choices, " "))));
    }
  }
  return text;
}

}  // namespace

std::string fish_completion(const CommandDescription& root) {
  std::string text =
      "# fish completion of boxplus; made by `boxplus completion fish`.\ncomplete -c boxplus -e\n";
  for (const CommandDescription& command : root.commands) {
    text += fmt::format("complete -c boxplus -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.text));
  }
  text += option_lines(" -n __fish_use_subcommand", root);
  for (const CommandDescription& command : root.commands)
    text += option_lines(" -n '__fish_seen_subcommand_from " + command.name + "'", command);
  return text;
}

}  // namespace boxplus::app
