// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/commands.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "boxplus/base/error.h"
#include "viewer/server/element_request.h"
#include "viewer/settings/parse_number.h"
#include "viewer/settings/run_settings.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

/// Reads the settings of a command, whose values are texts.
Settings settings_of(const Json& command) {
  Settings settings;
  const auto found = command.find("settings");
  if (found == command.end()) return settings;
  if (!found->is_object()) throw InvalidArgument("settings: expected an object");
  for (const auto& item : found->items()) {
    if (!item.value().is_string()) throw InvalidArgument(fmt::format("{}: expected a text", item.key()));
    settings.emplace(item.key(), item.value().get<std::string>());
  }
  return settings;
}

std::string start_of(const Json& command) {
  const auto start = command.find("start");
  if (start == command.end() || !start->is_string())
    throw InvalidArgument("expected the name of an initial guess");
  return start->get<std::string>();
}

/// Carries out an edit, all of whose members are texts.
void carry_out_edit(Workspace& workspace, const Json& command) {
  Parameters members;
  for (const auto& item : command.items()) {
    if (item.value().is_string()) members.emplace(item.key(), item.value().get<std::string>());
  }
  const ElementRequest request = parse_element_request(members);
  const auto text = [&](const char* name) {
    const auto found = members.find(name);
    return found == members.end() ? std::string() : found->second;
  };
  Edit edit{.kind = edit_kind(text("edit")), .element = request.name};
  if (edit.kind == Edit::Kind::kScale) {
    if (!parse_number(text("factor"), edit.factor)) throw InvalidArgument("factor: expected a number");
  }
  workspace.edit(request.structure, edit);
}

struct Command {
  std::string_view type;
  void (*carry_out)(Workspace&, const Json&);
};

constexpr std::array kCommands{
    Command{"optimize",
            [](Workspace& workspace, const Json& command) { workspace.optimize(settings_of(command)); }},
    Command{"step", [](Workspace& workspace, const Json& command) { workspace.step(settings_of(command)); }},
    Command{"guess", [](Workspace& workspace, const Json& command) { workspace.guess(start_of(command)); }},
    Command{"edit", carry_out_edit},
    Command{"covariances", [](Workspace& workspace, const Json&) { workspace.covariances(); }},
    Command{"reset", [](Workspace& workspace, const Json&) { workspace.reset(); }},
    Command{"stop", [](Workspace& workspace, const Json&) { workspace.stop(); }},
};

/// Deeply nested arrays would exhaust the stack of a parser that calls itself; no command is nested.
bool is_flat(std::string_view text) {
  constexpr int kDeepest = 8;
  int depth = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
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
  throw InvalidArgument("the command is unknown");
}

}  // namespace boxplus::viewer
