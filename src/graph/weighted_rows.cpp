// SPDX-License-Identifier: BSD-3-Clause
#include "graph/weighted_rows.h"

namespace boxplus {

using detail::InformationKind;
using detail::InformationView;

bool is_weighted(const InformationView& omega, int row) {
  if (omega(row, row) != 0) return true;
  if (omega.kind != InformationKind::kFull) return false;
  for (int j = 0; j < omega.rows; ++j) {
    if (omega(row, j) != 0) return true;
  }
  return false;
}

int weighted_rows(const InformationView& omega) {
  if (omega.kind == InformationKind::kScalar) return omega.values[0] != 0 ? omega.rows : 0;
  int rows = 0;
  for (int i = 0; i < omega.rows; ++i) rows += is_weighted(omega, i);
  return rows;
}

bool is_structural(const InformationView& omega, int row) {
  return omega.kind == InformationKind::kScalar || is_weighted(omega, row) || weighted_rows(omega) == 0;
}

int structural_rows(const InformationView& omega) {
  const int rows = weighted_rows(omega);
  return rows > 0 ? rows : omega.rows;
}

}  // namespace boxplus
