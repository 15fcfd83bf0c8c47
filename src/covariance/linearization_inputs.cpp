// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/linearization_inputs.h"

#include <cstring>
#include <span>

#include "covariance/plain_elements.h"

namespace boxplus {
namespace {

using Bytes = std::span<const std::byte>;
using detail::EdgePool;
using detail::InformationKind;

std::size_t value_count(const detail::InformationView& omega) {
  const auto rows = static_cast<std::size_t>(omega.rows);
  if (omega.kind == InformationKind::kScalar) return 1;
  return omega.kind == InformationKind::kDiagonal ? rows : rows * (rows + 1) / 2;
}

/// Passes bytes on to f. Joins parts that lie one after the other in memory.
template <class F>
class Joined {
 public:
  explicit Joined(F& f) : f_(f) {}
  bool add(Bytes part) {
    if (part.data() == pending_.data() + pending_.size()) {
      pending_ = {pending_.data(), pending_.size() + part.size()};
      return true;
    }
    const bool goes_on = flush();
    pending_ = part;
    return goes_on;
  }
  bool flush() {
    const Bytes part = pending_;
    pending_ = {};
    return part.empty() || f_(part);
  }

 private:
  F& f_;
  Bytes pending_;
};

/// Calls f for Ω of all edges, and then for their flags. Stops when f returns false, and returns false.
template <class F>
bool for_weights(const EdgePool& pool, std::span<const std::uint32_t> edges, std::vector<std::uint8_t>& flags,
                 F& f) {
  Joined<F> values(f);
  flags.clear();
  const int rows = pool.shape(edges[0]).rows;  // the same for all edges of these types
  for (const std::uint32_t edge : edges) {
    const detail::InformationView omega = pool.information(edge, rows);
    if (!values.add(std::as_bytes(std::span(omega.values, value_count(omega))))) return false;
    flags.push_back(
        static_cast<std::uint8_t>(static_cast<int>(omega.kind) * 2 + (pool.enabled(edge) ? 1 : 0)));
  }
  return values.flush() && f(std::as_bytes(std::span(flags)));
}

/// Calls f for all parts of the inputs, always in the same order. Stops when f returns false, and returns
/// false. Also returns false if some inputs are of other types.
template <class F>
bool for_each_input(const Graph& graph, const Plan& plan, std::vector<std::uint8_t>& flags, F&& f) {
  for (const auto& pool : graph.vertex_pools()) {
    if (pool->slots() == 0) continue;
    const auto estimates = plain_elements(*pool);
    if (!estimates || !f(*estimates)) return false;
  }
  for (const EdgeList& list : plan.edges) {
    if (list.edges.empty()) continue;
    const EdgePool& pool = *graph.edge_pools()[list.pool];
    const auto measurements = plain_elements(pool);
    if (!measurements || pool.has_kernels() || !f(*measurements)) return false;
    if (!for_weights(pool, list.edges, flags, f)) return false;
  }
  return true;
}

}  // namespace

bool LinearizationInputs::take(const Graph& graph, const Plan& plan, const LinearizeOptions& options) {
  options_ = options;
  copy_.clear();
  is_taken_ = for_each_input(graph, plan, flags_, [&](Bytes part) {
    copy_.insert(copy_.end(), part.begin(), part.end());
    return true;
  });
  if (!is_taken_) copy_ = {};
  return is_taken_;
}

bool LinearizationInputs::equal(const Graph& graph, const Plan& plan, const LinearizeOptions& options) {
  if (!is_taken_ || options.numeric_jacobians != options_.numeric_jacobians ||
      options.triggs_correction != options_.triggs_correction)
    return false;
  Bytes rest = copy_;
  const bool equal = for_each_input(graph, plan, flags_, [&](Bytes part) {
    if (part.size() > rest.size()) return false;
    if (!part.empty() && std::memcmp(part.data(), rest.data(), part.size()) != 0) return false;
    rest = rest.subspan(part.size());
    return true;
  });
  return equal && rest.empty();
}

}  // namespace boxplus
