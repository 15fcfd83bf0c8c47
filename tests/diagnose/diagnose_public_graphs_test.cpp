// SPDX-License-Identifier: BSD-3-Clause
// The public graphs are healthy: before and after a run, their diagnosis contains only notes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "boxplus/diagnose/diagnose.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

class DiagnosePublicGraph : public testing::TestWithParam<const char*> {};

TEST_P(DiagnosePublicGraph, GivesOnlyNotesBeforeAndAfterARun) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::filesystem::path path = std::filesystem::path(folder ? folder : "") / GetParam();
  if (!folder || !std::filesystem::exists(path)) GTEST_SKIP() << path << " does not exist";
  GraphFile file = read_graph(path.string());
  const Diagnosis before = diagnose(file.graph);
  EXPECT_TRUE(before.ok()) << before;
  EXPECT_FALSE(before.at_minimum);
  EXPECT_TRUE(optimize(file.graph, {.start = Start::kAutomatic}).converged());
  const Diagnosis after = diagnose(file.graph);
  EXPECT_TRUE(after.ok()) << after;
  EXPECT_TRUE(after.at_minimum);
}

std::string name_of(const testing::TestParamInfo<const char*>& info) {
  std::string name = std::filesystem::path(info.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Data, DiagnosePublicGraph,
                         testing::Values("posegraph2d/intel_1728.g2o", "posegraph2d/M3500.g2o",
                                         "posegraph2d/city10000.g2o", "posegraph2d/csail.g2o",
                                         "posegraph2d/MITb.g2o", "posegraph2d/w10000.graph",
                                         "posegraph3d/smallGrid3D.g2o", "posegraph3d/sphere2500.g2o",
                                         "posegraph3d/parking-garage.g2o", "posegraph3d/torus3D.g2o",
                                         "posegraph3d/sphere_bignoise_vertex3.g2o",
                                         "landmark2d/victoriaPark-full.g2o", "landmark2d/world-2000-full.g2o",
                                         "bal/problem-16-22106-pre.txt", "bal/problem-21-11315-pre.txt",
                                         "bal/problem-49-7776-pre.txt"),
                         name_of);

}  // namespace
}  // namespace boxplus
