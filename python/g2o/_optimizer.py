# SPDX-License-Identifier: BSD-3-Clause
"""SparseOptimizer, and the actions that it calls."""

import collections
import sys
import time

import numpy as np

from ._elements import Edge
from ._engine import Engine
from ._graph import HyperGraph
from ._kinds import warn
from ._marginals import SparseBlockMatrix, marginals


class SparseOptimizer(HyperGraph):
    def __init__(self):
        super().__init__()
        self._algorithm = None
        self._is_verbose = False
        self._stop_flag = None
        self._before, self._after = [], []

    def algorithm(self):
        return self._algorithm

    def set_algorithm(self, algorithm):
        self._algorithm = algorithm

    def solver(self):
        return self._algorithm

    def verbose(self):
        return self._is_verbose

    def set_verbose(self, verbose):
        """If true, optimize() writes a line per iteration to sys.stderr, as g2o does."""
        self._is_verbose = bool(verbose)

    def set_force_stop_flag(self, flag):
        """An object with `value`, or is_set(), such as threading.Event. optimize() ends when it is true."""
        self._stop_flag = flag

    def force_stop_flag(self):
        return self._stop_flag

    def terminate(self):
        flag = self._stop_flag
        return bool(flag is not None and (flag.is_set() if hasattr(flag, "is_set") else flag.value))

    def add_pre_iteration_action(self, action):
        self._before.append(action)
        return True

    def add_post_iteration_action(self, action):
        self._after.append(action)
        return True

    def remove_pre_iteration_action(self, action):
        return self._remove(self._before, action)

    def remove_post_iteration_action(self, action):
        return self._remove(self._after, action)

    @staticmethod
    def _remove(actions, action):
        if action not in actions:
            return False
        actions.remove(action)
        return True

    def initialize_optimization(self, elements=0, level=0):
        """Chooses the edges that take part: those of a level, those of a level between given vertices, or given edges."""
        if isinstance(elements, (int, np.integer)):
            edges = self._edges
            level = int(elements)
        else:
            elements = self._of(elements)
            if all(isinstance(element, Edge) for element in elements):
                edges, level = elements, -1
            else:
                chosen = set(elements)
                edges = [edge for edge in self._edges if chosen.issuperset(edge._vertices)]
        self._active = [edge for edge in edges if (level < 0 or edge.level() == level) and None not in edge._vertices
                        and not edge.all_vertices_fixed()]
        active = {vertex: None for edge in self._active for vertex in edge._vertices if not vertex.fixed()}
        for vertex in self._vertices.values():
            vertex._hessian_index = -1
        order = sorted(active, key=lambda vertex: (vertex.marginalized(), vertex.id()))
        for index, vertex in enumerate(order):
            vertex._hessian_index = index
        self._order = order
        return bool(self._active)

    def update_initialization(self, vertices, edges):
        """After vertices and edges were added: they take part, too."""
        return SparseOptimizer.initialize_optimization(self, list(dict.fromkeys([*(self._active or ()), *edges])))

    def active_edges(self):
        return list(self._active or ())

    def active_vertices(self):
        return sorted({vertex for edge in self.active_edges() for vertex in edge._vertices}, key=lambda vertex: vertex.id())

    def index_mapping(self):
        """The vertices that move, in the order of their hessian_index()."""
        return list(self._order) if self._active else []

    def find_active_vertex(self, vertex):
        return vertex if vertex in self.active_vertices() else None

    def find_active_edge(self, edge):
        return edge if edge in self.active_edges() else None

    def compute_active_errors(self):
        for edge in self.active_edges():
            self._error_of(edge)

    def active_chi2(self):
        """Σ eᵀΩe over the active edges, without kernels."""
        return float(sum(edge.chi2() for edge in self.active_edges()))

    def active_robust_chi2(self):
        """Σ ρ(eᵀΩe) over the active edges."""
        return float(sum(edge.chi2() if edge._kernel is None else edge._kernel.robustify(edge.chi2())[0]
                         for edge in self.active_edges()))

    def gauge_freedom(self):
        """True if no vertex is fixed and no edge has a single vertex."""
        return not any(vertex.fixed() for vertex in self._vertices.values()) and not any(
            len(edge._vertices) == 1 for edge in self._edges)

    def find_gauge(self):
        """The vertex with the lowest id among those of the largest dimension."""
        return max(self._vertices.values(), key=lambda vertex: (vertex.dimension(), -vertex.id()), default=None)

    def compute_initial_guess(self):
        """Propagates estimates from the fixed vertices along the edges with relative poses."""
        if not self._active:
            return
        self._sync()
        self._engine.run(dict(self._options(), start="spanning-tree", max_iterations=0))
        self._read()

    def compute_marginals(self, *arguments):
        """The blocks of the inverse of H: compute_marginals(pairs) of hessian indices, (vertex) or (vertices), after
        initialize_optimization(). Returns (True, SparseBlockMatrix), or (False, an empty one) if H is singular. If the first
        argument is a SparseBlockMatrix, it gets the blocks, and the result is True or False."""
        target = arguments[0] if isinstance(arguments[0], SparseBlockMatrix) else None
        self._sync()
        ok, blocks = marginals(self._engine, self.index_mapping(), arguments[-1], dict(self._options(), gauge="error"))
        if target is None:
            return ok, blocks
        target._take(blocks)
        return ok

    def optimize(self, iterations, online=False):
        """Runs up to so many iterations from the current estimates. Returns their number; -1 if nothing is active, and 0 if
        no step could be computed. A warning says why. As in g2o, an iteration that finds no better estimates counts, too: it
        is the last one of Levenberg-Marquardt and dogleg, but Gauss-Newton goes on to the last iteration."""
        if not self._active:
            warn("optimize: there is nothing to optimize; call initialize_optimization() after the edges were added")
            return -1
        if self._algorithm is None:
            warn("optimize: there is no algorithm; call set_algorithm()")
            return -1
        self._sync()
        if not self._active:
            warn("optimize: no edge that initialize_optimization() has chosen is left")
            return -1
        if self.terminate():
            return 0
        for action in self._before:
            action(self, 0)
        moving = self.index_mapping()
        in_steps = any(vertex._is_chart() for vertex in moving) or any(getattr(edge, "pl_pl", False) for edge in self._active)
        return self._run_in_steps(iterations) if in_steps else self._run(iterations)

    def _run(self, iterations):
        watch = _Watch(self)
        try:
            report = self._engine.run(dict(self._options(), max_iterations=max(0, iterations), callback=watch))
        finally:
            self._read()  # also after Ctrl-C or an exception of an action: the best estimates
        return watch.finish(report, iterations)

    def _run_in_steps(self, iterations):
        """One iteration after the other, because each of them begins with new estimates of charts or new informations."""
        watch, damping = _Watch(self), {}
        while watch.done < iterations:
            record = []
            report = self._engine.run(dict(self._options(), max_iterations=1, callback=lambda r: record.append(r), **damping))
            self._read()
            if record and not watch(record[0]):
                break
            if not record or report.reason != report.Reason.kMaxIterations:
                return watch.finish(report, iterations)
            damping = self._algorithm_damping(record[0])
            for edge in self._active:
                if getattr(edge, "pl_pl", False):
                    self._engine.graph.set_information(self._engine.refs[edge], edge._current_information())
        return watch.done

    def _algorithm_damping(self, record):
        """λ or the radius of the next iteration (Nielsen, "Damping parameter in Marquardt's method", 1999)."""
        options = self._algorithm.options()
        if options["algorithm"] == "levenberg-marquardt":
            gain = record.chi2_decrease / record.predicted_decrease if record.predicted_decrease > 0 else 1.0
            return {"initial_lambda": record.lambda_ * max(1 / 3, 1 - (2 * gain - 1) ** 3)}
        if options["algorithm"] == "dogleg" and np.isfinite(record.radius):
            return {"initial_radius": record.radius}
        return {}

    def _options(self):
        options = {"algorithm": "levenberg-marquardt"} if self._algorithm is None else self._algorithm.options()
        options.update(gauge="damp", level=-1, cost_tolerance=0.0, noise_tolerance=0.0, step_tolerance=0.0)
        if len(self._active) < len(self._edges):
            options["edges"] = [self._engine.refs[edge] for edge in self._active if edge in self._engine.refs]
        return options

    def _sync(self):
        if self._engine is None:
            self._engine = Engine()
        changed_vertices, self._changed_vertices = self._changed_vertices, {}
        changed_edges, self._changed_edges = self._changed_edges, {}
        self._active = [edge for edge in self._active or () if edge._optimizer is self and None not in edge._vertices]
        self._engine.sync(self._vertices.values(), {vertex: flags for vertex, flags in changed_vertices.items()
                                                    if vertex in self._engine.ids}, self._edges, changed_edges)

    def _read(self):
        self._engine.read_estimates(self.index_mapping())
        self._state += 1


class _Watch:
    """Is called after each iteration: writes lines, calls actions, and looks at the flag that stops the run."""

    def __init__(self, optimizer):
        self.optimizer = optimizer
        self.begin = self.last = time.monotonic()
        self.done = 0  # iterations

    def __call__(self, record):
        optimizer, iteration = self.optimizer, self.done
        self.done += 1
        if optimizer._algorithm is not None:
            optimizer._algorithm._last_lambda = record.lambda_
        if optimizer._is_verbose:
            self.write(record, iteration)
        if optimizer._after:
            optimizer._read()
        answers = [action(optimizer, iteration) for action in optimizer._after]
        return not optimizer.terminate() and not any(answer is False for answer in answers)

    def write(self, record, iteration):
        now = time.monotonic()
        damping = f"\t lambda= {record.lambda_:.6f}\t levenbergIter= {record.tries}" if record.lambda_ else ""
        schur = int(any(vertex.marginalized() for vertex in self.optimizer.index_mapping()))
        edges = len(self.optimizer._active)
        print(f"iteration= {iteration}\t chi2= {record.chi2:.6f}\t time= {now - self.last:.6g}\t "
              f"cumTime= {now - self.begin:.6g}\t edges= {edges}\t schur= {schur}{damping}", file=sys.stderr)
        self.last = now

    def finish(self, report, iterations):
        """The number of iterations, with those that g2o would do after the end of this run without a change."""
        if report.status == report.Status.kFailed:
            warn(f"optimize: {report.message}")
            return 0
        algorithm = self.optimizer._algorithm
        no_step = _NoStep(report.chi2_final, algorithm._last_lambda, 1)
        is_over = report.reason == report.Reason.kCallback
        while self.done < iterations and not is_over:
            is_over = not self(no_step) or not algorithm._GOES_ON
        return self.done


#: The record of an iteration that changes nothing.
_NoStep = collections.namedtuple("_NoStep", "chi2 lambda_ tries")


class SparseOptimizerTerminateAction:
    """An action that stops the run if chi2 falls by less than a fraction of itself. Add it with
    add_post_iteration_action()."""

    def __init__(self):
        self._gain_threshold, self._max_iterations, self._last = 1e-6, sys.maxsize, None

    def gain_threshold(self):
        return self._gain_threshold

    def set_gain_threshold(self, threshold):
        self._gain_threshold = float(threshold)

    def max_iterations(self):
        return self._max_iterations

    def set_max_iterations(self, iterations):
        self._max_iterations = int(iterations)

    def __call__(self, optimizer, iteration):
        chi2, last = optimizer.active_robust_chi2(), self._last if iteration > 0 else None
        self._last = chi2
        small = last is not None and 0 <= last - chi2 < self._gain_threshold * chi2
        return not small and iteration + 1 < self._max_iterations
