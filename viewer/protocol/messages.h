// SPDX-License-Identifier: BSD-3-Clause
// The messages of the stream to a page (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "settings/setting_table.h"
#include "viewer/scene/errors.h"
#include "viewer/scene/pattern.h"
#include "viewer/scene/positions.h"
#include "viewer/scene/scans.h"
#include "viewer/scene/structure.h"
#include "viewer/scene/truth.h"
#include "viewer/scene/uncertainty.h"

namespace boxplus::viewer {

enum class MessageKind : std::uint32_t {
  kHeartbeat,
  kState,
  kStructure,
  kFrame,
  kForm,
  kPattern,
  kTruth,
  kDiagnosis
};

/// A message with its length and kind, as it is sent. Pages share it.
using Message = std::shared_ptr<const std::string>;

Message make_message(MessageKind kind, std::string_view payload);

struct FormatName {
  std::string name, extension;
};
/// The reason why a value of a choice makes no sense for the graph, or an empty text.
using WhyUnsuitable = std::function<std::string(const Setting&, std::string_view word)>;
/// What the user can choose.
Message form_message(const std::vector<FormatName>& formats, std::span<const Setting> settings,
                     const WhyUnsuitable& why_unsuitable);

/// `graph` identifies the graph, and `number` the structure in later frames. `scans` may be empty.
Message structure_message(const Structure& structure, std::uint64_t graph, std::uint64_t number,
                          const Scans& scans = {});

struct FrameFacts {
  std::uint64_t structure = 0, sequence = 0;
  int iteration = 0;
  double chi2 = 0;
};
/// The vectors of `errors` and `uncertainty` may be empty.
Message frame_message(const FrameFacts& facts, const Structure& structure, const Positions& positions,
                      const Errors& errors, const Uncertainty& uncertainty = {},
                      const std::optional<TruthFit>& truth = {});

/// The same frame as that of another iteration.
Message frame_of_iteration(const std::string& frame, int iteration);

/// `structure` is the number of the structure to which the places belong.
Message truth_message(std::uint64_t structure, const TruthFacts& facts, const TruthPlaces& places);

Message pattern_message(const Pattern& pattern);

}  // namespace boxplus::viewer
