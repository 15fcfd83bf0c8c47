# SPDX-License-Identifier: BSD-3-Clause
"""Poses and points of space."""

import numpy as np

import boxplus

from . import _kinds, _rows
from ._codecs import ISOMETRY, POINT3
from ._elements import Edge, Parameter, Vertex
from ._geometry import Isometry3d


class ParameterSE3Offset(Parameter):
    """The pose of a sensor on the robot."""

    _TAG = "PARAMS_SE3OFFSET"

    def __init__(self):
        super().__init__()
        self._row = ISOMETRY.origin.copy()

    def offset(self):
        return ISOMETRY.decode(self._row)

    def set_offset(self, offset=None):
        self._row = ISOMETRY.encode(Isometry3d() if offset is None else offset)
        self._changed()

    def _data(self):
        return self._row


class ParameterCamera(ParameterSE3Offset):
    """The pose of a camera on the robot, and its camera matrix."""

    _TAG = "PARAMS_CAMERACALIB"

    def __init__(self):
        super().__init__()
        self._intrinsics = np.array([1.0, 1, 0, 0])

    def set_kcam(self, fx, fy, cx, cy):
        self._intrinsics = np.array([fx, fy, cx, cy], dtype=float)
        self._changed()

    def kcam(self):
        fx, fy, cx, cy = self._intrinsics
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])

    def _data(self):
        return np.concatenate([self._row, self._intrinsics])


class VertexSE3(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_SE3:QUAT", _kinds.SE3, ISOMETRY


class VertexPointXYZ(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_TRACKXYZ", _kinds.VECTORS[3], POINT3


class EdgeSE3(Edge):
    """The pose j as seen from i."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_SE3:QUAT", (VertexSE3, VertexSE3), ISOMETRY, boxplus.Between, 6

    @staticmethod
    def _residuals(z, a, b):
        return _rows.relative(z, a, b)

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(0).estimate().inverse() * self.vertex(1).estimate())
        return True


class EdgeSE3Prior(Edge):
    """The pose of a sensor, whose pose on the robot is a parameter."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3_PRIOR", (VertexSE3,), ISOMETRY, 6
    _PARAMETERS = (ParameterSE3Offset,)

    @staticmethod
    def _residuals(data, x):
        return _rows.minimal(_rows.compose(_rows.inverse(data[:, :7]), _rows.compose(x, data[:, 7:])))


class EdgeSE3XYZPrior(Edge):
    """The position of a pose. The parameter has no effect, as in g2o's file format."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_SE3_XYZ_PRIOR", (VertexSE3,), POINT3, boxplus.PositionPrior, 3
    _PARAMETERS = (ParameterSE3Offset,)

    def _data(self):
        return self._z

    @staticmethod
    def _residuals(z, x):
        return x[:, :3] - z


class EdgeSE3Offset(Edge):
    """The pose of a sensor at j as seen from a sensor at i."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3_OFFSET", (VertexSE3, VertexSE3), ISOMETRY, 6
    _PARAMETERS = (ParameterSE3Offset, ParameterSE3Offset)

    @staticmethod
    def _residuals(data, a, b):
        return _rows.relative(data[:, :7], _rows.compose(a, data[:, 7:14]), _rows.compose(b, data[:, 14:]))


class EdgePointXYZ(Edge):
    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_POINTXYZ", (VertexPointXYZ, VertexPointXYZ), POINT3, boxplus.Between, 3

    @staticmethod
    def _residuals(z, a, b):
        return b - a - z


class EdgeXYZPrior(Edge):
    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_POINTXYZ_PRIOR", (VertexPointXYZ,), POINT3, boxplus.Prior, 3

    @staticmethod
    def _residuals(z, x):
        return x - z


class EdgeSE3PointXYZ(Edge):
    """A point as seen from a sensor, whose pose on the robot is a parameter."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = ("EDGE_SE3_TRACKXYZ", (VertexSE3, VertexPointXYZ), POINT3,
                                              boxplus.OffsetPointObservation3, 3)
    _PARAMETERS = (ParameterSE3Offset,)

    @staticmethod
    def _residuals(data, x, p):
        return _rows.into(_rows.compose(x, data[:, 3:]), p) - data[:, :3]


def _image(data, x, p):
    """(u, v) of points in the camera on a pose, and their depths."""
    seen = _rows.into(_rows.compose(x, data[:, 3:10]), p)
    return data[:, 10:12] * seen[:, :2] / seen[:, 2:] + data[:, 12:14], seen[:, 2:]


class EdgeSE3PointXYZDepth(Edge):
    """(u, v, depth) of a point in a camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_DEPTH", (VertexSE3, VertexPointXYZ), POINT3, 3
    _PARAMETERS = (ParameterCamera,)

    @staticmethod
    def _residuals(data, x, p):
        image, depth = _image(data, x, p)
        return np.concatenate([image, depth], axis=1) - data[:, :3]


class EdgeSE3PointXYZDisparity(Edge):
    """(u, v, 1 / depth) of a point in a camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_DISPARITY", (VertexSE3, VertexPointXYZ), POINT3, 3
    _PARAMETERS = (ParameterCamera,)

    @staticmethod
    def _residuals(data, x, p):
        image, depth = _image(data, x, p)
        return np.concatenate([image, 1 / depth], axis=1) - data[:, :3]
