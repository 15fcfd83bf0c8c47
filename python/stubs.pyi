# SPDX-License-Identifier: BSD-3-Clause
# The types that the bindings do not know: aliases, what the package defines in Python, and where `object` says too little.
# make_stubs.py adds all other names of the module.
from __future__ import annotations

import os
from typing import Any, Callable, Literal, NamedTuple, Optional, Sequence, Union, overload

import numpy
from numpy.typing import ArrayLike

from . import rows as rows

__version__: str
Array = numpy.ndarray[Any, numpy.dtype[numpy.float64]]
Ids = numpy.ndarray[Any, numpy.dtype[numpy.int64]]
Vertex = VertexRef | int
Manifold = SO2 | SE2 | SO3 | SE3 | S2 | Sim3 | Plane3 | Line3 | Camera
Estimate = Manifold | tuple[Manifold | ArrayLike, ...] | ArrayLike
VertexType = type[Manifold] | type[Array] | tuple[type[Manifold] | type[Array], ...]

class Enum:
    name: str
    value: int

class InputError:
    line: int
    column: int

class BatchedEdge:
    def error(self, *arguments: Any, **options: Any) -> Any: ...

class EdgeFunctionCost(NamedTuple):
    name: str
    jacobians: str
    calls: int
    edges: int
    seconds: float

class CalibratedReprojection(Edge):
    camera: Camera
    def __init__(self, measurement: ArrayLike, camera: Camera) -> None: ...

class Graph:
    def add_vertex(self, estimate: Estimate, id: int | None = None) -> VertexRef: ...
    def add_parameter(self, value: Estimate, id: int | None = None) -> VertexRef: ...
    def add_edge(
        self, edge: Edge | Callable[..., Any] | Constraint, *vertices: Vertex, information: float | ArrayLike = 1.0
    ) -> EdgeRef: ...
    def kernel(self, edge: EdgeRef) -> RobustKernel | None: ...
    def add_vertices(self, type: VertexType, ids: ArrayLike | None, estimates: ArrayLike) -> Ids: ...
    def add_edges(
        self,
        type: type[Edge] | BatchedEdge | Callable[..., Any] | Constraint,
        *vertices: Vertex | ArrayLike | Sequence[Vertex],
        measurements: ArrayLike | None = None,
        informations: ArrayLike = 1.0,
        camera: Camera | None = None,
    ) -> list[EdgeRef]: ...

def se3_sigmas(translation: float, rotation: float) -> Array: ...
def load(
    path: str | os.PathLike[str],
    *,
    lenient: bool = False,
    information: Literal["refuse", "project", "as-given"] = "refuse",
    threads: int = 0,
) -> Graph: ...

class Options:
    vertices: Sequence[Vertex]
    callback: Callable[[IterationRecord], bool | None] | None
    stop: StopFlag | None

class Report:
    edge_functions: tuple[EdgeFunctionCost, ...]
    def to_pandas(self) -> Any: ...

class OutlierReport:
    def arrays(self) -> dict[str, numpy.ndarray[Any, numpy.dtype[Any]]]: ...

def optimize(graph: Graph, options: Options | None = None, **changes: Any) -> Report: ...

class Optimizer:
    def run(self) -> Report: ...

class SmootherOptions:
    lag: int | None
    stop: StopFlag | None

class Smoother:
    def __init__(self, graph: Graph, options: SmootherOptions | None = None, **changes: Any) -> None: ...
    def set_options(self, options: SmootherOptions | None = None, **changes: Any) -> None: ...

class Viewer:
    def __init__(self, graph: Graph, *, name: str = "graph", host: str = "127.0.0.1", port: int = 0) -> None: ...
    @property
    def url(self) -> str: ...
    @property
    def closed(self) -> bool: ...
    def close(self) -> None: ...
    def update(self) -> None: ...
    def hand_over(self) -> None: ...
    def take_back(self) -> None: ...
    def __enter__(self) -> Viewer: ...
    def __exit__(self, *_: object) -> None: ...

def view(graph: Graph, *, name: str = "graph", host: str = "127.0.0.1", port: int = 0) -> Viewer: ...
