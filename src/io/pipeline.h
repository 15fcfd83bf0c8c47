// SPDX-License-Identifier: BSD-3-Clause
// A pipeline: several workers prepare items, and one worker consumes them in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "boxplus/base/parallel.h"
#include "boxplus/base/progress.h"

namespace boxplus {

/// Calls prepare(k, item) for k = 0 … count − 1 on any worker, and then consume(item) on the calling thread,
/// in the order of k. Allocates only a few items per worker, and reuses them. `threads` is the maximum number
/// of workers; 0 means one worker per hardware thread. Notes the progress.
template <class Item, class Prepare, class Consume>
void prepare_and_consume(std::size_t count, int threads, Prepare&& prepare, Consume&& consume) {
  constexpr std::size_t kItemsPerWorker = 4;
  const auto most = static_cast<std::size_t>(threads > 0 ? threads : detail::hardware_threads());
  const std::size_t workers = std::min(most, std::max<std::size_t>(1, count));
  const std::size_t round = std::min(count, workers * kItemsPerWorker);
  std::vector<Item> ready(round), coming(round);
  std::size_t ready_count = 0;
  for (std::size_t first = 0; first < count || ready_count > 0; first += round) {
    const std::size_t coming_count = first < count ? std::min(round, count - first) : 0;
    std::atomic<std::size_t> next = 0;
    detail::parallel_tasks(static_cast<int>(workers), [&](int worker) {
      if (worker == 0) {
        for (std::size_t k = 0; k < ready_count; ++k) consume(ready[k]);
      }
      for (std::size_t k = next++; k < coming_count; k = next++) prepare(first + k, coming[k]);
    });
    detail::note_progress(static_cast<double>(std::min(first, count)) / static_cast<double>(count));
    ready.swap(coming);
    ready_count = coming_count;
  }
}

}  // namespace boxplus
