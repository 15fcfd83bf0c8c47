// SPDX-License-Identifier: BSD-3-Clause
// An edge whose number of vertices is known at compile time.
#pragma once
#ifndef G2O_BASE_FIXED_SIZED_EDGE_H
#define G2O_BASE_FIXED_SIZED_EDGE_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <tuple>
#include <type_traits>
#include <utility>

#include "g2o/core/base_edge.h"
#include "g2o/stuff/logger.h"

/// The dimension of each vertex, or 0 if it is known only at run time, for pack expansions over the
/// VertexTypes of an edge.
#define G2O_VERTEX_DIM ((VertexTypes::Dimension < 0) ? 0 : VertexTypes::Dimension)

namespace g2o {
namespace internal {

/// Returns the index of the pair (i, j) of vertex positions with i < j. The order of the pairs is (0,1),
/// (0,2), (1,2), (0,3), …
constexpr int pair_to_index(int i, int j) {
  return j * (j - 1) / 2 + i;
}
constexpr int pair_first(int k) {
  int j = 1;
  while (j * (j + 1) / 2 <= k) ++j;
  return k - j * (j - 1) / 2;
}
constexpr int pair_second(int k) {
  int j = 1;
  while (j * (j + 1) / 2 <= k) ++j;
  return j;
}

/// A pair of vertex positions.
struct TrivialPair {
  int first = 0, second = 0;
  constexpr TrivialPair(int f, int s) : first(f), second(s) {}
  constexpr bool operator==(const TrivialPair& other) const {
    return first == other.first && second == other.second;
  }
};
/// Returns the k-th pair after the first pair whose second position is j. Both counts begin with 0. Without
/// j, this function is the inverse of pair_to_index().
constexpr TrivialPair index_to_pair(int k, int j = 0) {
  return TrivialPair(pair_first(k + j * (j - 1) / 2), pair_second(k + j * (j - 1) / 2));
}

/// A Rows × Cols Jacobian, stored by columns. Row vectors are declared RowMajor, because Eigen requires it.
template <int Rows, int Cols>
using JacobianMatrix =
    Eigen::Matrix<double, Rows, Cols, (Rows == 1 && Cols != 1) ? Eigen::RowMajor : Eigen::ColMajor>;

}  // namespace internal

/// An edge between vertices of the types VertexTypes. A derived class implements computeError(), read() and
/// write(). It also implements linearizeOplus() if it has analytic Jacobians.
///
/// The edge also accepts a vertex of another class if it has the same BaseVertex<D, T>, and casts it
/// statically. If it uses more of its vertex type than this base, this type must say so (UsedByEdges).
template <int D, typename E, typename... VertexTypes>
class BaseFixedSizedEdge : public BaseEdge<D, E> {
 public:
  template <int VertexN>
  using VertexXnType = std::tuple_element_t<VertexN, std::tuple<VertexTypes...>>;
  static constexpr std::size_t _nr_of_vertices = sizeof...(VertexTypes);
  static constexpr std::size_t _nr_of_vertex_pairs = _nr_of_vertices * (_nr_of_vertices - 1) / 2;

  template <int EdgeDimension, int VertexDimension>
  using JacobianType = Eigen::Map<internal::JacobianMatrix<EdgeDimension, VertexDimension>>;
  template <int DN, int DM>
  using HessianBlockType = Eigen::Map<internal::JacobianMatrix<DN, DM>>;

  static constexpr int Dimension = BaseEdge<D, E>::Dimension;
  using Measurement = typename BaseEdge<D, E>::Measurement;
  using ErrorVector = typename BaseEdge<D, E>::ErrorVector;
  using InformationType = typename BaseEdge<D, E>::InformationType;

  BaseFixedSizedEdge()
      : _hessianRowMajor{},
        _jacobianOplus(emptyMap<JacobianType<D, VertexTypes::Dimension>>()...),
        _hessianTuple(emptyPairs<false>(std::make_index_sequence<_nr_of_vertex_pairs>())),
        _hessianTupleTransposed(emptyPairs<true>(std::make_index_sequence<_nr_of_vertex_pairs>())) {
    this->_vertices.resize(_nr_of_vertices, nullptr);
  }

  template <int VertexN>
  const VertexXnType<VertexN>* vertexXn() const {
    return static_cast<const VertexXnType<VertexN>*>(this->_vertices[VertexN]);
  }
  template <int VertexN>
  VertexXnType<VertexN>* vertexXn() {
    return static_cast<VertexXnType<VertexN>*>(this->_vertices[VertexN]);
  }
  /// Returns a vertex, which may be of another class than the declared one, as the base class that both have.
  template <int VertexN>
  const typename VertexXnType<VertexN>::UsedByEdges* usedVertexXn() const {
    return static_cast<const typename VertexXnType<VertexN>::UsedByEdges*>(this->_vertices[VertexN]);
  }
  template <int VertexN>
  typename VertexXnType<VertexN>::UsedByEdges* usedVertexXn() {
    return static_cast<typename VertexXnType<VertexN>::UsedByEdges*>(this->_vertices[VertexN]);
  }
  /// Returns the number of dimensions of a vertex, which may be chosen at run time.
  template <int VertexN>
  int vertexDimension() const {
    constexpr int kDimension = VertexXnType<VertexN>::Dimension;
    if constexpr (kDimension >= 0) {
      return kDimension;
    } else {
      return usedVertexXn<VertexN>()->dimension();
    }
  }
  template <int VertexN>
  auto& jacobianOplusXn() {
    return std::get<VertexN>(_jacobianOplus);
  }
  template <int VertexN>
  const auto& jacobianOplusXn() const {
    return std::get<VertexN>(_jacobianOplus);
  }

  void resize(size_t size) override {
    if (size != _nr_of_vertices) {
      constexpr std::size_t kVertices =
          _nr_of_vertices;  // a copy, because the member has no definition in C++14
      G2O_ERROR("resize: the edge always has {} vertices, got {}", kVertices, size);
      return;
    }
    BaseEdge<D, E>::resize(size);
  }

  bool verticesFit() const override { return verticesFit(std::index_sequence_for<VertexTypes...>()); }
  bool allVerticesFixed() const override {
    return allVerticesFixed(std::index_sequence_for<VertexTypes...>());
  }

  /// Maps the Jacobians to memory of the workspace and calls linearizeOplus() to compute them.
  void linearizeOplus(JacobianWorkspace& jacobianWorkspace) override {
    mapJacobians(jacobianWorkspace, std::index_sequence_for<VertexTypes...>());
    linearizeOplus();
  }
  /// Computes the Jacobians of the vertices that are not fixed. By default, differentiates numerically.
  virtual void linearizeOplus() { linearizeNumerically(std::index_sequence_for<VertexTypes...>()); }

  void constructQuadraticForm() override {
    if (this->robustKernel() != nullptr) {
      Vector3 rho;
      this->robustKernel()->robustify(this->chi2(), rho);
      constructBlocks(this->robustInformation(rho), std::index_sequence_for<VertexTypes...>());
    } else {
      constructBlocks(this->_information, std::index_sequence_for<VertexTypes...>());
    }
  }

  /// Adds JᵀΩJ to the Hessian blocks, and JᵀweightedError to the b, of the vertices at the positions N. An
  /// edge with its own weights overrides constructQuadraticForm(), and calls this function with Ω = `omega`,
  /// weightedError = −Ωe and N = 0, …, _nr_of_vertices − 1.
  template <std::size_t... N>
  void constructQuadraticFormNs(const InformationType& omega, const ErrorVector& weightedError,
                                std::index_sequence<N...>) {
    (constructQuadraticFormN<static_cast<int>(N)>(omega, weightedError), ...);
  }
  /// Adds the terms of the vertex at position N: its diagonal block, its b, and its off-diagonal blocks with
  /// the vertices after it.
  template <int N>
  void constructQuadraticFormN(const InformationType& omega, const ErrorVector& weightedError) {
    constructColumn<N>(omega, weightedError, std::make_index_sequence<_nr_of_vertices - N - 1>());
  }

  void mapHessianMemory(double* d, int i, int j, bool rowMajor) override {
    if (i < 0 || i >= j || j >= static_cast<int>(_nr_of_vertices)) return;
    mapPair(d, internal::pair_to_index(i, j), rowMajor, std::make_index_sequence<_nr_of_vertex_pairs>());
  }

  OptimizableGraph::Vertex* createVertex(int i) override {
    return createVertexAt(i, std::index_sequence_for<VertexTypes...>());
  }
  /// Returns a new vertex of the type at position i, constructed from these arguments. Returns nullptr if the
  /// type has no such constructor.
  template <typename First, typename... Rest>
  OptimizableGraph::Vertex* createVertex(int i, First&& first, Rest&&... rest) {
    return createVertexAt(i, std::index_sequence_for<VertexTypes...>(), std::forward<First>(first),
                          std::forward<Rest>(rest)...);
  }

 protected:
  using BaseEdge<D, E>::_measurement;
  using BaseEdge<D, E>::_information;
  using BaseEdge<D, E>::_error;
  using BaseEdge<D, E>::_vertices;
  using BaseEdge<D, E>::_dimension;

  template <int K, bool Transposed>
  using PairBlock = HessianBlockType<
      VertexXnType<Transposed ? internal::pair_second(K) : internal::pair_first(K)>::Dimension,
      VertexXnType<Transposed ? internal::pair_first(K) : internal::pair_second(K)>::Dimension>;
  template <bool Transposed, std::size_t... K>
  static std::tuple<PairBlock<K, Transposed>...> pairTuple(std::index_sequence<K...>);
  template <bool Transposed>
  using PairTuple = decltype(pairTuple<Transposed>(
      std::make_index_sequence<sizeof...(VertexTypes) * (sizeof...(VertexTypes) - 1) / 2>()));

  std::array<bool, (_nr_of_vertex_pairs > 0 ? _nr_of_vertex_pairs : 1)> _hessianRowMajor;
  std::tuple<JacobianType<D, VertexTypes::Dimension>...> _jacobianOplus;
  PairTuple<false> _hessianTuple;
  PairTuple<true> _hessianTupleTransposed;

 private:
  template <class Map>
  static Map emptyMap() {
    return Map(nullptr, std::max<int>(Map::RowsAtCompileTime, 0), std::max<int>(Map::ColsAtCompileTime, 0));
  }
  template <bool Transposed, std::size_t... K>
  static PairTuple<Transposed> emptyPairs(std::index_sequence<K...>) {
    return PairTuple<Transposed>(emptyMap<PairBlock<K, Transposed>>()...);
  }

  template <std::size_t... N>
  bool verticesFit(std::index_sequence<N...>) const {
    return ((this->_vertices[N] == nullptr ||
             dynamic_cast<const typename VertexXnType<N>::UsedByEdges*>(this->_vertices[N]) != nullptr) &&
            ...);
  }
  template <std::size_t... N>
  bool allVerticesFixed(std::index_sequence<N...>) const {
    return (usedVertexXn<N>()->fixed() && ...);
  }

  template <std::size_t... N>
  void mapJacobians(JacobianWorkspace& workspace, std::index_sequence<N...>) {
    (mapJacobian<N>(workspace.workspaceForVertex(N)), ...);
  }
  template <int N>
  void mapJacobian(double* d) {
    using Map = JacobianType<D, VertexXnType<N>::Dimension>;
    new (&std::get<N>(_jacobianOplus)) Map(d, this->_dimension, vertexDimension<N>());
  }

  template <std::size_t... N>
  void linearizeNumerically(std::index_sequence<N...>) {
    (linearizeNumerically<N>(), ...);
  }
  template <int N>
  void linearizeNumerically() {
    if (usedVertexXn<N>()->fixed()) return;
    internal::numericJacobian(*this, *usedVertexXn<N>(), std::get<N>(_jacobianOplus).data());
  }

  /// The total number of columns of all Jacobians, or −1 if it is known only at run time.
  static constexpr int kColumns =
      ((VertexTypes::Dimension >= 0) && ...) ? (VertexTypes::Dimension + ... + 0) : -1;
  static constexpr bool kMultipliedAtOnce =
      ((VertexTypes::Dimension > 1) && ...) && internal::hasNormalProducts(D, kColumns);
  /// Returns the first column of the Jacobian of vertex N in the matrix of all Jacobians side by side.
  template <int N>
  static constexpr int columnOf() {
    if constexpr (N == 0) {
      return 0;
    } else {
      return columnOf<N - 1>() + VertexXnType<N - 1>::Dimension;
    }
  }

  template <std::size_t... N>
  void constructBlocks(const InformationType& omega, std::index_sequence<N...>) {
    if constexpr (kMultipliedAtOnce) {
      double triangle[static_cast<std::size_t>(D * (D + 1) / 2)];
      if (internal::upperTriangle<D>(omega, triangle)) {
        constructAtOnce(triangle, std::index_sequence<N...>());
        return;
      }
    }
    const ErrorVector weightedError = omega * -this->_error;
    constructQuadraticFormNs(omega, weightedError, std::index_sequence<N...>());
  }
  template <std::size_t... N>
  void constructAtOnce(const double* omegaTriangle, std::index_sequence<N...>) {
    constexpr int kRoom = internal::kMostProductColumns;
    const double* jacobian[static_cast<std::size_t>(kColumns)];
    const double** column = jacobian;
    const auto appendColumns = [&column](const auto& J) {
      for (Eigen::Index c = 0; c < J.cols(); ++c) *column++ = J.data() + c * D;
    };
    (appendColumns(std::get<N>(_jacobianOplus)), ...);
    double products[kRoom * kRoom], gradient[kRoom];
    const int stride = internal::normalProducts(D, kColumns, jacobian, omegaTriangle, this->_error.data(),
                                                products, gradient);
    (addColumn<N>(products, stride, gradient, std::make_index_sequence<_nr_of_vertices - N - 1>()), ...);
  }
  /// Returns the block of `products` that starts at `row` and `column`.
  template <int Rows, int Cols>
  static auto productBlock(const double* products, int stride, int row, int column) {
    return Eigen::Map<const internal::JacobianMatrix<Rows, Cols>, 0, Eigen::OuterStride<>>(
        products + column * stride + row, Eigen::OuterStride<>(stride));
  }
  /// Adds the products to the diagonal Hessian block of vertex N, and to the off-diagonal blocks of vertex N
  /// with the vertices after N.
  template <int N, std::size_t... M>
  void addColumn(const double* products, int stride, const double* gradient, std::index_sequence<M...>) {
    auto* from = usedVertexXn<N>();
    if (from->fixed() || from->A().data() == nullptr) return;
    constexpr int kDimension = VertexXnType<N>::Dimension, kColumn = columnOf<N>();
    from->b() -= Eigen::Map<const Eigen::Matrix<double, kDimension, 1>>(gradient + kColumn);
    from->A() += productBlock<kDimension, kDimension>(products, stride, kColumn, kColumn);
    (addPair<N, N + 1 + static_cast<int>(M)>(products, stride), ...);
  }
  template <int N, int M>
  void addPair(const double* products, int stride) {
    constexpr int K = internal::pair_to_index(N, M);
    if (usedVertexXn<M>()->fixed()) return;
    constexpr int kFirst = VertexXnType<N>::Dimension, kSecond = VertexXnType<M>::Dimension;
    if (_hessianRowMajor[K]) {
      auto& block = std::get<K>(_hessianTupleTransposed);
      if (block.data() != nullptr)
        block += productBlock<kSecond, kFirst>(products, stride, columnOf<M>(), columnOf<N>());
    } else {
      auto& block = std::get<K>(_hessianTuple);
      if (block.data() != nullptr)
        block += productBlock<kFirst, kSecond>(products, stride, columnOf<N>(), columnOf<M>());
    }
  }
  /// Computes JᵀΩJ and adds it to the diagonal Hessian block of vertex N, and to the off-diagonal blocks of
  /// vertex N with the vertices after N.
  template <int N, std::size_t... M>
  void constructColumn(const InformationType& omega, const ErrorVector& weightedError,
                       std::index_sequence<M...>) {
    auto* from = usedVertexXn<N>();
    if (from->fixed() || from->A().data() == nullptr) return;
    constexpr int kDimension = VertexXnType<N>::Dimension;
    const auto& J = std::get<N>(_jacobianOplus);
    const Eigen::Matrix<double, kDimension, D,
                        (kDimension == 1 && D != 1) ? Eigen::RowMajor : Eigen::ColMajor>
        JtOmega = J.transpose() * omega;
    from->b().noalias() += J.transpose() * weightedError;
    from->A().noalias() += JtOmega * J;
    (constructPair<N, N + 1 + static_cast<int>(M)>(JtOmega), ...);
  }
  template <int N, int M, class Product>
  void constructPair(const Product& JtOmega) {
    constexpr int K = internal::pair_to_index(N, M);
    if (usedVertexXn<M>()->fixed()) return;
    const auto& J = std::get<M>(_jacobianOplus);
    if (_hessianRowMajor[K]) {
      auto& block = std::get<K>(_hessianTupleTransposed);
      if (block.data() != nullptr) block.noalias() += J.transpose() * JtOmega.transpose();
    } else {
      auto& block = std::get<K>(_hessianTuple);
      if (block.data() != nullptr) block.noalias() += JtOmega * J;
    }
  }

  template <std::size_t... K>
  void mapPair([[maybe_unused]] double* d, [[maybe_unused]] int index, [[maybe_unused]] bool rowMajor,
               std::index_sequence<K...>) {
    (mapPair<K>(d, index, rowMajor), ...);
  }
  template <int K>
  void mapPair(double* d, int index, bool rowMajor) {
    if (index != K) return;
    const int first = vertexDimension<internal::pair_first(K)>();
    const int second = vertexDimension<internal::pair_second(K)>();
    _hessianRowMajor[K] = rowMajor;
    if (rowMajor) {
      new (&std::get<K>(_hessianTupleTransposed)) PairBlock<K, true>(d, second, first);
    } else {
      new (&std::get<K>(_hessianTuple)) PairBlock<K, false>(d, first, second);
    }
  }

  template <std::size_t... N, typename... Arguments>
  OptimizableGraph::Vertex* createVertexAt(int i, std::index_sequence<N...>, Arguments&&... arguments) {
    OptimizableGraph::Vertex* made = nullptr;
    ((i == static_cast<int>(N)
          ? void(made = newVertex<VertexXnType<N>>(std::forward<Arguments>(arguments)...))
          : void()),
     ...);
    return made;
  }
  template <class V, typename... Arguments>
  static OptimizableGraph::Vertex* newVertex(Arguments&&... arguments) {
    if constexpr (std::is_constructible<V, Arguments...>::value) {
      return new V(std::forward<Arguments>(arguments)...);
    } else {
      return nullptr;
    }
  }
};

}  // namespace g2o

#endif  // G2O_BASE_FIXED_SIZED_EDGE_H
