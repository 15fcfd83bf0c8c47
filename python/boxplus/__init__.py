# SPDX-License-Identifier: BSD-3-Clause
"""Nonlinear least squares on graphs: SLAM, calibration, trajectory fitting.

The names are those of the C++ library, and docs/python.md explains the differences. Poses and rotations are the
classes SE2, SE3, SO2 and SO3; points and matrices are NumPy arrays.
"""

import numpy as _numpy

from . import _boxplus
from ._boxplus import *
from ._html import report_as_html as _report_as_html
from ._pandas import report_to_pandas as _report_to_pandas


class Vector2:
    """The class of points in the plane. Vector2(x, y) is a NumPy array of two numbers."""

    def __new__(cls, x, y):
        return _numpy.array([x, y], dtype=float)


class Vector3:
    """The class of points in space. Vector3(x, y, z) is a NumPy array of three numbers."""

    def __new__(cls, x, y, z):
        return _numpy.array([x, y, z], dtype=float)


_boxplus.Report._repr_html_ = _report_as_html
_boxplus.Report.to_pandas = _report_to_pandas
__all__ = [name for name in vars(_boxplus) if not name.startswith("_")] + ["Vector2", "Vector3"]
