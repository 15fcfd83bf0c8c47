// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/linear_engine.h"

#include <algorithm>

#include "engine/engine_solver.h"
#include "linear/inverse_blocks.h"

namespace g2o {
namespace internal {

struct LinearEngine::State {
  EngineSettings settings;
  boxplus::BlockStructure structure;
  std::vector<double> values;
  std::unique_ptr<boxplus::AssembledSystem>
      system;                                     // refers to `values`; iterative solvers read it in solve()
  std::unique_ptr<boxplus::LinearSolver> solver;  // nullptr, or a solver that is analyzed for the structure
  int iterations = 0;
};

LinearEngine::LinearEngine(const EngineSettings& settings) : state_(std::make_unique<State>()) {
  state_->settings = settings;
}

LinearEngine::~LinearEngine() = default;

void LinearEngine::reset() {
  state_->solver.reset();
}

void LinearEngine::setSettings(const EngineSettings& settings) {
  if (settings.solver == EngineSolver::kNone) return;
  if (settings.solver != state_->settings.solver || settings.exact != state_->settings.exact) reset();
  state_->settings = settings;
}

bool LinearEngine::factorize(const std::vector<int>& dims, const std::vector<EngineBlock>& blocks) {
  State& s = *state_;
  std::vector<boxplus::BlockCoordinate> pairs;
  for (const EngineBlock& block : blocks) {
    if (block.row == block.column) continue;
    pairs.push_back({static_cast<std::uint32_t>(block.row), static_cast<std::uint32_t>(block.column)});
  }
  const std::vector<std::uint32_t> sizes(dims.begin(), dims.end());
  boxplus::BlockStructure made = boxplus::make_block_structure(sizes, pairs);
  if (!(made == s.structure)) s.solver.reset();
  if (!s.solver) {
    s.structure = std::move(made);
    s.solver = make_engine_solver(s.settings, solver_options(s.settings));
    s.solver->analyze(s.structure, analyze_hints());
  }
  s.values.assign(s.structure.nonzero_values(), 0.0);
  for (const EngineBlock& block : blocks) {
    const std::uint32_t k =
        s.structure.find(static_cast<std::uint32_t>(block.row), static_cast<std::uint32_t>(block.column));
    std::copy_n(block.values, s.structure.value_start[k + 1] - s.structure.value_start[k],
                s.values.begin() + s.structure.value_start[k]);
  }
  s.system = std::make_unique<boxplus::AssembledSystem>(s.structure, s.values);
  return s.solver->factorize(*s.system, {}).status == boxplus::LinearStatus::kOk;
}

bool LinearEngine::solve(const double* b, double* x) {
  const boxplus::SolveControl control = solve_control(state_->settings, b, state_->structure.scalars());
  const boxplus::SolveResult result = state_->solver->solve(b, 1, x, control);
  state_->iterations = result.iterations;
  return result.status == boxplus::LinearStatus::kOk || result.status == boxplus::LinearStatus::kNotConverged;
}

bool LinearEngine::inverse(const std::vector<std::pair<int, int>>& blocks,
                           const std::function<void(size_t, const MatrixX&)>& take) {
  const State& s = *state_;
  std::vector<boxplus::BlockCoordinate> wanted;
  for (const auto& [row, column] : blocks)
    wanted.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)});
  boxplus::InverseBlocks inverse(s.structure, wanted);
  if (!inverse.compute(*s.solver)) return false;
  for (size_t k = 0; k < wanted.size(); ++k) take(k, inverse.block(k));
  return true;
}

bool LinearEngine::save(const std::string& fileName) const {
  const State& s = *state_;
  if (!s.system) return false;
  std::vector<int> ends(s.structure.offset.begin() + 1, s.structure.offset.end());
  const auto n = static_cast<int>(ends.size());
  SparseBlockMatrix<MatrixX> A(ends.data(), ends.data(), n, n);
  for (std::uint32_t c = 0; c < s.structure.blocks(); ++c) {
    for (std::uint32_t k = s.structure.column_start[c]; k < s.structure.column_start[c + 1]; ++k) {
      const std::uint32_t r = s.structure.row[k];
      const Eigen::Map<const MatrixX> block(s.values.data() + s.structure.value_start[k], s.structure.dim(r),
                                            s.structure.dim(c));
      *A.block(static_cast<int>(c), static_cast<int>(r), true) = block.transpose();
    }
  }
  return A.writeOctave(fileName.c_str(), true);
}

int LinearEngine::iterations() const {
  return state_->iterations;
}

bool fillInverse(LinearEngine& engine, const std::vector<int>& dims,
                 const std::vector<std::pair<int, int>>& blockIndices, SparseBlockMatrix<MatrixX>& spinv) {
  const auto n = static_cast<int>(dims.size());
  std::vector<int> ends;
  int end = 0;
  for (int dim : dims) ends.push_back(end += dim);
  for (const auto& [i, j] : blockIndices) {
    if (i < 0 || j < 0 || i >= n || j >= n) return false;
  }
  spinv = SparseBlockMatrix<MatrixX>(ends.data(), ends.data(), n, n);
  return engine.inverse(blockIndices, [&](size_t k, const MatrixX& block) {
    *spinv.block(blockIndices[k].first, blockIndices[k].second, true) = block;
  });
}

}  // namespace internal
}  // namespace g2o
