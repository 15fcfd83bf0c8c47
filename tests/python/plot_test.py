# SPDX-License-Identifier: BSD-3-Clause
"""boxplus.plot: the data that is drawn are the numbers of the graph."""

import importlib
import sys
import unittest
import unittest.mock

import boxplus
import numpy as np
from boxplus import SE2, SE3, Between, Graph, PointObservation2, Prior, Vector2, Vector3, find_outliers, optimize
from graph_test import square
from outliers_test import rounds

try:
    import matplotlib
    from matplotlib.figure import Figure
except ImportError as error:
    print(f"SKIPPED: Matplotlib cannot be imported: {error}")
    sys.exit(77)

matplotlib.use("Agg")
from boxplus import plot


def town():
    """Five poses with the ids 10, 20, 30, 40 and 50, and a landmark. Odometry is missing between 30 and 40; a closure joins
    50 and 10."""
    graph = Graph()
    rows = np.array([[0, 0, 0], [1, 0, 0.1], [2, 0.5, 1], [2, 2, 2], [0, 1, 3]], dtype=float)
    graph.add_vertices(SE2, [50, 40, 30, 20, 10], rows[::-1])
    graph.add_vertex([3, 3], id=5)
    graph.fix(10)
    for i, j in ((10, 20), (30, 20), (40, 50)):
        graph.add_edge(Between(SE2(1, 0, 0)), i, j)
    closure = graph.add_edge(Between(SE2(0, 0, 0)), 50, 10, information=4)
    graph.add_edge(PointObservation2([1, 1]), 20, 5)
    graph.add_edge(Prior(SE2(0, 0, 0)), 10)
    return graph, rows, closure


def spiral():
    """Poses in space with turned frames, and a landmark."""
    graph = Graph()
    angles = np.arange(6) * 0.9
    for i, angle in enumerate(angles):
        graph.add_vertex(SE3([np.cos(angle), np.sin(angle), 0.1 * i], [0, 0, np.sin(angle / 2), np.cos(angle / 2)]))
    graph.add_vertex([0, 0, 2])
    information = np.diag([1, 4, 9, 50, 60, 70])
    graph.add_edge(Prior(graph.estimate(0)), 0, information=information)
    for i in range(5):
        graph.add_edge(Between(graph.estimate(i).inverse_times(graph.estimate(i + 1))), i, i + 1, information=information)
    graph.add_edge(Between(graph.estimate(5).inverse_times(graph.estimate(0))), 5, 0, information=information)
    graph.add_edge(Prior([0, 0, 2]), 6)
    return graph


def lines_of(ax):
    """{label: points (n, 2 or 3)} of the lines in the Axes."""
    return {line.get_label(): np.column_stack(line.get_data_3d() if ax.name == "3d" else line.get_data()).astype(float)
            for line in ax.get_lines()}


def segments_of(points):
    """The segments (n, 2, d) of a line with gaps."""
    points = points.reshape(-1, 3, points.shape[1])
    assert np.isnan(points[:, 2]).all()
    return points[:, :2]


class Trajectories(unittest.TestCase):
    def test_the_poses_are_a_line_in_the_order_of_ids(self):
        graph, rows, _ = town()
        lines = lines_of(plot.trajectory(graph))
        np.testing.assert_array_equal(lines["poses"], rows[::-1, :2][::-1])
        np.testing.assert_array_equal(lines["landmarks"], [[3, 3]])

    def test_edges_are_odometry_closures_and_observations(self):
        graph, rows, _ = town()
        ax = plot.trajectory(graph)
        lines = lines_of(ax)
        p = dict(zip((10, 20, 30, 40, 50), rows[:, :2]))
        np.testing.assert_array_equal(segments_of(lines["odometry"]), [[p[10], p[20]], [p[30], p[20]], [p[40], p[50]]])
        np.testing.assert_array_equal(segments_of(lines["loop closures"]), [[p[50], p[10]]])
        np.testing.assert_array_equal(segments_of(lines["observations"]), [[p[20], [3, 3]]])
        colors = {line.get_label(): line.get_color() for line in ax.get_lines()}
        self.assertNotEqual(colors["odometry"], colors["loop closures"])
        legend = {text.get_text() for text in ax.get_legend().get_texts()}
        self.assertEqual(legend, {"poses", "odometry", "loop closures", "observations", "landmarks"})
        self.assertEqual((ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()), ("x (m)", "y (m)", 1))

    def test_disabled_edges_are_not_drawn(self):
        graph, _, closure = town()
        graph.set_enabled(closure, False)
        self.assertNotIn("loop closures", lines_of(plot.trajectory(graph)))
        self.assertEqual(set(lines_of(plot.trajectory(graph, edges=False))), {"poses", "landmarks"})

    def test_a_graph_in_space_is_drawn_in_space_or_in_a_plane(self):
        graph = spiral()
        positions = graph.estimates(SE3)[1][:, :3]
        ax = plot.trajectory(graph)
        self.assertEqual(ax.name, "3d")
        np.testing.assert_array_equal(lines_of(ax)["poses"], positions)
        np.testing.assert_array_equal(lines_of(ax)["landmarks"], [[0, 0, 2]])
        np.testing.assert_array_equal(segments_of(lines_of(ax)["loop closures"]), [positions[[5, 0]]])
        for low, high, limits in zip(positions.min(axis=0), positions.max(axis=0), (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())):
            self.assertTrue(limits[0] <= low and high <= limits[1], (limits, low, high))
        ax = plot.trajectory(graph, plane="zx")
        self.assertEqual((ax.name, ax.get_xlabel(), ax.get_ylabel()), ("rectilinear", "z (m)", "x (m)"))
        np.testing.assert_array_equal(lines_of(ax)["poses"], positions[:, [2, 0]])

    def test_the_scales_of_the_axes_are_equal_in_space(self):
        graph = spiral()
        ax = plot.trajectory(graph)
        spans = np.ptp([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()], axis=1)
        np.testing.assert_allclose(np.asarray(ax._box_aspect) / spans, np.full(3, ax._box_aspect[0] / spans[0]))
        before = ax.get_zlim()
        graph.set_estimate(6, [0, 0, 50])
        self.assertLess(before[1], 50)
        self.assertGreaterEqual(plot.trajectory(graph, ax).get_zlim()[1], 50)

    def test_the_truth_is_a_graph_or_an_array(self):
        graph, rows, _ = town()
        for truth in (graph, rows, rows[:, :2], rows.tolist()):
            np.testing.assert_array_equal(lines_of(plot.trajectory(graph, truth=truth))["truth"], rows[:, :2])
        in_space = spiral()
        np.testing.assert_array_equal(lines_of(plot.trajectory(in_space, truth=in_space))["truth"],
                                      in_space.estimates(SE3)[1][:, :3])

    def test_several_plots_share_axes(self):
        graph, rows, _ = town()
        ax = Figure().add_subplot()
        self.assertIs(plot.trajectory(graph, ax, edges=False, label="before"), ax)
        graph.set_estimate(50, SE2(7, 7, 0))
        self.assertIs(plot.trajectory(graph, ax, edges=False, label="after"), ax)
        lines = lines_of(ax)
        np.testing.assert_array_equal(lines["before"], rows[:, :2])
        np.testing.assert_array_equal(lines["after"], np.r_[rows[:4, :2], [[7, 7]]])

    def test_wrong_arguments_are_refused(self):
        graph, _, _ = town()
        mixed = Graph()
        mixed.add_vertex(SE2())
        mixed.add_vertex(SE3())
        flat, space = Figure().add_subplot(), Figure().add_subplot(projection="3d")
        for text, function in (
                ("expected vertices of the plane .* got none", lambda: plot.trajectory(Graph())),
                ("expected vertices of the plane .* got both", lambda: plot.trajectory(mixed)),
                ("plane: expected None", lambda: plot.trajectory(graph, plane="xy")),
                ("plane: expected two of the letters", lambda: plot.trajectory(spiral(), plane="xx")),
                ("ax: expected Axes with the projection '3d', got 'rectilinear'; or choose a plane",
                 lambda: plot.trajectory(spiral(), flat)),
                ("ax: expected Axes with the projection 'rectilinear'", lambda: plot.trajectory(graph, space)),
                (r"truth: expected a Graph or an array of the shape \(n, 2\)", lambda: plot.trajectory(graph, truth=[1, 2]))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                function()


class Closures(unittest.TestCase):
    def test_the_color_is_the_chi2(self):
        graph, closures, _ = rounds(250)
        graph.set_kernel(closures, "Huber")
        ax = plot.closures(graph)
        lines, = ax.collections
        chi2 = np.array([graph.chi2(edge) for edge in closures])
        order = np.argsort(chi2, kind="stable")
        np.testing.assert_array_equal(lines.get_array(), chi2[order])
        rows = graph.estimates(SE2)[1][:, :2]
        ends = np.array([[graph.id(vertex) for vertex in graph.vertices(edge)] for edge in closures])
        np.testing.assert_array_equal(lines.get_segments(), rows[ends[order]])
        self.assertEqual((lines.norm.vmin, lines.norm.vmax), (1, chi2.max()))
        self.assertEqual(len(ax.figure.axes), 2)
        ax = plot.closures(graph, limits=(3, 30), colorbar=False)
        self.assertEqual((ax.collections[0].norm.vmin, ax.collections[0].norm.vmax, len(ax.figure.axes)), (3, 30, 1))
        with self.assertRaisesRegex(ValueError, "limits"):
            plot.closures(graph, limits=(0, 1))

    def test_the_color_is_the_verdict(self):
        graph, _, is_false = rounds(250)
        found = find_outliers(graph)
        ax = plot.closures(graph, found=found)
        rows = graph.estimates(SE2)[1][:, :2]
        true_lines, false_lines = ax.collections
        early = np.arange(150)
        np.testing.assert_array_equal(true_lines.get_segments(), rows[np.c_[early, early + 100][~is_false]])
        np.testing.assert_array_equal(false_lines.get_segments(), rows[np.c_[early, early + 100][is_false]])
        self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()],
                         [f"inlier ({(~is_false).sum()})", f"outlier ({is_false.sum()})"])
        graph.remove(249)
        with self.assertRaisesRegex(ValueError, "no pose with the id 249"):
            plot.closures(graph, found=found)

    def test_a_chi2_that_is_not_a_number_has_the_last_color(self):
        graph, _, closure = town()
        graph.set_estimate(50, SE2(1e200, 0, 0))
        lines, = plot.closures(graph).collections
        self.assertEqual((len(lines.get_segments()), lines.norm.vmax), (1, 10))
        self.assertEqual(tuple(lines.to_rgba(lines.get_array())[0]), tuple(lines.cmap(1.0)))

    def test_closures_in_space_are_drawn_in_space(self):
        graph = spiral()
        ax = plot.closures(graph)
        positions = graph.estimates(SE3)[1][:, :3]
        np.testing.assert_array_equal(ax.collections[0]._segments3d, positions[np.newaxis, [5, 0]])

    def test_a_graph_without_closures_has_only_its_poses(self):
        ax = plot.closures(square()[0])
        self.assertEqual((len(ax.collections), len(ax.figure.axes)), (0, 1))


class Covariances(unittest.TestCase):
    def test_an_ellipse_has_its_half_axes_in_the_world_frame(self):
        graph = Graph()
        graph.add_vertex(SE2(3, 4, np.pi / 6))
        graph.add_vertex([1, 2])
        graph.add_edge(Prior(SE2(3, 4, np.pi / 6)), 0, information=np.diag([1 / 4, 1, 1]))  # 2 m forward, 1 m sideways
        graph.add_edge(Prior([1, 2]), 1, information=[[2, 1], [1, 2]])
        covariance = boxplus.covariance(graph, [0, 1])
        ax = plot.covariances(graph, [0, graph.vertex(1)], covariance, sigmas=3)
        pose, point = (path.vertices[:-1] for path in ax.collections[0].get_paths())
        rotation = graph.estimate(0).rotation()
        own = (pose - [3, 4]) @ rotation
        np.testing.assert_allclose(own**2 @ [1 / 4, 1], 9)
        np.testing.assert_allclose(np.abs(own).max(axis=0), [6, 3], rtol=1e-2)
        d = point - [1, 2]
        np.testing.assert_allclose(np.einsum("ni,ij,nj->n", d, [[2, 1], [1, 2]], d), 9)

    def test_an_ellipsoid_is_three_ellipses_or_their_outline_in_a_plane(self):
        graph = spiral()
        optimize(graph)
        covariance = boxplus.marginal_covariances(graph, graph.all_vertices())
        for vertex in (4, 6):
            block, center = covariance.of(vertex)[:3, :3], np.ravel(graph.estimate(vertex).translation() if vertex == 4 else [0, 0, 2])
            if vertex == 4:
                rotation = graph.estimate(vertex).rotation()
                block = rotation @ block @ rotation.T
            outlines = np.asarray(plot.covariances(graph, [vertex], covariance).collections[0]._segments3d)
            self.assertEqual(len(outlines), 3)
            d = outlines.reshape(-1, 3) - center
            np.testing.assert_allclose(np.einsum("ni,ij,nj->n", d, np.linalg.inv(block), d), 4)
            ax = plot.covariances(graph, [vertex], covariance, plane="xz")
            d = ax.collections[0].get_paths()[0].vertices - center[[0, 2]]
            seen = block[np.ix_([0, 2], [0, 2])]
            np.testing.assert_allclose(np.einsum("ni,ij,nj->n", d, np.linalg.inv(seen), d), 4)

    def test_a_fixed_vertex_has_an_ellipse_of_size_zero(self):
        graph, _ = square()
        covariance = boxplus.covariance(graph, [0])
        ax = plot.covariances(graph, [0], covariance)
        np.testing.assert_array_equal(np.ptp(ax.collections[0].get_paths()[0].vertices, axis=0), [0, 0])

    def test_wrong_arguments_are_refused(self):
        graph, _ = square()
        covariance = boxplus.covariance(graph, [1])
        number = graph.add_vertex([1], id=9)
        for error, text, function in (
                (ValueError, "sigmas: expected a positive number", lambda: plot.covariances(graph, [1], covariance, sigmas=0)),
                (ValueError, "vertex 9 has no position", lambda: plot.covariances(graph, [number], covariance)),
                (boxplus.InvalidArgument, "no vertex with the id 7", lambda: plot.covariances(graph, [7], covariance)),
                (boxplus.Error, "", lambda: plot.covariances(graph, [2], covariance))):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                function()


class Convergence(unittest.TestCase):
    def test_chi2_is_drawn_over_the_iterations(self):
        report = optimize(rounds(250)[0])
        ax = plot.convergence(report, label="first")
        iterations, chi2 = ax.get_lines()[0].get_data()
        self.assertEqual(list(iterations), list(range(report.iterations + 1)))
        self.assertEqual(list(chi2), [report.chi2_start()] + [record.chi2 for record in report.records])
        self.assertEqual((ax.get_yscale(), ax.get_legend().get_texts()[0].get_text()), ("log", "first"))
        self.assertIs(plot.convergence(report, ax), ax)
        self.assertEqual(len(ax.get_lines()), 2)


class Module(unittest.TestCase):
    def test_no_global_state_of_matplotlib_changes(self):
        from matplotlib import pyplot
        before = dict(matplotlib.rcParams)
        graph, _, _ = rounds(250)
        covariance = boxplus.marginal_covariances(graph, graph.all_vertices())
        with unittest.mock.patch.object(pyplot, "show", side_effect=AssertionError("show() was called")):
            for ax in (plot.trajectory(graph), plot.closures(graph), plot.convergence(optimize(graph)),
                       plot.covariances(graph, graph.all_vertices(), covariance), plot.trajectory(spiral())):
                ax.figure.canvas.draw()  # every plot can be drawn
        self.assertEqual((pyplot.get_fignums(), dict(matplotlib.rcParams)), ([], before))

    def test_without_matplotlib_the_import_says_what_to_install(self):
        with unittest.mock.patch.dict(sys.modules, matplotlib=None):
            del sys.modules["boxplus.plot"]
            with self.assertRaisesRegex(ImportError, "python3-matplotlib, or pip install matplotlib") as raised:
                importlib.import_module("boxplus.plot")
        self.assertEqual(raised.exception.name, "matplotlib")


if __name__ == "__main__":
    unittest.main()
