// SPDX-License-Identifier: BSD-3-Clause
// Growth in two steps, so that an element is added to several vectors or to none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "boxplus/base/large_pages.h"

namespace boxplus {

/// Room for `count` elements in all, in large pages where that is much.
template <class T>
void reserve(std::vector<T>& vector, std::size_t count) {
  if (count <= vector.capacity()) return;
  vector.reserve(count);
  prefer_large_pages(vector.data(), vector.capacity() * sizeof(T));
}

/// After it, `extra` elements can be appended without allocation. Amortised O(extra).
template <class T>
void make_room(std::vector<T>& vector, std::size_t extra = 1) {
  const std::size_t needed = vector.size() + extra;
  if (needed > vector.capacity()) reserve(vector, std::max(needed, 2 * vector.capacity()));
}

}  // namespace boxplus
