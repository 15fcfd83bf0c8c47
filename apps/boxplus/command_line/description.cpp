// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace boxplus::app {
namespace {

/// Returns the values in a text such as "TEXT:{a,b,c}", the form in which validators describe their choices.
/// Returns nothing if the text has no braces.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

/// The placeholder for an option's value in help texts. Empty for flags, which take no value, and for
/// positional arguments, whose own name is the placeholder.
std::string value_of(const CLI::Option& option, const std::vector<std::string>& choices) {
  if (option.get_items_expected_max() == 0 || option.get_positional()) return {};
  if (!choices.empty()) return "NAME";
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

OptionDescription describe(const CLI::Option& option) {
  OptionDescription result;
  result.positional = option.get_positional();
  result.required = option.get_required();
  if (result.positional) {
    result.names.push_back(option.get_name(true));
  } else {
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  }
  result.choices = choices_in(option.get_type_name());
  result.value = value_of(option, result.choices);
  result.text = option.get_description();
  result.default_text = option.get_default_str();
  result.group = option.get_group();
  return result;
}

/// Returns the usage line, such as "boxplus optimize [OPTIONS] FILE".
std::string usage_of(const CLI::App& app, const CommandDescription& command) {
  std::string usage = command.name;
  for (const CLI::App* parent = app.get_parent(); parent; parent = parent->get_parent())
    usage.insert(0, parent->get_name() + " ");
  if (!command.commands.empty()) usage += " COMMAND";
  usage += command.commands.empty() ? " [OPTIONS]" : " …";
  for (const OptionDescription& option : command.options) {
    if (option.positional) usage += option.required ? " " + option.names[0] : " [" + option.names[0] + "]";
  }
  return usage;
}

}  // namespace

CommandDescription describe(const CLI::App& app) {
  CommandDescription result;
  result.name = app.get_name();
  result.text = app.get_description();
  result.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) result.options.push_back(describe(*option));
  }
  // CLI11 lists --help first, but users look for it at the end.
  std::stable_partition(result.options.begin(), result.options.end(),
                        [](const OptionDescription& option) { return option.names.back() != "--help"; });
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    result.commands.push_back(describe(*command));
  result.usage = usage_of(app, result);
  return result;
}

std::string signature(const OptionDescription& option) {
  const std::string names = fmt::format("{}", fmt::join(option.names, ", "));
  return option.value.empty() ? names : names + " " + option.value;
}

std::string explanation(const OptionDescription& option) {
  std::vector<std::string> details;
  if (!option.choices.empty()) details.push_back(fmt::format("one of {}", fmt::join(option.choices, ", ")));
  if (!option.default_text.empty()) details.push_back("default: " + option.default_text);
  if (option.required && !option.positional) details.emplace_back("required");
  if (details.empty()) return option.text;
  return fmt::format("{} ({})", option.text, fmt::join(details, "; "));
}

}  // namespace boxplus::app
