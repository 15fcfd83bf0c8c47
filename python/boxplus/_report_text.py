# SPDX-License-Identifier: BSD-3-Clause
"""The text of a report: that of C++, in which types of edges with the same name are counted, and what the error functions
of Python cost."""

import collections

from . import _boxplus
from ._batched import costs_text

_text = _boxplus.Report.__repr__
_SOURCES = {"kAnalytic": "analytic", "kAutomatic": "exact", "kNumeric": "numeric"}


def _jacobians(report):
    """The line "Jacobians". Each function of Python is a type of edges, and many of them may be called <lambda>."""
    counts = collections.Counter((edge.source.name, edge.edge_type) for edge in report.jacobians)
    groups = []
    for source, text in _SOURCES.items():
        names = [name if count == 1 else f"{name} ({count} functions)"
                 for (found, name), count in counts.items() if found == source]
        if names:
            groups.append(f"{text}: {', '.join(names)}")
    return f"  {'Jacobians':<16}{'; '.join(groups)}"


def report_text(report):
    lines = _text(report).split("\n")
    if len({(edge.source.name, edge.edge_type) for edge in report.jacobians}) < len(report.jacobians):
        lines = [_jacobians(report) if line.startswith("  Jacobians ") else line for line in lines]
    return "\n".join(lines) + costs_text(report)
