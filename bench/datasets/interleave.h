// SPDX-License-Identifier: BSD-3-Clause
// Contestants are measured in turn, over and over, so that whatever disturbs the machine disturbs them alike.
#pragma once

#include <functional>
#include <vector>

namespace boxplus::bench {

/// The figures of one run: seconds, mostly. All runs of a contestant have equally many.
using Figures = std::vector<double>;
using Contestant = std::function<Figures()>;

struct Effort {
  int least = 5;          ///< repetitions, whatever they take
  int most = 25;          ///< repetitions, however short
  double enough_s = 1.0;  ///< between the two: no further repetition after so many seconds
};

/// The median of each figure of each contestant, after one run of each that is not counted.
std::vector<Figures> interleaved_medians(const std::vector<Contestant>& contestants,
                                         const Effort& effort = {});

/// exp of the mean logarithm; 1 of nothing.
double geometric_mean(const std::vector<double>& values);

}  // namespace boxplus::bench
