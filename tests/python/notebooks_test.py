# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks are the numbered examples, without outputs, and their cells run."""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "examples/python/notebooks"
NEEDED = {"05_plots": "matplotlib"}
#: Runs the code cells of a notebook one after the other in one namespace, as a kernel does.
RUN = """
import json, sys
namespace = {"__name__": "__main__"}
cells = json.load(open(sys.argv[1], encoding="utf-8"))["cells"]
for index, cell in enumerate(cells):
    if cell["cell_type"] == "code":
        exec(compile("".join(cell["source"]), f"{sys.argv[1]}, cell {index}", "exec"), namespace)
"""


def is_there(module):
    return importlib.util.find_spec(module) is not None


class Notebooks(unittest.TestCase):
    def test_they_are_made_from_the_examples(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/notebooks.py", "--check"], capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assertGreaterEqual(len(list(FOLDER.glob("*.ipynb"))), 8)

    def test_they_have_no_outputs_and_begin_with_a_text(self):
        for path in FOLDER.glob("*.ipynb"):
            notebook = json.loads(path.read_text(encoding="utf-8"))
            self.assertEqual((notebook["nbformat"], notebook["cells"][0]["cell_type"]), (4, "markdown"))
            ids = [cell["id"] for cell in notebook["cells"]]
            self.assertEqual(len(set(ids)), len(ids))
            for cell in notebook["cells"]:
                self.assertEqual(cell.get("outputs", []), [])
                self.assertTrue("".join(cell["source"]).strip())

    def test_their_cells_run(self):
        environment = {**os.environ, "MPLBACKEND": "Agg"}
        for path in sorted(FOLDER.glob("*.ipynb")):
            if not is_there(NEEDED.get(path.stem, "numpy")):
                continue
            command = [sys.executable, "-c", RUN, str(path)]
            if is_there("nbconvert") and is_there("ipykernel"):
                command = [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--stdout", str(path)]
            with self.subTest(path.stem):
                done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
