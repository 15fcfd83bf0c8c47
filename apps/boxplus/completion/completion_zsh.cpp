// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion/completion_scripts.h"

namespace boxplus::app {
namespace {

/// Quotes text for a specification of zsh's _arguments that is written in single quotes.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      if (c == ':' || c == '[' || c == ']' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result;
}

/// The completion of a value: its choices, files, or nothing.
std::string action_of(const OptionDescription& option) {
  if (!option.choices.empty()) {
    std::vector<std::string> words;
    for (const std::string& choice : option.choices) words.push_back(quoted(choice));
    return fmt::format("({})", fmt::join(words, " "));
  }
  const bool is_file = option.positional || option.value == "FILE" || option.value == "TEXT";
  return is_file ? "_files" : " ";
}

std::string specifications(const CommandDescription& command) {
  std::string text;
  for (const OptionDescription& option : command.options) {
    if (option.positional) {
      text += fmt::format(" \\\n        '{}:{}:{}'", option.required ? "" : ":", quoted(option.names[0]),
                          action_of(option));
      continue;
    }
    for (const std::string& name : option.names) {
      text += fmt::format(" \\\n        '{}[{}]", name, quoted(option.text));
      text += option.value.empty() ? "'" : fmt::format(":{}:{}'", quoted(option.value), action_of(option));
    }
  }
  return text;
}

constexpr const char* kScript = R"(#compdef boxplus
# zsh completion of boxplus; made by `boxplus completion zsh`.
_boxplus() {{
  local context state line
  _arguments -C{} '1: :->command' '*:: :->rest'
  case $state in
  command)
    local -a commands=({})
    _describe -t commands command commands ;;
  rest)
    case $line[1] in
{}    esac ;;
  esac
}}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _boxplus "$@"; else compdef _boxplus boxplus; fi
)";

}  // namespace

std::string zsh_completion(const CommandDescription& root) {
  std::string commands, branches;
  for (const CommandDescription& command : root.commands) {
    commands += fmt::format("\n      '{}:{}'", command.name, quoted(command.text));
    branches += fmt::format("      {}) _arguments{} ;;\n", command.name, specifications(command));
  }
  return fmt::format(kScript, specifications(root), commands, branches);
}

}  // namespace boxplus::app
