# SPDX-License-Identifier: BSD-3-Clause
"""Masked arrays (numpy.ma) whose masks would be lost are refused. The module calls this file (python/src/convert.cpp)."""

import numpy as np


def is_masked(value):
    return isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value)


def require_unmasked(values, name):
    for value in values:
        if is_masked(value):
            place = [int(axis[0]) for axis in np.nonzero(np.ma.getmaskarray(value))]
            raise ValueError(f"{name}: expected an array without masked numbers, got a masked array of shape {value.shape} with "
                             f"{np.ma.count_masked(value)} masked numbers, the first at {place}")
