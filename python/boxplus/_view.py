# SPDX-License-Identifier: BSD-3-Clause
"""The viewer of a graph: boxplus.view()."""

import atexit
import html
import os

from . import _boxplus

_open = set()  # viewers stay open until they are closed, also if the program keeps no reference


class Viewer:
    """Serves a page that shows a graph, and its optimization while it runs. view() opens it.

    optimize(), Optimizer.run() and find_outliers() show their iterations on the page, and Smoother.update() shows how the
    graph grows, at most 30 times a second. Call update() to show what else has changed. The page only watches, unless hand_over() lets it optimize the graph.
    """

    def __init__(self, graph, *, name="graph", host="127.0.0.1", port=0):
        _import_viewer()
        self._native = _boxplus._Viewer(graph, name, host, port)
        _open.add(self)

    @property
    def url(self):
        """The address of the page. If other machines can reach the server, it contains the token that they need."""
        return self._native.url()

    @property
    def closed(self):
        return self._native.is_closed()

    def close(self):
        """Ends the server and closes all pages. Returns within a second, or when a run that a page has started has ended its
        iteration. During an optimize() in another thread, the server ends with this run."""
        self._native.close()
        _open.discard(self)

    def update(self):
        """Shows the current estimates, and the vertices and edges if they have changed."""
        self._native.update()

    def hand_over(self):
        """Lets pages optimize the graph. The program cannot use it until take_back() or close()."""
        self._native.hand_over()

    def take_back(self):
        """Stops what a page has started, and waits for its end. Has no effect without hand_over()."""
        self._native.take_back()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __repr__(self):
        return f"Viewer({self.url}{', closed' if self.closed else ''})"

    def _repr_html_(self):
        url = html.escape(self.url)
        return f"<p>Viewer: {'closed' if self.closed else f'<a href={chr(34)}{url}{chr(34)} target={chr(34)}_blank{chr(34)}>{url}</a>'}</p>"


def view(graph, *, name="graph", host="127.0.0.1", port=0):
    """Opens a Viewer of a graph, and returns it. The server runs in the background until close(), or until the program ends.

    name: what the page calls the graph. host: at any other address, other machines can reach the server. port: 0 is 8743, or
    any free port if it is taken. Raises ImportError if the module was built without the viewer, and Error if the address
    cannot be bound.
    """
    return Viewer(graph, name=name, host=host, port=port)


def _import_viewer():
    try:
        import ssl  # noqa: F401  so that Python's own OpenSSL is loaded, and not another one that a wheel contains
    except ImportError:
        pass
    try:
        from . import _viewer  # noqa: F401
    except ImportError as error:
        raise ImportError(f"boxplus.view: this module has no viewer, because it was built without cpp-httplib or nlohmann-json, "
                          f"or its libraries are missing: {error}") from error


def _close_all():
    for viewer in list(_open):
        viewer.close()


def _forget_all():
    """In the child of a fork, viewers count as closed; the server is that of the parent."""
    for viewer in list(_open):
        _open.discard(viewer)
        viewer._native.forget()


os.register_at_fork(after_in_child=_forget_all)
# Before the interpreter finalizes: a page may have started a run that calls error functions of Python.
atexit.register(_close_all)
