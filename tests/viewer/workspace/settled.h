// SPDX-License-Identifier: BSD-3-Clause
// What tests of workspaces share: a graph, and readers that wait for the end of a command.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {

using Json = nlohmann::json;

inline GraphFile small_graph() {
  return parse_graph(
      "VERTEX_SE2 0 0 0 0\n"
      "VERTEX_SE2 1 3 0 0\n"
      "VERTEX_SE2 2 0 3 0\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 2 2.5 0 0 1 0 0 1 0 1\n",
      "small.g2o");
}

inline MessageKind kind_of(const Message& message) {
  std::uint32_t kind = 0;
  std::memcpy(&kind, message->data() + sizeof kind, sizeof kind);
  return static_cast<MessageKind>(kind);
}

/// The JSON of a message: all of a state or diagnosis, or the header of arrays.
inline Json json_of(const Message& message) {
  constexpr std::size_t kBegin = 8;  // after the length and the kind
  const MessageKind kind = kind_of(message);
  if (kind == MessageKind::kState || kind == MessageKind::kDiagnosis)
    return Json::parse(message->substr(kBegin));
  std::uint32_t size = 0;
  std::memcpy(&size, message->data() + kBegin, sizeof size);
  return Json::parse(message->substr(kBegin + sizeof size, size));
}

/// The last message of each kind that a reader got until the worker waited; null if there was none.
struct Settled {
  Json state, structure, frame, truth, diagnosis;
  std::vector<std::string> log = {};  ///< the lines of all states
};

inline Settled settled_messages(Workspace::Reader& reader) {
  Settled last;
  while (!reader.has_ended()) {
    for (const Message& message : reader.wait(std::chrono::seconds(10))) {
      if (kind_of(message) == MessageKind::kState) {
        last.state = json_of(message);
        for (const Json& line : last.state["log"]["lines"]) last.log.push_back(line["text"]);
      }
      if (kind_of(message) == MessageKind::kStructure) last.structure = json_of(message);
      if (kind_of(message) == MessageKind::kFrame) last.frame = json_of(message);
      if (kind_of(message) == MessageKind::kTruth) last.truth = json_of(message);
      if (kind_of(message) == MessageKind::kDiagnosis) last.diagnosis = json_of(message);
    }
    if (!last.state.is_null() && !last.state["busy"].get<bool>()) break;
  }
  return last;
}

inline Json settled(Workspace::Reader& reader) {
  return settled_messages(reader).state;
}

inline Json settled_frame(Workspace::Reader& reader) {
  return settled_messages(reader).frame;
}

}  // namespace boxplus::viewer
