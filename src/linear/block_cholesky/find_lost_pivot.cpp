// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/find_lost_pivot.h"

#include <algorithm>

#include "linear/block_cholesky/triangular_solve.h"

namespace boxplus {

template <class Scalar>
std::uint32_t find_lost_pivot(const SymbolicFactor& symbolic, const BlockStructure& structure,
                              NumericFactor<Scalar>& factor) {
  const auto suspects = factor.suspects.list();
  std::sort(suspects.begin(), suspects.end(), [](auto a, auto b) { return a.scalar < b.scalar; });
  for (const auto [scalar, ratio] : suspects) {
    const auto above = std::upper_bound(symbolic.offset.begin(), symbolic.offset.end(), scalar);
    const std::uint32_t s = symbolic.front_of[static_cast<std::size_t>(above - symbolic.offset.begin()) - 1];
    const Front& front = symbolic.fronts[s];
    const std::size_t column = scalar - symbolic.offset[front.first_block];
    const Scalar root = factor.arena()[front.panel + column * (front.leading + 1)];
    Scalar* const x = factor.x();
    std::fill_n(x, structure.scalars(), Scalar{0});
    x[scalar] = root;
    solve_upper_from(symbolic, factor.arena(), s, x, factor.work());
    double noise = 0;
    for (std::uint32_t i = 0; i <= scalar; ++i) noise += double{factor.minimum_pivot()[i]} * x[i] * x[i];
    if (!(double{root} * root > noise)) return scalar;
  }
  return structure.scalars();
}

template std::uint32_t find_lost_pivot(const SymbolicFactor&, const BlockStructure&, NumericFactor<double>&);
template std::uint32_t find_lost_pivot(const SymbolicFactor&, const BlockStructure&, NumericFactor<float>&);

}  // namespace boxplus
