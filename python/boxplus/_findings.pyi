# SPDX-License-Identifier: BSD-3-Clause
# The types of diagnose(), find_outliers() and certify(). There is no such module at run time: the names are in boxplus.
from __future__ import annotations

from typing import Any

import numpy

from . import Array, EdgeRef, VertexRef
from ._report import Enum, Report

class Finding:
    class Kind(Enum):
        kNonFiniteEstimate: Finding.Kind
        kNonFiniteError: Finding.Kind
        kNonFiniteJacobian: Finding.Kind
        kImplausibleEstimate: Finding.Kind
        kNothingMoves: Finding.Kind
        kWrongJacobian: Finding.Kind
        kIsolatedVertex: Finding.Kind
        kFreeComponent: Finding.Kind
        kZeroJacobian: Finding.Kind
        kUndeterminedDirection: Finding.Kind
        kSeenOnce: Finding.Kind
        kBehindCameras: Finding.Kind
        kFarPoint: Finding.Kind
        kZeroInformation: Finding.Kind
        kMixedUnits: Finding.Kind
        kDuplicateEdge: Finding.Kind
        kOutlier: Finding.Kind
        kDominantVertex: Finding.Kind
        kFixedEdge: Finding.Kind
        kNotAtMinimum: Finding.Kind
        kChi2Ratio: Finding.Kind
    class Severity(Enum):
        kNote: Finding.Severity
        kWarning: Finding.Severity
        kError: Finding.Severity
    class Direction:
        class Kind(Enum):
            kAlong: Finding.Direction.Kind
            kAbout: Finding.Direction.Kind
            kScale: Finding.Direction.Kind
            kTangent: Finding.Direction.Kind
        kind: Finding.Direction.Kind
        axis: Array
        vertex: VertexRef
        tangent: Array
    kind: Finding.Kind
    severity: Finding.Severity
    text: str
    vertices: list[VertexRef]
    ids: list[int]
    edges: list[EdgeRef]
    directions: list[Finding.Direction]

class Diagnosis:
    findings: list[Finding]
    is_complete: bool
    at_minimum: bool
    def ok(self) -> bool: ...
    def count(self, severity: Finding.Severity | str) -> int: ...

class Suspects(Enum):
    kLoopClosures: Suspects
    kAll: Suspects

class Verdict(Enum):
    kInlier: Verdict
    kOutlier: Verdict
    kUndecided: Verdict

class EdgeVerdict:
    edge: EdgeRef
    from_: int
    to: int
    verdict: Verdict
    weight: float
    chi2: float
    supported: bool

class OutlierReport:
    suspects: Suspects
    report: Report
    verdicts: list[EdgeVerdict]
    noise_scale: float
    time_s: float
    note: str
    def count(self, verdict: Verdict | str) -> int: ...
    def edges(self, verdict: Verdict | str) -> list[EdgeRef]: ...
    def arrays(self) -> dict[str, numpy.ndarray[Any, numpy.dtype[Any]]]: ...

class Certificate:
    class Verdict(Enum):
        kGlobalMinimum: Certificate.Verdict
        kLocalMinimum: Certificate.Verdict
        kUndecided: Certificate.Verdict
    class Relation(Enum):
        kEqual: Certificate.Relation
        kBelow: Certificate.Relation
        kSimilar: Certificate.Relation
    verdict: Certificate.Verdict
    relation: Certificate.Relation
    chi2: float
    better_chi2: float
    chordal_cost: float
    bound: float
    chi2_from_chordal: float
    steps: int
    escapes: int
    time_s: float
    note: str
    def relative_gap(self) -> float: ...
    def chi2_bound(self) -> float: ...
