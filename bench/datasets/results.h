// SPDX-License-Identifier: BSD-3-Clause
// Everything that one run of the benchmark found, and the Markdown of it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/datasets.h"
#include "datasets/face_duel.h"
#include "datasets/linear_duel.h"
#include "datasets/scale.h"
#include "datasets/solve_duel.h"
#include "datasets/thread_duel.h"
#include "datasets/whole_duel.h"

namespace boxplus::bench {

/// Of one file. What could not be measured is absent, and `trouble` says why.
struct DatasetResults {
  Dataset dataset;
  std::optional<LinearDuel> linear = {};
  std::optional<SolveDuel> solve = {};
  std::optional<WholeDuel> whole = {};
  std::optional<ThreadDuel> threads = {};
  std::optional<FaceDuel> faces = {};
  std::string trouble = {};
};

inline constexpr int kLargeTorus = 10'000;

struct Results {
  std::vector<std::pair<std::string, std::string>> machine;
  double dgemm_rate = 0;  ///< GFLOP/s
  std::vector<DatasetResults> datasets = {};
  std::map<int, ThreadDuel> tori = {};  ///< simulated, by the number of their poses
  std::vector<ScaleResult> scale = {};
};

/// The tables, without the goals.
std::string tables_of(const Results& results);

/// How far the goals are reached: one line each, with the geometric mean and the worst file.
std::string goals_of(const Results& results);

}  // namespace boxplus::bench
