// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/help_format.h"

#include <fmt/format.h>

#include "command_line/description.h"
#include "command_line/table.h"

namespace boxplus::app {
namespace {

constexpr std::size_t kWidth = 100, kIndent = 31;

/// Breaks `text` into lines between words. All lines after the first one begin with kIndent blanks.
std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t column = kIndent;
  for (const std::string& word : CLI::detail::split(text, ' ')) {
    if (column > kIndent && column + 1 + shown_width(word) > kWidth) {
      result += "\n" + std::string(kIndent, ' ');
      column = kIndent;
    }
    if (column > kIndent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += shown_width(word);
  }
  return result;
}

/// Returns "  left       right". If the left side is too long, the right side starts on a new line.
std::string entry(const std::string& left, const std::string& right) {
  const std::size_t used = 2 + shown_width(left);
  const std::string gap =
      used < kIndent ? std::string(kIndent - used, ' ') : "\n" + std::string(kIndent, ' ');
  return fmt::format("  {}{}{}\n", left, gap, wrapped(right));
}

}  // namespace

std::string HelpFormat::make_help(const CLI::App* app, std::string /*name*/,
                                  CLI::AppFormatMode /*mode*/) const {
  const CommandDescription command = describe(*app);
  std::string help = fmt::format("{}\n\nUsage: {}\n", command.text, command.usage);
  if (!command.commands.empty()) help += "\nCommands:\n";
  for (const CommandDescription& sub : command.commands) help += entry(sub.name, sub.text);
  for_each_group(command, [&](const std::string& title, const std::vector<OptionDescription>& options) {
    help += fmt::format("\n{}:\n", title);
    for (const OptionDescription& option : options) help += entry(signature(option), explanation(option));
  });
  if (!command.footer.empty()) help += fmt::format("\n{}\n", command.footer);
  return help;
}

}  // namespace boxplus::app
