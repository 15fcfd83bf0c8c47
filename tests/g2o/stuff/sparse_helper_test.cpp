// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/sparse_helper.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(SparseHelper, WritesMatricesAndVectorsForOctave) {
  const std::string file = testing::TempDir() + "matrix.txt";
  const int p[] = {0, 1, 3}, i[] = {0, 0, 1};
  const double values[] = {4, 1, 0.1};
  ASSERT_TRUE(g2o::writeCCSMatrix(file, 2, 2, p, i, values));
  EXPECT_EQ(text_of(file),
            "# name: matrix\n# type: sparse matrix\n# nnz: 4\n# rows: 2\n# columns: 2\n"
            "1 1 4\n2 1 1\n1 2 1\n2 2 0.10000000000000001\n");
  ASSERT_TRUE(g2o::writeTripletEntries(file, 1, 3, {{0, 2, 5}, {0, 0, 6}}));
  EXPECT_EQ(text_of(file),
            "# name: matrix\n# type: sparse matrix\n# nnz: 2\n# rows: 1\n# columns: 3\n1 1 6\n1 3 5\n");
  ASSERT_TRUE(g2o::writeVector(file, values, 2));
  EXPECT_EQ(text_of(file), "4\n1\n");
  std::remove(file.c_str());
  EXPECT_FALSE(g2o::writeVector(testing::TempDir() + "no/such/folder", values, 2));
}

}  // namespace
