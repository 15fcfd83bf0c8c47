// SPDX-License-Identifier: BSD-3-Clause
// Growth in two steps: first reserve memory in several vectors, then append to each of them. Therefore, an
// element is added to all of the vectors or to none of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "boxplus/base/large_pages.h"

namespace boxplus::detail {

/// Reserves memory for a total of `count` elements. If this is much memory, it uses large pages.
template <class T>
void reserve(std::vector<T>& vector, std::size_t count) {
  if (count <= vector.capacity()) return;
  vector.reserve(count);
  prefer_large_pages(vector.data(), vector.capacity() * sizeof(T));
}

/// After this call, `extra` elements can be appended without allocation. Amortized O(extra).
template <class T>
void make_room(std::vector<T>& vector, std::size_t extra = 1) {
  const std::size_t needed = vector.size() + extra;
  if (needed > vector.capacity()) reserve(vector, std::max(needed, 2 * vector.capacity()));
}

}  // namespace boxplus::detail
