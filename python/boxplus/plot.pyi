# SPDX-License-Identifier: BSD-3-Clause
# The types of boxplus.plot. tests/python/stubs_test.py compares them with the module.
from __future__ import annotations

from typing import Any, Sequence

from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from . import Covariance, Graph, OutlierReport, Report, VertexRef

def trajectory(
    graph: Graph,
    ax: Axes | None = None,
    truth: Graph | ArrayLike | None = None,
    *,
    plane: str | None = None,
    edges: bool = True,
    label: str | None = "poses",
) -> Axes: ...
def closures(
    graph: Graph,
    ax: Axes | None = None,
    found: OutlierReport | None = None,
    *,
    plane: str | None = None,
    limits: tuple[float, float] | None = None,
    colorbar: bool = True,
) -> Axes: ...
def covariances(
    graph: Graph,
    vertices: Sequence[VertexRef | int],
    covariance: Covariance,
    sigmas: float = 2,
    ax: Axes | None = None,
    *,
    plane: str | None = None,
    color: Any = "#7c3aed",
    label: str | None = None,
) -> Axes: ...
def convergence(report: Report, ax: Axes | None = None, *, label: str | None = None) -> Axes: ...
