# SPDX-License-Identifier: BSD-3-Clause
"""Edges from a pose to any number of points, which are seen from the pose."""

import numpy as np

from . import _rows
from ._codecs import vectors
from ._elements import Edge, identity
from ._slam2d import VertexPointXY, VertexSE2
from ._slam3d import VertexPointXYZ, VertexSE3


class LotsOfPoints(Edge):
    """resize(n) sets the number of vertices: a pose and n − 1 points. The measurement has the coordinates of the points one
    after the other."""

    _POINT = None

    def __init__(self):
        super().__init__()
        self._set_size(1)

    def resize(self, vertices):
        if vertices < 1:
            raise ValueError(f"{type(self).__name__}: expected at least 1 vertex, got {vertices}")
        if self._optimizer is not None:
            raise ValueError(f"{type(self).__name__}: resize() must be called before add_edge()")
        self._set_size(vertices)

    def _set_size(self, vertices):
        self._vertices = (self._vertices + [None] * vertices)[:vertices]
        self._DIM = (vertices - 1) * self._POINT._KIND.dim
        self._CODEC = vectors(self._DIM)
        self._z, self._information = np.zeros(self._DIM), identity(self._DIM)

    def set_measurement(self, measurement):
        super().set_measurement(np.ravel(measurement))

    def _type_of_vertex(self, i):
        return self._VERTICES[0] if i == 0 else self._POINT

    @staticmethod
    def _residuals(z, x, *points):
        return np.concatenate([_rows.inverse_times(x, p) for p in points], axis=1) - z

    def set_measurement_from_state(self):
        pose = self._vertices[0]._row[None]
        self.set_measurement([_rows.inverse_times(pose, vertex._row[None])[0] for vertex in self._vertices[1:]])
        return True


class EdgeSE2LotsOfXY(LotsOfPoints):
    _TAG, _VERTICES, _POINT = "EDGE_SE2_LOTSOFXY", (VertexSE2,), VertexPointXY


class EdgeSE3LotsOfXYZ(LotsOfPoints):
    _TAG, _VERTICES, _POINT = "EDGE_SE3_LOTSOF_XYZ", (VertexSE3,), VertexPointXYZ
