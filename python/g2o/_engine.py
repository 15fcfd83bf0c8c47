# SPDX-License-Identifier: BSD-3-Clause
"""The graph of boxplus behind a SparseOptimizer. It gets what has changed before each run, and gives the estimates back."""

import numpy as np

import boxplus

from . import _kinds
from ._groups import CustomGroup, Group, GroupWithJacobians

#: A step of more than 12 numbers is in several vertices of boxplus. These are the ids of the others.
FIRST_STEP_ID = 1 << 60
#: The edges of boxplus whose last vertex is a parameter.
WITH_SENSOR = (boxplus.OffsetPointObservation2, boxplus.OffsetPointObservation3)


def _measurement(edge):
    """The measurement of a native edge, as an object of boxplus."""
    types = {"SE2": boxplus.SE2, "Isometry3d": boxplus.SE3, "Sim3": boxplus.Sim3}
    name = edge._CODEC.name
    return types[name].from_vector(edge._z) if name in types else edge._z


class Engine:
    def __init__(self):
        self.graph = boxplus.Graph()
        self.ids = {}  # vertex: the ids of the vertices of boxplus that hold its estimate or its step
        self.refs = {}  # edge: EdgeRef
        self._places = {}  # edge: (group, place), unless boxplus has its type
        self._groups = {}
        self._kernels = {}
        self._parameters = {}  # parameter: [VertexRef, version]
        self._versions = {}
        self._next = FIRST_STEP_ID
        self._optimizer = boxplus.Optimizer(self.graph)

    # Changes.

    def sync(self, vertices, changed_vertices, edges, changed_edges):
        """Adds vertices and edges, and applies changes. The dicts of changes say whether flags or errors have changed."""
        self._add_vertices([vertex for vertex in vertices if vertex not in self.ids])
        self._change_vertices(changed_vertices)
        self._refresh_parameters()
        self._add_edges([edge for edge in edges if edge not in self.refs and None not in edge._vertices])
        self._change_edges(changed_edges)
        self._set_kernels(edges)

    def remove_vertex(self, vertex):
        for id in self.ids.pop(vertex, ()):
            self.graph.remove(id)

    def remove_edge(self, edge):
        ref = self.refs.pop(edge, None)
        self._places.pop(edge, None)
        self._kernels.pop(edge, None)
        if ref is not None and self.graph.contains(ref):
            self.graph.remove(ref)

    def _add_vertices(self, vertices):
        by_kind = {}
        for vertex in vertices:
            if vertex._is_chart():
                kinds = _kinds.pieces(vertex.dimension())
                self.ids[vertex] = [vertex.id(), *range(self._next, self._next + len(kinds) - 1)]
                self._next += len(kinds) - 1
                for kind, id in zip(kinds, self.ids[vertex]):
                    by_kind.setdefault(kind, []).append((id, np.zeros(kind.size)))
            else:
                self.ids[vertex] = [vertex.id()]
                by_kind.setdefault(vertex._KIND, []).append((vertex.id(), vertex._row))
        for kind, rows in by_kind.items():
            self.graph.add_vertices(kind.type, [id for id, _ in rows], np.array([row for _, row in rows]))
        for vertex in vertices:
            self._set_flags(vertex)

    def _set_flags(self, vertex):
        for id in self.ids[vertex]:
            self.graph.set_fixed(id, vertex.fixed())
            self.graph.set_eliminated(id, vertex.marginalized())
        if vertex._KIND is _kinds.SIM3 and not vertex._is_chart():
            self.graph.fix_directions(vertex.id(), vertex._fixed_directions())

    def _change_vertices(self, changed):
        by_kind = {}
        for vertex, flags in changed.items():
            if flags:
                self._set_flags(vertex)
            if not vertex._is_chart():
                by_kind.setdefault(vertex._KIND, []).append(vertex)
        for kind, vertices in by_kind.items():
            self.graph.set_estimates(kind.type, [vertex.id() for vertex in vertices],
                                     np.array([vertex._row for vertex in vertices]))

    def _refresh_parameters(self):
        changed = set()
        for parameter, version in self._versions.items():
            if parameter._version != version:
                changed.add(parameter)
        for parameter in changed:
            self._versions[parameter] = parameter._version
            if parameter in self._parameters:
                kind = boxplus.SE2 if len(parameter._row) == 3 else boxplus.SE3
                self.graph.set_estimate(self._parameters[parameter], kind.from_vector(parameter._row))
        if changed:
            for edge, (group, place) in self._places.items():
                if edge._PARAMETERS:
                    group.refresh(place)

    def _parameter_ref(self, parameter):
        if parameter not in self._parameters:
            kind = boxplus.SE2 if len(parameter._row) == 3 else boxplus.SE3
            self._parameters[parameter] = self.graph.add_parameter(kind.from_vector(parameter._row), parameter.id())
        return self._parameters[parameter]

    def _add_edges(self, edges):
        by_key = {}
        for edge in edges:
            is_without = edge._is_custom() or edge._NATIVE not in (*WITH_SENSOR, None)
            for i in range(0 if is_without else len(edge._PARAMETERS)):
                parameter = edge._parameter(i)
                self._versions.setdefault(parameter, parameter._version)
            by_key.setdefault(self._key(edge), []).append(edge)
        for key, members in by_key.items():
            self._add_alike(key, members)

    def _key(self, edge):
        kinds = tuple(tuple(_kinds.pieces(vertex.dimension())) if vertex._is_chart() else (vertex._KIND,)
                      for vertex in edge._vertices)
        charts = tuple(vertex._is_chart() for vertex in edge._vertices)
        native = edge._NATIVE is not None and not edge._is_custom() and not any(charts)
        parameter = edge._parameter(0) if native and edge._NATIVE in WITH_SENSOR else None
        return type(edge), edge.dimension(), kinds, charts, native, parameter, len(edge._data())

    def _add_alike(self, key, edges):
        _, _, kinds, charts, native, parameter, _ = key
        ids = [[id for vertex in edge._vertices for id in self.ids[vertex]] for edge in edges]
        columns = list(np.array(ids, dtype=np.int64).T)
        informations = np.array([edge._current_information() for edge in edges])
        if native:
            if parameter is not None:
                columns.append(self._parameter_ref(parameter))
            refs = self.graph.add_edges(edges[0]._NATIVE, *columns, measurements=np.array([edge._z for edge in edges]),
                                        informations=informations)
        else:
            places = self._extend_group(key, edges, kinds, charts)
            refs = self.graph.add_edges(self._groups[key], *columns, measurements=places, informations=informations)
        for edge, ref in zip(edges, refs):
            self.refs[edge] = ref
            if edge.level() != 0:
                self.graph.set_level(ref, edge.level())

    def _extend_group(self, key, edges, kinds, charts):
        group = self._groups.get(key)
        if group is None:
            make = GroupWithJacobians if type(edges[0])._jacobians is not None else Group
            make = CustomGroup if edges[0]._is_custom() or any(charts) else make
            # Messages name the class of a group.
            self._groups[key] = group = type(type(edges[0]).__name__, (make,), {})(kinds)
        places = group.extend(edges)
        for edge, place in zip(edges, places[:, 0]):
            self._places[edge] = group, int(place)
        return places

    def _change_edges(self, changed):
        for edge in changed:
            ref = self.refs.get(edge)
            if ref is None:
                continue
            if edge in self._places:
                group, place = self._places[edge]
                group.refresh(place)
            else:
                self.graph.set_measurement(ref, _measurement(edge))
            self.graph.set_information(ref, edge._current_information())
            self.graph.set_level(ref, edge.level())

    def _set_kernels(self, edges):
        """A kernel may have got another width."""
        by_kernel = {}
        for edge in edges:
            key = None if edge._kernel is None else edge._kernel._key()
            if self._kernels.get(edge) != key and edge in self.refs:
                by_kernel.setdefault(key, []).append(self.refs[edge])
                self._kernels[edge] = key
        for key, refs in by_kernel.items():
            self.graph.set_kernel(refs, None if key is None else boxplus.make_robust_kernel(*key))

    # Runs.

    def run(self, options):
        self._optimizer.set_options(boxplus.Options(**options))
        try:
            return self._optimizer.run()
        finally:
            self._optimizer.set_options(boxplus.Options())  # lets the callback go

    def read_estimates(self, vertices):
        """Gives the estimates of boxplus to the vertices, and applies the steps that it holds."""
        rows = {}
        for kind in {vertex._KIND for vertex in vertices if not vertex._is_chart()}:
            rows.update(self._rows(kind))
        steps = {}
        for vertex in vertices:
            if not vertex._is_chart():
                vertex._row = rows[vertex.id()]
            elif not vertex.fixed():
                for kind in set(_kinds.pieces(vertex.dimension())) - steps.keys():
                    steps[kind] = self._rows(kind)
                parts = [steps[kind][id] for kind, id in zip(_kinds.pieces(vertex.dimension()), self.ids[vertex])]
                self._apply(vertex, np.concatenate(parts))

    def _rows(self, kind):
        ids, rows = self.graph.estimates(kind.type)
        return dict(zip(ids.tolist(), rows))

    def _apply(self, vertex, step):
        if not step.any():
            return
        vertex._apply(step)
        for kind, id in zip(_kinds.pieces(vertex.dimension()), self.ids[vertex]):
            self.graph.set_estimate(id, np.zeros(kind.size))

    def covariances(self, vertices, options):
        """A function of two vertices that gives a block, or None if H is singular."""
        ids = [id for vertex in vertices for id in self.ids[vertex]]
        found = boxplus.covariance(self.graph, ids, boxplus.Options(**options))
        if not found.ok():
            return None, found.message()
        return lambda a, b: _to_tangent(a) @ np.block(
            [[found.of(i, j) for j in self.ids[b]] for i in self.ids[a]]) @ _to_tangent(b).T, ""


def _to_tangent(vertex):
    """The derivative of a step of g2o by a step of boxplus."""
    tangent = None if vertex._is_chart() else vertex._tangent()
    return np.eye(vertex.dimension()) if tangent is None else np.linalg.inv(tangent)
