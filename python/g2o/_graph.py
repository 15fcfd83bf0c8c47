# SPDX-License-Identifier: BSD-3-Clause
"""Graphs: vertices, edges and parameters, and the errors of the edges."""

import numpy as np

from . import _files
from ._elements import Edge, Parameter, Vertex
from ._kinds import warn

#: After this many requests for single errors, all errors of a graph are computed at once.
SINGLE_ERRORS = 8


class HyperGraph:
    """Vertices, which have unique ids, and edges."""

    Vertex, Edge = Vertex, Edge

    def __init__(self):
        self._vertices = {}
        self._edges = {}
        self._parameters = {}
        self._engine = None
        self._changed_vertices = {}
        self._changed_edges = {}
        self._active = None
        self._state = 0  # changes with each estimate and measurement
        self._errors = {}
        self._errors_of = -1
        self._misses = 0

    def vertices(self):
        """{id: vertex}"""
        return dict(self._vertices)

    def edges(self):
        """The edges, which can be iterated over and counted: a view of a copy, so that a loop may remove them."""
        return dict(self._edges).keys()

    def vertex(self, id):
        return self._vertices.get(id)

    def add_vertex(self, vertex, user_data=None):
        if not isinstance(vertex, Vertex):
            raise TypeError(f"add_vertex: expected a vertex, got {vertex!r}")
        if vertex._optimizer is not None or vertex.id() < 0 or vertex.id() in self._vertices or vertex.dimension() < 1:
            warn(f"add_vertex: expected a new vertex with a new id from 0 and a dimension, got {vertex!r}")
            return False
        if user_data is not None:
            vertex.set_user_data(user_data)
        self._vertices[vertex.id()] = vertex
        vertex._optimizer = self
        self._state += 1
        return True

    def add_edge(self, edge):
        if not isinstance(edge, Edge):
            raise TypeError(f"add_edge: expected an edge, got {edge!r}")
        foreign = [vertex for vertex in edge._vertices if vertex is not None and vertex._optimizer is not self]
        twice = len(set(edge._vertices) - {None}) < len([vertex for vertex in edge._vertices if vertex is not None])
        if edge._optimizer is not None or foreign or twice or not edge._vertices or not edge.dimension():
            warn(f"add_edge: expected a new edge with a dimension, between different vertices of this graph, got {edge!r}")
            return False
        self._edges[edge] = None
        edge._optimizer = self
        for vertex in edge._vertices:
            if vertex is not None:
                vertex._edges[edge] = None
        self._state += 1
        return True

    # Programs derive from the class and give its methods other arguments, so that its methods do not call each other.

    def set_edge_vertex(self, edge, i, vertex):
        return self._set_edge_vertex(edge, i, vertex)

    def _set_edge_vertex(self, edge, i, vertex):
        old = edge._vertices[i]
        edge._vertices[i] = vertex
        if old is not None and old not in edge._vertices:
            old._edges.pop(edge, None)
        if vertex is not None:
            vertex._edges[edge] = None
        self._forget_edge(edge)
        self._state += 1
        return True

    def remove_edge(self, edge):
        if edge not in self._edges:
            return False
        del self._edges[edge]
        for vertex in edge._vertices:
            if vertex is not None:
                vertex._edges.pop(edge, None)
        self._forget_edge(edge)
        edge._optimizer = None
        return True

    def detach_vertex(self, vertex):
        """Takes the vertex out of its edges, which remain."""
        for edge in list(vertex._edges):
            self._set_edge_vertex(edge, edge._vertices.index(vertex), None)
        return True

    def remove_vertex(self, vertex, detach=False):
        if self._vertices.get(vertex.id()) is not vertex:
            return False
        if detach:
            HyperGraph.detach_vertex(self, vertex)
        for edge in list(vertex._edges):
            HyperGraph.remove_edge(self, edge)
        del self._vertices[vertex.id()]
        if self._engine is not None:
            self._engine.remove_vertex(vertex)
        self._changed_vertices.pop(vertex, None)
        vertex._optimizer = None
        return True

    def change_id(self, vertex, id):
        return self._change_id(vertex, id)

    def _change_id(self, vertex, id):
        if self._vertices.get(vertex.id()) is not vertex or id in self._vertices or id < 0:
            return False
        del self._vertices[vertex.id()]
        self._vertices[int(id)] = vertex
        vertex._id = int(id)
        self._engine = None  # begins with the new ids
        return True

    def clear(self):
        for element in (*self._vertices.values(), *self._edges, *self._parameters.values()):
            element._optimizer = None
        for vertex in self._vertices.values():
            vertex._edges.clear()
        state, self._state = self._state, 0
        HyperGraph.__init__(self)
        self._state = state + 1

    def add_parameter(self, parameter):
        if not isinstance(parameter, Parameter):
            raise TypeError(f"add_parameter: expected a parameter, got {parameter!r}")
        if parameter.id() < 0 or parameter.id() in self._parameters:
            warn(f"add_parameter: expected a new id from 0, got {parameter.id()}")
            return False
        self._parameters[parameter.id()] = parameter
        parameter._optimizer = self
        return True

    def parameter(self, id):
        return self._parameters.get(id)

    def push(self, vertices=None):
        for vertex in self._of(vertices):
            vertex.push()

    def pop(self, vertices=None):
        for vertex in self._of(vertices):
            vertex.pop()

    def discard_top(self, vertices=None):
        for vertex in self._of(vertices):
            vertex.discard_top()

    def set_fixed(self, vertices, fixed):
        for vertex in vertices:
            vertex.set_fixed(fixed)

    def chi2(self):
        """Σ eᵀΩe over all edges with vertices, without kernels."""
        return float(sum(edge.chi2() for edge in self._edges if None not in edge._vertices))

    _insert_vertex, _insert_edge, _insert_parameter = add_vertex, add_edge, add_parameter

    def load(self, path):
        """Reads a .g2o file. Returns False if a line is bad; warnings name the lines."""
        return _files.load(self, path)

    def save(self, path, level=0):
        """Writes the edges of a level, with all vertices and parameters."""
        return _files.save(self, path, level)

    def _of(self, vertices):
        if vertices is None:
            return list(self._vertices.values())
        return list(vertices.values()) if isinstance(vertices, dict) else list(vertices)

    # Errors, which are computed for all edges at once.

    def _error_of(self, edge):
        if self._errors_of != self._state:
            self._errors, self._errors_of, self._misses = {}, self._state, 0
        if edge not in self._errors:
            self._misses += 1
            members = [edge] if self._misses < SINGLE_ERRORS else self._edges
            self._compute_errors([e for e in members if None not in e._vertices] or [edge])
        return self._errors[edge]

    def _compute_errors(self, edges):
        alike = {}
        for edge in edges:
            if edge._is_custom():
                self._errors[edge] = edge._evaluate()
            else:
                alike.setdefault((type(edge), len(edge._data())), []).append(edge)
        for (cls, _), members in alike.items():
            rows = [np.array([edge._vertices[i]._row for edge in members]) for i in range(len(members[0]._vertices))]
            errors = cls._residuals(np.array([edge._data() for edge in members], dtype=float), *rows)
            self._errors.update(zip(members, errors))

    # Changes, by vertices and edges.

    def _vertex_changed(self, vertex, flags):
        self._changed_vertices[vertex] = flags or self._changed_vertices.get(vertex, False)
        if not flags:
            self._state += 1

    def _edge_changed(self, edge, error):
        self._changed_edges[edge] = None
        if error:
            self._state += 1

    def _forget_edge(self, edge):
        if self._engine is not None:
            self._engine.remove_edge(edge)
        self._changed_edges.pop(edge, None)
        self._errors.pop(edge, None)
