// SPDX-License-Identifier: BSD-3-Clause
// All results of one run of the benchmark, and their tables in Markdown.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/datasets.h"
#include "datasets/face_comparison.h"
#include "datasets/linear_comparison.h"
#include "datasets/scale.h"
#include "datasets/solve_comparison.h"
#include "datasets/thread_comparison.h"
#include "datasets/whole_comparison.h"

namespace boxplus::bench {

/// The results for one file. If a comparison throws an exception, its result and all later ones are empty,
/// and `trouble` is the message of the exception. `faces` is measured for a few files only.
struct DatasetResults {
  Dataset dataset;
  std::optional<LinearComparison> linear = {};
  std::optional<SolveComparison> solve = {};
  std::optional<WholeComparison> whole = {};
  std::optional<ThreadComparison> threads = {};
  std::optional<FaceComparison> faces = {};
  std::string trouble = {};
};

inline constexpr int kLargeTorus = 10'000;

struct Results {
  std::vector<std::pair<std::string, std::string>> machine;
  double dgemm_rate = 0;  ///< the rate of DGEMM in GFLOP/s
  std::vector<DatasetResults> datasets = {};
  std::map<int, ThreadComparison> tori = {};  ///< simulated graphs; the key is the number of poses
  std::vector<ScaleResult> scale = {};
};

/// Returns the tables of all results.
std::string tables_of(const Results& results);

/// Returns a table of the goals of the project. Each line compares a goal with the geometric mean of the
/// results and with the worst result.
std::string goals_of(const Results& results);

}  // namespace boxplus::bench
