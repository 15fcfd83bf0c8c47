# SPDX-License-Identifier: BSD-3-Clause
"""Pickles of graphs: the text of a .json file, which has everything that a graph contains."""

import pathlib
import tempfile

from . import _boxplus


def reduce_graph(graph, protocol):
    """Graph.__reduce_ex__(). Raises TypeError if a pickle would lose something."""
    if graph.format.startswith("COLMAP"):
        raise TypeError("Graph: cannot be pickled, because names and colors of a COLMAP model would be lost; use save() and "
                        "load()")
    if graph.stack_size() > 0:
        raise TypeError("Graph: cannot be pickled while estimates are pushed on its stack; call pop() or discard_top()")
    try:
        return graph_of_text, (graph.to_text(format="json"),)
    except _boxplus.Error as error:
        raise TypeError(f"Graph: cannot be pickled: {error}") from error


def graph_of_text(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "graph.json"
        path.write_text(text, encoding="utf-8")
        return _boxplus.load(path)
