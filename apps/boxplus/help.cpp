// SPDX-License-Identifier: BSD-3-Clause
// boxplus help [COMMAND]: the help texts, or all of them as docs/cli.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command.h"
#include "command_line/description.h"
#include "command_line/option_kinds.h"

namespace boxplus::app {
namespace {

struct HelpArguments {
  std::string command;
  bool markdown = false;
};

/// Escapes bars, which would end a cell of a table.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string markdown_of_options(const CommandDescription& command) {
  std::string text;
  for_each_group(command, [&](const std::string& title, const std::vector<OptionDescription>& options) {
    text += fmt::format("\n| {} | |\n|---|---|\n", title);
    for (const OptionDescription& option : options)
      text += fmt::format("| `{}` | {} |\n", cell(signature(option)), cell(explanation(option)));
  });
  return text;
}

std::string markdown_of_footer(const CommandDescription& command) {
  if (command.footer.empty()) return {};
  return fmt::format("\n```text\n{}\n```\n", command.footer);
}

std::string markdown_of(const CommandDescription& root) {
  std::string text = fmt::format(
      "# The `{}` command\n\n"
      "<!-- Made by `boxplus help --markdown`: do not edit. -->\n\n"
      "{}.\n\n    {}\n\n| Command | |\n|---|---|\n",
      root.name, root.text, root.usage);
  for (const CommandDescription& command : root.commands)
    text += fmt::format("| [`{0}`](#boxplus-{0}) | {1} |\n", command.name, cell(command.text));
  text += markdown_of_options(root) + markdown_of_footer(root);
  for (const CommandDescription& command : root.commands) {
    text += fmt::format("\n## boxplus {}\n\n{}.\n\n    {}\n", command.name, command.text, command.usage);
    text += markdown_of_options(command) + markdown_of_footer(command);
  }
  return text;
}

int print_help(const CLI::App& root, const HelpArguments& arguments) {
  if (arguments.markdown) {
    fmt::print("{}", markdown_of(describe(root)));
  } else {
    const CLI::App* chosen = arguments.command.empty() ? &root : root.get_subcommand(arguments.command);
    fmt::print("{}", chosen->get_formatter()->make_help(chosen, "", CLI::AppFormatMode::Normal));
  }
  return kSuccess;
}

}  // namespace

void add_help(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<HelpArguments>();
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  CLI::App* command = app.add_subcommand("help", "Shows the help of a command");
  command->add_option("COMMAND", arguments->command, "The command")->check(one_of(names));
  command->add_flag("--markdown", arguments->markdown, "All help texts as Markdown: docs/cli.md");
  command->footer("Example:\n  boxplus help optimize");
  command->callback(
      [&app, &action, arguments] { action = [&app, arguments] { return print_help(app, *arguments); }; });
}

}  // namespace boxplus::app
