// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "boxplus/base/error.h"
#include "viewer/settings/setting_table.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

/// Reads the settings of a command. Throws InvalidArgument if one is unknown or has another value than the
/// table accepts.
RunSettings settings_of(const Json& command) {
  RunSettings settings;
  const auto found = command.find("settings");
  if (found == command.end()) return settings;
  if (!found->is_object()) throw InvalidArgument("settings: expected an object");
  for (const auto& item : found->items()) {
    const std::string& name = item.key();
    const Json& value = item.value();
    const auto table = setting_table();
    const auto setting =
        std::find_if(table.begin(), table.end(), [&](const Setting& s) { return s.name == name; });
    if (setting == table.end()) throw InvalidArgument(fmt::format("settings: '{}' is unknown", name));
    if (!value.is_string()) throw InvalidArgument(fmt::format("{}: expected a text", name));
    try {
      setting->set(settings, value.get_ref<const std::string&>());
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("{}: {}", name, error.what()));
    }
  }
  for (const Setting& setting : setting_table()) {
    if (setting.needed_setting.empty() || !found->contains(setting.name)) continue;
    const std::string other = found->value(setting.needed_setting, "");
    if (setting.needed_value.empty() ? other.empty() : other != setting.needed_value)
      throw InvalidArgument(fmt::format("{}: needs the setting {} {}", setting.name, setting.needed_setting,
                                        setting.needed_value));
  }
  return settings;
}

struct Command {
  std::string_view type;
  void (*carry_out)(Workspace&, const Json&);
};

constexpr std::array kCommands{
    Command{"optimize",
            [](Workspace& workspace, const Json& command) { workspace.optimize(settings_of(command)); }},
    Command{"step", [](Workspace& workspace, const Json& command) { workspace.step(settings_of(command)); }},
    Command{"guess",
            [](Workspace& workspace, const Json& command) {
              const auto start = command.find("start");
              if (start == command.end()) throw InvalidArgument("expected the name of an initial guess");
              workspace.guess(settings_of({{"settings", {{"start", *start}}}}));
            }},
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
