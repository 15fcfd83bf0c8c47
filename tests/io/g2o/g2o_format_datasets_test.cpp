// SPDX-License-Identifier: BSD-3-Clause
// With the estimates of their files, public graphs have the chi2 that other implementations of the same error
// functions report.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "boxplus/io/field_reader.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

struct Dataset {
  const char* file;
  std::size_t vertices, edges;
  double chi2;
  double tolerance;  ///< relative; larger in 3-D, because the files contain rounded quaternions
};

void PrintTo(const Dataset& dataset, std::ostream* out) {
  *out << dataset.file;
}

class DatasetTest : public testing::TestWithParam<Dataset> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path())) GTEST_SKIP() << "SKIPPED: no " << path();
  }
  static std::string path() {
    const char* folder = std::getenv("BOXPLUS_DATA");
    return std::string(folder ? folder : ".") + "/" + GetParam().file;
  }
};

TEST_P(DatasetTest, HasTheKnownChi2) {
  const Dataset& expected = GetParam();
  const GraphFile file = read_graph(path());
  EXPECT_EQ(file.graph.vertex_count(), expected.vertices);
  EXPECT_EQ(file.graph.edge_count(), expected.edges);
  EXPECT_NEAR(file.graph.chi2() / expected.chi2, 1, expected.tolerance);
  EXPECT_THAT(file.notes, testing::IsEmpty());
}

TEST_P(DatasetTest, IsReadBackBitForBitAfterItIsWritten) {
  const GraphFile file = read_graph(path());
  const std::string text = format_graph(file);
  const GraphFile again = parse_graph(text, "again");
  EXPECT_EQ(again.graph.chi2(), file.graph.chi2());
  EXPECT_TRUE(format_graph(again) == text);
}

/// All numbers of the lines that define edges, in the order of the text.
std::vector<double> edge_numbers(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    FieldReader in("text", 0, line);
    if (in.at_end() || !in.token("a tag").starts_with("EDGE_")) continue;
    while (!in.at_end()) numbers.push_back(in.number("a number"));
  }
  return numbers;
}

TEST_P(DatasetTest, WritesMeasurementsWithTheSameNumbersAsInTheFile) {
  std::ostringstream text;
  text << std::ifstream(path()).rdbuf();
  const std::vector<double> printed = edge_numbers(text.str());
  if (printed.empty()) GTEST_SKIP() << "a file of another format";
  EXPECT_EQ(edge_numbers(format_graph(read_graph(path()))), printed);
}

// The published chi2 of 2-D graphs have 14 digits, so they are accurate to half a unit of the last digit at
// best.
INSTANTIATE_TEST_SUITE_P(
    Public, DatasetTest,
    testing::Values(Dataset{"posegraph2d/intel_1728.g2o", 1728, 2512, 551.73573084974, 1e-12},
                    Dataset{"posegraph2d/M3500.g2o", 3500, 5453, 2566667.6592069, 1e-12},
                    Dataset{"posegraph2d/city10000.g2o", 10000, 20687, 654162688.48789, 1e-12},
                    Dataset{"posegraph2d/csail.g2o", 1045, 1172, 1310652.5397044, 1e-12},
                    Dataset{"posegraph2d/MITb.g2o", 808, 827, 4414181662.5246, 1e-12},
                    Dataset{"posegraph2d/w10000.graph", 10000, 64311, 6880893.5596091, 1e-12},
                    Dataset{"posegraph3d/smallGrid3D.g2o", 125, 297, 115957.9967730, 1e-8},
                    Dataset{"posegraph3d/sphere2500.g2o", 2500, 4949, 2547810.8488056, 1e-8},
                    Dataset{"posegraph3d/parking-garage.g2o", 1661, 6275, 16720.018300997, 1e-8},
                    Dataset{"posegraph3d/torus3D.g2o", 5000, 9048, 2946826.5453766, 1e-8},
                    Dataset{"posegraph3d/sphere_bignoise_vertex3.g2o", 2200, 8647, 176631217.87069, 1e-8},
                    Dataset{"landmark2d/victoriaPark-full.g2o", 7120, 10608, 84128051.990956, 1e-12},
                    Dataset{"landmark2d/world-2000-full.g2o", 2070, 5812, 13797.8, 1e-5}),
    [](const auto& test) {
      std::string name = std::filesystem::path(test.param.file).stem().string();
      for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      }
      return name;
    });

}  // namespace
}  // namespace boxplus
