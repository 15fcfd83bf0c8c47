// SPDX-License-Identifier: BSD-3-Clause
// The tables of the dense kernels, which are compiled once per instruction set. The library chooses a table
// when it first uses a kernel.
#pragma once

#include <cstdint>
#include <span>

namespace boxplus::dense {

/// The numbers of rows and columns of the largest Jacobian that normal_products() accepts.
inline constexpr int kMostEdgeRows = 8, kMostEdgeColumns = 16;

/// The numbers of an edge. J has at least one column, and each column may have any address. Depending on
/// `kind`, Ω is stored as one value, one value per row, or its upper triangle by rows.
struct EdgeNumbers {
  enum Kind { kScalar, kDiagonal, kFull };
  int rows, cols;
  const double* const* jacobian;
  const double* error;
  Kind kind;
  const double* omega;
  double weight;  ///< the factor on Ω
};

/// The number of edges that are processed side by side. "In lanes" means: if the block of each edge has n
/// values, value m of edge k lies at ((k / kTileLanes) · n + m) · kTileLanes + k % kTileLanes.
inline constexpr int kTileLanes = 8;

/// The targets of an edge are the offsets of its vertices in the gradient, and then the offsets of the blocks
/// H_ij, j ≤ i, among the values: (0,0) (1,0) (1,1) (2,0) … A target H_ij with the bit kTransposedTarget
/// means that H_ji is stored instead. kNoTarget means that this part of the gradient or of H is not stored.
inline constexpr std::uint32_t kNoTarget = 0xFFFFFFFFu, kTransposedTarget = 0x80000000u;

/// Edges of one shape with two or more vertices.
struct EdgeLanes {
  int count;
  const double *jacobian, *error;  // the Jacobians and errors of all edges, in lanes
  EdgeNumbers::Kind kind;
  const double* const* omega;           // Ω of each edge
  const double* weight;                 // the weight of each edge; null if all weights are 1
  const std::uint32_t* const* targets;  // of each edge
  double *values, *gradient;
};
/// Adds JᵀΩJ to H and JᵀΩe to the gradient, for all edges in their order.
using AddEdges = void (*)(const EdgeLanes& edges);

/// Edges of one shape, and a vector x with an entry for each scalar of H. Gradient targets below `first_kept`
/// belong to eliminated vertices and are indices of x. Other targets are indices of x plus `copy`.
struct CoupledEdges {
  int count;
  const double* jacobian;  // the Jacobians of all edges, in lanes
  EdgeNumbers::Kind kind;
  const double* const* omega;           // Ω of each edge
  const double* weight;                 // the weight ρ′ of each edge; null if all weights are 1
  const std::uint32_t* const* targets;  // of each edge
  std::uint32_t first_kept, copy;
  double* x;
};
/// x_e −= ρ′ J_eᵀ Ω J_k x_k, for the parts x_e and x_k of x that belong to the eliminated and to the kept
/// vertices of an edge; for all edges in their order.
using SubtractCoupling = void (*)(const CoupledEdges& edges);

/// out[k] = eᵀΩe of edge k. `error` is stored in lanes. All Ω have the same kind.
using SquaredNorms = void (*)(int count, const double* error, EdgeNumbers::Kind kind,
                              const double* const* omega, double* out);

/// Unary edges whose Jacobians have the same shape. The Jacobians and errors are stored edge after edge. All
/// other members have the same meaning as in EdgeLanes.
struct UnaryEdges {
  int count;
  const double *jacobian, *error;  // of each edge: rows × cols values column by column, and rows values
  EdgeNumbers::Kind kind;
  const double* const* omega;
  const double* weight;
  const std::uint32_t* const* targets;  // of each edge: its offset in the gradient, and the offset of H_ii
  double *values, *gradient;
};
/// Adds JᵀΩJ to H and JᵀΩe to the gradient, for all edges in their order.
using AddUnaryEdges = void (*)(const UnaryEdges& edges);

/// Edges that measure one pose relative to another: for each edge, pointers to its measurement and two poses.
struct PosePairs {
  int count;
  const double *const *measurement, *const *from, *const *to;
};

/// The products of one block A with `count` blocks B, which are stored one after the other. Block k has
/// b_rows[k] rows, and its product is subtracted from the block at values + targets[k].
struct BlockProducts {
  const double* b;
  const int* b_rows;
  int count;
  const std::uint32_t* targets;
  double* values;
};

/// The steps of an elimination (linear/schur/schur.h) on a block W, which has rows × dim values and is
/// column-major.
struct EliminationKernels {
  /// Y = W L⁻ᵀ. L is dim × dim, with the reciprocals of its diagonal in place of the diagonal. The columns of
  /// Y begin y_stride values apart.
  void (*whitened_block)(int rows, int dim, const double* l, const double* w, double* y, int y_stride);
  /// C −= A Bᵀ for each block B. A is rows × dim, B is b_rows × dim, C is rows × b_rows.
  void (*subtract_block_products)(int rows, int dim, const double* a, const BlockProducts& products);
  /// y −= W x.
  void (*subtract_block_multiple)(int rows, int dim, const double* w, const double* x, double* y);
  /// y −= Wᵀ x.
  void (*subtract_transposed_multiple)(int rows, int dim, const double* w, const double* x, double* y);
};

/// A run of consecutive values and its destination.
struct Run {
  std::uint32_t source, destination, length;
};

/// The task of adding columns of a child's update matrix, at and below the diagonal, to a part of its
/// parent's front.
template <class Scalar>
struct ExtendAdd {
  const Scalar* update;  // below × below
  int below;
  const Run *columns, *columns_end, *end;  // the columns to add; the rows continue until `end`
  Scalar* to;
  int leading;
  std::uint32_t row_origin, column_origin;  // the row and column of the parent's front that `to` points to
};

/// The number of columns that are factorized together before the remaining columns of a panel are updated. It
/// is so small that a strip of these columns stays in the L1 cache.
inline constexpr int kBlock = 64;

/// The kernels of a factorization in double or float. dense_kernels.h documents them.
template <class Scalar>
struct FactorKernels {
  int (*factor_panel)(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot);
  void (*set_to_minus_square)(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin,
                              int end);
  void (*subtract_square)(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin, int end);
  void (*subtract_product_transposed)(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb,
                                      int rows, int columns, int k);
  void (*subtract_product)(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb, int rows,
                           int columns, int k);
  void (*divide_by_transposed)(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size);
  void (*divide_by)(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size);
  void (*solve_forward)(const Scalar* panel, int rows, int columns, int ld, Scalar* work);
  void (*solve_backward)(const Scalar* panel, int rows, int columns, int ld, Scalar* work);
  /// gather_runs(): work[source…] = x[destination…] for each run. scatter_runs() copies in the other
  /// direction.
  void (*gather_runs)(const Run* runs, int count, const Scalar* x, Scalar* work);
  void (*scatter_runs)(const Run* runs, int count, const Scalar* work, Scalar* x);
  /// to[destination…] += from[source…] for each run.
  void (*add_runs)(const Run* runs, int count, const Scalar* from, Scalar* to);
  void (*extend_add)(const ExtendAdd<Scalar>& task);
};

/// The kernels for one instruction set.
struct KernelTable {
  const char* name;
  /// The time per floating-point operation for fronts of medium size, measured on x86 processors from about
  /// 2023. For NEON, it is an estimate: two thirds of the peak of a core with two pipes at 2.6 GHz.
  double nanoseconds_per_flop;
  FactorKernels<double> in_double;
  FactorKernels<float> in_float;
  /// products = JᵀΩJ, column-major with the returned stride, and gradient = JᵀΩe. `products` must have memory
  /// for kMostEdgeColumns² values, and `gradient` for kMostEdgeColumns values. The kernel may overwrite
  /// values beyond the first `cols` of a column.
  int (*normal_products)(const EdgeNumbers& edge, double* products, double* gradient);
  /// block += source. The block is rows × cols and dense; the source has the given stride.
  void (*add_block)(double* block, int rows, int cols, const double* source, int stride);
  /// The kernels for edges with two or more vertices of these tangent sizes, or null if there are none.
  AddEdges (*add_edges_for)(int rows, const int* dims, int arity);
  SubtractCoupling (*subtract_coupling_for)(int rows, const int* dims, int arity);
  /// The kernel for unary edges of these sizes, or null if there is none.
  AddUnaryEdges (*add_unary_edges_for)(int rows, int dim);
  /// Copies blocks of `size` values, which lie edge after edge, to lanes. Remaining lanes get copies of the
  /// last edge.
  void (*to_lanes)(const double* edges, int size, int count, double* lanes);
  /// The kernel for errors of this many rows, or null if there is none.
  SquaredNorms (*squared_norms_for)(int rows);
  /// Computes the errors and, unless `jacobian` is null, the Jacobians of Between<SE2> and Between<SE3> in
  /// lanes.
  void (*between_se2)(const PosePairs& edges, double* error, double* jacobian);
  void (*between_se3)(const PosePairs& edges, double* error, double* jacobian);
  /// The kernels for blocks of this size, or null if there are none.
  const EliminationKernels* (*elimination_kernels_for)(int rows, int dim);
};

/// The tables of kernels that this processor can run. The fastest table is last.
std::span<const KernelTable* const> usable_kernels();
/// The table of kernels that is in use. If the environment variable BOXPLUS_ISA names a table (baseline,
/// avx2, avx512, neon) that the processor can run, this table is used. Otherwise, the fastest table is used.
const KernelTable& kernels();
template <class Scalar>
const FactorKernels<Scalar>& factor_kernels() {
  if constexpr (sizeof(Scalar) == sizeof(double)) {
    return kernels().in_double;
  } else {
    return kernels().in_float;
  }
}
/// Changes the table that is in use. Only tests may call this, and only while no other thread uses kernels.
void use_kernels(const KernelTable& table);

namespace baseline {
extern const KernelTable kTable;
}
namespace avx2 {
extern const KernelTable kTable;
}
namespace avx512 {
extern const KernelTable kTable;
}
namespace neon {
extern const KernelTable kTable;
}

}  // namespace boxplus::dense
