// SPDX-License-Identifier: BSD-3-Clause
// boxplus completion SHELL: prints a script that lets the shell complete command lines of boxplus.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command.h"
#include "command_line/option_kinds.h"
#include "completion/completion_scripts.h"

namespace boxplus::app {
namespace {

using Script = std::string (*)(const CommandDescription&);

}  // namespace

void add_completion(CLI::App& app, Action& action) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Prints a script that lets a shell complete boxplus command lines");
  command->add_option("SHELL", *shell, "The shell")->required()->check(one_of({"bash", "zsh", "fish"}));
  command->footer(
      "Examples:\n"
      "  source <(boxplus completion bash)        # add this line to ~/.bashrc to keep it\n"
      "  source <(boxplus completion zsh)         # after compinit; add it to ~/.zshrc\n"
      "  boxplus completion fish | source");
  command->callback([&app, &action, shell] {
    action = [&app, shell] {
      const Script script = *shell == "bash"  ? bash_completion
                            : *shell == "zsh" ? zsh_completion
                                              : fish_completion;
      fmt::print("{}", script(describe(app)));
      return kSuccess;
    };
  });
}

}  // namespace boxplus::app
