// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/robust_kernel_impl.h"

#include <algorithm>
#include <tuple>

#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"
#include "g2o/core/thread_safe.h"

namespace g2o {
namespace {

/// Sets rho to (ρ, ρ′, ρ″) of a kernel of boxplus with the width `delta`, or with the nearest width that
/// boxplus accepts. If the width is not positive, sets rho to zero, so that the error has no effect.
template <class Kernel>
void robustify_by(double delta, double e2, Vector3& rho) {
  if (!(delta > 0)) {
    rho.setZero();
    return;
  }
  using boxplus::detail::kLargestKernelWidth, boxplus::detail::kSmallestKernelWidth;
  const double width = std::clamp(delta, kSmallestKernelWidth, kLargestKernelWidth);
  const boxplus::RobustKernel::Rho value = Kernel(width)(e2);
  rho << value.value, value.first, value.second;
}

template <class... Kernels>
using AllThreadSafe = std::tuple<ThreadSafe<Kernels>...>;
const AllThreadSafe<RobustKernelHuber, RobustKernelPseudoHuber, RobustKernelCauchy, RobustKernelGemanMcClure,
                    RobustKernelWelsch, RobustKernelFair, RobustKernelTukey, RobustKernelSaturated,
                    RobustKernelDCS>
    kThreadSafe;

}  // namespace

RobustKernelScaleDelta::RobustKernelScaleDelta(const RobustKernelPtr& kernel, double delta)
    : RobustKernel(delta), _kernel(kernel) {}
RobustKernelScaleDelta::RobustKernelScaleDelta(double delta) : RobustKernel(delta) {}

void RobustKernelScaleDelta::setKernel(const RobustKernelPtr& ptr) {
  _kernel = ptr;
}

void RobustKernelScaleDelta::robustify(double error, Vector3& rho) const {
  if (_kernel == nullptr) {
    rho << error, 1, 0;
    return;
  }
  const double d2 = _delta * _delta;
  _kernel->robustify(error / d2, rho);
  rho[0] *= d2;
  rho[2] /= d2;
}

void RobustKernelHuber::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Huber>(_delta, e2, rho);
}

void RobustKernelPseudoHuber::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::PseudoHuber>(_delta, e2, rho);
}

void RobustKernelCauchy::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Cauchy>(_delta, e2, rho);
}

void RobustKernelGemanMcClure::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::GemanMcClure>(_delta, e2, rho);
}

void RobustKernelWelsch::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Welsch>(_delta, e2, rho);
}

void RobustKernelFair::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Fair>(_delta, e2, rho);
}

void RobustKernelTukey::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Tukey>(_delta, e2, rho);
}

void RobustKernelSaturated::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::Saturated>(_delta, e2, rho);
}

void RobustKernelDCS::robustify(double e2, Vector3& rho) const {
  robustify_by<boxplus::DCS>(_delta, e2, rho);
}

}  // namespace g2o

// Defines the symbol that G2O_USE_ROBUST_KERNEL(classname) needs. It is weak, because a client may register a
// class of the same name.
#define DEFINE_FOR_USE(classname) \
  G2O_API_EXPORT __attribute__((weak)) void g2o_robust_kernel_##classname(void) {}
extern "C" {
DEFINE_FOR_USE(RobustKernelHuber)
DEFINE_FOR_USE(RobustKernelPseudoHuber)
DEFINE_FOR_USE(RobustKernelCauchy)
DEFINE_FOR_USE(RobustKernelGemanMcClure)
DEFINE_FOR_USE(RobustKernelWelsch)
DEFINE_FOR_USE(RobustKernelFair)
DEFINE_FOR_USE(RobustKernelTukey)
DEFINE_FOR_USE(RobustKernelSaturated)
DEFINE_FOR_USE(RobustKernelDCS)
}
