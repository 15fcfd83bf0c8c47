# SPDX-License-Identifier: BSD-3-Clause
"""Plots of graphs and reports with Matplotlib 3.6 or later.

`import boxplus` does not import this module; write `from boxplus import plot`. Every function draws into the Axes `ax`,
or into a new Figure, and returns the Axes. A new Figure is `ax.figure`, which has `savefig()`; pyplot does not know it.
To see a plot in a window, pass the Axes of a figure of pyplot, and call pyplot's show(). No function calls show(), and
none changes the settings of Matplotlib.

Positions are in the unit of the graph, which the labels call meters. A graph of the plane (SE2, Vector2) is drawn as it
is. A graph in space (SE3, Vector3) is drawn in Axes with projection="3d", or seen along an axis if `plane` is two of the
letters x, y and z: plane="xy" is the view from above. Vertices of other types have no position and are not drawn.
"""

import numpy as _np

from . import SE2, SE3, Vector2, Vector3
from ._boxplus import Graph

try:
    from matplotlib import collections as _collections
    from matplotlib import colors as _colors
    from matplotlib import ticker as _ticker
    from matplotlib.figure import Figure as _Figure
except ImportError as error:
    raise ImportError("boxplus.plot needs Matplotlib, which cannot be imported. Install it: apt-get install "
                      f"python3-matplotlib, or pip install matplotlib ({error})", name="matplotlib") from error

__all__ = ["closures", "convergence", "covariances", "trajectory"]

# The classes of vertices that have a position: their dimension, and whether they are poses.
_KINDS = {SE2: (2, True), SE3: (3, True), Vector2: (2, False), Vector3: (3, False)}

_POSES, _TRUTH, _LANDMARKS = "#1f3b73", "black", "#2a9d5c"
_ODOMETRY, _CLOSURES, _OBSERVATIONS = "#8fb4e3", "#d1495b", "#b8b8b8"
_VERDICTS = {"inlier": "#2a9d5c", "undecided": "#e9a23b", "outlier": "#d1495b"}
# From small to large errors: the colors of `boxplus plot`.
_ERRORS = _colors.LinearSegmentedColormap.from_list("errors", ["#a6b2c2", "#e29424", "#cf4a1f", "#9d1250", "#45084f"])
_CORNERS = 64  # of an ellipse


def trajectory(graph, ax=None, truth=None, *, plane=None, edges=True, label="poses"):
    """Draws the poses as a line in the order of their ids, the landmarks as points, and the edges between them.

    Edges between poses whose ids follow each other are odometry, and a band below the line: a bare part of the line has
    no odometry. All other edges between two poses are loop closures. Other edges between two vertices with positions are
    observations. Edges that are disabled are not drawn.

    truth: the true poses, drawn as a dashed line: a Graph, or an array (n, 2) or (n, 3) of positions in meters. An array
    may have more columns, as the arrays of Graph.estimates() have. It is drawn as it is, without an alignment.
    plane: the plane to which a graph in space is projected, such as "xy".
    edges: if False, no edges are drawn.
    label: the name of the line in the legend.

    Returns the Axes. Raises ValueError if the graph has no vertex with a position, or vertices of the plane and of space.
    """
    view = _View(graph, ax, plane)
    poses, landmarks = view.poses, view.landmarks
    if edges:
        lines = {"observations": [], "odometry": [], "loop closures": []}
        for edge in graph.all_edges():
            ends = view.ends(graph, edge)
            if ends is not None:
                lines[view.kind_of(*ends)].append(ends)
        for (name, ends), color, width in zip(lines.items(), (_OBSERVATIONS, _ODOMETRY, _CLOSURES), (0.4, 3, 0.8)):
            if ends:
                view.line(view.broken_line(ends), color=color, linewidth=width, label=name, zorder=1)
    if truth is not None:
        view.line(view.projected(_true_positions(truth, view.dimension)), color=_TRUTH, linewidth=0.9, linestyle="--",
                  label="truth", zorder=4)
    if len(poses):
        view.line(view.positions[poses], color=_POSES, linewidth=1.2, marker="." if len(poses) <= 100 else "", label=label,
                  zorder=3)
    if len(landmarks):
        view.line(view.positions[landmarks], color=_LANDMARKS, linestyle="", marker="o", markersize=3, label="landmarks",
                  zorder=2)
    return view.finished()


def closures(graph, ax=None, found=None, *, plane=None, limits=None, colorbar=True):
    """Draws the loop closures over a thin line of the poses: the edges between two poses whose ids do not follow each
    other.

    Without `found`, the color is the chi2 of the closure at the current estimates, eᵀΩe (no unit, without a kernel). The
    scale is logarithmic. If Ω is right, chi2 is about the number of rows: 3 for SE2, 6 for SE3. Large values are drawn
    over small ones.

    found: the OutlierReport of find_outliers(graph). The color is then the verdict, and the legend counts the verdicts.
    plane: the plane to which a graph in space is projected, such as "xy".
    limits: the values of chi2 with the first and the last color. Smaller and larger values have these colors, too. The
    default is 1 and the largest finite chi2, which is taken as 10 if it is smaller.
    colorbar: if False, there is no color bar.

    Returns the Axes. Raises ValueError as trajectory() does, and if `found` is about poses that the graph does not have.
    """
    view = _View(graph, ax, plane)
    if len(view.poses):
        view.line(view.positions[view.poses], color=_OBSERVATIONS, linewidth=0.8, zorder=1)
    if found is None:
        _closures_by_chi2(graph, view, limits, colorbar)
    else:
        verdicts = found.arrays()
        ends = [(view.row_of_id(i), view.row_of_id(j)) for i, j in zip(verdicts["from"], verdicts["to"])]
        for name, color in _VERDICTS.items():
            chosen = [pair for pair, verdict in zip(ends, verdicts["verdict"]) if verdict == name]
            if chosen:
                view.segments(chosen, colors=color, linewidths=0.9, label=f"{name} ({len(chosen)})", zorder=2)
    return view.finished()


def covariances(graph, vertices, covariance, sigmas=2, ax=None, *, plane=None, color="#7c3aed", label=None):
    """Draws the uncertainty of positions as ellipses in the world frame.

    vertices: VertexRefs or ids of vertices with positions: poses or points.
    covariance: the Covariance of these vertices, from covariance() or marginal_covariances(). For poses, it is in the
    frame of the pose, and this function rotates it into the world frame.
    sigmas: the half-axes in standard deviations, which are in meters. A position of the plane is inside with the
    probability 1 - exp(-sigmas² / 2): 39 % for 1, 86 % for 2, 95 % for 2.448.
    plane: the plane to which a graph in space is projected, such as "xy". Without it, each ellipsoid of a graph in space is
    drawn as the three ellipses in the planes of its axes; it contains the position with 74 % probability for sigmas=2.
    label: the name of the ellipses in the legend.

    Returns the Axes. Raises ValueError if a vertex has no position, and boxplus.Error if it has no covariance.
    """
    sigmas = float(sigmas)
    if not 0 < sigmas < _np.inf:
        raise ValueError(f"sigmas: expected a positive number, got {sigmas}")
    view = _View(graph, ax, plane)
    outlines = []
    for vertex in vertices:
        ref = graph.vertex(vertex)
        row = view.rows.get(ref)
        if row is None:
            raise ValueError(f"vertices: vertex {graph.id(ref)} has no position; expected one of SE2, SE3, Vector2 and Vector3")
        block = _np.asarray(covariance.of(ref))[:view.dimension, :view.dimension]
        if view.is_pose[row]:
            rotation = graph.estimate(ref).rotation()
            block = rotation @ block @ rotation.T
        block = block[_np.ix_(view.columns, view.columns)]
        outlines += [view.positions[row] + outline for outline in _outlines(block, sigmas)]
    if not outlines:
        return view.finished()
    if view.in_space:
        view.add_segments(_np.array(outlines), colors=color, linewidths=0.6, label=label, zorder=5)
    else:
        ellipses = _collections.PolyCollection(_np.array(outlines), facecolors=_colors.to_rgba(color, 0.15), edgecolors=color,
                                               linewidths=0.8, label=label, zorder=5)
        view.ax.add_collection(ellipses)
        view.ax.autoscale_view()
    return view.finished()


def convergence(report, ax=None, *, label=None):
    """Draws chi2 (no unit) over the iterations of a Report, with a logarithmic axis. Iteration 0 is the start.

    Call it again with the same Axes and another `label` to compare runs. A chi2 of 0 is below the end of the axis.

    Returns the Axes.
    """
    if ax is None:
        ax = _Figure(layout="constrained").add_subplot()
    iterations = [0] + [record.iteration for record in report.records]
    ax.plot(iterations, [report.chi2_start()] + [record.chi2 for record in report.records], marker=".", label=label)
    ax.set_yscale("log")
    ax.xaxis.set_major_locator(_ticker.MaxNLocator(integer=True))
    ax.set_xlabel("iteration")
    ax.set_ylabel("chi2")
    _add_legend(ax)
    return ax


class _View:
    """The positions of a graph, as they appear in the Axes."""

    def __init__(self, graph, ax, plane):
        ids, positions, is_pose, dimensions = [], [], [], set()
        for kind, (dimension, poses) in _KINDS.items():
            ids_of_kind, rows = graph.estimates(kind)
            if len(ids_of_kind):
                ids.append(ids_of_kind)
                positions.append(rows[:, :dimension])
                is_pose.append(_np.full(len(ids_of_kind), poses))
                dimensions.add(dimension)
        if len(dimensions) != 1:
            raise ValueError("graph: expected vertices of the plane (SE2, Vector2) or of space (SE3, Vector3), got " +
                             ("both" if dimensions else "none"))
        self.dimension = dimensions.pop()
        self.ax, self.columns = _axes(ax, plane, self.dimension)
        self.in_space = len(self.columns) == 3
        ids = _np.concatenate(ids)
        self.is_pose = _np.concatenate(is_pose)
        self.positions = self.projected(_np.concatenate(positions))
        self.poses, self.landmarks = _np.flatnonzero(self.is_pose), _np.flatnonzero(~self.is_pose)
        self.row_by_id = {id: row for row, id in enumerate(ids.tolist())}
        self.rows = {graph.vertex(id): row for id, row in self.row_by_id.items()}
        # estimates() sorts by id, and the poses of a graph are all of one class, so their rows are in the order of ids.
        self.rank = _np.cumsum(self.is_pose)

    def projected(self, positions):
        return positions[:, self.columns]

    def row_of_id(self, id):
        row = self.row_by_id.get(int(id))
        if row is None:
            raise ValueError(f"found: the graph has no pose with the id {id}")
        return row

    def ends(self, graph, edge):
        """The rows of the two vertices with positions that an edge joins, or None."""
        if not graph.is_enabled(edge):
            return None
        rows = [self.rows[vertex] for vertex in graph.vertices(edge) if vertex in self.rows]
        return tuple(rows) if len(rows) == 2 else None

    def kind_of(self, a, b):
        if not (self.is_pose[a] and self.is_pose[b]):
            return "observations"
        return "odometry" if abs(self.rank[a] - self.rank[b]) == 1 else "loop closures"

    def broken_line(self, ends):
        """One line through all segments, with a gap (NaN) after each of them."""
        points = _np.full((len(ends), 3, self.positions.shape[1]), _np.nan)
        points[:, :2] = self.positions[_np.array(ends)]
        return points.reshape(-1, points.shape[2])

    def line(self, points, **style):
        self.ax.plot(*points.T, **style)

    def segments(self, ends, **style):
        return self.add_segments(self.positions[_np.array(ends)], **style)

    def add_segments(self, lines, **style):
        """Lines (n, points, 2 or 3) that may have one color each."""
        if self.in_space:
            from mpl_toolkits.mplot3d.art3d import Line3DCollection
            collection = Line3DCollection(lines, **style)
            self.ax.add_collection3d(collection)
            self.ax.auto_scale_xyz(*lines.reshape(-1, 3).T, had_data=True)
        else:
            collection = _collections.LineCollection(lines, **style)
            self.ax.add_collection(collection)
            self.ax.autoscale_view()
        return collection

    def finished(self):
        for axis, column in zip("xyz", self.columns):
            getattr(self.ax, f"set_{axis}label")(f"{'xyz'[column]} (m)")
        _make_scales_equal(self.ax)
        _add_legend(self.ax)
        return self.ax


def _axes(ax, plane, dimension):
    """The Axes, and the columns of positions that they show."""
    if plane is not None:
        if dimension == 2:
            raise ValueError(f"plane: expected None for a graph of the plane, got {plane!r}")
        if not (isinstance(plane, str) and len(plane) == 2 and set(plane) <= set("xyz") and plane[0] != plane[1]):
            raise ValueError(f"plane: expected two of the letters x, y and z, such as \"xy\", got {plane!r}")
    columns = list(range(dimension)) if plane is None else ["xyz".index(letter) for letter in plane]
    projection = "3d" if len(columns) == 3 else "rectilinear"
    if ax is None:
        ax = _Figure(layout="constrained").add_subplot(projection=projection)
    elif ax.name != projection:
        raise ValueError(f"ax: expected Axes with the projection {projection!r}, got {ax.name!r}" +
                         ("; or choose a plane, such as plane=\"xy\"" if projection == "3d" else ""))
    return ax, columns


def _true_positions(truth, dimension):
    if isinstance(truth, Graph):
        kind = SE2 if dimension == 2 else SE3
        return truth.estimates(kind)[1][:, :dimension]
    positions = _np.asarray(truth, dtype=float)
    if positions.ndim != 2 or positions.shape[1] < dimension:
        raise ValueError(f"truth: expected a Graph or an array of the shape (n, {dimension}) or wider, got the shape "
                         f"{positions.shape}")
    return positions[:, :dimension]


def _closures_by_chi2(graph, view, limits, colorbar):
    found = []
    for edge in graph.all_edges():
        ends = view.ends(graph, edge)
        if ends is not None and view.kind_of(*ends) == "loop closures":
            found.append((graph.chi2(edge), ends))
    if not found:
        return
    chi2 = _np.array([value for value, _ in found])
    chi2[~_np.isfinite(chi2)] = _np.finfo(float).max  # drawn with the last color
    order = _np.argsort(chi2, kind="stable")
    low, high = limits or (1, max([10, *chi2[chi2 < _np.finfo(float).max]]))
    if not 0 < low < high < _np.inf:
        raise ValueError(f"limits: expected 0 < low < high, got {limits}")
    lines = view.segments(_np.array([ends for _, ends in found])[order], array=chi2[order], cmap=_ERRORS,
                          norm=_colors.LogNorm(low, high), linewidths=1.1, zorder=2)
    if colorbar:
        view.ax.figure.colorbar(lines, ax=view.ax, label="chi2 of the loop closure", extend="both")


def _outlines(block, sigmas):
    """Closed lines around the origin: an ellipse for a covariance (2, 2), three for a covariance (3, 3)."""
    variances, axes = _np.linalg.eigh((block + block.T) / 2)
    half_axes = axes * (sigmas * _np.sqrt(_np.maximum(variances, 0)))
    angles = _np.linspace(0, 2 * _np.pi, _CORNERS + 1)[:, _np.newaxis]
    pairs = [(0, 1)] if len(block) == 2 else [(0, 1), (0, 2), (1, 2)]
    return [_np.cos(angles) * half_axes[:, i] + _np.sin(angles) * half_axes[:, j] for i, j in pairs]


def _make_scales_equal(ax):
    if ax.name != "3d":
        ax.set_aspect("equal")
        return
    limits = _np.array([ax.get_xlim3d(), ax.get_ylim3d(), ax.get_zlim3d()])
    spans = limits[:, 1] - limits[:, 0]
    spans = _np.maximum(spans, 0.2 * spans.max())  # room for the numbers at the axis of a flat graph
    for axis, center, span in zip("xyz", limits.mean(axis=1), spans):
        getattr(ax, f"set_{axis}lim3d")(center - span / 2, center + span / 2, auto=None)
    ax.set_box_aspect(spans)


def _add_legend(ax):
    if ax.get_legend_handles_labels()[0]:
        ax.legend(fontsize="small")
