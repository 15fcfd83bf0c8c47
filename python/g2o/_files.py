# SPDX-License-Identifier: BSD-3-Clause
"""Files in the format .g2o. docs/formats.md has the fields of each tag.

If a line is bad, load() skips it, a warning names the line, and the result is False. Numbers are read back exactly.
"""

import functools
import math

import numpy as np

import boxplus

from . import _rows
from ._geometry import unit_quaternion
from ._icp import EdgeGICP, EdgeVVGicp
from ._kinds import warn
from ._lots import EdgeSE2LotsOfXY, EdgeSE3LotsOfXYZ, LotsOfPoints
from ._sba import (CameraParameters, EdgeProjectP2MC, EdgeProjectP2SC, EdgeProjectPSI2UV, EdgeProjectXYZ2UV,
                   EdgeProjectXYZ2UVU, EdgeSBACam, EdgeSBAScale, EdgeSE3Expmap, EdgeSE3ProjectXYZ, EdgeSE3ProjectXYZOnlyPose,
                   EdgeStereoSE3ProjectXYZ, EdgeStereoSE3ProjectXYZOnlyPose, VertexCam, VertexSBAPointXYZ, VertexSE3Expmap)
from ._sim3 import EdgeInverseSim3ProjectXYZ, EdgeSim3, EdgeSim3ProjectXYZ, VertexSim3Expmap
from ._slam2d import (EdgePointXY, EdgeSE2, EdgeSE2Offset, EdgeSE2PointXY, EdgeSE2PointXYBearing, EdgeSE2PointXYCalib,
                      EdgeSE2PointXYOffset, EdgeSE2Prior, EdgeSE2TwoPointsXY, EdgeSE2XYPrior, EdgeXYPrior, ParameterSE2Offset,
                      VertexPointXY, VertexSE2)
from ._slam3d import (EdgePointXYZ, EdgeSE3, EdgeSE3Offset, EdgeSE3PointXYZ, EdgeSE3PointXYZDepth, EdgeSE3PointXYZDisparity,
                      EdgeSE3Prior, EdgeSE3XYZPrior, EdgeXYZPrior, ParameterCamera, ParameterSE3Offset, VertexPointXYZ,
                      VertexSE3)

VERTICES = {cls._TAG: cls for cls in (VertexSE2, VertexPointXY, VertexSE3, VertexPointXYZ, VertexSBAPointXYZ, VertexSE3Expmap,
                                      VertexCam, VertexSim3Expmap)}
PARAMETERS = {cls._TAG: cls for cls in (ParameterSE2Offset, ParameterSE3Offset, ParameterCamera, CameraParameters)}
EDGES = {cls._TAG: cls for cls in (
    EdgePointXY, EdgeSE2, EdgeSE2Offset, EdgeSE2PointXY, EdgeSE2PointXYBearing, EdgeSE2PointXYCalib, EdgeSE2PointXYOffset,
    EdgeSE2Prior, EdgeSE2TwoPointsXY, EdgeSE2XYPrior, EdgeXYPrior, EdgePointXYZ, EdgeSE3, EdgeSE3Offset, EdgeSE3PointXYZ,
    EdgeSE3PointXYZDepth, EdgeSE3PointXYZDisparity, EdgeSE3Prior, EdgeSE3XYZPrior, EdgeXYZPrior, EdgeProjectP2MC,
    EdgeProjectP2SC, EdgeProjectPSI2UV, EdgeProjectXYZ2UV, EdgeProjectXYZ2UVU, EdgeSBACam, EdgeSBAScale, EdgeSE3Expmap,
    EdgeSE3ProjectXYZ, EdgeSE3ProjectXYZOnlyPose, EdgeStereoSE3ProjectXYZ, EdgeStereoSE3ProjectXYZOnlyPose, EdgeSim3,
    EdgeSim3ProjectXYZ, EdgeInverseSim3ProjectXYZ, EdgeVVGicp, EdgeSE2LotsOfXY, EdgeSE3LotsOfXYZ)}
#: Types whose files have the inverse of the pose. Those of similarities have the logarithm of the inverse, which is the row.
INVERTED = (VertexSE3Expmap, EdgeSE3Expmap)
#: The most lines that a warning names.
MOST_NAMED = 5


@functools.lru_cache(maxsize=None)
def _places_in_triangle(size):
    """The places of the entries of a symmetric matrix in the list of its upper triangle."""
    places = np.zeros((size, size), dtype=int)
    places[np.triu_indices(size)] = np.arange(size * (size + 1) // 2)
    return np.maximum(places, places.T)


class _Fields:
    """The fields of a line, one after the other."""

    def __init__(self, words):
        self.words, self.next = words, 1

    def left(self):
        return len(self.words) - self.next

    def word(self, expected):
        if self.left() == 0:
            raise ValueError(f"expected {expected}, got the end of the line")
        self.next += 1
        return self.words[self.next - 1]

    def id(self):
        word = self.word("an id")
        if not word.lstrip("-").isdigit():
            raise ValueError(f"expected an id, got '{word}'")
        return int(word)

    def numbers(self, count):
        words = self.words[self.next:self.next + count]
        try:
            values = np.array(list(map(float, words)))
        except ValueError:
            values = np.array([])
        if len(values) == count and np.isfinite(values).all() and not any("_" in word for word in words):
            self.next += count
            return values
        return np.array([self.number() for _ in range(count)])  # raises

    def number(self):
        word = self.word("a number")
        try:
            value = float(word)
        except ValueError:
            value = math.nan
        if not math.isfinite(value) or "_" in word:
            raise ValueError(f"expected a finite number, got '{word}'")
        return value

    def end(self):
        if self.left():
            raise ValueError(f"expected the end of the line, got '{self.words[self.next]}'")


def load(optimizer, path):
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        warn(f"{path}: {error}")
        return False
    bad, unknown, edges, fixed = [], {}, [], []
    for number, line in enumerate(lines, 1):
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        fields = _Fields(words)
        try:
            if words[0] in VERTICES:
                _read_vertex(optimizer, VERTICES[words[0]](), fields)
            elif words[0] in PARAMETERS:
                _read_parameter(optimizer, PARAMETERS[words[0]](), fields)
            elif words[0] in EDGES or words[0] == "FIX":
                (fixed if words[0] == "FIX" else edges).append((number, fields))  # after all vertices
            else:
                unknown.setdefault(words[0], []).append(number)
        except ValueError as error:
            bad.append((number, error))
    for number, fields in fixed:
        _guarded(bad, number, lambda: _read_fixed(optimizer, fields))
    for number, fields in edges:
        _guarded(bad, number, lambda: _read_edge(optimizer, EDGES[fields.words[0]](), fields))
    for tag, numbers in unknown.items():
        warn(f"{path}:{numbers[0]}: skipped {len(numbers)} lines with the unknown tag {tag}")
    for number, error in sorted(bad, key=lambda item: item[0])[:MOST_NAMED]:
        warn(f"{path}:{number}: {error}")
    if len(bad) > MOST_NAMED:
        warn(f"{path}: {len(bad)} bad lines in all")
    return not bad


def _guarded(bad, number, read):
    try:
        read()
    except ValueError as error:
        bad.append((number, error))


def _read_vertex(optimizer, vertex, fields):
    id = fields.id()
    if id < 0 or id in optimizer._vertices:
        raise ValueError(f"expected a new id from 0, got {id}")
    vertex._id = id
    if isinstance(vertex, VertexSim3Expmap):
        vertex._row = boxplus.Sim3.exp(fields.numbers(7)).vector()
        count = 8 if fields.left() == 8 else 4
        vertex._cameras[:count] = fields.numbers(count)
    else:
        vertex._row = _row(vertex, fields)
    if isinstance(vertex, VertexCam) and fields.left():
        vertex._intrinsics = fields.numbers(5)
    fields.end()
    optimizer._insert_vertex(vertex)


def _row(element, fields):
    """The estimate of a vertex, or the measurement of an edge."""
    row = fields.numbers(element._CODEC.size)
    if len(row) == 7:
        row = _pose(row)
    return _rows.inverse(row[None])[0] if isinstance(element, INVERTED) else row


def _pose(row):
    length = np.linalg.norm(row[3:])
    if abs(length - 1) > 0.1:
        raise ValueError(f"expected a quaternion of length 1, got {row[3:].tolist()}")
    return row if abs(length - 1) < 1e-15 else np.append(row[:3], unit_quaternion(row[3:]))


def _read_parameter(optimizer, parameter, fields):
    id = fields.id()
    if id < 0 or id in optimizer._parameters:
        raise ValueError(f"expected a new id from 0, got {id}")
    parameter._id = id
    if isinstance(parameter, CameraParameters):
        parameter._values = fields.numbers(4)
    else:
        row = fields.numbers(len(parameter._row))
        parameter._row = _pose(row) if len(row) == 7 else row
        if isinstance(parameter, ParameterCamera):
            parameter._intrinsics = fields.numbers(4)
    fields.end()
    optimizer._insert_parameter(parameter)


def _read_fixed(optimizer, fields):
    while fields.left():
        id = fields.id()
        if id not in optimizer._vertices:
            raise ValueError(f"there is no vertex with the id {id}")
        optimizer._vertices[id].set_fixed(True)


def _read_edge(optimizer, edge, fields):
    if isinstance(edge, LotsOfPoints):
        end = fields.words.index("||") if "||" in fields.words else len(fields.words)
        edge.resize(max(1, end - fields.next))
    for i in range(len(edge._vertices)):
        expected, id = edge._type_of_vertex(i), fields.id()
        vertex = optimizer._vertices.get(id)
        if id != -1 and not isinstance(vertex, expected):
            raise ValueError(f"expected the id of a {expected.__name__}, got {id}")
        edge._vertices[i] = vertex
    edge._parameter_ids = [fields.id() for _ in edge._PARAMETERS]
    for id, expected in zip(edge._parameter_ids, edge._PARAMETERS):
        if not isinstance(optimizer._parameters.get(id), expected):
            raise ValueError(f"expected the id of a {expected.__name__}, got {id}")
    if isinstance(edge, EdgeVVGicp):
        _read_pair(edge, fields)
    else:
        if isinstance(edge, LotsOfPoints) and (fields.word("||"), fields.id()) != ("||", len(edge._vertices) - 1):
            raise ValueError(f"expected || and the number of the {len(edge._vertices) - 1} points")
        _read_measurement(edge, fields)
    fields.end()
    if not optimizer._insert_edge(edge):
        raise ValueError("expected an edge between different vertices")


def _read_pair(edge, fields):
    pair = EdgeGICP()
    pair.pos0, pair.normal0, pair.pos1, pair.normal1 = (fields.numbers(3) for _ in range(4))
    edge.set_measurement(pair)
    edge.set_information(pair.prec0(0.01))


def _read_measurement(edge, fields):
    if isinstance(edge, EdgeSim3):
        edge._z = boxplus.Sim3.exp(fields.numbers(7)).vector()
    else:
        edge._z = _row(edge, fields)
    size = edge.dimension()
    edge._information = fields.numbers(size * (size + 1) // 2)[_places_in_triangle(size)]
    if hasattr(edge, "_FIELDS") and fields.left():
        if hasattr(edge, "Xw"):
            edge.Xw = fields.numbers(3)
        for name in edge._FIELDS:
            setattr(edge, name, fields.number())


def save(optimizer, path, level=0):
    lines = []
    for id, parameter in sorted(optimizer._parameters.items()):
        lines.append(_line(parameter._TAG, id, parameter._data()))
    vertices = sorted(optimizer._vertices.items())
    edges = [edge for edge in optimizer._edges if edge.level() == level]
    missing = {type(element).__name__ for element in (*optimizer._vertices.values(), *edges) if element._TAG is None}
    if missing:
        warn(f"{path}: types without a tag were not written: {', '.join(sorted(missing))}")
    lines += [_line(vertex._TAG, id, _vertex_fields(vertex)) for id, vertex in vertices if vertex._TAG is not None]
    fixed = [str(id) for id, vertex in vertices if vertex.fixed() and vertex._TAG is not None]
    if fixed:
        lines.append("FIX " + " ".join(fixed))
    for edge in edges:
        if edge._TAG is not None and all(vertex is None or vertex._TAG is not None for vertex in edge._vertices):
            ids = [-1 if vertex is None else vertex.id() for vertex in edge._vertices]
            count = ["||", len(ids) - 1] if isinstance(edge, LotsOfPoints) else []
            lines.append(_line(edge._TAG, *ids, *count, *edge._parameter_ids, _edge_fields(edge)))
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n" if lines else "")
    except OSError as error:
        warn(f"{path}: {error}")
        return False
    return True


def _line(tag, *parts):
    *ids, numbers = parts
    return " ".join([tag, *map(str, ids), *(repr(float(number)) for number in numbers)])


def _vertex_fields(vertex):
    if isinstance(vertex, VertexSim3Expmap):
        return np.append(boxplus.Sim3.from_vector(vertex._row).log(), vertex._cameras)
    row = _rows.inverse(vertex._row[None])[0] if isinstance(vertex, INVERTED) else vertex._row
    return np.append(row, vertex._intrinsics) if isinstance(vertex, VertexCam) else row


def _edge_fields(edge):
    if isinstance(edge, EdgeVVGicp):
        pair = edge.measurement()
        return np.concatenate([pair.pos0, pair.normal0, pair.pos1, pair.normal1])
    if isinstance(edge, EdgeSim3):
        row = boxplus.Sim3.from_vector(edge._z).log()
    else:
        row = _rows.inverse(edge._z[None])[0] if isinstance(edge, INVERTED) else edge._z
    fields = [row, edge._information[np.triu_indices(edge.dimension())]]
    if hasattr(edge, "_FIELDS"):
        fields += [getattr(edge, "Xw", ()), [getattr(edge, name) for name in edge._FIELDS]]
    return np.concatenate(fields)
