// SPDX-License-Identifier: BSD-3-Clause
// Conversions of a SparseBlockMatrix to other storage formats, and the computation of entries of the inverse
// of a matrix from its Cholesky factor.
#include "g2o/core/sparse_block_matrix.h"

#include <gmock/gmock.h>

#include <Eigen/SparseCholesky>
#include <cstdio>

#include "g2o/core/marginal_covariance_cholesky.h"

namespace {

using Matrix = g2o::SparseBlockMatrix<g2o::MatrixX>;

/// The end row of each block.
const std::vector<int> kEnds = {2, 3, 6};

/// A symmetric positive definite matrix with block sizes 2, 1 and 3. The blocks (0, 2) and (2, 0) do not
/// exist.
Matrix sample() {
  Matrix m(kEnds.data(), kEnds.data(), 3, 3);
  *m.block(0, 0, true) = Eigen::Matrix2d{{4, 1}, {1, 5}};
  *m.block(1, 1, true) << 6;
  *m.block(2, 2, true) = Eigen::Matrix3d{{7, 1, 0}, {1, 8, 2}, {0, 2, 9}};
  *m.block(0, 1, true) = Eigen::Vector2d(1, -1);
  *m.block(1, 2, true) = Eigen::RowVector3d(0.5, -1, 2);
  *m.block(1, 0, true) = m.block(0, 1)->transpose();
  *m.block(2, 1, true) = m.block(1, 2)->transpose();
  return m;
}

Eigen::MatrixXd dense(const Matrix& m) {
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(m.rows(), m.cols());
  for (int c = 0; c < 3; ++c)
    for (const auto& [r, b] : m.blockCols()[static_cast<size_t>(c)])
      d.block(m.rowBaseOfBlock(r), m.colBaseOfBlock(c), b->rows(), b->cols()) = *b;
  return d;
}

TEST(BlockMatrices, CompressedColumnsReferToTheBlocksOfTheirMatrix) {
  const Matrix m = sample();
  g2o::SparseBlockMatrixCCS<g2o::MatrixX> ccs(m.rowBlockIndices(), m.colBlockIndices());
  EXPECT_EQ(m.fillSparseBlockMatrixCCS(ccs), 7);
  EXPECT_EQ(ccs.blockCols()[1].size(), 3u);
  EXPECT_EQ(ccs.blockCols()[1][0].block, m.block(0, 1));
  std::vector<int> Cp(7), Ci(36), Cp2(7), Ci2(36);
  std::vector<double> Cx(36), Cx2(36), Cx3(36);
  for (const bool upper : {false, true}) {
    const int count = m.fillCCS(Cp.data(), Ci.data(), Cx.data(), upper);
    EXPECT_EQ(ccs.fillCCS(Cp2.data(), Ci2.data(), Cx2.data(), upper), count);
    EXPECT_EQ(ccs.fillCCS(Cx3.data(), upper), count);
    EXPECT_EQ(Cp, Cp2);
    EXPECT_EQ(Ci, Ci2);
    EXPECT_EQ(Cx, Cx2);
    EXPECT_EQ(Cx, Cx3);
  }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(6, 1, 2);
  double* y = nullptr;
  ccs.rightMultiply(y, x.data());
  EXPECT_LT((Eigen::Map<Eigen::VectorXd>(y, 6) - dense(m).transpose() * x).norm(), 1e-14);
  delete[] y;
}

TEST(BlockMatrices, TransposedCompressedColumnsReferToTheBlocksOfEachRow) {
  Matrix m = sample();
  delete m.block(1, 0);
  m.blockCols()[0].erase(1);
  g2o::SparseBlockMatrixCCS<g2o::MatrixX> ccs(m.rowBlockIndices(), m.colBlockIndices());
  m.fillSparseBlockMatrixCCSTransposed(ccs);
  EXPECT_EQ(ccs.blockCols()[1].size(), 2u) << "the block (1, 0) was deleted";
  EXPECT_EQ(ccs.blockCols()[0].size(), 2u);
  EXPECT_EQ(ccs.blockCols()[0][1].block, m.block(0, 1));
}

TEST(BlockMatrices, TransposedBlocksMayHaveAnotherType) {
  const int rows[] = {3}, columns[] = {2, 4};
  g2o::SparseBlockMatrix<Eigen::Matrix<double, 3, 2>> m(rows, columns, 1, 2);
  *m.block(0, 1, true) << 1, 2, 3, 4, 5, 6;
  const std::unique_ptr<g2o::SparseBlockMatrix<Eigen::Matrix<double, 2, 3>>> transposed =
      m.transposed<Eigen::Matrix<double, 2, 3>>();
  ASSERT_NE(transposed->block(1, 0), nullptr);
  EXPECT_EQ(*transposed->block(1, 0), m.block(0, 1)->transpose());
}

TEST(BlockMatrices, SortColumnsSortsTheBlocksOfEachColumnByRow) {
  const Matrix m = sample();
  g2o::SparseBlockMatrixCCS<g2o::MatrixX> ccs(m.rowBlockIndices(), m.colBlockIndices());
  m.fillSparseBlockMatrixCCS(ccs);
  std::swap(ccs.blockCols()[1][0], ccs.blockCols()[1][2]);
  ccs.sortColumns();
  for (int r = 0; r < 3; ++r) EXPECT_EQ(ccs.blockCols()[1][static_cast<size_t>(r)].row, r);
}

TEST(BlockMatrices, ABlockDiagonalMatrixMultipliesAVector) {
  const Matrix m = sample();
  g2o::SparseBlockMatrixDiagonal<g2o::MatrixX> diagonal(m.rowBlockIndices());
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(6, 6);
  for (int i = 0; i < 3; ++i) {
    diagonal.diagonal().push_back(*m.block(i, i));
    const int base = diagonal.baseOfBlock(i), dim = diagonal.dimOfBlock(i);
    expected.block(base, base, dim, dim) = *m.block(i, i);
  }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(6, 1, 2);
  double* y = nullptr;
  diagonal.multiply(y, x.data());
  EXPECT_LT((Eigen::Map<Eigen::VectorXd>(y, 6) - expected * x).norm(), 1e-14);
  delete[] y;
}

TEST(BlockMatrices, AMatrixTakesItsBlocksFromAHashMap) {
  Matrix m = sample();
  g2o::SparseBlockMatrixHashMap<g2o::MatrixX> hashed(m.rowBlockIndices(), m.colBlockIndices());
  g2o::MatrixX* block = hashed.addBlock(2, 0, true);
  EXPECT_EQ(hashed.addBlock(2, 0), block);
  EXPECT_EQ(block->rows(), 3);
  hashed.addBlock(0, 0, true);
  m.takePatternFromHash(hashed);
  EXPECT_EQ(m.nonZeroBlocks(), 2u);
  EXPECT_EQ(m.block(2, 0), block);
  EXPECT_EQ(hashed.blockCols()[0].size(), 0u);
}

class MarginalCovariances : public testing::Test {
 protected:
  using Sparse = Eigen::SparseMatrix<double>;
  void SetUp() override {
    const Eigen::MatrixXd A = dense(matrix);
    expected = A.inverse();
    factor.compute(A.sparseView());
    L = factor.matrixL();
    L.makeCompressed();
    place = factor.permutationP().indices();
    marginals.setCholeskyFactor(6, L.outerIndexPtr(), L.innerIndexPtr(), L.valuePtr(), place.data());
  }
  Matrix matrix = sample();
  Eigen::MatrixXd expected;
  Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> factor;
  Sparse L;
  Eigen::VectorXi place;
  g2o::MarginalCovarianceCholesky marginals;
};

TEST_F(MarginalCovariances, DiagonalBlocksEqualTheDiagonalBlocksOfTheInverse) {
  std::vector<std::vector<double>> memory = {std::vector<double>(4), std::vector<double>(1),
                                             std::vector<double>(9)};
  std::vector<double*> blocks = {memory[0].data(), memory[1].data(), memory[2].data()};
  marginals.computeCovariance(blocks.data(), kEnds);
  for (int i = 0; i < 3; ++i) {
    const int base = matrix.rowBaseOfBlock(i), dim = matrix.rowsOfBlock(i);
    const Eigen::Map<Eigen::MatrixXd> block(blocks[static_cast<size_t>(i)], dim, dim);
    EXPECT_LT((block - expected.block(base, base, dim, dim)).norm(), 1e-14);
  }
}

TEST_F(MarginalCovariances, EachRequestedBlockEqualsTheSameBlockOfTheInverse) {
  Matrix spinv;
  const std::vector<std::pair<int, int>> wanted = {{0, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 2}};
  marginals.computeCovariance(spinv, kEnds, wanted);
  EXPECT_EQ(spinv.nonZeroBlocks(), wanted.size());
  for (const auto& [i, j] : wanted) {
    const auto& block = *spinv.block(i, j);
    EXPECT_LT(
        (block - expected.block(spinv.rowBaseOfBlock(i), spinv.colBaseOfBlock(j), block.rows(), block.cols()))
            .norm(),
        1e-14);
  }
}

TEST(SparseBlockMatrix, BringsTheFunctionsThatWriteVectorsAndMatrices) {
  const std::string file = testing::TempDir() + "block_matrix_vector.txt";
  const double values[] = {1, 2};
  EXPECT_TRUE(g2o::writeVector(file, values, 2));
  std::remove(file.c_str());
}

}  // namespace
