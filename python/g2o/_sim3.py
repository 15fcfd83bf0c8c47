# SPDX-License-Identifier: BSD-3-Clause
"""Similarities. A VertexSim3Expmap is the similarity from the world frame to the frame of a camera; its step is
(omega, upsilon, sigma), with S ⊞ step = exp(step) S. Its row is S⁻¹, as is the row of a measurement."""

import numpy as np

import boxplus

from . import _kinds, _rows
from ._codecs import POINT2, SIMILARITY
from ._elements import Edge, Vertex
from ._geometry import vector
from ._sba import pinhole
from ._slam3d import VertexPointXYZ


class VertexSim3Expmap(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_SIM3:EXPMAP", _kinds.SIM3, SIMILARITY

    def __init__(self):
        super().__init__()
        self._fix_scale = False
        self._cameras = np.array([1.0, 1, 0, 0, 1, 1, 0, 0])

    def fix_scale(self):
        return self._fix_scale

    def set_fix_scale(self, fix_scale):
        """If true, steps keep the scale."""
        self._fix_scale = bool(fix_scale)
        self._changed(flags=True)

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
        step[self._fixed_directions()] = 0
        super()._oplus(-step)

    def _tangent(self):
        return -np.eye(7)

    def _fixed_directions(self):
        return [6] if self._fix_scale else []


class EdgeSim3(Edge):
    """The similarity from camera i to camera j: S_j = z S_i."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = ("EDGE_SIM3:EXPMAP", (VertexSim3Expmap, VertexSim3Expmap), SIMILARITY,
                                              boxplus.Between, 7)

    @staticmethod
    def _residuals(*rows):
        similarities = [map(boxplus.Sim3.from_vector, each) for each in rows]
        return np.array([(z.inverse() * (a.inverse() * b)).log() for z, a, b in zip(*similarities)])

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(1).estimate() * self.vertex(0).estimate().inverse())
        return True


class EdgeSim3ProjectXYZ(Edge):
    """The image of a point in the first camera: vertices point, camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_SIM3_XYZ:EXPMAP", (VertexPointXYZ, VertexSim3Expmap), POINT2, 2

    def _data(self):
        return np.concatenate([self._z, self._vertices[1]._cameras[:4]])

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :2] - pinhole(_rows.into(x[:, :7], p) / x[:, 7:], data[:, 2:])


class EdgeInverseSim3ProjectXYZ(Edge):
    """The image of a point of the first camera in the second camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP", (VertexPointXYZ, VertexSim3Expmap), POINT2, 2

    def _data(self):
        return np.concatenate([self._z, self._vertices[1]._cameras[4:]])

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :2] - pinhole(_rows.out_of(x[:, :7], x[:, 7:] * p), data[:, 2:])
