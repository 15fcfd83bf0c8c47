# SPDX-License-Identifier: BSD-3-Clause
"""Exact derivatives of functions that are written with NumPy."""

import unittest

import numpy as np

from boxplus._dual import Dual

RANDOM = np.random.default_rng(3)
A = RANDOM.uniform(0.2, 0.8, (5, 3))
MATRIX = RANDOM.normal(size=(3, 3))
MATRICES = RANDOM.normal(size=(5, 3, 3))


def assign(x):
    y = 2 * x
    y[:, 1] = x[:, 0] * x[:, 2]
    y[:, 2] = 7
    y += x
    return y


def in_place(x):
    y = x * 1
    y += np.sin(x)
    y *= x[:, :1]
    y -= 1
    y /= 2 + x
    y **= 2
    return y


def in_place_views(x):
    y = x * 2
    view = y[:, :2]
    view *= x[:, 2:]
    y[1] += 3 * x[0]
    for row in y:
        row *= 0.5
    alias = y
    alias += x
    return y


# Functions of an array (5, 3) with values between 0.2 and 0.8.
FUNCTIONS = {
    "arithmetic": lambda x: (1 + x) * x / (2 - x) - (-x) + 3 / x,
    "powers": lambda x: x**3 + x**0.5 + 2.0**x + x**x + np.square(x) + np.sqrt(x) + np.cbrt(x) + np.reciprocal(x),
    "exponentials": lambda x: np.exp(x) * np.log(x) + np.expm1(x) * np.log1p(x),
    "circles": lambda x: np.sin(x) * np.cos(x) + np.tan(x) + np.arcsin(x) + np.arccos(x) + np.arctan(x),
    "two arguments": lambda x: np.arctan2(x[:, 0], x[:, 1]) + np.hypot(x[:, 1], x[:, 2]),
    "hyperbolas": lambda x: np.sinh(x) + np.cosh(x) + np.tanh(x),
    "kinks": lambda x: np.abs(x - 0.5) + np.maximum(x, 0.4) + np.minimum(0.6, x) + np.clip(x, 0.3, 0.7),
    "angles": lambda x: np.deg2rad(np.rad2deg(x) * x) + np.mod(5 * x, 1.0),
    "choice": lambda x: np.where(x > 0.5, x * x, 3.0) + np.where(x < 0.5, 1.0, np.sin(x)),
    "sums": lambda x: x.sum(axis=1) * np.mean(x, axis=1) + np.sum(x * x, axis=1) + np.add.reduce(x, axis=1),
    "norm": lambda x: np.linalg.norm(x, axis=1, keepdims=True) * x,
    "stack": lambda x: np.stack([x[:, 0], np.ones(5), x[:, 1] * x[:, 2]], axis=1),
    "concatenate": lambda x: np.concatenate([x, np.zeros((5, 2)), x[:, :1] * x[:, 1:2]], axis=1),
    "columns": lambda x: np.column_stack((x[:, 2], x[:, 0] ** 2)),
    "einsum": lambda x: np.einsum("nij,nj->ni", MATRICES, x) * x,
    "product of sums": lambda x: np.einsum("ni,ni->n", x, np.sin(x)),
    "matrices": lambda x: x @ MATRIX + (MATRICES @ x[:, :, np.newaxis])[:, :, 0],
    "cross": lambda x: np.cross(x, np.array([1.0, 2.0, 3.0])) + np.cross(x, x * x),
    "shapes": lambda x: np.swapaxes(x, 0, 1).reshape(3, 5).T * np.squeeze(np.expand_dims(x, 0), 0) + x.ravel().reshape(5, 3),
    "indices": lambda x: x[..., [2, 0]] * x[:, 1, None],
    "iteration": lambda x: np.stack([row * row for row in x]),
    "broadcasting": lambda x: x * x[:, :1] + np.arange(3.0) * x[:, 1:2],
    "assignment": assign,
    "in place": in_place,
    "in-place views": in_place_views,
    "more logarithms": lambda x: np.log2(x) + np.log10(x) + np.exp2(x) + np.fabs(x - 0.5) + np.degrees(np.radians(x)),
    "integer conditions": lambda x: np.where((x > 0.5).astype(int), x * x, 3 * x),
    "methods": lambda x: x.clip(0.3, 0.7) + x.T.T + x.copy() + x.flatten().reshape(5, 3),
}


def derivatives(function, x):
    """∂ function(x) / ∂ t for three directions of x, by central differences."""
    directions = RANDOM.normal(size=(3, *x.shape))
    h = 1e-6
    numeric = np.stack([(function(x + h * d) - function(x - h * d)) / (2 * h) for d in directions])
    return directions, numeric


class DualNumbers(unittest.TestCase):
    def test_each_function_has_its_value_and_its_derivative(self):
        for name, function in FUNCTIONS.items():
            with self.subTest(name):
                directions, numeric = derivatives(function, A)
                result = function(Dual(A.copy(), directions))
                np.testing.assert_allclose(result.value, function(A), rtol=1e-15)
                np.testing.assert_allclose(result.derivative, numeric, rtol=2e-7, atol=2e-8)

    def test_functions_without_a_rule_raise_type_error(self):
        x = Dual(A.copy(), np.ones((1, 5, 3)))
        for function in (np.sort, np.linalg.inv, np.array, float, np.spacing, lambda v: np.linalg.norm(v, ord=1, axis=1)):
            with self.assertRaises(TypeError):
                function(x)

    def test_options_without_a_rule_raise_type_error(self):
        x = Dual(A.copy(), np.ones((1, 5, 3)))
        plain = np.empty((5, 3))
        for call in (lambda: np.sin(x, out=plain), lambda: np.multiply(x, 2, out=plain), lambda: np.sum(x, axis=1, initial=5.0),
                     lambda: np.add.reduce(x, axis=1, where=A > 0.5), lambda: np.sum(x, axis=1, out=np.empty(5)),
                     lambda: np.diff(x, prepend=1.0), lambda: np.atleast_2d(x, A), lambda: np.einsum("knm,nm->nm", [x, x], A),
                     lambda: np.cross([x[:, 0], x[:, 1], x[:, 2]], A, axisa=0), lambda: np.sin(x, where=A > 0.5),
                     lambda: np.stack([x, x], out=np.empty((2, 5, 3))), lambda: plain.__setitem__((slice(None), 0), x[:, 0])):
            with self.assertRaises(TypeError):
                call()

    def test_advanced_indices_that_move_axes_raise_type_error(self):
        x = Dual(MATRICES.copy(), np.ones((2, 5, 3, 3)))
        with self.assertRaises(TypeError):
            x[np.arange(5), :, np.array([0, 1, 2, 0, 1])]
        with self.assertRaises(TypeError):
            Dual(MATRIX.copy(), np.ones((2, 3, 3)))[np.newaxis][np.arange(1), :, 0]

    def test_comparisons_have_no_derivative(self):
        x = Dual(A.copy(), np.ones((1, 5, 3)))
        np.testing.assert_array_equal(x > 0.5, A > 0.5)
        self.assertIsInstance(np.sign(x), np.ndarray)


if __name__ == "__main__":
    unittest.main()
