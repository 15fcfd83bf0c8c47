# SPDX-License-Identifier: BSD-3-Clause
"""Edges of g2o as batched edges of boxplus. The measurement of such an edge is its place in the group."""

import weakref

import numpy as np

import boxplus

from . import _kinds

#: The step of numeric derivatives, relative to the size of the number that changes.
STEP = 1e-6


class Group(boxplus.BatchedEdge):
    """Ready-made edges, whose derivatives are exact."""

    def __init__(self, kinds):
        """`kinds`: for each vertex, the types of boxplus that hold its estimate or its step."""
        self._edges = []  # weak, because the graph of boxplus, which owns the group, cannot be freed in a cycle
        self.kinds = kinds
        self.data = None

    def edge(self, place):
        return self._edges[place]()

    def extend(self, edges):
        """Returns the places of the edges."""
        first = len(self._edges)
        self._edges.extend(weakref.ref(edge) for edge in edges)
        self.type = type(edges[0])
        added = np.array([edge._data() for edge in edges], dtype=float).reshape(len(edges), -1)
        self.data = added if self.data is None else np.concatenate([self.data, added])
        return np.arange(first, len(self._edges), dtype=float)[:, None]

    def refresh(self, place):
        """Reads the measurement of an edge again."""
        self.data[place] = self.edge(place)._data()

    def error(self, *columns):
        with np.errstate(all="ignore"):  # a result that is not finite is in the report
            return self.type._residuals(self.data[columns[-1][:, 0].astype(int)], *columns[:-1])


class GroupWithJacobians(Group):
    """Ready-made edges with formulas for their derivatives."""

    def jacobians(self, *columns):
        with np.errstate(all="ignore"):
            return self.type._jacobians(self.data[columns[-1][:, 0].astype(int)], *columns[:-1])


class CustomGroup(Group):
    """Edges whose errors, or the steps of whose vertices, are written in Python by the user."""

    def error(self, *columns):
        return self.errors_at(*self._vertices(columns))

    def jacobians(self, *columns):
        values, places = self._vertices(columns)
        if hasattr(self.type, "linearize_oplus"):
            blocks = self._written(values, places)
        else:
            blocks = [self._numeric(values, places, i) for i in range(len(values))]
        return [part for block, kinds in zip(blocks, self.kinds)
                for part in np.split(block, np.cumsum([kind.dim for kind in kinds])[:-1], axis=2)]

    def _written(self, values, places):
        """The blocks that linearize_oplus() returns, by the steps of boxplus."""
        blocks = [np.empty((len(places), self.edge(places[0]).dimension(), sum(kind.dim for kind in kinds)))
                  for kinds in self.kinds]

        def linearize(k, edge):
            for block, jacobian, vertex in zip(blocks, edge._linearize(), edge._vertices):
                tangent = None if vertex._is_chart() else vertex._tangent()
                block[k] = jacobian if tangent is None else jacobian @ np.linalg.inv(tangent)

        self._for_each(values, places, linearize)
        return blocks

    def _vertices(self, columns):
        """One array per vertex, with the rows of its estimates or steps, and the places of the edges."""
        values, first = [], 0
        for kinds in self.kinds:
            values.append(np.concatenate(columns[first:first + len(kinds)], axis=1))
            first += len(kinds)
        return values, columns[-1][:, 0].astype(int)

    def _numeric(self, values, places, i):
        """Central differences by the step of vertex i."""
        kind = self.kinds[i][0] if len(self.kinds[i]) == 1 else None
        dim = sum(kind.dim for kind in self.kinds[i])
        block = np.empty((len(places), self.edge(places[0]).dimension(), dim))
        for direction in range(dim):
            size = 1 if kind is None else _kinds.sizes(kind, values[i], direction)
            steps = np.zeros((len(places), dim))
            steps[:, direction] = STEP * np.maximum(1, size)
            ahead, behind = (self._moved(values, places, i, kind, sign * steps) for sign in (1, -1))
            block[:, :, direction] = (ahead - behind) / (2 * steps[:, direction:direction + 1])
        return block

    def _moved(self, values, places, i, kind, steps):
        values = list(values)
        values[i] = values[i] + steps if kind is None else _kinds.moved(kind, values[i], steps)
        return self.errors_at(values, places)

    def errors_at(self, values, places):
        errors = np.empty((len(places), self.edge(places[0]).dimension()))

        def evaluate(k, edge):
            errors[k] = edge._evaluate()

        self._for_each(values, places, evaluate)
        return errors

    def _for_each(self, values, places, function):
        """Calls function(k, edge) for each place, while the vertices of the edge have these values."""
        saved, current = {}, {}
        try:
            for k, place in enumerate(places):
                edge = self.edge(place)
                for rows, vertex in zip(values, edge._vertices):
                    row = rows[k]
                    key = row.tobytes()
                    if current.get(vertex) == key:
                        continue
                    saved.setdefault(vertex, vertex._raw())
                    current[vertex] = key
                    vertex._restore(saved[vertex])
                    if not vertex._is_chart():
                        vertex._restore(row)
                    elif row.any():
                        vertex._restore(vertex._state())
                        vertex._apply(row)
                function(k, edge)
        finally:
            for vertex, estimate in saved.items():
                vertex._restore(estimate)
