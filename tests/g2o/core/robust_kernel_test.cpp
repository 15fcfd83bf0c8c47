// SPDX-License-Identifier: BSD-3-Clause
// The robust kernels of the g2o API pass the same checks as the kernels of the engine (boxplus without the
// g2o API).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "boxplus/testing/check_kernel.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"

namespace {

/// Adapts a kernel of the g2o API to the interface of the kernels of the engine.
class Adapter final : public boxplus::RobustKernel {
 public:
  Adapter(const std::string& name, double delta)
      : name_(name), kernel_(g2o::RobustKernelFactory::instance()->construct(name)) {
    kernel_->setDelta(delta);
  }
  Rho operator()(double e2) const override {
    g2o::Vector3 rho;
    kernel_->robustify(e2, rho);
    return {rho[0], rho[1], rho[2]};
  }
  std::string_view name() const override { return name_; }
  double delta() const override { return kernel_->delta(); }
  std::unique_ptr<boxplus::RobustKernel> clone() const override {
    return std::make_unique<Adapter>(name_, delta());
  }

 private:
  std::string name_;
  std::unique_ptr<g2o::RobustKernel> kernel_;
};

TEST(RobustKernels, OfTheFactoryPassTheChecksAtEveryWidth) {
  std::vector<std::string> names;
  g2o::RobustKernelFactory::instance()->fillKnownKernels(names);
  ASSERT_GE(names.size(), 9u);
  for (const std::string& name : names) {
    for (const double delta : {0.1, 1.0, 5.0, 300.0}) {
      const boxplus::KernelCheck check = check_kernel(Adapter(name, delta));
      EXPECT_TRUE(check) << check.message << ", delta " << delta;
    }
  }
}

TEST(RobustKernels, WithHugeWidthsKeepTheSquaredErrorAndWithTinyWidthsStayFinite) {
  std::vector<std::string> names;
  g2o::RobustKernelFactory::instance()->fillKnownKernels(names);
  for (const std::string& name : names) {
    for (const double delta : {std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()}) {
      EXPECT_NEAR(Adapter(name, delta)(9).value, 9, 1e-12) << name << ", delta " << delta;
      EXPECT_NEAR(Adapter(name, delta)(9).first, 1, 1e-12) << name << ", delta " << delta;
    }
    const boxplus::RobustKernel::Rho rho = Adapter(name, 1e-300)(9);
    EXPECT_TRUE(std::isfinite(rho.value) && std::isfinite(rho.first) && std::isfinite(rho.second)) << name;
  }
}

TEST(RobustKernels, DynamicCovarianceScalingHasTheWeightFromItsPaper) {
  g2o::RobustKernelDCS kernel(1);
  g2o::Vector3 rho;
  kernel.robustify(100, rho);
  EXPECT_DOUBLE_EQ(rho[1], 4.0 / (101 * 101));
  EXPECT_DOUBLE_EQ(rho[0], 3 - 4.0 / 101);
}

}  // namespace
