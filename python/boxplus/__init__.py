# SPDX-License-Identifier: BSD-3-Clause
"""Nonlinear least squares on graphs: SLAM, calibration, trajectory fitting.

The names are those of the C++ library, and docs/python.md explains the differences. Poses and rotations are the
classes SE2, SE3, SO2 and SO3; points and matrices are NumPy arrays.
"""

import numpy as _numpy

from . import _boxplus, rows
from ._batched import BatchedEdge, EdgeFunctionCost
from ._boxplus import *
from ._html import report_as_html as _report_as_html
from ._pandas import report_to_pandas as _report_to_pandas
from ._pickle import reduce_graph as _reduce_graph
from ._report_text import report_text as _report_text
from ._threads import awaited as _awaited, stoppable as _stoppable, stoppable_run as _stoppable_run
from ._view import Viewer, view


def _vector_class(size):
    def new(cls, *numbers):
        if len(numbers) != size:
            raise TypeError(f"Vector{size}: expected {size} numbers, got {len(numbers)}")
        return _numpy.array(numbers, dtype=float)

    place = {2: "points in the plane", 3: "points in space"}.get(size, f"vectors of {size} numbers")
    return type(f"Vector{size}", (), {"__new__": new, "__module__": "boxplus", "__doc__":
                                      f"The class of {place}. Vector{size}(...) is a NumPy array."})


_VECTORS = [f"Vector{size}" for size in range(1, 13)]
for _size, _vector in enumerate(_VECTORS, 1):
    globals()[_vector] = _vector_class(_size)

for _name in ("optimize", "covariance", "marginal_covariances", "diagnose", "find_outliers", "certify"):
    globals()[_name] = _stoppable(getattr(_boxplus, _name))
for _name in ("run", "covariance", "marginal_covariances"):
    setattr(_boxplus.Optimizer, _name, _stoppable_run(getattr(_boxplus.Optimizer, _name)))
for _name in ("update", "finish"):
    setattr(_boxplus.Smoother, _name, _stoppable_run(getattr(_boxplus.Smoother, _name)))
load, marginalize = _awaited(_boxplus.load), _awaited(_boxplus.marginalize)
__version__ = _boxplus.__version__

_boxplus.Graph.__reduce_ex__ = _reduce_graph
_boxplus.Report.edge_functions = ()
_boxplus.Report.__repr__ = _report_text
_boxplus.Report._repr_html_ = _report_as_html
_boxplus.Report.to_pandas = _report_to_pandas
__all__ = [name for name in vars(_boxplus) if not name.startswith("_")] + _VECTORS + ["BatchedEdge", "EdgeFunctionCost",
                                                                                             "Viewer", "view"]
