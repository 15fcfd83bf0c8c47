# SPDX-License-Identifier: BSD-3-Clause
# Reads a file, optimizes it and writes it; bad input.

import pathlib
import tempfile

folder = tempfile.TemporaryDirectory()
path = pathlib.Path(folder.name) / "town.g2o"
path.write_text("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1.1 0.1 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n", encoding="utf-8")
out = path.with_name("optimized.g2o")

# [file]
import boxplus

graph = boxplus.load(path)
for note in graph.notes:  # unusual lines that are not errors
    print(note)
report = boxplus.optimize(graph)
graph.save(out)
# [/file]

assert report.converged() and out.exists()

path.write_text("VERTEX_SE2 0 0 zero 0\n", encoding="utf-8")
# [error]
try:
    boxplus.load(path)
except boxplus.InputError as error:
    print(error, error.line, error.column)  # file:line:column: expected …, got …
# [/error]
else:
    raise AssertionError("the file was accepted")
