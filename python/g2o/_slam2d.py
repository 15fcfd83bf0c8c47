# SPDX-License-Identifier: BSD-3-Clause
"""Poses and points of the plane."""

import numpy as np

import boxplus

from . import _kinds, _rows
from ._codecs import NUMBER, POINT2, POSE2, VECTOR4
from ._elements import Edge, Parameter, Vertex


class ParameterSE2Offset(Parameter):
    """The pose of a sensor on the robot."""

    _TAG = "PARAMS_SE2OFFSET"

    def __init__(self):
        super().__init__()
        self._row = np.zeros(3)

    def offset(self):
        return POSE2.decode(self._row)

    def set_offset(self, offset):
        self._row = POSE2.encode(offset)
        self._changed()

    def _data(self):
        return self._row


class VertexSE2(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_SE2", _kinds.SE2, POSE2


class VertexPointXY(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_XY", _kinds.VECTORS[2], POINT2


class EdgeSE2(Edge):
    """The pose j as seen from i."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_SE2", (VertexSE2, VertexSE2), POSE2, boxplus.Between, 3

    @staticmethod
    def _residuals(z, a, b):
        return _rows.relative2(z, a, b)

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(0).estimate().inverse() * self.vertex(1).estimate())
        return True


class EdgeSE2Prior(Edge):
    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_PRIOR_SE2", (VertexSE2,), POSE2, boxplus.Prior, 3

    @staticmethod
    def _residuals(z, x):
        return _rows.compose2(_rows.inverse2(z), x)

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(0).estimate())
        return True


class EdgeSE2XYPrior(Edge):
    """The position of a pose."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_PRIOR_SE2_XY", (VertexSE2,), POINT2, boxplus.PositionPrior, 2

    @staticmethod
    def _residuals(z, x):
        return x[:, :2] - z


class EdgeXYPrior(Edge):
    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_PRIOR_XY", (VertexPointXY,), POINT2, boxplus.Prior, 2

    @staticmethod
    def _residuals(z, x):
        return x - z


class EdgePointXY(Edge):
    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = "EDGE_POINTXY", (VertexPointXY, VertexPointXY), POINT2, boxplus.Between, 2

    @staticmethod
    def _residuals(z, a, b):
        return b - a - z


class EdgeSE2PointXY(Edge):
    """A point as seen from a pose."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = ("EDGE_SE2_XY", (VertexSE2, VertexPointXY), POINT2,
                                              boxplus.PointObservation2, 2)

    @staticmethod
    def _residuals(z, x, p):
        return _rows.into2(x, p) - z


class EdgeSE2PointXYBearing(Edge):
    """The angle to a point in the frame of a pose."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = ("EDGE_BEARING_SE2_XY", (VertexSE2, VertexPointXY), NUMBER,
                                              boxplus.BearingObservation2, 1)

    @staticmethod
    def _residuals(z, x, p):
        seen = _rows.into2(x, p)
        return _rows.wrapped(z[:, 0] - np.arctan2(seen[:, 1], seen[:, 0]))[:, None]


class EdgeSE2PointXYOffset(Edge):
    """A point as seen from a sensor, whose pose on the robot is a parameter."""

    _TAG, _VERTICES, _CODEC, _NATIVE, _DIM = ("EDGE_SE2_POINTXY_OFFSET", (VertexSE2, VertexPointXY), POINT2,
                                              boxplus.OffsetPointObservation2, 2)
    _PARAMETERS = (ParameterSE2Offset,)

    @staticmethod
    def _residuals(data, x, p):
        return _rows.into2(_rows.compose2(x, data[:, 2:]), p) - data[:, :2]


class EdgeSE2PointXYCalib(Edge):
    """A point as seen from a sensor, whose pose on the robot is a vertex."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE2_XY_CALIB", (VertexSE2, VertexPointXY, VertexSE2), POINT2, 2

    @staticmethod
    def _residuals(z, x, p, sensor):
        return _rows.into2(_rows.compose2(x, sensor), p) - z


class EdgeSE2Offset(Edge):
    """The pose of a sensor at j as seen from a sensor at i."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE2_OFFSET", (VertexSE2, VertexSE2), POSE2, 3
    _PARAMETERS = (ParameterSE2Offset, ParameterSE2Offset)

    @staticmethod
    def _residuals(data, a, b):
        return _rows.relative2(data[:, :3], _rows.compose2(a, data[:, 3:6]), _rows.compose2(b, data[:, 6:]))


class EdgeSE2TwoPointsXY(Edge):
    """Two points as seen from a pose."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE2_TWOPOINTSXY", (VertexSE2, VertexPointXY, VertexPointXY), VECTOR4, 4

    @staticmethod
    def _residuals(z, x, p, q):
        return np.concatenate([_rows.into2(x, p), _rows.into2(x, q)], axis=1) - z
