# SPDX-License-Identifier: BSD-3-Clause
"""Report.to_pandas()."""

import sys
import unittest

from boxplus import IterationRecord, optimize
from graph_test import square

try:
    import pandas
except ImportError as error:
    print(f"SKIPPED: pandas cannot be imported: {error}")
    sys.exit(77)


class Tables(unittest.TestCase):
    def test_a_report_is_a_table_with_a_row_per_iteration(self):
        report = optimize(square()[0])
        table = report.to_pandas()
        self.assertIsInstance(table, pandas.DataFrame)
        self.assertEqual(table.index.name, "iteration")
        self.assertEqual(list(table.index), list(range(1, report.iterations + 1)))
        self.assertEqual(list(table["chi2"]), [record.chi2 for record in report.records])
        self.assertEqual(list(table["tries"]), [record.tries for record in report.records])
        members = {name for name in vars(IterationRecord) if not name.startswith("_")}
        self.assertEqual(set(table.columns), members - {"iteration"})

    def test_the_types_of_columns_do_not_depend_on_the_number_of_rows(self):
        empty = optimize(square()[0], max_iterations=0).to_pandas()
        self.assertEqual(len(empty), 0)
        self.assertEqual(list(empty.dtypes), list(optimize(square()[0]).to_pandas().dtypes))
        self.assertEqual((empty["chi2"].dtype, empty["tries"].dtype, empty.index.dtype), ("float64", "int64", "int64"))

    def test_integers_have_columns_of_integers(self):
        report = optimize(square()[0])
        table = report.to_pandas()
        for name in table.columns:
            is_integer = isinstance(getattr(report.records[0], name), int)
            self.assertEqual(table[name].dtype, "int64" if is_integer else "float64", name)


if __name__ == "__main__":
    unittest.main()
