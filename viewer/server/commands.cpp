// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/commands.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

int iterations_of(const Json& command) {
  constexpr int kDefault = 100;
  const auto found = command.find("iterations");
  if (found == command.end()) return kDefault;
  if (!found->is_number_integer())
    throw InvalidArgument(fmt::format("iterations: expected a whole number, got {}", found->type_name()));
  const auto number = found->get<std::int64_t>();
  // optimize() refuses numbers outside of its range.
  return number >= 0 && number <= Workspace::kMostIterations ? static_cast<int>(number) : -1;
}

struct Command {
  std::string_view type;
  void (*carry_out)(Workspace&, const Json&);
};

constexpr std::array kCommands{
    Command{"optimize",
            [](Workspace& workspace, const Json& command) { workspace.optimize(iterations_of(command)); }},
    Command{"step", [](Workspace& workspace, const Json&) { workspace.step(); }},
    Command{"stop", [](Workspace& workspace, const Json&) { workspace.stop(); }},
    Command{"reset", [](Workspace& workspace, const Json&) { workspace.reset(); }},
};

/// Deeply nested arrays would exhaust the stack of a parser that calls itself; no command is nested.
bool is_flat(std::string_view text) {
  constexpr int kDeepest = 8;
  int depth = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kDeepest) return false;
  }
  return true;
}

}  // namespace

void carry_out(std::string_view text, Workspace& workspace) {
  const Json command = is_flat(text) ? Json::parse(text, nullptr, false) : Json(Json::value_t::discarded);
  if (!command.is_object()) throw InvalidArgument("expected a command as a JSON object");
  const auto type = command.find("type");
  if (type == command.end() || !type->is_string())
    throw InvalidArgument("expected a command with a \"type\"");
  for (const Command& known : kCommands) {
    if (type->get_ref<const std::string&>() != known.type) continue;
    known.carry_out(workspace, command);
    return;
  }
  throw InvalidArgument("expected a command \"optimize\", \"step\", \"stop\" or \"reset\", got another one");
}

}  // namespace boxplus::viewer
