// SPDX-License-Identifier: BSD-3-Clause
// The settings of a run, in one table: each is an option of `boxplus optimize` and a field of the viewer's
// form.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "settings/run_settings.h"

namespace boxplus {

struct Setting {
  /// kKernel is the name of a robust kernel, which may contain a shape.
  enum class Kind : std::uint8_t { kChoice, kWholeNumber, kNumber, kKernel };

  std::string name;   ///< "cost-tolerance"; the option of the command is --cost-tolerance
  std::string group;  ///< "Method", "Outliers", "False edges", "Problem" or "Stop"
  Kind kind;
  std::string help;                     ///< one or two sentences for people, without a period at the end
  std::vector<std::string> words = {};  ///< the values of kChoice and kKernel
  std::string default_text = {};        ///< empty if the default is no value
  std::string unit = {};                ///< what stands for the value in help texts: "N", "X", "SECONDS"
  /// The setting has no meaning unless the setting of this name has the value `needed_value` or, if that is
  /// empty, any value.
  std::string needed_setting = {}, needed_value = {};
  /// Throws InvalidArgument ("expected …, got …") if the text is not a value.
  std::function<void(RunSettings&, const std::string&)> set;
};

/// All settings, in the order of help texts.
std::span<const Setting> setting_table();

/// A run of the viewer has at most this many iterations, because its pages keep a row for each.
inline constexpr int kMostIterations = 10'000;

/// Throws InvalidArgument if a setting is unknown, or has a value that the table does not accept, or needs
/// another setting that is absent, or if there would be more than kMostIterations.
RunSettings run_settings(const Settings& values);

/// Returns the reason why a value of kChoice makes no sense for this graph, or an empty text.
std::string why_unsuitable(const Graph& graph, const Setting& setting, std::string_view word);

}  // namespace boxplus
