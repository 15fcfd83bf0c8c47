// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "boxplus/base/function_ref.h"
#include "boxplus/base/parallel.h"

namespace g2o {
namespace internal {

/// The smallest number of edges for which threads save more time than they cost.
inline constexpr std::size_t kFewestEdgesForThreads = 1000;

/// Runs task(0) … task(parts − 1) on all threads.
inline void for_each_part(int parts, boxplus::detail::FunctionRef<void(int)> task) {
  const int threads = parts > 1 ? std::min(boxplus::detail::hardware_threads(), parts) : 1;
  boxplus::detail::parallel_tasks(threads, [&](int thread) {
    for (int part = thread; part < parts; part += threads) task(part);
  });
}

}  // namespace internal
}  // namespace g2o
