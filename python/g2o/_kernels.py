# SPDX-License-Identifier: BSD-3-Clause
"""Robust kernels. The formulas are those of boxplus (docs/first_steps.md)."""

import numpy as np

import boxplus


class RobustKernel:
    """The contribution ρ(e²) of an edge with the squared error e². The width is delta()."""

    _NAME = None

    def __init__(self, delta=1.0):
        if type(self)._NAME is None:
            raise TypeError(f"{type(self).__name__}: kernels that are written in Python are not supported; derive from none, "
                            "and use one of the kernels of g2o")
        self.set_delta(delta)

    def delta(self):
        return self._delta

    def set_delta(self, delta):
        self._native = boxplus.make_robust_kernel(type(self)._NAME, float(delta))
        self._delta = float(delta)

    def robustify(self, e2):
        """ρ, ρ′ and ρ″."""
        return np.array(self._native(float(e2)))

    def _key(self):
        return type(self)._NAME, self._delta

    def __repr__(self):
        return f"{type(self).__name__}({self._delta:.9g})"


def _kernel(name):
    return type(f"RobustKernel{name}", (RobustKernel,), {"_NAME": name, "__module__": "g2o", "__doc__": f"The kernel {name}."})


RobustKernelHuber = _kernel("Huber")
RobustKernelPseudoHuber = _kernel("PseudoHuber")
RobustKernelCauchy = _kernel("Cauchy")
RobustKernelGemanMcClure = _kernel("GemanMcClure")
RobustKernelWelsch = _kernel("Welsch")
RobustKernelFair = _kernel("Fair")
RobustKernelTukey = _kernel("Tukey")
RobustKernelSaturated = _kernel("Saturated")
RobustKernelDCS = _kernel("DCS")


class RobustKernelScaleDelta(RobustKernel):
    """Another kernel for errors that are divided by delta: ρ(e²) = delta² ρ'(e²/delta²)."""

    _NAME = "ScaleDelta"

    def __init__(self, kernel, delta=1.0):
        self._kernel = kernel
        self.set_delta(delta)

    def set_delta(self, delta):
        # The width of these two kernels is a squared error.
        is_squared = isinstance(self._kernel, (RobustKernelDCS, RobustKernelGemanMcClure))
        width = self._kernel.delta() * float(delta) ** (2 if is_squared else 1)
        self._native = boxplus.make_robust_kernel(self._kernel._NAME, width)
        self._delta = float(delta)

    def _key(self):
        return self._kernel._NAME, self._native.delta()
