# SPDX-License-Identifier: BSD-3-Clause
"""Linear solvers, block solvers and algorithms. They only carry the choice of the user to boxplus.

The sizes in the names (SE2, SE3, X, …) have no meaning: every solver takes vertices of all sizes.
"""

from ._kinds import warn

SIZES = ("X", "SE2", "SE3", "Sim3", "SBA", "SCAM")


class LinearSolver:
    _KIND = "block-cholesky"

    def __init__(self):
        self._settings = {}

    def set_block_ordering(self, block_ordering):
        """Has no effect: boxplus chooses the order."""
        self._settings["block_ordering"] = bool(block_ordering)

    def block_ordering(self):
        return self._settings.get("block_ordering", True)

    def set_write_debug(self, write_debug):
        """Has no effect: boxplus writes no such files."""
        self._settings["write_debug"] = bool(write_debug)

    def write_debug(self):
        return self._settings.get("write_debug", False)


class LinearSolverCholmod(LinearSolver):
    """The block Cholesky of boxplus."""


class LinearSolverCSparse(LinearSolver):
    """The block Cholesky of boxplus."""


class LinearSolverEigen(LinearSolver):
    """The block Cholesky of boxplus."""


class LinearSolverDense(LinearSolver):
    _KIND = "dense"


class LinearSolverPCG(LinearSolver):
    """Conjugate gradients with a preconditioner of blocks."""

    _KIND = "pcg"

    def __init__(self):
        super().__init__()
        self._tolerance = 1e-6

    def set_tolerance(self, tolerance):
        self._tolerance = float(tolerance)

    def tolerance(self):
        return self._tolerance


class BlockSolver:
    """Takes a linear solver."""

    def __init__(self, linear_solver):
        if not isinstance(linear_solver, LinearSolver):
            raise TypeError(f"{type(self).__name__}: expected a linear solver, got {linear_solver!r}")
        self._linear_solver = linear_solver

    def linear_solver(self):
        return self._linear_solver


class OptimizationAlgorithm:
    """Takes a block solver, or (as in older programs) a linear solver."""

    _OPTIONS = {}
    _GOES_ON = False  # after an iteration that finds no step

    def __init__(self, solver):
        if isinstance(solver, LinearSolver):
            solver = BlockSolver(solver)
        if not isinstance(solver, BlockSolver):
            raise TypeError(f"{type(self).__name__}: expected a BlockSolver, got {solver!r}")
        self._solver = solver
        self._last_lambda = 0.0

    def solver(self):
        return self._solver

    def options(self):
        """The options of boxplus."""
        linear_solver = self._solver.linear_solver()
        options = dict(self._OPTIONS, linear_solver=linear_solver._KIND)
        if isinstance(linear_solver, LinearSolverPCG):
            options["linear_tolerance"] = linear_solver.tolerance()
        return options


class OptimizationAlgorithmGaussNewton(OptimizationAlgorithm):
    _OPTIONS = {"algorithm": "gauss-newton"}
    _GOES_ON = True


class OptimizationAlgorithmLevenberg(OptimizationAlgorithm):
    _OPTIONS = {"algorithm": "levenberg-marquardt", "damping": "identity"}

    def __init__(self, solver):
        super().__init__(solver)
        self._initial_lambda = 0.0

    def set_user_lambda_init(self, initial_lambda):
        """The first λ; 0: 1e-5 times the largest diagonal entry of H."""
        self._initial_lambda = float(initial_lambda)

    def user_lambda_init(self):
        return self._initial_lambda

    def current_lambda(self):
        """λ of the last iteration."""
        return self._last_lambda

    def set_max_trials_after_failure(self, trials):
        warn("OptimizationAlgorithmLevenberg.set_max_trials_after_failure() has no effect")

    def options(self):
        return dict(super().options(), initial_lambda=self._initial_lambda)


class OptimizationAlgorithmDogleg(OptimizationAlgorithm):
    _OPTIONS = {"algorithm": "dogleg"}


ALL = {}
for _base in (LinearSolverCholmod, LinearSolverCSparse, LinearSolverEigen, LinearSolverDense, LinearSolverPCG, BlockSolver):
    for _size in SIZES:
        _name = f"{_base.__name__}{_size}"
        ALL[_name] = type(_name, (_base,), {"__module__": "g2o", "__doc__": _base.__doc__})
for _alias, _size in (("BlockSolver_6_3", "SE3"), ("BlockSolver_7_3", "Sim3"), ("BlockSolver_3_2", "SE2")):
    ALL[_alias] = ALL[f"BlockSolver{_size}"]
