// SPDX-License-Identifier: BSD-3-Clause
// What a call tells a ProgressWatch.
#pragma once

#include <string>
#include <vector>

#include "boxplus/base/progress.h"

namespace boxplus {

struct Notes {
  std::vector<std::string> stages;
  std::vector<double> shares;
};

template <class F>
Notes notes_of(F&& f) {
  Notes notes;
  const ProgressWatch watch([&](std::string_view stage, double share) {
    notes.stages.emplace_back(stage);
    notes.shares.push_back(share);
  });
  f();
  return notes;
}

}  // namespace boxplus
