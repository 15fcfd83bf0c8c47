# SPDX-License-Identifier: BSD-3-Clause
"""Masked arrays (numpy.ma) whose masks would be lost are refused."""

import functools

import numpy as np


def is_masked(value):
    return isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value)


def require_unmasked(values, name):
    for value in values:
        if is_masked(value):
            place = [int(axis[0]) for axis in np.nonzero(np.ma.getmaskarray(value))]
            raise ValueError(f"{name}: expected an array without masked numbers, got a masked array of shape {value.shape} with "
                             f"{np.ma.count_masked(value)} masked numbers, the first at {place}")


def refuses_masks(method):
    """A method of Graph whose arguments are arrays."""
    name = f"Graph.{method.__name__}"

    @functools.wraps(method)
    def checked(self, *arguments, **options):
        for value in arguments:
            if isinstance(value, np.ma.MaskedArray):
                require_unmasked(arguments, name)
        if options:
            require_unmasked(options.values(), name)
        return method(self, *arguments, **options)

    return checked
