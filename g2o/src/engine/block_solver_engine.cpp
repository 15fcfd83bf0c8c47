// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/block_solver_engine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <span>
#include <string>
#include <utility>

#include "boxplus/base/parallel.h"
#include "core/prefetch.h"
#include "engine/client_solver.h"
#include "engine/edge_parts.h"
#include "engine/engine_solver.h"
#include "engine/measured_solver.h"
#include "g2o/core/batch_stats.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/timeutil.h"
#include "linear/inverse_blocks.h"

namespace g2o {
namespace internal {

using boxplus::BlockStructure;
using boxplus::LinearStatus;

struct BlockSolverEngine::State {
  std::vector<OptimizableGraph::Vertex*> vertices;  // by Hessian index; dangling if `revision` is not current
  std::vector<int> ids;                             // the ids of `vertices`
  std::uint64_t revision = 0;                       // the optimizer's revision for which H was laid out
  std::uint32_t kept = 0, eliminated = 0;           // numbers of blocks
  BlockStructure structure;                         // the structure of H; the eliminated blocks come first
  std::shared_ptr<std::vector<double>> memory = std::make_shared<std::vector<double>>();  // the values of H
  std::unique_ptr<boxplus::BlockSystem> full;
  std::shared_ptr<boxplus::LinearSolver> solver;  // eliminates blocks, then calls `measured`
  std::shared_ptr<MeasuredSolver> measured;       // solves for the kept blocks
  ClientSolver* client = nullptr;                 // the client's solver inside `measured`, or nullptr
  EngineSettings settings;
  std::vector<double> engine_b, engine_x;
  std::vector<double> gradient;  // JᵀΩe of the edges in batches, by Hessian index, and the sums of parts
  std::uint64_t stamp = 0;       // of this layout of H, for EdgeBatches
  bool ready = false;            // true if the solvers are analyzed for the structure
  bool filled = false;           // true if H contains a linearization
  bool complained = false;       // true if complain() has reported an error since buildStructure()

  std::vector<double>& values() const { return *memory; }
  std::uint32_t block_of(int hessian_index) const {
    const auto h = static_cast<std::uint32_t>(hessian_index);
    return h < kept ? eliminated + h : h - kept;
  }
  std::vector<int> block_ends() const {  // by Hessian index
    std::vector<int> ends;
    int end = 0;
    for (int h = 0; h < static_cast<int>(ids.size()); ++h)
      ends.push_back(end += static_cast<int>(structure.dim(block_of(h))));
    return ends;
  }
  std::uint32_t eliminated_scalars() const { return structure.offset[eliminated]; }

  /// to_engine() converts a vector from the order of Hessian indices to the order of the engine, and
  /// from_engine() converts it back. In the order of Hessian indices, the kept blocks come first. In the
  /// order of the engine, the eliminated blocks come first.
  void to_engine(const double* in, double* out) const {
    const std::uint32_t first = structure.scalars() - eliminated_scalars();
    std::copy_n(in, first, out + eliminated_scalars());
    std::copy_n(in + first, eliminated_scalars(), out);
  }
  void from_engine(const double* in, double* out) const {
    const std::uint32_t first = structure.scalars() - eliminated_scalars();
    std::copy_n(in + eliminated_scalars(), first, out);
    std::copy_n(in, eliminated_scalars(), out + first);
  }

  bool lay_out(SparseOptimizer& optimizer, bool use_schur);
  void allocate(std::size_t extra_values);
  bool can_linearize(EdgeBatches& batches);
  void linearize(SparseOptimizer& optimizer);
  void map_vertices(const SparseOptimizer& optimizer);
  void map_edges(const SparseOptimizer& optimizer);
  void map_pair(OptimizableGraph::Edge& edge, int i, int j);
  void make_solver(const EngineSettings& new_settings);
  bool factorize(double lambda);
  class Places;
  double largest_diagonal() const;
  bool complain(LinearStatus status, std::uint32_t failed_block, double lambda);
  std::string reason(LinearStatus status, std::uint32_t failed_block) const;
};

BlockSolverEngine::BlockSolverEngine() = default;
BlockSolverEngine::~BlockSolverEngine() = default;

namespace {

const OptimizableGraph::Vertex* vertex_at(const OptimizableGraph::Edge& edge, size_t i) {
  return static_cast<const OptimizableGraph::Vertex*>(edge.vertex(i));
}

}  // namespace

/// Numbers the blocks and finds the pattern of H. Returns false if an edge connects two eliminated vertices.
bool BlockSolverEngine::State::lay_out(SparseOptimizer& optimizer, bool use_schur) {
  vertices = optimizer.indexMapping();
  ids.clear();
  for (const OptimizableGraph::Vertex* v : vertices) ids.push_back(v->id());
  const auto marginalized =
      std::count_if(vertices.begin(), vertices.end(), [](const auto* v) { return v->marginalized(); });
  const bool eliminate = use_schur && marginalized > 0 && static_cast<size_t>(marginalized) < vertices.size();
  const std::uint32_t eliminated_before = eliminated;
  eliminated = eliminate ? static_cast<std::uint32_t>(marginalized) : 0;
  kept = static_cast<std::uint32_t>(vertices.size()) - eliminated;
  std::vector<std::uint32_t> dims(vertices.size());
  for (size_t h = 0; h < vertices.size(); ++h)
    dims[block_of(static_cast<int>(h))] = static_cast<std::uint32_t>(vertices[h]->dimension());
  std::vector<boxplus::BlockCoordinate> pairs;
  for (const OptimizableGraph::Edge* edge : optimizer.activeEdges()) {
    for (size_t j = 1; j < edge->vertices().size(); ++j) {
      if (vertex_at(*edge, j)->hessianIndex() < 0) continue;
      const std::uint32_t b = block_of(vertex_at(*edge, j)->hessianIndex());
      for (size_t i = 0; i < j; ++i) {
        if (vertex_at(*edge, i)->hessianIndex() < 0) continue;
        const std::uint32_t a = block_of(vertex_at(*edge, i)->hessianIndex());
        if (a < eliminated && b < eliminated) {
          G2O_ERROR("vertices {} and {} are both marginalized, but an edge joins them", edge->vertex(i)->id(),
                    edge->vertex(j)->id());
          return false;
        }
        pairs.push_back({std::max(a, b), std::min(a, b)});
      }
    }
  }
  BlockStructure made = boxplus::make_block_structure(dims, pairs);
  static std::atomic<std::uint64_t> last_stamp = 0;
  stamp = ++last_stamp;
  const std::size_t extra_values = optimizer.edgeParts().batches().extra_values();
  if (full && made == structure && eliminated == eliminated_before) {
    if (values().size() != structure.nonzero_values() + extra_values) allocate(extra_values);
    return true;
  }
  structure = std::move(made);
  allocate(extra_values);
  ready = false;
  engine_b.resize(structure.scalars());
  engine_x.resize(structure.scalars());
  return true;
}

/// Allocates H, and behind it, memory for `extra_values` values.
void BlockSolverEngine::State::allocate(std::size_t extra_values) {
  memory = std::make_shared<std::vector<double>>(structure.nonzero_values() + extra_values, 0.0);
  full = std::make_unique<boxplus::AssembledSystem>(
      structure, std::span<const double>(values().data(), structure.nonzero_values()));
}

/// Maps the vertices to the diagonal blocks of H. Vertices without a Hessian index get no memory.
void BlockSolverEngine::State::map_vertices(const SparseOptimizer& optimizer) {
  for (OptimizableGraph::Vertex* v : optimizer.activeVertices()) {
    if (v->hessianIndex() < 0) v->mapHessianMemory(nullptr);
  }
  for (OptimizableGraph::Vertex* v : vertices) {
    const std::uint32_t block = block_of(v->hessianIndex());
    v->mapHessianMemory(values().data() + structure.value_start[structure.column_start[block]]);
    const std::uint32_t column = structure.offset[block];
    const std::uint32_t first = structure.scalars() - eliminated_scalars();
    v->setColInHessian(static_cast<int>(block < eliminated ? first + column : column - eliminated_scalars()));
  }
}

/// Maps the vertices at positions i and j of an edge to their block of H. H stores the block (i, j) if vertex
/// i has the larger block number. Otherwise, H stores the block (j, i).
void BlockSolverEngine::State::map_pair(OptimizableGraph::Edge& edge, int i, int j) {
  const int index_i = vertex_at(edge, static_cast<size_t>(i))->hessianIndex();
  const int index_j = vertex_at(edge, static_cast<size_t>(j))->hessianIndex();
  if (index_i < 0 || index_j < 0) {
    edge.mapHessianMemory(nullptr, i, j, false);
    return;
  }
  const std::uint32_t a = block_of(index_i), b = block_of(index_j);
  const std::uint32_t k = structure.find(std::max(a, b), std::min(a, b));
  edge.mapHessianMemory(values().data() + structure.value_start[k], i, j, a < b);
}

void BlockSolverEngine::State::map_edges(const SparseOptimizer& optimizer) {
  for (OptimizableGraph::Edge* edge : optimizer.activeEdges()) {
    const int arity = static_cast<int>(edge->vertices().size());
    for (int j = 1; j < arity; ++j)
      for (int i = 0; i < j; ++i) map_pair(*edge, i, j);
  }
}

void BlockSolverEngine::State::make_solver(const EngineSettings& new_settings) {
  const bool same_kind = new_settings.solver == settings.solver && new_settings.exact == settings.exact &&
                         new_settings.indefinite == settings.indefinite;
  settings = new_settings;
  if (same_kind && ready) {
    measured->set_settings(settings);
    return;
  }
  ready = true;
  std::unique_ptr<boxplus::LinearSolver> inner;
  client = nullptr;
  if (settings.solver == EngineSolver::kNone) {
    auto adapter = std::make_unique<ClientSolver>();
    client = adapter.get();
    inner = std::move(adapter);
  } else {
    inner = make_engine_solver(settings, for_newton_steps(solver_options(settings)));
  }
  measured = std::make_shared<MeasuredSolver>(std::move(inner), settings);
  solver = boxplus::make_schur_solver(measured);
  solver->analyze(structure, analyze_hints(eliminated));
}

bool BlockSolverEngine::buildStructure(SparseOptimizer& optimizer, bool schur,
                                       const EngineSettings& settings) {
  optimizer.dropIncompleteEdges();
  if (!state_) state_ = std::make_unique<State>();
  if (!state_->lay_out(optimizer, schur)) {
    state_.reset();
    return false;
  }
  state_->revision = optimizer.structure_revision_;
  state_->filled = false;
  state_->complained = false;
  optimizer.hessian_memory_ = state_->memory;
  state_->map_vertices(optimizer);
  state_->map_edges(optimizer);
  state_->make_solver(settings);
  return true;
}

bool BlockSolverEngine::hasStructure() const {
  return state_ != nullptr;
}

bool BlockSolverEngine::isCurrent(const SparseOptimizer& optimizer) const {
  return state_ != nullptr && state_->revision == optimizer.structure_revision_;
}

size_t BlockSolverEngine::scalars() const {
  return state_ ? state_->structure.scalars() : 0;
}

/// The places of blocks in the memory of H, and of vertices in a vector in the order of Hessian indices.
class BlockSolverEngine::State::Places final : public HessianPlaces {
 public:
  explicit Places(const State& state) : state_(state), ends_(state.block_ends()) {}
  Block block(int i, int j) const override {
    const std::uint32_t a = state_.block_of(i), b = state_.block_of(j);
    const std::uint32_t k = state_.structure.find(std::max(a, b), std::min(a, b));
    return {state_.structure.value_start[k], a < b};
  }
  std::uint32_t gradient(int i) const override {
    return i == 0 ? 0 : static_cast<std::uint32_t>(ends_[static_cast<size_t>(i - 1)]);
  }
  std::uint32_t values() const override { return state_.structure.nonzero_values(); }
  std::uint32_t scalars() const override { return state_.structure.scalars(); }

 private:
  const State& state_;
  std::vector<int> ends_;
};

/// Whether the edges in batches can be added to H. A client may have fixed a vertex, or removed an edge,
/// since H was laid out.
bool BlockSolverEngine::State::can_linearize(EdgeBatches& batches) {
  if (batches.empty()) return false;
  bool any_fixed = false;
  for_each_ahead(vertices, [&](const OptimizableGraph::Vertex& v) { any_fixed = any_fixed || v.fixed(); });
  if (any_fixed) return false;
  if (values().size() < structure.nonzero_values() + batches.extra_values()) return false;
  gradient.resize(structure.scalars() + batches.extra_scalars());
  return batches.stamp() == stamp || batches.lay_out(Places(*this), stamp);
}

/// Fills H, and b of each vertex.
void BlockSolverEngine::State::linearize(SparseOptimizer& optimizer) {
  EdgeParts& parts = optimizer.edgeParts();
  const bool with_errors = std::exchange(optimizer.errors_postponed_, false);
  const bool in_batches = can_linearize(parts.batches());
  if (in_batches) {
    parts.batches().clear(values().data(), gradient.data());
    if (parts.linearize_batches(values().data(), gradient.data(), with_errors))
      optimizer.lost_vertices_ = true;
    const double* from = gradient.data();
    for_each_ahead(vertices, [&](OptimizableGraph::Vertex& v) {
      v.clearQuadraticForm();
      double* to = v.bData();
      for (const double* end = from + v.dimension(); from != end; ++from, ++to) *to -= *from;
    });
  } else {
    std::fill(values().begin(), values().end(), 0.0);
    for_each_ahead(vertices, [](OptimizableGraph::Vertex& v) { v.clearQuadraticForm(); });
    if (with_errors && parts.compute_errors_of_batches()) optimizer.lost_vertices_ = true;
  }
  const auto add = [](OptimizableGraph::Edge& edge, JacobianWorkspace& workspace) {
    if (!internal::is_complete(edge)) return;
    edge.linearizeOplus(workspace);
    edge.constructQuadraticForm();
  };
  parts.for_each_by_parts(optimizer.jacobianWorkspace(), add);
  parts.for_each_of_batches(optimizer.jacobianWorkspace(), add, in_batches);
}

void BlockSolverEngine::buildSystem(SparseOptimizer& optimizer, double* b) {
  State& s = *state_;
  s.linearize(optimizer);
  for_each_ahead(s.vertices, [&](const OptimizableGraph::Vertex& v) { b += v.copyB(b); });
  s.filled = true;
}

bool BlockSolverEngine::isLinearized(const SparseOptimizer& optimizer) const {
  return isCurrent(optimizer) && state_->filled;
}

double BlockSolverEngine::State::largest_diagonal() const {
  double largest = 0;
  for (std::uint32_t c = 0; c < structure.blocks(); ++c) {
    const double* block = values().data() + structure.value_start[structure.column_start[c]];
    const std::uint32_t dim = structure.dim(c);
    for (std::uint32_t i = 0; i < dim; ++i) largest = std::max(largest, std::abs(block[i * (dim + 1)]));
  }
  return largest;
}

/// Says why the system cannot be solved, and at which vertex if this is known.
std::string BlockSolverEngine::State::reason(LinearStatus status, std::uint32_t failed_block) const {
  std::string text = "the linear system is ";
  text += status == LinearStatus::kNotPositiveDefinite ? "not positive definite" : "not finite";
  if (failed_block == BlockStructure::kAbsent) return text;
  const std::uint32_t h = failed_block < eliminated ? kept + failed_block : failed_block - eliminated;
  return text + " (at vertex " + std::to_string(ids[h]) + ")";
}

/// Reports why the system cannot be solved: the first time as an error, which is shown by default. An
/// algorithm that retries makes up for a singular H, but not for an indefinite one. Then even damping far
/// above rounding leaves the system indefinite. Returns false.
bool BlockSolverEngine::State::complain(LinearStatus status, std::uint32_t failed_block, double lambda) {
  constexpr double kRounding = 1e-9;
  const bool not_definite = status == LinearStatus::kNotPositiveDefinite;
  if (not_definite && settings.retries && lambda <= kRounding * largest_diagonal()) {
    G2O_WARN("{}", reason(status, failed_block));
    return false;
  }
  const char* more = !not_definite         ? ""
                     : settings.indefinite ? ", and it is singular"
                                           : "; only LinearSolverCholmod solves indefinite systems, such as "
                                             "those of equality constraints with Lagrange multipliers";
  const auto level = std::exchange(complained, true) ? logging::Level::kWarn : logging::Level::kError;
  logging::format_and_log(level, "{}{}", reason(status, failed_block), more);
  return false;
}

bool BlockSolverEngine::State::factorize(double lambda) {
  const double begin = get_monotonic_time();
  const boxplus::FactorResult result = solver->factorize(*full, {lambda, nullptr});
  const double solver_seconds = measured->take_factorize_seconds();
  if (G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats()) {
    if (eliminated > 0) statistics->timeSchurComplement += get_monotonic_time() - begin - solver_seconds;
    statistics->choleskyNNZ = solver->statistics().factor_nonzeros;
  }
  return result.status == LinearStatus::kOk || complain(result.status, result.failed_block, lambda);
}

bool BlockSolverEngine::solve(double lambda, const double* b, double* x, const EngineSettings& settings,
                              const ClientLinearSolver& client) {
  State& s = *state_;
  s.make_solver(settings);
  if (s.client != nullptr) s.client->set_client(&client);
  if (!s.factorize(lambda)) return false;
  s.to_engine(b, s.engine_b.data());
  const boxplus::SolveResult result = s.solver->solve(s.engine_b.data(), 1, s.engine_x.data());
  if (G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats())
    statistics->iterationsLinearSolver = result.iterations;
  if (result.status != LinearStatus::kOk && result.status != LinearStatus::kNotConverged)
    return s.client == nullptr && s.complain(result.status, result.failed_block, lambda);
  s.from_engine(s.engine_x.data(), x);
  return true;
}

void BlockSolverEngine::multiply(double* dest, const double* src) const {
  State& s = *state_;
  std::vector<double> in(s.structure.scalars()), out(in.size());
  s.to_engine(src, in.data());
  s.full->multiply(in.data(), out.data());
  s.from_engine(out.data(), dest);
}

bool BlockSolverEngine::inverse(const std::vector<std::pair<int, int>>& blockIndices,
                                SparseBlockMatrix<MatrixX>& spinv) {
  const State& s = *state_;
  const auto n = static_cast<int>(s.ids.size());
  std::vector<boxplus::BlockCoordinate> wanted;
  for (const auto& [i, j] : blockIndices) {
    if (i < 0 || j < 0 || i >= n || j >= n) {
      G2O_ERROR("computeMarginals: expected Hessian indices from 0 to {}, got ({}, {})", n - 1, i, j);
      return false;
    }
    wanted.push_back({s.block_of(i), s.block_of(j)});
  }
  EngineSettings settings{EngineSolver::kCholesky};
  settings.indefinite = s.settings.indefinite;
  const auto solver = boxplus::make_schur_solver(make_engine_solver(settings, {}));
  boxplus::AnalyzeHints hints = analyze_hints(s.eliminated);
  hints.may_be_singular = true;
  solver->analyze(s.structure, hints);
  const boxplus::FactorResult factor = solver->factorize(*s.full, {});
  if (factor.status != LinearStatus::kOk) {
    G2O_ERROR("computeMarginals: {}", s.reason(factor.status, factor.failed_block));
    return false;
  }
  boxplus::InverseBlocks blocks(s.structure, wanted);
  if (!blocks.compute(*solver)) return false;
  const std::vector<int> ends = s.block_ends();
  spinv = SparseBlockMatrix<MatrixX>(ends.data(), ends.data(), n, n);
  for (size_t k = 0; k < wanted.size(); ++k)
    *spinv.block(blockIndices[k].first, blockIndices[k].second, true) = blocks.block(k);
  return true;
}

bool BlockSolverEngine::save(const std::string& fileName) const {
  if (!state_) return false;
  const std::vector<int> ends = blockEnds();
  const auto n = static_cast<int>(ends.size());
  SparseBlockMatrix<MatrixX> H(ends.data(), ends.data(), n, n);
  visitBlocks([&](int i, int j, const MatrixX& block) { *H.block(i, j, true) = block; });
  return H.writeOctave(fileName.c_str(), true);
}

std::vector<int> BlockSolverEngine::blockEnds() const {
  return state_->block_ends();
}

int BlockSolverEngine::keptBlocks() const {
  return static_cast<int>(state_->kept);
}

void BlockSolverEngine::visitBlocks(const std::function<void(int, int, const MatrixX&)>& take) const {
  const State& s = *state_;
  const auto index_of = [&](std::uint32_t block) {
    return static_cast<int>(block < s.eliminated ? s.kept + block : block - s.eliminated);
  };
  for (std::uint32_t c = 0; c < s.structure.blocks(); ++c) {
    for (std::uint32_t k = s.structure.column_start[c]; k < s.structure.column_start[c + 1]; ++k) {
      const std::uint32_t r = s.structure.row[k];
      const Eigen::Map<const MatrixX> block(s.values().data() + s.structure.value_start[k],
                                            s.structure.dim(r), s.structure.dim(c));
      const int i = index_of(r), j = index_of(c);
      if (i <= j) {
        take(i, j, block);
      } else {
        take(j, i, block.transpose());
      }
    }
  }
}

}  // namespace internal
}  // namespace g2o
