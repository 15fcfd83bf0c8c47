# SPDX-License-Identifier: BSD-3-Clause
# The types of enumerations and reports. There is no such module at run time: the names are in boxplus.
from __future__ import annotations

from typing import Any

from . import EdgeFunctionCost, EdgeRef, VertexRef
from ._findings import EdgeVerdict, Finding

class Enum:
    name: str
    value: int

class AlgorithmKind(Enum):
    kAutomatic: AlgorithmKind
    kGaussNewton: AlgorithmKind
    kLevenbergMarquardt: AlgorithmKind
    kDogleg: AlgorithmKind

class LinearSolverKind(Enum):
    kAutomatic: LinearSolverKind
    kBlockCholesky: LinearSolverKind
    kPcg: LinearSolverKind
    kDense: LinearSolverKind
    kEigenSparse: LinearSolverKind

class Precision(Enum):
    kAutomatic: Precision
    kDouble: Precision
    kMixed: Precision

class Ordering(Enum):
    kAutomatic: Ordering
    kMinimumDegree: Ordering
    kNestedDissection: Ordering

class Start(Enum):
    kCurrent: Start
    kOdometry: Start
    kSpanningTree: Start
    kChordal: Start
    kAutomatic: Start

class GaugePolicy(Enum):
    kFixFirst: GaugePolicy
    kDamp: GaugePolicy
    kError: GaugePolicy

class SchurMode(Enum):
    kAutomatic: SchurMode
    kExplicit: SchurMode
    kImplicit: SchurMode

class JacobianSource(Enum):
    kAnalytic: JacobianSource
    kAutomatic: JacobianSource
    kNumeric: JacobianSource

class IterationRecord:
    iteration: int
    chi2: float
    chi2_decrease: float
    predicted_decrease: float
    step_max: float
    gradient_max: float
    lambda_: float
    radius: float
    tries: int
    linear_iterations: int
    time_s: float

class GaugeFreedom:
    vertex: VertexRef
    id: int
    directions: int
    translation: bool
    rotation: bool
    scale: bool

class LinearStatistics:
    factor_nonzeros: int
    factor_flops: float
    supernodes: int
    largest_front: int
    factor_seconds: float
    pcg_seconds: float
    refused_factor_bytes: int
    ordering: Ordering
    precision: Precision
    workers: int
    fell_back_to_double: bool

class Report:
    class Status(Enum):
        kConverged: Report.Status
        kNotConverged: Report.Status
        kFailed: Report.Status
    class Reason(Enum):
        kCostTolerance: Report.Reason
        kStepTolerance: Report.Reason
        kGradientTolerance: Report.Reason
        kNoFurtherDecrease: Report.Reason
        kNothingToOptimize: Report.Reason
        kMaxIterations: Report.Reason
        kTimeLimit: Report.Reason
        kStopFlag: Report.Reason
        kCallback: Report.Reason
        kNoStepFound: Report.Reason
        kRaisedChi2: Report.Reason
        kNotPositiveDefinite: Report.Reason
        kNotFinite: Report.Reason
        kRejectedEdges: Report.Reason
        kWeightSpan: Report.Reason
        kConstraints: Report.Reason
        kGaugeFreedom: Report.Reason
    class StartReport:
        requested: Start
        used: Start
        chi2_current: float
        first_step_kept: float
        chi2_guess: float
        ran_both: bool
        chi2_other_final: float
        other_iterations: int
        note: str
    class GaugeReport:
        held: list[int]
        free: list[GaugeFreedom]
        held_directions: int
    class RejectionReport:
        is_known: bool
        edges: int
        redescending: int
        by_redescending: int
        cut_off: list[int]
    class ActiveBound:
        vertex: VertexRef
        id: int
        entry: int
        is_upper: bool
        limit: float
        multiplier: float
    class ConstraintResult:
        edge: EdgeRef
        multipliers: list[float]
    class EdgeJacobians:
        edge_type: str
        source: JacobianSource
    class Timings:
        plan_s: float
        start_s: float
        linearize_s: float
        factorize_s: float
        solve_s: float
        evaluate_s: float
        total_s: float
    status: Report.Status
    reason: Report.Reason
    message: str
    chi2_initial: float
    chi2_final: float
    iterations: int
    start: Report.StartReport
    gauge: Report.GaugeReport
    rejection: Report.RejectionReport
    records: list[IterationRecord]
    active_bounds: list[Report.ActiveBound]
    constraints: list[Report.ConstraintResult]
    constraint_violation: float
    constraint_rounds: int
    findings: list[Finding]
    algorithm: str
    linear_solver: str
    vertices: int
    eliminated: int
    edges: int
    disabled_edges: int
    robust_edges: int
    scalars: int
    rows: int
    degrees_of_freedom: int
    jacobians: list[Report.EdgeJacobians]
    linear: LinearStatistics
    regularized_steps: int
    displaced_directions: int
    precise_steps: int
    threads: int
    workers: int
    plan_reused: bool
    plan_extended: bool
    time: Report.Timings
    kRejectedWeight: float
    edge_functions: tuple[EdgeFunctionCost, ...]
    def converged(self) -> bool: ...
    def chi2_per_degree(self) -> float: ...
    def chi2_start(self) -> float: ...
    def chi2_remark(self) -> str: ...
    def start_remark(self) -> str: ...
    def to_pandas(self) -> Any: ...
