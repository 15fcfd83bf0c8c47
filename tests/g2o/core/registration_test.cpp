// SPDX-License-Identifier: BSD-3-Clause
// Types that are registered twice, as if two copies of a library were loaded, and unregistered once, as if
// one copy were unloaded.
#include <gtest/gtest.h>

#include <memory>

#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/thread_safe.h"
#include "g2o/types/slam2d/types_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_ROBUST_KERNEL(RobustKernelHuber)
G2O_USE_ROBUST_KERNEL(RobustKernelDCS)

namespace {

TEST(UnloadingACopy, KeepsTheTypeOfTheOtherCopy) {
  {
    const g2o::RegisterTypeProxy<g2o::VertexSE2> copy("VERTEX_SE2");
    EXPECT_TRUE(g2o::Factory::instance()->knowsTag("VERTEX_SE2"));
  }
  EXPECT_TRUE(g2o::Factory::instance()->knowsTag("VERTEX_SE2"));
  const g2o::VertexSE2 v;
  EXPECT_EQ(g2o::Factory::instance()->tag(&v), "VERTEX_SE2");
}

class CustomVertex : public g2o::VertexSE2 {};

TEST(UnloadingACopy, KeepsTheTypeOfTheCopyThatWasLoadedLater) {
  auto first = std::make_unique<g2o::RegisterTypeProxy<CustomVertex>>("CUSTOM");
  auto second = std::make_unique<g2o::RegisterTypeProxy<CustomVertex>>("CUSTOM");
  first.reset();
  const std::unique_ptr<g2o::HyperGraph::HyperGraphElement> made(
      g2o::Factory::instance()->construct("CUSTOM"));
  EXPECT_NE(dynamic_cast<CustomVertex*>(made.get()), nullptr);
  second.reset();
  EXPECT_FALSE(g2o::Factory::instance()->knowsTag("CUSTOM"));
}

class CustomAlgorithm : public g2o::AbstractOptimizationAlgorithmCreator {
 public:
  CustomAlgorithm()
      : AbstractOptimizationAlgorithmCreator(
            g2o::OptimizationAlgorithmProperty("custom_algorithm", "", "", false, 3, 2)) {}
  g2o::OptimizationAlgorithm* construct() override { return nullptr; }
};

TEST(UnloadingACopy, KeepsTheAlgorithmOfTheOtherCopy) {
  const auto is_there = [] {
    int count = 0;
    for (const auto& creator : g2o::OptimizationAlgorithmFactory::instance()->creatorList())
      count += creator->property().name == "custom_algorithm";
    return count;
  };
  auto first = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new CustomAlgorithm);
  auto second = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new CustomAlgorithm);
  auto third = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new CustomAlgorithm);
  EXPECT_EQ(is_there(), 1);
  third.reset();
  EXPECT_EQ(is_there(), 1);
  first.reset();
  EXPECT_EQ(is_there(), 1);
  second.reset();
  EXPECT_EQ(is_there(), 0);
}

class CustomAction : public g2o::HyperGraphElementAction {
 public:
  CustomAction() : HyperGraphElementAction(typeid(g2o::VertexSE2).name()) { _name = "custom action"; }
  g2o::HyperGraphElementAction* operator()(g2o::HyperGraph::HyperGraphElement*, Parameters*) override {
    return this;
  }
};

TEST(UnloadingACopy, KeepsTheActionOfTheOtherCopy) {
  g2o::VertexSE2 v;
  const auto is_there = [&] {
    g2o::HyperGraphElementAction* custom =
        g2o::HyperGraphActionLibrary::instance()->actionByName("custom action");
    return custom != nullptr && (*custom)(&v, nullptr) != nullptr;
  };
  auto first = std::make_unique<g2o::RegisterActionProxy<CustomAction>>();
  auto second = std::make_unique<g2o::RegisterActionProxy<CustomAction>>();
  second.reset();
  EXPECT_TRUE(is_there());
  first.reset();
  EXPECT_FALSE(is_there());
}

TEST(Registration, IsWithdrawnByOneCallEvenIfItWasRepeated) {
  auto* factory = g2o::RobustKernelFactory::instance();
  using Creator = g2o::RobustKernelCreator<g2o::RobustKernelHuber>;
  const auto a = std::make_shared<Creator>(), b = std::make_shared<Creator>();
  for (const auto& creator : {a, a, b, a}) factory->registerRobustKernel("repeated", creator);
  factory->unregisterType("repeated", a);
  EXPECT_EQ(factory->creator("repeated"), b);
  factory->unregisterType("repeated", b);
  EXPECT_EQ(factory->creator("repeated"), nullptr);
  const auto custom = std::make_shared<CustomAlgorithm>();
  auto* algorithms = g2o::OptimizationAlgorithmFactory::instance();
  algorithms->registerSolver(custom);
  algorithms->registerSolver(custom);
  algorithms->unregisterSolver(custom);
  EXPECT_EQ(custom.use_count(), 1);
}

// A class of a client that has the same name as a class of the library.
class RobustKernelTukey : public g2o::RobustKernel {
 public:
  void robustify(double e2, g2o::Vector3& rho) const override { rho << e2, 1, 0; }
};
G2O_REGISTER_ROBUST_KERNEL(CustomTukey, RobustKernelTukey)

TEST(Registration, AcceptsAClientClassWithTheNameOfALibraryClass) {
  EXPECT_NE(g2o::RobustKernelFactory::instance()->creator("CustomTukey"), nullptr);
}

TEST(UnloadingACopy, KeepsTheKernelOfTheOtherCopy) {
  auto* factory = g2o::RobustKernelFactory::instance();
  { const g2o::RegisterRobustKernelProxy<g2o::RobustKernelHuber> copy("Huber"); }
  EXPECT_NE(factory->creator("Huber"), nullptr);
  factory->registerRobustKernel("none", nullptr);
  EXPECT_EQ(factory->creator("none"), nullptr);
}

}  // namespace
