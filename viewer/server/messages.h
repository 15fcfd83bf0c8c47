// SPDX-License-Identifier: BSD-3-Clause
// The messages of the stream to a page (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "viewer/scene/positions.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

enum class MessageKind : std::uint32_t { kHeartbeat, kState, kStructure, kFrame, kForm };

/// A message with its length and kind, as it is sent. Pages share it.
using Message = std::shared_ptr<const std::string>;

Message make_message(MessageKind kind, std::string_view payload);

/// What the user can choose for this graph: settings and formats.
Message form_message(const Graph& graph);

/// `number` identifies the structure in later frames.
Message structure_message(const Structure& structure, std::uint64_t number);

struct FrameFacts {
  std::uint64_t structure, sequence;
  int iteration;
  double chi2;
};
/// `errors` may be empty.
Message frame_message(const FrameFacts& facts, const Structure& structure, const Positions& positions,
                      const std::vector<float>& errors);

}  // namespace boxplus::viewer
