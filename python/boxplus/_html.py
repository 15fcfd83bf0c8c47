# SPDX-License-Identifier: BSD-3-Clause
"""A report as HTML, for notebooks."""

import html

COLUMNS = ("iteration", "chi2", "chi2_decrease", "step_max", "gradient_max", "time_s")


def _cell(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def report_as_html(report):
    """A summary and a table with one row per iteration. The first row is the start."""
    summary = (f"{report.message} chi2 {report.chi2_start():.9g} → {report.chi2_final:.9g}, "
               f"{report.vertices} vertices, {report.edges} edges, {report.algorithm}, {report.linear_solver}, "
               f"{report.time.total_s:.4f} s")
    rows = [["0", _cell(report.chi2_start())] + [""] * (len(COLUMNS) - 2)]
    rows += [[_cell(getattr(record, column)) for column in COLUMNS] for record in report.records]
    head = "".join(f"<th>{column}</th>" for column in COLUMNS)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return (f"<p><b>{'converged' if report.converged() else 'not converged'}</b>: {html.escape(summary)}</p>"
            f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>")
