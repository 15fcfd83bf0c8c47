// SPDX-License-Identifier: BSD-3-Clause
// A description of the command line as data. Help texts, docs/cli.md and shell completions are generated from
// it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace boxplus::app {

struct OptionDescription {
  std::vector<std::string> names;  ///< such as "-o" and "--output"; a positional argument has one name
  std::string value;  ///< the placeholder for the value, such as FILE; empty if there is no placeholder
  std::vector<std::string> choices;  ///< the allowed values, if they can be listed
  std::string text, default_text, group;
  bool positional = false, required = false;
};

struct CommandDescription {
  std::string name, text, usage;
  std::string footer;  ///< the text at the end of the help, such as examples and exit codes
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
};

CommandDescription describe(const CLI::App& app);

/// Returns the names and the placeholder of an option, such as "-o, --output FILE".
std::string signature(const OptionDescription& option);
/// Returns the text of an option, followed by its choices and its default if there are any.
std::string explanation(const OptionDescription& option);

/// Calls f(title, options) for the arguments and for each group of options, in order.
template <class F>
void for_each_group(const CommandDescription& command, F&& f) {
  std::vector<std::string> titles;
  std::vector<std::vector<OptionDescription>> groups;
  for (const OptionDescription& option : command.options) {
    const std::string title = option.positional ? "Arguments" : option.group;
    std::size_t k = 0;
    while (k < titles.size() && titles[k] != title) ++k;
    if (k == titles.size()) {
      titles.push_back(title);
      groups.emplace_back();
    }
    groups[k].push_back(option);
  }
  for (std::size_t k = 0; k < titles.size(); ++k) f(titles[k], groups[k]);
}

}  // namespace boxplus::app
