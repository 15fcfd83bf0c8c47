# SPDX-License-Identifier: BSD-3-Clause
"""Similarities. A VertexSim3Expmap is the similarity from the world frame to the frame of a camera; its step is
(omega, upsilon, sigma), with S ⊞ step = exp(step) S."""

import numpy as np

from . import _rows
from ._codecs import POINT2, SIMILARITY
from ._elements import Edge, Vertex
from ._geometry import vector
from ._slam3d import VertexPointXYZ


class VertexSim3Expmap(Vertex):
    _TAG, _CODEC = "VERTEX_SIM3:EXPMAP", SIMILARITY

    def __init__(self):
        super().__init__()
        self._fix_scale = False
        self._cameras = np.array([1.0, 1, 0, 0, 1, 1, 0, 0])

    def dimension(self):
        return 7

    def fix_scale(self):
        return self._fix_scale

    def set_fix_scale(self, fix_scale):
        """If true, steps keep the scale."""
        self._fix_scale = bool(fix_scale)
        self._changed()

    def _camera(where):
        def change(self, value):
            self._cameras = self._cameras.copy()
            self._cameras[where] = vector(value, 2, "camera")
            for edge in self._edges:
                edge._changed()

        return property(lambda self: self._cameras[where].copy(), change)

    focal_length1, principle_point1 = _camera(slice(0, 2)), _camera(slice(2, 4))
    focal_length2, principle_point2 = _camera(slice(4, 6)), _camera(slice(6, 8))
    del _camera

    def cam_map1(self, v):
        return vector(v, 2, "v") * self._cameras[:2] + self._cameras[2:4]

    def cam_map2(self, v):
        return vector(v, 2, "v") * self._cameras[4:6] + self._cameras[6:]

    def _oplus(self, step):
        self._row = self._moved_rows(self._row[None], step[None], np.array([self._fix_scale]))[0]

    @staticmethod
    def _moved_rows(rows, steps, fix_scale):
        steps = np.where(fix_scale[:, None] & (np.arange(7) == 6), 0, steps)
        return _rows.similarity_compose(_rows.similarity_exponential(steps), rows)


class EdgeSim3(Edge):
    """The similarity from camera i to camera j: S_j = z S_i."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SIM3:EXPMAP", (VertexSim3Expmap, VertexSim3Expmap), SIMILARITY, 7

    @staticmethod
    def _residuals(z, a, b):
        return _rows.similarity_logarithm(_rows.similarity_compose(_rows.similarity_compose(z, a),
                                                                   _rows.similarity_inverse(b)))

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(1).estimate() * self.vertex(0).estimate().inverse())
        return True


class EdgeSim3ProjectXYZ(Edge):
    """The image of a point in the first camera: vertices point, camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_SIM3_XYZ:EXPMAP", (VertexPointXYZ, VertexSim3Expmap), POINT2, 2

    def _data(self):
        return np.concatenate([self._z, self._vertices[1]._cameras[:4]])

    @staticmethod
    def _residuals(data, p, s):
        seen = _rows.similarity_map(s, p)
        return data[:, :2] - (data[:, 2:4] * seen[:, :2] / seen[:, 2:] + data[:, 4:])


class EdgeInverseSim3ProjectXYZ(Edge):
    """The image of a point of the first camera in the second camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP", (VertexPointXYZ, VertexSim3Expmap), POINT2, 2

    def _data(self):
        return np.concatenate([self._z, self._vertices[1]._cameras[4:]])

    @staticmethod
    def _residuals(data, p, s):
        seen = _rows.similarity_map(_rows.similarity_inverse(s), p)
        return data[:, :2] - (data[:, 2:4] * seen[:, :2] / seen[:, 2:] + data[:, 4:])
