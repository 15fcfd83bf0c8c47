// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "boxplus/base/error.h"
#include "settings/parse_number.h"
#include "viewer/server/element_request.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;
template <class Kind>
using Named = std::pair<std::string_view, Kind>;

constexpr std::array kCommands{Named<Command::Kind>{"optimize", Command::Kind::kOptimize},
                               Named<Command::Kind>{"step", Command::Kind::kStep},
                               Named<Command::Kind>{"guess", Command::Kind::kGuess},
                               Named<Command::Kind>{"edit", Command::Kind::kEdit},
                               Named<Command::Kind>{"remove_false_edges", Command::Kind::kRemoveFalseEdges},
                               Named<Command::Kind>{"covariances", Command::Kind::kCovariances},
                               Named<Command::Kind>{"reset", Command::Kind::kReset},
                               Named<Command::Kind>{"stop", Command::Kind::kStop}};

constexpr std::array kEdits{
    Named<Edit::Kind>{"fix", Edit::Kind::kFix},       Named<Edit::Kind>{"free", Edit::Kind::kFree},
    Named<Edit::Kind>{"remove", Edit::Kind::kRemove}, Named<Edit::Kind>{"disable", Edit::Kind::kDisable},
    Named<Edit::Kind>{"enable", Edit::Kind::kEnable}, Named<Edit::Kind>{"scale", Edit::Kind::kScale}};

/// Returns what has this name. Throws InvalidArgument if nothing has it.
template <class Kind, std::size_t N>
Kind find(const std::array<Named<Kind>, N>& table, std::string_view name, const char* what) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Named<Kind>& each) { return each.first == name; });
  if (found != table.end()) return found->second;
  std::string names;
  for (const auto& each : table) names += fmt::format("{}{}", names.empty() ? "" : ", ", each.first);
  throw InvalidArgument(fmt::format("{}: expected one of {}", what, names));
}

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

/// Reads an edit, all of whose members are texts.
void read_edit(const Json& json, Command& command) {
  Parameters members;
  for (const auto& item : json.items()) {
    if (item.value().is_string()) members.emplace(item.key(), item.value().get<std::string>());
  }
  const auto text = [&](const char* name) {
    const auto found = members.find(name);
    return found == members.end() ? std::string() : found->second;
  };
  const ElementRequest request = parse_element_request(members);
  command.structure = request.structure;
  command.edit = {.kind = find(kEdits, text("edit"), "edit"), .element = request.name};
  const bool needs_factor = command.edit.kind == Edit::Kind::kScale;
  if (needs_factor && !parse_number(text("factor"), command.edit.factor))
    throw InvalidArgument("factor: expected a number");
}

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

Command parse_command(std::string_view text) {
  const Json json = is_flat(text) ? Json::parse(text, nullptr, false) : Json(Json::value_t::discarded);
  if (!json.is_object()) throw InvalidArgument("expected a command as a JSON object");
  const auto type = json.find("type");
  if (type == json.end() || !type->is_string()) throw InvalidArgument("expected a command with a \"type\"");
  Command command{.kind = find(kCommands, type->get_ref<const std::string&>(), "type")};
  switch (command.kind) {
    case Command::Kind::kOptimize:
    case Command::Kind::kStep:
      command.settings = settings_of(json);
      break;
    case Command::Kind::kGuess:
      command.start = start_of(json);
      break;
    case Command::Kind::kEdit:
      read_edit(json, command);
      break;
    default:
      break;
  }
  return command;
}

}  // namespace boxplus::viewer
