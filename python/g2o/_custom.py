# SPDX-License-Identifier: BSD-3-Clause
"""Vertices and edges that are written in Python.

While an error is computed, the estimates of the vertices may be those of a tried step.
"""

import copy

import numpy as np

from ._codecs import vectors
from ._elements import Edge, Vertex


class BaseVertex(Vertex):
    """A vertex with an estimate of any type. Derive from it, call set_dimension(), and write oplus_impl(step), which applies
    a step of dimension() numbers to the estimate, and set_to_origin_impl()."""

    def __init__(self, dimension=None):
        super().__init__()
        self._dim = 0
        self._estimate = None
        if dimension is not None:
            self.set_dimension(dimension)

    def dimension(self):
        return self._dim

    def set_dimension(self, dimension):
        if self._optimizer is not None:
            raise ValueError(f"{type(self).__name__}: set_dimension() must be called before add_vertex()")
        if int(dimension) < 1:
            raise ValueError(f"{type(self).__name__}: expected a dimension of at least 1, got {dimension!r}")
        self._dim = int(dimension)

    def estimate(self):
        return self._estimate.copy() if isinstance(self._estimate, np.ndarray) else self._estimate

    def set_estimate(self, estimate):
        self._estimate = estimate
        self._changed()

    def set_to_origin(self):
        self.set_to_origin_impl()
        self._changed()

    def set_to_origin_impl(self):
        raise NotImplementedError(f"{type(self).__name__}: set_to_origin_impl() is missing")

    def oplus_impl(self, step):
        raise NotImplementedError(f"{type(self).__name__}: oplus_impl() is missing")

    def get_estimate_data(self):
        return np.array(self._estimate, dtype=float)

    def set_estimate_data(self, data):
        self.set_estimate(np.array(data, dtype=float))
        return True

    def _state(self):
        return copy.deepcopy(self._estimate)

    def _raw(self):
        return self._estimate

    def _restore(self, state):
        self._estimate = state


class VectorXVertex(BaseVertex):
    """A vector of dimension() numbers. oplus_impl() adds the step, unless a derived class overrides it."""

    def set_dimension(self, dimension):
        super().set_dimension(dimension)
        self._estimate = np.zeros(self._dim)

    def set_estimate(self, estimate):
        super().set_estimate(vectors(self._dim or np.size(estimate)).encode(estimate))

    def oplus_impl(self, step):
        self._estimate = self._estimate + step

    def set_to_origin_impl(self):
        self._estimate = np.zeros(self._dim)

    def estimate_dimension(self):
        return self._dim


class BaseEdge(Edge):
    """An edge whose error is written in Python. Derive from it, call set_dimension() and resize(), and write
    compute_error(), which returns dimension() numbers (or sets self._error). linearize_oplus() is optional: it returns one
    Jacobian (dimension, dimension of the vertex) per vertex, by the step of oplus_impl(). Without it, Jacobians are
    numeric."""

    def __init__(self, dimension=None, vertices=None):
        super().__init__()
        self._z = None
        self._dim = 0
        if dimension is not None:
            self.set_dimension(dimension)
        if vertices is not None:
            self.resize(vertices)

    def dimension(self):
        return self._dim

    def set_dimension(self, dimension):
        if int(dimension) < 1:
            raise ValueError(f"{type(self).__name__}: expected a dimension of at least 1, got {dimension!r}")
        self._dim = int(dimension)
        self._information = np.eye(self._dim)

    def resize(self, vertices):
        """Sets the number of vertices."""
        if self._optimizer is not None:
            raise ValueError(f"{type(self).__name__}: resize() must be called before add_edge()")
        self._vertices = (self._vertices + [None] * vertices)[:vertices]

    def measurement(self):
        return self._z

    def set_measurement(self, measurement):
        self._z = measurement
        self._changed()

    def get_measurement_data(self):
        return np.ravel(np.array(self._z, dtype=float))

    def set_measurement_data(self, data):
        self.set_measurement(np.array(data, dtype=float))
        return True

    def measurement_dimension(self):
        return np.size(self._z)

    def compute_error(self):
        raise NotImplementedError(f"{type(self).__name__}: compute_error() is missing")

    def _data(self):
        return ()


class VariableVectorXEdge(BaseEdge):
    """An edge with any number of vertices, whose measurement is a vector or any other object."""


class BaseUnaryEdge(BaseEdge):
    def __init__(self, dimension=None):
        super().__init__(dimension, 1)


class BaseBinaryEdge(BaseEdge):
    def __init__(self, dimension=None):
        super().__init__(dimension, 2)
