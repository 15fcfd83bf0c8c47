// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/man_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace boxplus::app {
namespace {

/// Escapes the text of one line. A hyphen without a backslash is printed as a typographic one, which cannot
/// be copied to a command line.
std::string escaped(const std::string& text) {
  std::string result;
  if (text.starts_with('.') || text.starts_with('\'')) result = "\\&";
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

/// Text whose lines stay as they are.
std::string preformatted(const std::string& text) {
  std::string result = ".PP\n.nf\n";
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += escaped(text.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return result + ".fi\n";
}

std::string options_of(const CommandDescription& command) {
  std::string text;
  for_each_group(command, [&](const std::string& title, const std::vector<OptionDescription>& options) {
    text += fmt::format(".PP\n.B {}\n", escaped(title));
    for (const OptionDescription& option : options)
      text += fmt::format(".TP\n.B {}\n{}\n", escaped(signature(option)), escaped(explanation(option)));
  });
  return text;
}

}  // namespace

std::string man_page(const CommandDescription& root) {
  std::string text = fmt::format(
      ".TH BOXPLUS 1 \"\" \"boxplus {}\" \"User Commands\"\n"
      ".SH NAME\n{} \\- {}\n"
      ".SH SYNOPSIS\n.B {}\n"
      ".SH DESCRIPTION\n{}.\n",
      BOXPLUS_VERSION, root.name, escaped(root.text), escaped(root.usage), escaped(root.text));
  text += options_of(root);
  if (!root.footer.empty()) text += preformatted(root.footer);
  text += ".SH COMMANDS\n";
  for (const CommandDescription& command : root.commands) {
    text += fmt::format(".SS {} {}\n{}.\n.PP\n.B {}\n", root.name, command.name, escaped(command.text),
                        escaped(command.usage));
    text += options_of(command);
    if (!command.footer.empty()) text += preformatted(command.footer);
  }
  return text;
}

}  // namespace boxplus::app
