# SPDX-License-Identifier: BSD-3-Clause
"""Every class of the modules: no use of its objects ends the process."""

import copy
import pickle
import subprocess
import sys
import unittest
import warnings

import boxplus
import g2o
import numpy as np
from boxplus import SE2, SE3, Between, Graph
from graph_test import square

#: What is done with every object. Each may raise an exception.
USES = (repr, copy.copy, copy.deepcopy, hash, bool, iter, len, *(lambda x, p=p: pickle.dumps(x, p) for p in range(6)))


def classes():
    """The classes of the modules and of their classes, with those whose names begin with _."""
    found, scopes = {}, [boxplus, boxplus._boxplus, g2o]
    for scope in scopes:
        for cls in vars(scope).values():
            if isinstance(cls, type) and cls.__module__.split(".")[0] in ("boxplus", "g2o") and cls not in found:
                found[cls] = None
                scopes.append(cls)
    return list(found)


def results():
    """Objects that only functions make."""
    graph, edges = square()
    report = boxplus.optimize(graph)
    yield from (graph, report, boxplus.covariance(graph, [1]), boxplus.diagnose(graph), boxplus.certify(graph))
    yield from (edges[0], graph.vertex(1), boxplus.find_outliers(graph), boxplus.Optimizer(graph))
    yield from (boxplus.make_robust_kernel("Huber", 1), boxplus.Constraint(len), boxplus.Between(SE2()))
    smoother = boxplus.Smoother(graph)
    yield from (smoother, smoother.update(), smoother.preview(edges[1]), smoother.options, boxplus.TangentDistance())
    yield from (*report.records, report.start, report.gauge, report.time, report.linear)


def use(value):
    """Does everything with an object that any object has."""
    for function in USES:
        attempt(function, value)
    for name in dir(type(value)):
        attempt(getattr, value, name)


def use_without_value(cls):
    """Also calls each method of an object whose __init__() was not called."""
    value = attempt(cls.__new__, cls)
    if type(value) is not cls:
        return
    use(value)
    if cls.__module__.split(".")[0] == "boxplus":
        for name in dir(cls):
            if not name.startswith("_") or name in ("__getstate__", "__call__", "__eq__", "__mul__", "__int__"):
                for arguments in ((), (value,), (1,)):
                    attempt(lambda: getattr(value, name)(*arguments))


def attempt(function, *arguments):
    try:
        return function(*arguments)
    except Exception:  # of any type
        return None


def use_everything():
    warnings.simplefilter("ignore")
    for cls in classes():
        print(cls.__module__, cls.__qualname__, flush=True)
        use_without_value(cls)
        value = attempt(cls)
        if value is not None:
            use(value)
    for value in results():
        print("a result:", type(value).__qualname__, flush=True)
        use(value)


class Classes(unittest.TestCase):
    def test_no_use_of_any_class_ends_the_process(self):
        run = subprocess.run([sys.executable, __file__, "use-everything"], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, (run.stdout.splitlines()[-1:], run.stderr[-2000:]))
        self.assertGreater(len(run.stdout.splitlines()), 200)

    def test_an_object_without_a_value_is_refused_everywhere(self):
        graph = Graph()
        for cls in (SE2, boxplus.Options, boxplus.Report, boxplus.Report.Status, boxplus.VertexRef, Between, Graph):
            with self.subTest(cls), self.assertRaisesRegex(TypeError, "without a value"):
                repr(cls.__new__(cls))
        with self.assertRaisesRegex(TypeError, "without a value"):
            graph.add_vertex(SE3.__new__(SE3))

    def test_classes_without_a_pickle_say_so(self):
        for value in (boxplus.Options(), Between(SE2()), boxplus.StopFlag(), square()[1][0]):
            for function in (copy.deepcopy, *(lambda x, p=p: pickle.dumps(x, p) for p in range(6))):
                with self.assertRaisesRegex(TypeError, f"{type(value).__name__}: cannot be pickled or copied"):
                    function(value)

    def test_a_pickle_of_every_protocol_gives_the_same_value(self):
        graph = square()[0]
        for protocol in range(6):
            for value in (SE2(1, 2, 3), SE3([1, 2, 3], [0, 0, 0.6, 0.8]), boxplus.SimplePinholeCamera(500, 320, 240),
                          boxplus.Report.Status.kConverged):
                self.assertEqual(pickle.loads(pickle.dumps(value, protocol)), value)
            self.assertEqual(pickle.loads(pickle.dumps(graph, protocol)).to_text(), graph.to_text(format="json"))

    def test_a_class_derived_from_one_of_boxplus_may_have_its_own_pickle(self):
        edge = pickle.loads(pickle.dumps(Odometry(np.array([1.0, 2, 3]))))
        self.assertEqual(edge.measurement, SE2(1, 2, 3))


class Odometry(Between):
    def __init__(self, row):
        super().__init__(SE2.from_vector(row))

    def __reduce__(self):
        return Odometry, (self.measurement.vector(),)


if __name__ == "__main__":
    if sys.argv[1:] == ["use-everything"]:
        use_everything()
    else:
        unittest.main()
