// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/covariance/covariance.h"

#include "boxplus/base/error.h"

namespace boxplus {

const Covariance::Place& Covariance::place(VertexRef vertex) const {
  if (!ok()) throw Error(message_);
  const auto found = places_.find(vertex);
  if (found == places_.end())
    throw InvalidArgument("Covariance: expected one of the vertices that it was computed for");
  return found->second;
}

std::size_t Covariance::block_index(std::size_t i, std::size_t j) const {
  return is_joint_ ? i * (i + 1) / 2 + j : i;
}

}  // namespace boxplus
