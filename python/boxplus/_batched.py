# SPDX-License-Identifier: BSD-3-Clause
"""Error functions of Python for many edges at a time. The module calls this file (python/src/edge_function.cpp)."""

import collections
import warnings

import numpy as np

from ._dual import Dual
from ._masks import require_unmasked

ERRORS, JACOBIANS, NUMERIC_JACOBIANS = range(3)
#: The step of numeric derivatives, in the tangent space, relative to the size of the number that changes.
STEP = 1e-6
#: The most functions that a report lists.
MOST_LISTED = 10


class BatchedEdge:
    """An error function for many edges at a time. Derive from it, and add edges with Graph.add_edges().

    error(x1, x2, ..., measurements) gets the estimates of the vertices of n edges as arrays of the shape (n, size), whose
    rows are those of Graph.estimates(), and the measurements (n, width), if add_edges() got some. It returns the errors of
    all edges: (n, rows), or (n,) for one row. It is called once per iteration.

    jacobians(x1, x2, ..., measurements) is optional. It returns one array (n, rows, dim) per vertex: the derivative of the
    error by the step in the tangent space of the vertex. Without it, error() is called with arrays of dual numbers, which
    give exact derivatives if it uses NumPy's functions; if that fails, its derivatives are computed numerically, and the
    report says so.
    """

    def error(self, *arguments):
        raise NotImplementedError(f"{type(self).__name__}: error() is missing")


#: What an error function of Python cost in a run: the source of its Jacobians, the number of calls, of edges in these
#: calls, and the seconds.
EdgeFunctionCost = collections.namedtuple("EdgeFunctionCost", "name jacobians calls edges seconds")


def describe(edge):
    """The name of an error function, whether it has Jacobians, and whether it can get dual numbers."""
    if hasattr(edge, "error"):
        return type(edge).__name__, hasattr(edge, "jacobians"), True
    return getattr(edge, "__name__", type(edge).__name__), False, False


def evaluate(edge, arguments, dims, rows, want, seeds, moved, objects):
    """(errors, Jacobians per vertex or None, whether they had to be numeric)"""
    for array in arguments:
        array.flags.writeable = False  # so that the function cannot change the arguments of its next call
    error = _batched_error(edge, len(dims), objects)
    errors = _checked(edge, error(*arguments), len(arguments[0]), rows)
    if want == ERRORS:
        return errors, None, False
    if want == JACOBIANS and hasattr(edge, "jacobians"):
        return errors, _given(edge, arguments, dims, errors.shape[1]), False
    numeric = _Numeric(error, edge, arguments, dims, errors, moved)
    if want == JACOBIANS and hasattr(edge, "error"):
        try:
            return errors, _exact(edge, arguments, errors, seeds, numeric), False
        except Exception as reason:  # of any type: the same call with plain arrays has succeeded
            _warn(edge, reason)
    return errors, [numeric.block(i) for i in range(len(dims))], True


def costs_of_run(before, after):
    known = dict((index, cost) for index, cost in enumerate(before))
    costs = []
    for index, (name, source, calls, edges, seconds) in enumerate(after):
        _, _, old_calls, old_edges, old_seconds = known.get(index, (name, source, 0, 0, 0.0))
        costs.append(EdgeFunctionCost(name, source, calls - old_calls, edges - old_edges, seconds - old_seconds))
    return tuple(costs)


def costs_text(report):
    """A line for all functions with the same name and source of Jacobians, such as those called <lambda>."""
    alike = {}
    for cost in report.edge_functions:
        alike.setdefault((cost.name, cost.jacobians), []).append(cost)
    lines = []
    for (name, jacobians), costs in list(alike.items())[:MOST_LISTED]:
        calls, edges, seconds = (sum(getattr(cost, member) for cost in costs) for member in ("calls", "edges", "seconds"))
        count = "" if len(costs) == 1 else f" ({len(costs)} functions)"
        lines.append(f"  {'function':<16} {name}{count}: {calls} calls for {edges} errors, {seconds:.4f} s, {jacobians} Jacobians\n")
    if len(alike) > MOST_LISTED:
        seconds = sum(cost.seconds for cost in report.edge_functions)
        lines.append(f"  {'functions':<16} {len(report.edge_functions)} in all, {seconds:.4f} s\n")
    return "".join(lines)


def _name(edge):
    return describe(edge)[0]


def _warn(edge, reason):
    """Once per edge."""
    if getattr(edge, "_boxplus_is_numeric", False):
        return
    lines = str(reason).splitlines() or [type(reason).__name__]
    warnings.warn(f"{_name(edge)}: numeric derivatives, because {lines[0][:200]}", RuntimeWarning, stacklevel=2)
    try:
        edge._boxplus_is_numeric = True
    except AttributeError:
        pass


def _batched_error(edge, vertices, objects):
    """A function of arrays. A function of one edge is called for each row, with an SE2, an SE3 or an array per vertex, and
    with its measurement as an array."""
    if hasattr(edge, "error"):
        return edge.error

    def copied(value):  # the function may use its array again
        require_unmasked([value], _name(edge))
        return np.array(value, dtype=float, ndmin=1)

    def error(*arguments):
        columns = [objects(i, rows) for i, rows in enumerate(arguments[:vertices])] + list(arguments[vertices:])
        return np.stack([copied(edge(*row)) for row in zip(*columns)])

    return error


def _checked(edge, errors, count, rows):
    require_unmasked([errors], _name(edge))
    errors = np.array(errors, dtype=float)  # a copy, because the function may use its array again
    if errors.ndim == 1:
        errors = errors[:, np.newaxis]
    expected = f"({count}, {rows if rows > 0 else 'rows'})"
    if errors.ndim != 2 or errors.shape[0] != count or errors.shape[1] == 0 or (rows > 0 and errors.shape[1] != rows):
        raise ValueError(f"{_name(edge)}: expected errors of the shape {expected}, got {errors.shape}")
    return np.ascontiguousarray(errors)


def _given(edge, arguments, dims, rows):
    blocks = edge.jacobians(*arguments)
    if isinstance(blocks, np.ndarray) and len(dims) == 1:
        blocks = [blocks]
    if len(blocks) != len(dims):
        raise ValueError(f"{_name(edge)}: expected {len(dims)} Jacobians, one per vertex, got {len(blocks)}")
    count = len(arguments[0])
    result = []
    require_unmasked(blocks, _name(edge))
    for i, (block, dim) in enumerate(zip(blocks, dims)):
        block = np.asarray(block, dtype=float)
        if rows == 1 and block.shape == (count, dim):
            block = block[:, np.newaxis, :]
        if block.shape != (count, rows, dim):
            raise ValueError(f"{_name(edge)}: expected a Jacobian of the shape {(count, rows, dim)} for vertex {i}, got "
                             f"{block.shape}")
        result.append(np.ascontiguousarray(block))
    return result


def _exact(edge, arguments, errors, seeds, numeric):
    """The derivatives by one vertex after the other: all others are plain arrays."""
    blocks = []
    for i, dim in enumerate(numeric.dims):
        seeded = list(arguments)
        seeded[i] = Dual(arguments[i], np.moveaxis(seeds(i), 2, 0))
        with np.errstate(all="ignore"):  # the warnings of the values came before
            result = edge.error(*seeded)
        is_dual = isinstance(result, Dual)
        if not is_dual and not isinstance(result, np.ndarray):
            raise TypeError(f"its result is a {type(result).__name__}, and not an array")
        value = result.value if is_dual else result
        if not np.allclose(value.reshape(errors.shape), errors, rtol=1e-9, atol=1e-9 * np.abs(errors).max(initial=0),
                           equal_nan=True):
            raise TypeError("its result is another one for dual numbers")
        if not is_dual:  # it does not depend on this vertex
            blocks.append(np.zeros((*errors.shape, dim)))
            continue
        block = np.ascontiguousarray(np.moveaxis(result.derivative.reshape(dim, *errors.shape), 0, 2))
        if not np.isfinite(block).all() and np.isfinite(errors).all():  # such as that of |x| at 0
            block = np.where(np.isfinite(block), block, numeric.block(i))
        blocks.append(block)
    return blocks


class _Numeric:
    """Central differences."""

    def __init__(self, error, edge, arguments, dims, errors, moved):
        self.error, self.edge, self.arguments, self.dims, self.errors, self.moved = error, edge, arguments, dims, errors, moved

    def block(self, i):
        """The Jacobians by the i-th vertex."""
        count, rows = self.errors.shape
        block = np.empty((count, rows, self.dims[i]))
        for direction in range(self.dims[i]):
            steps = STEP * np.maximum(1.0, self.size(i, direction))
            after, before = (self.stepped(i, direction, sign * steps) for sign in (1, -1))
            ahead, behind = after - self.errors, self.errors - before
            derivative = ahead + behind
            # Where the error jumps, as an angle does at π, only one of the two differences is a derivative.
            jumps = np.abs(ahead - behind) > 1e-2 * (1 + np.abs(self.errors))
            derivative = np.where(jumps, 2 * np.where(np.abs(ahead) < np.abs(behind), ahead, behind), derivative)
            block[:, :, direction] = derivative / (2 * steps[:, np.newaxis])
        return block

    def size(self, i, direction):
        """Of the numbers that a step in this direction changes: of a coordinate, or of the position of a pose."""
        x, dim = self.arguments[i], self.dims[i]
        width = x.shape[1]
        if width > dim:  # SO3, S2, SE3, Sim3, (SE3, camera), planes and lines turn by angles
            if width > 8 and direction >= 6:
                return np.abs(x[:, direction + 1])
            moves = range(3, 6) if width == 8 else range(0, 3) if width >= 7 and dim >= 6 else ()
            scale = x[:, 7] if width == 8 else 1.0
            return np.abs(x[:, :3]).max(axis=1) / scale if direction in moves else np.ones(len(x))
        if dim == 3 and direction < 2:  # SE2 or a point
            return np.abs(x[:, :2]).max(axis=1)
        return np.abs(x[:, direction])

    def stepped(self, i, direction, steps):
        arguments = list(self.arguments)
        arguments[i] = self.moved(i, direction, steps)
        return _checked(self.edge, self.error(*arguments), len(steps), self.errors.shape[1])
