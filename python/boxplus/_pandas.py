# SPDX-License-Identifier: BSD-3-Clause
"""A report as a table of pandas."""

from ._boxplus import IterationRecord

COLUMNS = [name for name in vars(IterationRecord) if not name.startswith("_") and name != "iteration"]
INTEGERS = {"tries", "linear_iterations"}


def report_to_pandas(report):
    """A DataFrame with one row per iteration, and a column for each other member of IterationRecord. The start is not
    an iteration: its chi2 is chi2_start(). Needs pandas; raises ImportError if it cannot be imported."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError(f"Report.to_pandas() needs pandas, which cannot be imported: {error}", name="pandas") from error
    index = pandas.Index([record.iteration for record in report.records], dtype="int64", name="iteration")

    def column(name):
        values = [getattr(record, name) for record in report.records]
        return pandas.Series(values, index, dtype="int64" if name in INTEGERS else "float64")

    return pandas.DataFrame({name: column(name) for name in COLUMNS})
