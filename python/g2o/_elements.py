# SPDX-License-Identifier: BSD-3-Clause
"""Vertices, edges and parameters of a graph."""

import functools

import numpy as np

from . import _kinds
from ._geometry import matrix


@functools.lru_cache(maxsize=None)
def identity(size):
    """A matrix that is shared. Informations are never changed in place."""
    return np.eye(size)


class Element:
    def __init__(self):
        self._optimizer = None
        self._user_data = None

    def graph(self):
        return self._optimizer

    def user_data(self):
        return self._user_data

    def set_user_data(self, data):
        self._user_data = data


class Parameter(Element):
    """A constant that edges share, with an id of its own kind."""

    _TAG = None

    def __init__(self):
        super().__init__()
        self._id = -1
        self._version = 0

    def id(self):
        return self._id

    def set_id(self, id):
        self._id = int(id)

    def _changed(self):
        self._version += 1
        if self._optimizer is not None:
            self._optimizer._state += 1


class Vertex(Element):
    """An estimate. Its subclasses have
        _KIND   the type of boxplus that holds the estimate, unless a class has oplus_impl(): boxplus then holds steps from
                the estimate
        _CODEC  how to convert the estimate to a row
    """

    _TAG = None
    _KIND = None
    _CODEC = None

    def __init__(self):
        super().__init__()
        self._id = -1
        self._is_fixed = self._is_marginalized = False
        self._hessian_index = -1
        self._edges = {}
        self._stack = []
        if self._CODEC is not None:
            self._row = self._CODEC.origin.copy()

    def id(self):
        return self._id

    def set_id(self, id):
        if self._optimizer is not None:
            return self._optimizer._change_id(self, id)
        self._id = int(id)
        return True

    def edges(self):
        """The edges of this vertex, which can be iterated over and counted."""
        return dict(self._edges).keys()

    def dimension(self):
        return self._KIND.dim

    def fixed(self):
        return self._is_fixed

    def set_fixed(self, fixed):
        self._is_fixed = bool(fixed)
        self._changed(flags=True)

    def marginalized(self):
        return self._is_marginalized

    def set_marginalized(self, marginalized):
        self._is_marginalized = bool(marginalized)
        self._changed(flags=True)

    def hessian_index(self):
        return self._hessian_index

    def estimate(self):
        return self._CODEC.decode(self._row)

    def set_estimate(self, estimate):
        self._set_row(self._CODEC.encode(estimate))

    def set_to_origin(self):
        self._set_row(self._CODEC.origin.copy())

    def oplus(self, step):
        """Applies a step of dimension() numbers."""
        step = np.array(step, dtype=float)
        if step.shape != (self.dimension(),):
            raise ValueError(f"{type(self).__name__}: expected a step of {self.dimension()} numbers, got {step!r}")
        self._apply(step)
        self._changed()

    def estimate_dimension(self):
        return self._CODEC.size

    def get_estimate_data(self):
        return self._CODEC.turn(self._row)

    def set_estimate_data(self, data):
        self.set_estimate(self._CODEC.decode(self._CODEC.turn(np.array(data, dtype=float))))
        return True

    def push(self):
        self._stack.append(self._state())

    def pop(self):
        self._restore(self._stack.pop())
        self._changed()

    def discard_top(self):
        self._stack.pop()

    def stack_size(self):
        return len(self._stack)

    # What the optimizer needs.

    def _apply(self, step):
        """Applies a step, which counts as no change by the user."""
        optimizer, self._optimizer = self._optimizer, None
        try:
            getattr(self, "oplus_impl", self._oplus)(step)
        finally:
            self._optimizer = optimizer

    def _oplus(self, step):
        self._row = _kinds.moved(self._KIND, self._row[None], step[None])[0]

    def _is_chart(self):
        """True if boxplus holds steps from the estimate instead of the estimate."""
        return hasattr(self, "oplus_impl")

    def _state(self):
        """A copy of the estimate, which a step does not change."""
        return self._row

    _raw = _state

    def _restore(self, state):
        self._row = state

    def _set_row(self, row):
        self._row = row
        self._changed()

    def _changed(self, flags=False):
        if self._optimizer is not None:
            self._optimizer._vertex_changed(self, flags)

    def _tangent(self):
        """The derivative of a step of boxplus by a step of this vertex, or None if both steps are the same."""
        return None

    def __repr__(self):
        return f"{type(self).__name__}(id={self._id})"


class Edge(Element):
    """A measurement. Its subclasses have
        _VERTICES     the types of its vertices
        _CODEC        how to convert the measurement to a row
        _PARAMETERS   the types of its parameters
        _NATIVE       the edge of boxplus, or None: boxplus then calls _residuals()
        _residuals(data, row, …)  the errors (n, dimension) of n edges, from _data() of each and the rows of the vertices
        _jacobians(data, row, …)  optional: their derivatives by the steps of boxplus, one array (n, dimension, dim) per vertex
    """

    _TAG = None
    _VERTICES = ()
    _PARAMETERS = ()
    _CODEC = None
    _NATIVE = None
    _DIM = None
    _residuals = _jacobians = None

    def __init__(self):
        super().__init__()
        self._id = -1
        self._vertices = [None] * len(self._VERTICES)
        self._parameter_ids = [-1] * len(self._PARAMETERS)
        self._level = 0
        self._kernel = None
        self._error = None
        self._information = None if self._DIM is None else identity(self._DIM)
        if self._CODEC is not None:
            self._z = self._CODEC.origin.copy()

    def id(self):
        return self._id

    def set_id(self, id):
        self._id = int(id)

    def dimension(self):
        return self._DIM

    def vertices(self):
        return list(self._vertices)

    def vertex(self, i):
        return self._vertices[i]

    def resize(self, vertices):
        """Sets the number of vertices. Most edges have a fixed number."""
        if vertices != len(self._vertices):
            raise ValueError(f"{type(self).__name__}: expected {len(self._vertices)} vertices, got {vertices}")

    def set_vertex(self, i, vertex):
        if not 0 <= i < len(self._vertices):
            raise IndexError(f"{type(self).__name__}: expected a place from 0 to {len(self._vertices) - 1}, got {i}")
        expected = self._type_of_vertex(i)
        if vertex is not None and not isinstance(vertex, expected):
            raise TypeError(f"{type(self).__name__}: expected a {expected.__name__} as vertex {i}, got {vertex!r}")
        if self._optimizer is not None:
            self._optimizer._set_edge_vertex(self, i, vertex)
        else:
            self._vertices[i] = vertex

    def parameter_ids(self):
        return list(self._parameter_ids)

    def set_parameter_id(self, i, id):
        if not 0 <= i < len(self._parameter_ids):
            return False
        self._parameter_ids[i] = int(id)
        self._changed()
        return True

    def parameter(self, i):
        return None if self._optimizer is None else self._optimizer._parameters.get(self._parameter_ids[i])

    def measurement(self):
        return self._CODEC.decode(self._z)

    def set_measurement(self, measurement):
        self._z = self._CODEC.encode(measurement)
        self._changed()

    def set_measurement_data(self, data):
        self.set_measurement(self._CODEC.decode(self._CODEC.turn(np.array(data, dtype=float))))
        return True

    def get_measurement_data(self):
        return self._CODEC.turn(self._z)

    def measurement_dimension(self):
        return self._CODEC.size

    def information(self):
        return self._information.copy()

    def set_information(self, information):
        size = self.dimension()
        if size == 1 and isinstance(information, (int, float)):
            information = [[information]]
        omega = matrix(information, (size, size), f"{type(self).__name__}: information")
        asymmetry = omega - omega.T
        if asymmetry.any():
            if np.abs(asymmetry).max() > 1e-6 * np.abs(omega).max():
                raise ValueError(f"{type(self).__name__}: expected a symmetric information matrix, got {omega.tolist()}")
            omega = (omega + omega.T) / 2
        self._information = omega
        self._changed(error=False)

    def level(self):
        return self._level

    def set_level(self, level):
        self._level = int(level)
        self._changed(error=False)

    def robust_kernel(self):
        return self._kernel

    def set_robust_kernel(self, kernel):
        self._kernel = kernel
        self._changed(error=False)

    def compute_error(self):
        """The error is always up to date: error() and chi2() compute it if an estimate or a measurement has changed. A
        derived class may return another error of dimension() numbers, or set self._error."""
        self._require_vertices()
        rows = [vertex._row[None] for vertex in self._vertices]
        self._error = np.array(type(self)._residuals(np.array(self._data(), dtype=float)[None], *rows)[0])

    def error(self):
        return self._current_error().copy()

    def chi2(self):
        """eᵀΩe, without the kernel."""
        error = self._current_error()
        return float(error @ self._current_information() @ error)

    def all_vertices_fixed(self):
        return all(vertex is not None and vertex.fixed() for vertex in self._vertices)

    # What the optimizer needs.

    def _type_of_vertex(self, i):
        return self._VERTICES[i] if i < len(self._VERTICES) else Vertex

    def _current_error(self):
        return self._evaluate() if self._optimizer is None else self._optimizer._error_of(self)

    def _evaluate(self):
        self._require_vertices()
        error = self.compute_error()
        error = np.array(self._error if error is None else error, dtype=float).reshape(-1)
        if error.shape != (self.dimension(),):
            raise ValueError(f"{type(self).__name__}: expected an error of {self.dimension()} numbers, got {error.tolist()}")
        return error

    def _is_custom(self):
        """True if its error is written in Python by the user."""
        return type(self).compute_error is not Edge.compute_error

    def _current_information(self):
        """Ω at the current estimates."""
        return self._information

    def _linearize(self):
        """One Jacobian per vertex, by its step, or None."""
        linearize = getattr(self, "linearize_oplus", None)
        if linearize is None:
            return None
        blocks = linearize()
        if isinstance(blocks, np.ndarray) and len(self._vertices) == 1 and blocks.ndim == 2:
            blocks = [blocks]
        blocks = [np.array(block, dtype=float) for block in blocks]
        expected = [(self.dimension(), vertex.dimension()) for vertex in self._vertices]
        if [block.shape for block in blocks] != expected:
            raise ValueError(f"{type(self).__name__}: expected Jacobians of the shapes {expected}, got "
                             f"{[block.shape for block in blocks]}")
        return blocks

    def _require_vertices(self):
        for i, vertex in enumerate(self._vertices):
            if vertex is None:
                raise ValueError(f"{type(self).__name__}: vertex {i} is not set")

    def _data(self):
        """The numbers that _residuals() needs: by default, the measurement and the parameters."""
        return np.concatenate([self._z, *(self._parameter(i)._data() for i in range(len(self._PARAMETERS)))]) \
            if self._PARAMETERS else self._z

    def _parameter(self, i):
        parameter = self.parameter(i)
        if not isinstance(parameter, self._PARAMETERS[i]):
            raise ValueError(f"{type(self).__name__}: expected a {self._PARAMETERS[i].__name__} as parameter {i}, but the "
                             f"parameter with the id {self._parameter_ids[i]} is {parameter!r}")
        return parameter

    def _changed(self, error=True):
        if self._optimizer is not None:
            self._optimizer._edge_changed(self, error)

    def __repr__(self):
        ids = ", ".join("None" if vertex is None else str(vertex._id) for vertex in self._vertices)
        return f"{type(self).__name__}({ids})"
