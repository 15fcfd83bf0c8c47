// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "boxplus/certify/certificate.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

std::string data_path(const std::string& name) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  return std::string(folder == nullptr ? "" : folder) + "/" + name;
}

/// "posegraph3d/parking-garage.g2o" becomes "parking_garage".
std::string name_of(const testing::TestParamInfo<const char*>& test) {
  std::string name = std::filesystem::path(test.param).stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class CertifyPublicGraph : public testing::TestWithParam<const char*> {};

TEST_P(CertifyPublicGraph, ProvesTheGlobalMinimum) {
  const std::string path = data_path(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << GetParam() << " is not in BOXPLUS_DATA";
  Graph graph = read_graph(path).graph;
  Options options;
  options.start = Start::kAutomatic;
  ASSERT_TRUE(optimize(graph, options).converged());
  const double chi2 = graph.chi2();
  const Certificate certificate = certify(graph);
  EXPECT_EQ(certificate.verdict, Certificate::Verdict::kGlobalMinimum) << certificate;
  EXPECT_LE(certificate.relative_gap(), 1e-6);
  EXPECT_LE(certificate.chi2_bound(), certificate.chi2);
  EXPECT_NEAR(certificate.chi2, chi2, 1e-5 * chi2);  // quaternions in the file are rounded
  EXPECT_EQ(certificate.escapes, 0);
  EXPECT_EQ(graph.chi2(), chi2);
}

INSTANTIATE_TEST_SUITE_P(Files, CertifyPublicGraph,
                         testing::Values("posegraph2d/intel_1728.g2o", "posegraph2d/M3500.g2o",
                                         "posegraph2d/csail.g2o", "posegraph3d/sphere2500.g2o",
                                         "posegraph3d/parking-garage.g2o", "posegraph3d/torus3D.g2o",
                                         "posegraph3d/smallGrid3D.g2o"),
                         name_of);

TEST(CertifyLocalMinimum, FindsTheOptimumOfManhattanFromALocalMinimum) {
  const std::string path = data_path("posegraph2d/M3500.g2o");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "M3500.g2o is not in BOXPLUS_DATA";
  Graph graph = read_graph(path).graph;
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (const VertexRef& vertex : graph.all_vertices()) {
    const auto pose = graph.typed<SE2>(vertex);
    graph.set_estimate(pose, SE2(100 * uniform(), 100 * uniform(), 6 * uniform()));
  }
  ASSERT_TRUE(optimize(graph).converged());
  const double local = graph.chi2();
  const Certificate certificate = certify(graph);
  EXPECT_EQ(certificate.verdict, Certificate::Verdict::kLocalMinimum) << certificate;
  EXPECT_GT(local, 1.1 * certificate.better_chi2);
  EXPECT_NEAR(certificate.better_chi2, 137.913, 1e-3);
  EXPECT_EQ(certify(graph).verdict, Certificate::Verdict::kGlobalMinimum);
}

}  // namespace
}  // namespace boxplus
