// SPDX-License-Identifier: BSD-3-Clause
#include "linear/incremental/incremental_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <random>

namespace boxplus {
namespace {

using Index = IncrementalFactor::Index;

/// A factor, and the same matrix as a list of dense terms.
class Reference {
 public:
  explicit Reference(unsigned seed) : random_(seed) {}

  std::size_t pick(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  void add_block() {
    const std::vector<double> noticeable(1 + pick(3), 0.0);
    const Index block = factor.add_block(noticeable);
    blocks_.push_back(block);
    add_term({block});  // makes the matrix positive definite
  }

  /// A term on the newest block and up to two others.
  void add_random_term() {
    std::vector<Index> members{blocks_.back()};
    for (std::size_t k = 1 + pick(2); k-- > 0;) {
      const Index other = blocks_[pick(blocks_.size())];
      if (std::find(members.begin(), members.end(), other) == members.end()) members.push_back(other);
    }
    std::shuffle(members.begin(), members.end(), random_);
    add_term(members);
  }

  void remove_random_term() {
    const auto term = std::next(terms_.begin(), static_cast<std::ptrdiff_t>(pick(terms_.size())));
    if (factor.blocks_of(term->first).size() == 1) return;
    factor.remove_term(term->first);
    terms_.erase(term);
  }

  void change_random_term() {
    fill(std::next(terms_.begin(), static_cast<std::ptrdiff_t>(pick(terms_.size())))->first);
  }

  void remove_random_block() {
    if (blocks_.size() < 3) return;
    const std::size_t at = pick(blocks_.size());
    const Index block = blocks_[at];
    while (!factor.terms_of(block).empty()) {
      terms_.erase(factor.terms_of(block).front());
      factor.remove_term(factor.terms_of(block).front());
    }
    factor.remove_block(block);
    blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  void expect_solved() {
    FactorWork work;
    ASSERT_EQ(factor.factorize({}, work).status, LinearStatus::kOk);
    std::vector<Index> solved;
    factor.solve(solved);
    std::map<Index, Eigen::Index> offset;
    Eigen::Index size = 0;
    for (const Index block : blocks_) {
      offset[block] = size;
      size += factor.dim(block);
    }
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    for (const auto& [term, values] : terms_) {
      const auto members = factor.blocks_of(term);
      Eigen::Index row = 0;
      for (const Index a : members) {
        const Eigen::Index rows = factor.dim(a);
        g.segment(offset[a], rows) += values.g.segment(row, rows);
        Eigen::Index column = 0;
        for (const Index b : members) {
          const Eigen::Index columns = factor.dim(b);
          H.block(offset[a], offset[b], rows, columns) += values.H.block(row, column, rows, columns);
          column += columns;
        }
        row += rows;
      }
    }
    const Eigen::VectorXd x = H.ldlt().solve(-g);
    for (const Index block : blocks_) {
      for (std::size_t i = 0; i < factor.dim(block); ++i) {
        ASSERT_NEAR(factor.x(block)[i], x[offset[block] + static_cast<Eigen::Index>(i)], 1e-8);
      }
    }
  }

  IncrementalFactor factor;

 private:
  struct Values {
    Eigen::MatrixXd H;
    Eigen::VectorXd g;
  };

  void add_term(const std::vector<Index>& members) { fill(factor.add_term(members)); }

  void fill(Index term) {
    factor.clear_term(term);
    const auto members = factor.blocks_of(term);
    Eigen::Index size = 0;
    for (const Index block : members) size += factor.dim(block);
    const auto numbers = [&](Eigen::Index rows, Eigen::Index columns) {
      return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                          [&] { return std::normal_distribution<>()(random_); });
    };
    const Eigen::MatrixXd J = numbers(size, size);
    Values& values = terms_[term];
    values.H = J.transpose() * J + 0.1 * Eigen::MatrixXd::Identity(size, size);
    values.g = numbers(size, 1);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Eigen::Index rows = factor.dim(members[i]);
      Eigen::Map<Eigen::VectorXd>(factor.values() + factor.gradient_of(term, i), rows) =
          values.g.segment(row, rows);
      Eigen::Index column = 0;
      for (std::size_t j = 0; j <= i; ++j) {
        const Eigen::Index columns = factor.dim(members[j]);
        Eigen::Map<Eigen::MatrixXd>(factor.values() + factor.block_of(term, i, j), rows, columns) =
            values.H.block(row, column, rows, columns);
        column += columns;
      }
      row += rows;
    }
  }

  std::mt19937 random_;
  std::vector<Index> blocks_;
  std::map<Index, Values> terms_;
};

TEST(IncrementalFactor, SolvesTheSystemAfterEachOfManyRandomChanges) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Reference reference(seed);
    for (int step = 0; step < 150; ++step) {
      reference.add_block();
      reference.add_random_term();
      for (std::size_t changes = reference.pick(4); changes-- > 0;) {
        switch (reference.pick(5)) {
          case 0:
            reference.remove_random_term();
            break;
          case 1:
            reference.remove_random_block();
            break;
          case 2:
            reference.change_random_term();
            break;
          default:
            reference.add_random_term();
        }
      }
      ASSERT_NO_FATAL_FAILURE(reference.expect_solved()) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(IncrementalFactor, ComputesOnlyWhatAChangeReaches) {
  Reference chain(1);
  for (int k = 0; k < 400; ++k) {
    chain.add_block();
    if (k > 0) chain.add_random_term();
  }
  FactorWork all, one;
  ASSERT_EQ(chain.factor.factorize({}, all).status, LinearStatus::kOk);
  chain.add_block();
  ASSERT_EQ(chain.factor.factorize({}, one).status, LinearStatus::kOk);
  EXPECT_EQ(all.ordered_blocks, 400u);
  EXPECT_EQ(one.ordered_blocks, 1u);
  EXPECT_EQ(one.factorized_fronts, 1u);
}

TEST(IncrementalFactor, NamesTheBlockWhosePivotIsLostAndGoesOnAfterwards) {
  IncrementalFactor factor;
  const std::vector<double> noticeable(2, 0.0);
  const Index a = factor.add_block(noticeable), b = factor.add_block(noticeable);
  for (const Index block : {a, b}) {
    const Index term = factor.add_term(std::vector<Index>{block});
    double* const values = factor.values() + factor.block_of(term, 0, 0);
    values[0] = 2;
    values[3] = block == a ? 2 : 0;
  }
  FactorWork work;
  const auto result = factor.factorize({}, work);
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(result.lost_block, b);
  const Index term = factor.add_term(std::vector<Index>{b});
  factor.values()[factor.block_of(term, 0, 0) + 3] = 4;
  factor.values()[factor.gradient_of(term, 0) + 1] = 8;
  ASSERT_EQ(factor.factorize({}, work).status, LinearStatus::kOk);
  std::vector<Index> solved;
  factor.solve(solved);
  EXPECT_DOUBLE_EQ(factor.x(b)[1], -2);
}

TEST(IncrementalFactor, DoesNotPassOnChangesThatAreNotNoticeable) {
  IncrementalFactor factor;
  const std::vector<double> noticeable(1, 0.01);
  std::vector<Index> chain;
  for (int k = 0; k < 200; ++k) {
    chain.push_back(factor.add_block(noticeable));
    const Index own = factor.add_term(std::vector<Index>{chain.back()});
    factor.values()[factor.block_of(own, 0, 0)] = 1;
    if (k == 0) continue;
    const Index link = factor.add_term(std::vector<Index>{chain[chain.size() - 2], chain.back()});
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j <= i; ++j) factor.values()[factor.block_of(link, i, j)] = i == j ? 1 : -1;
    }
  }
  FactorWork work;
  std::vector<Index> solved;
  ASSERT_EQ(factor.factorize({}, work).status, LinearStatus::kOk);
  factor.solve(solved);
  EXPECT_EQ(solved.size(), chain.size());
  const Index pull = factor.add_term(std::vector<Index>{chain.back()});
  factor.values()[factor.gradient_of(pull, 0)] = 1;
  solved.clear();
  ASSERT_EQ(factor.factorize({}, work).status, LinearStatus::kOk);
  factor.solve(solved);
  EXPECT_LT(solved.size(), chain.size() / 2);
  const double pulled = factor.x(chain.back())[0];
  solved.clear();
  factor.solve_all(solved);
  EXPECT_EQ(solved.size(), chain.size());
  EXPECT_NEAR(factor.x(chain.back())[0], pulled, 1e-3);
}

}  // namespace
}  // namespace boxplus
