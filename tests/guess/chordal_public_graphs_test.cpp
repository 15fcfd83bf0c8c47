// SPDX-License-Identifier: BSD-3-Clause
// From the chordal guess, undamped Gauss-Newton reaches the best known minimum of every public graph.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/linear/make_linear_solver.h"
#include "guess/initial_guess.h"
#include "linearize/linearizer.h"

namespace boxplus {
namespace {

struct PublicGraph {
  const char* file;
  double guess;  ///< an upper bound of chi2 after the guess
  double best;   ///< the best known chi2; Gauss-Newton must reach it up to 1e-6 (relative)
};

void PrintTo(const PublicGraph& graph, std::ostream* out) {
  *out << graph.file;
}

/// The chi2 after `iterations` full Gauss-Newton steps.
double gauss_newton(Graph& graph, const Plan& plan, int iterations) {
  Linearizer linearizer(graph, plan);
  const auto solver = make_linear_solver(LinearSolverKind::kBlockCholesky);
  solver->analyze(plan.structure, {});
  std::vector<double> step(plan.scalars());
  for (int k = 0; k < iterations; ++k) {
    linearizer.linearize({});
    const AssembledSystem system(plan.structure, linearizer.values());
    EXPECT_EQ(solver->factorize(system, Damping{}).status, LinearStatus::kOk);
    solver->solve(linearizer.gradient().data(), 1, step.data());
    for (double& entry : step) entry = -entry;
    for (const VertexList& list : plan.vertices) {
      graph.vertex_pools()[list.pool]->oplus(list.slots, list.offsets, step.data());
    }
  }
  return linearizer.chi2();
}

class ChordalGuessOfPublicGraphs : public ::testing::TestWithParam<PublicGraph> {};

TEST_P(ChordalGuessOfPublicGraphs, LeadsGaussNewtonToTheBestKnownMinimum) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::filesystem::path path = std::filesystem::path(folder ? folder : "") / GetParam().file;
  if (!folder || !std::filesystem::exists(path)) GTEST_SKIP() << path << " does not exist";
  GraphFile file = read_graph(path.string());
  const Plan plan = make_plan(file.graph, {});
  ASSERT_TRUE(guess_chordal(file.graph, plan).made);
  EXPECT_LT(file.graph.chi2(), GetParam().guess);
  const double chi2 = gauss_newton(file.graph, plan, 9);
  EXPECT_LT(chi2, GetParam().best * (1 + 1e-6));
}

INSTANTIATE_TEST_SUITE_P(All, ChordalGuessOfPublicGraphs,
                         ::testing::Values(PublicGraph{"posegraph2d/intel_1728.g2o", 50, 45.0046958},
                                           PublicGraph{"posegraph2d/M3500.g2o", 830, 137.912951},
                                           PublicGraph{"posegraph2d/csail.g2o", 350, 38.9562859},
                                           PublicGraph{"posegraph2d/MITb.g2o", 89, 41.1632688},
                                           PublicGraph{"posegraph2d/city10000.g2o", 630, 511.985164},
                                           PublicGraph{"posegraph2d/w10000.graph", 281000, 171545.447},
                                           PublicGraph{"posegraph3d/smallGrid3D.g2o", 1200, 458.153785},
                                           PublicGraph{"posegraph3d/sphere2500.g2o", 1770, 727.149412},
                                           PublicGraph{"posegraph3d/parking-garage.g2o", 6.2, 1.23868351},
                                           PublicGraph{"posegraph3d/torus3D.g2o", 16700, 14574.7464},
                                           PublicGraph{"posegraph3d/sphere_bignoise_vertex3.g2o", 831000,
                                                       743862.712},
                                           PublicGraph{"landmark2d/victoriaPark-full.g2o", 780, 389.787423},
                                           PublicGraph{"landmark2d/world-2000-full.g2o", 9500, 7657.552126}),
                         [](const auto& test) {
                           std::string name = std::filesystem::path(test.param.file).stem().string();
                           for (char& c : name) {
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace boxplus
