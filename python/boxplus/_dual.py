# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of dual numbers: exact derivatives of functions that are written with NumPy.

A Dual has a value of any shape s, and derivatives of the shape (d, *s): one array per direction. NumPy's functions call
__array_ufunc__ and __array_function__ of a Dual, which apply the chain rule (Griewank and Walther, "Evaluating
Derivatives", 2008, section 3.1). Whatever has no rule raises TypeError: a function, an option of a function, an `out`.

x[...] of basic indices is a view, as in NumPy, and in-place operators change the value and the derivative. All other
functions return copies. So a function that changes the result of, for example, reshape() in place gets another value than
NumPy gives, which the caller must notice.
"""

import numpy as np


class Dual(np.lib.mixins.NDArrayOperatorsMixin):
    __slots__ = ("value", "derivative")
    __array_priority__ = 1000

    def __init__(self, value, derivative):
        if derivative.shape[1:] != value.shape:
            raise TypeError(f"the derivative of an array of the shape {value.shape} has the shape {derivative.shape[1:]}")
        self.value = value
        self.derivative = derivative

    shape = property(lambda self: self.value.shape)
    ndim = property(lambda self: self.value.ndim)
    size = property(lambda self: self.value.size)
    dtype = property(lambda self: self.value.dtype)
    T = property(lambda self: np.transpose(self))

    def __len__(self):
        return len(self.value)

    def __iter__(self):
        return (self[i] for i in range(len(self)))

    def __repr__(self):
        return f"Dual({self.value!r})"

    def __bool__(self):
        return bool(self.value)

    def __getitem__(self, key):
        return Dual(self.value[key], self.derivative[_after_directions(key)])

    def __setitem__(self, key, item):
        keys = _after_directions(key)
        self.value[key] = value_of(item)
        self.derivative[keys] = _fitted(item, self.value[key].ndim) if isinstance(item, Dual) else 0

    def reshape(self, *shape):
        return np.reshape(self, shape[0] if len(shape) == 1 else shape)

    def transpose(self, *axes):
        return np.transpose(self, axes or None)

    def swapaxes(self, a, b):
        return np.swapaxes(self, a, b)

    def ravel(self):
        return np.reshape(self, -1)

    def sum(self, axis=None, keepdims=False):
        return np.sum(self, axis=axis, keepdims=keepdims)

    def mean(self, axis=None, keepdims=False):
        return np.mean(self, axis=axis, keepdims=keepdims)

    def dot(self, other):
        return np.dot(self, other)

    def copy(self):
        return Dual(self.value.copy(), self.derivative.copy())

    def astype(self, dtype, **_):
        if np.dtype(dtype) != np.float64:
            raise TypeError(f"a derivative cannot be converted to {dtype}")
        return self.copy()

    def clip(self, low=None, high=None):
        return _clip(self, low, high)

    def flatten(self):
        return np.reshape(self, -1)

    def __array__(self, *_, **__):
        raise TypeError("an array of dual numbers cannot become a plain array: the derivative would be lost")

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        if method == "reduce" and ufunc is np.add and not options.keys() - {"axis", "keepdims", "dtype", "out"}:
            if options.get("out", (None,)) not in (None, (None,)):
                raise TypeError("numpy.add.reduce has no rule for derivatives with out")
            return np.sum(inputs[0], axis=options.get("axis", 0), keepdims=options.get("keepdims", False))
        out = options.pop("out", None)
        if method != "__call__" or options:
            raise TypeError(f"numpy.{ufunc.__name__} has no rule for derivatives with these options")
        if out is not None:
            if len(out) != 1 or out[0] is not inputs[0]:  # x += y passes x as out
                raise TypeError(f"numpy.{ufunc.__name__} has no rule for derivatives with out")
            return _assigned(inputs[0], ufunc(*inputs))
        values = [value_of(x) for x in inputs]
        if ufunc in _WITHOUT_DERIVATIVE:
            return ufunc(*values)
        if ufunc is np.matmul:
            return _of_each(np.matmul, inputs)
        rule = _RULES.get(ufunc)
        if rule is None:
            raise TypeError(f"numpy.{ufunc.__name__} has no rule for derivatives")
        result = ufunc(*values)
        partials = rule(result, *values)
        derivative = 0
        for x, partial in zip(inputs, partials):
            if isinstance(x, Dual):
                derivative = derivative + partial * _fitted(x, result.ndim)
        return Dual(result, _filled(derivative, result.shape))

    def __array_function__(self, function, types, arguments, options):
        if options.get("out") is not None:
            raise TypeError(f"numpy.{function.__name__} has no rule for derivatives with out")
        if function in _STRUCTURAL:
            return _linear(function, arguments, options)
        if function in _BILINEAR:
            return _of_each(function, arguments, options)
        rule = _FUNCTIONS.get(function)
        if rule is None:
            raise TypeError(f"numpy.{function.__name__} has no rule for derivatives")
        return rule(*arguments, **options)


def _after_directions(key):
    """The index of the derivative for an index of the value."""
    keys = key if isinstance(key, tuple) else (key,)
    is_array = [isinstance(k, (np.ndarray, list)) for k in keys]
    if any(is_array):  # then integers count as arrays, too, and arrays that are not next to each other move their axes
        places = [i for i, k in enumerate(keys) if is_array[i] or isinstance(k, (int, np.integer))]
        if places[-1] - places[0] >= len(places):
            raise TypeError("arrays of indices that are separated by slices have no rule for derivatives")
    return (slice(None), *keys)


def value_of(x):
    return x.value if isinstance(x, Dual) else np.asarray(x)


def _filled(derivative, shape):
    """An array of its own, that may be changed."""
    full = (derivative.shape[0], *shape)
    return derivative if derivative.shape == full else np.array(np.broadcast_to(derivative, full))


def _assigned(x, result):
    """x[...] = result"""
    x.value[...] = result.value
    x.derivative[...] = result.derivative
    return x


def _fitted(x, ndim):
    """The derivative of x, with axes of length 1 after the first one, so that it broadcasts to ndim axes."""
    missing = ndim - x.value.ndim
    return x.derivative.reshape(x.derivative.shape[0], *(1,) * missing, *x.value.shape) if missing > 0 else x.derivative


def _with(arguments, choose):
    """The arguments, in which choose(x) replaces each Dual, also inside of lists."""
    if isinstance(arguments, Dual):
        return choose(arguments)
    if isinstance(arguments, (list, tuple)):
        return type(arguments)(_with(x, choose) for x in arguments)
    if isinstance(arguments, dict):
        return {name: _with(x, choose) for name, x in arguments.items()}
    return arguments


def _duals(arguments):
    if isinstance(arguments, Dual):
        return [arguments]
    if isinstance(arguments, (list, tuple)):
        return [dual for x in arguments for dual in _duals(x)]
    if isinstance(arguments, dict):
        return _duals(list(arguments.values()))
    return []


def _zeros_like_constants(arguments):
    """The arguments with zeros in place of constant arrays, as the derivative of a constant."""
    if isinstance(arguments, (list, tuple)):
        return type(arguments)(_zeros_like_constants(x) for x in arguments)
    return arguments if isinstance(arguments, Dual) else np.zeros_like(np.asarray(arguments, dtype=float))


def _linear(function, arguments, options):
    """A function that is linear in its first argument, such as stack() of a list."""
    if not arguments or _duals(arguments[1:]) or _duals(options):
        raise TypeError(f"numpy.{function.__name__} has no rule for derivatives of these arguments")
    count = _duals(arguments)[0].derivative.shape[0]
    first, rest = arguments[0], arguments[1:]
    value = function(_with(first, lambda x: x.value), *rest, **options)
    zeros = _zeros_like_constants(first)
    derivative = np.stack([function(_with(zeros, lambda x, k=k: x.derivative[k]), *rest, **options) for k in range(count)])
    return Dual(value, derivative)


def _of_each(function, arguments, options=None):
    """A function that is linear in each array, such as einsum(): the sum of the derivatives by each of them."""
    options = options or {}
    if _duals(options) or any(_duals(x) for x in arguments if not isinstance(x, Dual)):
        raise TypeError(f"numpy.{function.__name__} has no rule for derivatives of lists")
    plain = [_with(x, lambda dual: dual.value) for x in arguments]
    value = function(*plain, **options)
    derivative = 0
    for i, x in enumerate(arguments):
        if isinstance(x, Dual):
            derivative = derivative + np.stack(
                [function(*plain[:i], part, *plain[i + 1:], **options) for part in x.derivative])
    return Dual(value, derivative)


def _norm(x, ord=None, axis=None, keepdims=False):
    if ord not in (None, 2) or (axis is None and x.ndim != 1) or isinstance(axis, tuple):
        raise TypeError("numpy.linalg.norm has a rule for derivatives only for the length of vectors")
    return np.sqrt(np.sum(x * x, axis=axis, keepdims=keepdims))


def _where(condition, x, y):
    condition = value_of(condition).astype(bool)
    value = np.where(condition, value_of(x), value_of(y))
    derivative = 0
    for part, chosen in ((x, condition), (y, ~condition)):
        if isinstance(part, Dual):
            derivative = derivative + np.where(chosen, _fitted(part, value.ndim), 0)
    if isinstance(derivative, int):
        return value
    return Dual(value, _filled(derivative, value.shape))


def _clip(x, low=None, high=None):
    x = x if low is None else np.maximum(x, low)
    return x if high is None else np.minimum(x, high)


def _on_axes(function):
    """A function whose arguments are axes or shapes of the value, which the derivative has after its first axis."""
    def rule(x, *arguments, **options):
        if not isinstance(x, Dual) or options.keys() - _AXES or _duals(list(arguments)) or _duals(options):
            raise TypeError(f"numpy.{function.__name__} has no rule for derivatives of these arguments")
        value = np.array(function(x.value, *arguments, **options))
        derivative = np.stack([function(part, *arguments, **options) for part in x.derivative])
        return Dual(value, derivative)
    return rule


#: The options of functions of one array that have no influence on the derivative.
_AXES = {"axis", "axes", "keepdims", "newshape", "shape", "source", "destination", "repeats", "reps", "n", "shift", "offset",
         "indices", "axis1", "axis2"}

#: The partial derivatives by each argument, from the result and the arguments.
_RULES = {
    np.add: lambda r, a, b: (1, 1),
    np.subtract: lambda r, a, b: (1, -1),
    np.multiply: lambda r, a, b: (b, a),
    np.divide: lambda r, a, b: (1 / b, -r / b),
    np.negative: lambda r, a: (-1,),
    np.positive: lambda r, a: (1,),
    np.reciprocal: lambda r, a: (-r * r,),
    np.square: lambda r, a: (2 * a,),
    np.sqrt: lambda r, a: (0.5 / r,),
    np.cbrt: lambda r, a: (r / (3 * a),),
    np.power: lambda r, a, b: (b * np.power(a, b - 1.0), r * np.log(np.where(a > 0, a, 1))),
    np.exp: lambda r, a: (r,),
    np.expm1: lambda r, a: (r + 1,),
    np.log: lambda r, a: (1 / a,),
    np.log1p: lambda r, a: (1 / (1 + a),),
    np.sin: lambda r, a: (np.cos(a),),
    np.cos: lambda r, a: (-np.sin(a),),
    np.tan: lambda r, a: (1 + r * r,),
    np.arcsin: lambda r, a: (1 / np.sqrt(1 - a * a),),
    np.arccos: lambda r, a: (-1 / np.sqrt(1 - a * a),),
    np.arctan: lambda r, a: (1 / (1 + a * a),),
    np.arctan2: lambda r, a, b: (b / (a * a + b * b), -a / (a * a + b * b)),
    np.hypot: lambda r, a, b: (a / r, b / r),
    np.sinh: lambda r, a: (np.cosh(a),),
    np.cosh: lambda r, a: (np.sinh(a),),
    np.tanh: lambda r, a: (1 - r * r,),
    np.absolute: lambda r, a: (np.sign(a),),
    np.maximum: lambda r, a, b: (a >= b, a < b),
    np.minimum: lambda r, a, b: (a <= b, a > b),
    np.remainder: lambda r, a, b: (1, -np.floor_divide(a, b)),
    np.fabs: lambda r, a: (np.sign(a),),
    np.exp2: lambda r, a: (r * np.log(2),),
    np.log2: lambda r, a: (1 / (a * np.log(2)),),
    np.log10: lambda r, a: (1 / (a * np.log(10)),),
    np.deg2rad: lambda r, a: (np.pi / 180,),
    np.radians: lambda r, a: (np.pi / 180,),
    np.rad2deg: lambda r, a: (180 / np.pi,),
    np.degrees: lambda r, a: (180 / np.pi,),
}
_WITHOUT_DERIVATIVE = {
    np.less, np.less_equal, np.greater, np.greater_equal, np.equal, np.not_equal, np.isfinite, np.isnan, np.isinf, np.sign,
    np.floor, np.ceil, np.rint, np.trunc, np.floor_divide, np.signbit,
}
_STRUCTURAL = {np.stack, np.concatenate, np.hstack, np.vstack, np.column_stack}
_BILINEAR = {np.einsum, np.dot, np.inner, np.outer, np.tensordot, np.cross}
_FUNCTIONS = {
    np.linalg.norm: _norm,
    np.where: _where,
    np.clip: _clip,
    np.shape: lambda x: x.shape,
    np.ndim: lambda x: x.ndim,
    np.zeros_like: lambda x, **options: np.zeros_like(x.value, **options),
    np.ones_like: lambda x, **options: np.ones_like(x.value, **options),
    np.full_like: lambda x, fill, **options: np.full_like(x.value, fill, **options),
}
for _function in (np.sum, np.mean, np.cumsum, np.reshape, np.transpose, np.swapaxes, np.moveaxis, np.expand_dims, np.squeeze,
                  np.broadcast_to, np.repeat, np.tile, np.take, np.roll, np.flip, np.diff, np.trace, np.diagonal, np.copy,
                  np.ravel):
    _FUNCTIONS[_function] = _on_axes(_function)
_FUNCTIONS[np.atleast_1d] = lambda x: _on_axes(np.atleast_1d)(x)  # of one array
_FUNCTIONS[np.atleast_2d] = lambda x: _on_axes(np.atleast_2d)(x)
