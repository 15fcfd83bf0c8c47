// SPDX-License-Identifier: BSD-3-Clause
// What is registered twice, as by two copies of a library, and taken back once.
#include <gtest/gtest.h>

#include <memory>

#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/side_by_side.h"
#include "g2o/types/slam2d/types_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_ROBUST_KERNEL(RobustKernelHuber)
G2O_USE_ROBUST_KERNEL(RobustKernelDCS)

namespace {

TEST(ACopyThatGoes, LeavesTheTypeOfTheOther) {
  {
    const g2o::RegisterTypeProxy<g2o::VertexSE2> copy("VERTEX_SE2");
    EXPECT_TRUE(g2o::Factory::instance()->knowsTag("VERTEX_SE2"));
  }
  EXPECT_TRUE(g2o::Factory::instance()->knowsTag("VERTEX_SE2"));
  const g2o::VertexSE2 v;
  EXPECT_EQ(g2o::Factory::instance()->tag(&v), "VERTEX_SE2");
}

class OwnVertex : public g2o::VertexSE2 {};

TEST(ACopyThatGoes, LeavesTheTypeToTheOneThatCameLater) {
  auto first = std::make_unique<g2o::RegisterTypeProxy<OwnVertex>>("OWN");
  auto second = std::make_unique<g2o::RegisterTypeProxy<OwnVertex>>("OWN");
  first.reset();
  const std::unique_ptr<g2o::HyperGraph::HyperGraphElement> made(g2o::Factory::instance()->construct("OWN"));
  EXPECT_NE(dynamic_cast<OwnVertex*>(made.get()), nullptr);
  second.reset();
  EXPECT_FALSE(g2o::Factory::instance()->knowsTag("OWN"));
}

class OwnAlgorithm : public g2o::AbstractOptimizationAlgorithmCreator {
 public:
  OwnAlgorithm()
      : AbstractOptimizationAlgorithmCreator(
            g2o::OptimizationAlgorithmProperty("own_algorithm", "", "", false, 3, 2)) {}
  g2o::OptimizationAlgorithm* construct() override { return nullptr; }
};

TEST(ACopyThatGoes, LeavesTheAlgorithmOfTheOther) {
  const auto is_there = [] {
    int count = 0;
    for (const auto& creator : g2o::OptimizationAlgorithmFactory::instance()->creatorList())
      count += creator->property().name == "own_algorithm";
    return count;
  };
  auto first = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new OwnAlgorithm);
  auto second = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new OwnAlgorithm);
  auto third = std::make_unique<g2o::RegisterOptimizationAlgorithmProxy>(new OwnAlgorithm);
  EXPECT_EQ(is_there(), 1);
  third.reset();
  EXPECT_EQ(is_there(), 1);
  first.reset();
  EXPECT_EQ(is_there(), 1);
  second.reset();
  EXPECT_EQ(is_there(), 0);
}

class OwnAction : public g2o::HyperGraphElementAction {
 public:
  OwnAction() : HyperGraphElementAction(typeid(g2o::VertexSE2).name()) { _name = "own action"; }
  g2o::HyperGraphElementAction* operator()(g2o::HyperGraph::HyperGraphElement*, Parameters*) override {
    return this;
  }
};

TEST(ACopyThatGoes, LeavesTheActionOfTheOther) {
  g2o::VertexSE2 v;
  const auto is_there = [&] {
    g2o::HyperGraphElementAction* own = g2o::HyperGraphActionLibrary::instance()->actionByName("own action");
    return own != nullptr && (*own)(&v, nullptr) != nullptr;
  };
  auto first = std::make_unique<g2o::RegisterActionProxy<OwnAction>>();
  auto second = std::make_unique<g2o::RegisterActionProxy<OwnAction>>();
  second.reset();
  EXPECT_TRUE(is_there());
  first.reset();
  EXPECT_FALSE(is_there());
}

TEST(ARegistration, ThatIsRepeatedIsTakenBackOnce) {
  auto* factory = g2o::RobustKernelFactory::instance();
  using Creator = g2o::RobustKernelCreator<g2o::RobustKernelHuber>;
  const auto a = std::make_shared<Creator>(), b = std::make_shared<Creator>();
  for (const auto& creator : {a, a, b, a}) factory->registerRobustKernel("repeated", creator);
  factory->unregisterType("repeated", a);
  EXPECT_EQ(factory->creator("repeated"), b);
  factory->unregisterType("repeated", b);
  EXPECT_EQ(factory->creator("repeated"), nullptr);
  const auto own = std::make_shared<OwnAlgorithm>();
  auto* algorithms = g2o::OptimizationAlgorithmFactory::instance();
  algorithms->registerSolver(own);
  algorithms->registerSolver(own);
  algorithms->unregisterSolver(own);
  EXPECT_EQ(own.use_count(), 1);
}

// A class of a client's that is called as one of ours.
class RobustKernelTukey : public g2o::RobustKernel {
 public:
  void robustify(double e2, g2o::Vector3& rho) const override { rho << e2, 1, 0; }
};
G2O_REGISTER_ROBUST_KERNEL(OwnTukey, RobustKernelTukey)

TEST(ARegistration, OfAClientsClassMayHaveTheNameOfOneOfOurs) {
  EXPECT_NE(g2o::RobustKernelFactory::instance()->creator("OwnTukey"), nullptr);
}

TEST(ACopyThatGoes, LeavesTheKernelOfTheOther) {
  auto* factory = g2o::RobustKernelFactory::instance();
  { const g2o::RegisterRobustKernelProxy<g2o::RobustKernelHuber> copy("Huber"); }
  EXPECT_NE(factory->creator("Huber"), nullptr);
  factory->registerRobustKernel("none", nullptr);
  EXPECT_EQ(factory->creator("none"), nullptr);
}

}  // namespace
