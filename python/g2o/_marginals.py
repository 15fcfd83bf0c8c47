# SPDX-License-Identifier: BSD-3-Clause
"""Covariances as blocks of a matrix."""

import numpy as np

from ._elements import Vertex
from ._kinds import warn


class SparseBlockMatrix:
    """Some blocks of a matrix. Rows and columns of blocks have the numbers of hessian_index()."""

    def __init__(self, sizes=()):
        self._ends = np.cumsum(list(sizes)).tolist()
        self._blocks = {}

    def block(self, row, column):
        """The block, or None if it was not computed."""
        if (row, column) in self._blocks:
            return self._blocks[row, column]
        found = self._blocks.get((column, row))
        return None if found is None else found.T

    def row_base_of_block(self, row):
        return self._ends[row - 1] if row > 0 else 0

    def rows_of_block(self, row):
        return self._ends[row] - self.row_base_of_block(row)

    col_base_of_block, cols_of_block = row_base_of_block, rows_of_block

    def rows(self):
        return self._ends[-1] if self._ends else 0

    cols = rows

    def non_zero_blocks(self):
        return len(self._blocks)

    def _take(self, other):
        self._ends, self._blocks = other._ends, other._blocks


def marginals(engine, order, what, options):
    """(success, SparseBlockMatrix)"""
    if isinstance(what, Vertex):
        what = [what]
    if isinstance(what, dict):
        what = what.values()
    pairs = [(item.hessian_index(),) * 2 if isinstance(item, Vertex) else tuple(item) for item in what]
    for row, column in pairs:
        if not (0 <= row < len(order) and 0 <= column < len(order)):
            raise ValueError(f"compute_marginals: expected hessian indices from 0 to {len(order) - 1}, got {(row, column)}")
    chosen = [order[index] for index in sorted({index for pair in pairs for index in pair})]
    result = SparseBlockMatrix(vertex.dimension() for vertex in order)
    if not chosen:
        return True, result
    block, message = engine.covariances(chosen, options)
    if block is None:
        warn(f"compute_marginals: {message}")
        return False, SparseBlockMatrix()
    for row, column in pairs:
        result._blocks[row, column] = block(order[row], order[column])
    return True, result
