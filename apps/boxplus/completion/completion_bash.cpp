// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion/completion_scripts.h"

namespace boxplus::app {
namespace {

/// The words that may follow this command: sub-commands, options, and the choices of positional arguments.
std::vector<std::string> words_of(const CommandDescription& command) {
  std::vector<std::string> words;
  for (const CommandDescription& sub : command.commands) words.push_back(sub.name);
  for (const OptionDescription& option : command.options) {
    const auto& more = option.positional ? option.choices : option.names;
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

/// One branch per option that takes a value: completes its choices, files, or nothing (a number).
std::string value_branches(const CommandDescription& command) {
  std::string text;
  for (const OptionDescription& option : command.options) {
    if (option.positional || option.value.empty()) continue;
    std::string patterns;
    for (const std::string& name : option.names)
      patterns += fmt::format("{}{}:{}", patterns.empty() ? "" : "|", command.name, name);
    if (!option.choices.empty()) {
      text += fmt::format("    {}) words='{}' ;;\n", patterns, fmt::join(option.choices, " "));
    } else if (option.value == "FILE" || option.value == "TEXT") {
      text += fmt::format("    {}) compopt -o default 2>/dev/null || true; return ;;\n", patterns);
    } else {
      text += fmt::format("    {}) return ;;\n", patterns);
    }
  }
  return text;
}

std::string word_branches(const CommandDescription& root) {
  std::string text = fmt::format("      '') words='{}' ;;\n", fmt::join(words_of(root), " "));
  for (const CommandDescription& command : root.commands)
    text += fmt::format("      {}) words='{}' ;;\n", command.name, fmt::join(words_of(command), " "));
  return text;
}

constexpr const char* kScript = R"(# bash completion of boxplus; made by `boxplus completion bash`.
_boxplus() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command='' word words=''
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $previous == '=' ]]; then
    previous=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $word in
      {}) command=$word; break ;;
    esac
  done
  COMPREPLY=()
  case $command:$previous in
{}    *)
      case $command in
{}      esac
      if [[ $current != -* && -n $command ]]; then
        local plain='' each
        for each in $words; do [[ $each == -* ]] || plain+=" $each"; done
        words=$plain
        if [[ -z $words ]]; then compopt -o default 2>/dev/null || true; return; fi
      fi ;;
  esac
  while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -W "$words" -- "$current")
}}
complete -F _boxplus boxplus
)";

}  // namespace

std::string bash_completion(const CommandDescription& root) {
  std::vector<std::string> names;
  std::string values;
  for (const CommandDescription& command : root.commands) {
    names.push_back(command.name);
    values += value_branches(command);
  }
  return fmt::format(kScript, fmt::join(names, "|"), values, word_branches(root));
}

}  // namespace boxplus::app
