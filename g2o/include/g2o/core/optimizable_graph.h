// SPDX-License-Identifier: BSD-3-Clause
// A hyper-graph as an optimization problem: vertices have estimates, and edges have errors.
#pragma once
#ifndef G2O_AIS_OPTIMIZABLE_GRAPH_HH_
#define G2O_AIS_OPTIMIZABLE_GRAPH_HH_

#include <functional>
#include <iosfwd>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <typeinfo>
#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/core/hyper_graph.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/jacobian_workspace.h"
#include "g2o/core/openmp_mutex.h"
#include "g2o/core/parameter.h"
#include "g2o/core/parameter_container.h"
#include "g2o/stuff/macros.h"
#include "g2o/stuff/misc.h"

namespace g2o {

class Cache;
class CacheContainer;
class RobustKernel;
struct OptimizationAlgorithmProperty;

struct G2O_CORE_API OptimizableGraph : public HyperGraph {
  enum ActionType {
    AT_PREITERATION,
    AT_POSTITERATION,
    AT_NUM_ELEMENTS,  // must be the last element
  };

  using HyperGraphActionSet = std::set<HyperGraphAction*>;

  class Vertex;
  class Edge;

  /// Orders vertices by id.
  struct VertexIDCompare {
    bool operator()(const Vertex* v1, const Vertex* v2) const { return v1->id() < v2->id(); }
  };

  /// Orders edges by the time at which they were added to the graph.
  struct EdgeIDCompare {
    bool operator()(const Edge* e1, const Edge* e2) const { return e1->internalId() < e2->internalId(); }
    bool operator()(const HyperGraph::Edge* e1, const HyperGraph::Edge* e2) const {
      return operator()(static_cast<const Edge*>(e1), static_cast<const Edge*>(e2));
    }
  };

  using VertexContainer = std::vector<Vertex*>;
  using EdgeContainer = std::vector<Edge*>;

  /// A variable on a manifold. BaseVertex implements everything except oplusImpl(), setToOriginImpl(), read()
  /// and write().
  class G2O_CORE_API Vertex : public HyperGraph::Vertex {
    friend struct OptimizableGraph;

   public:
    Vertex();
    ~Vertex() override;

    void setToOrigin() {
      setToOriginImpl();
      updateCache();
    }

    /// Return the entry (i, j), the determinant, and the memory of the vertex's diagonal block of the
    /// Hessian. Until optimize() allocates the Hessian, the values are NaN and the memory is nullptr. The
    /// results are valid until the next initializeOptimization().
    virtual const double& hessian(int i, int j) const = 0;
    virtual double& hessian(int i, int j) = 0;
    virtual double hessianDeterminant() const = 0;
    virtual double* hessianData() = 0;
    /// Maps the diagonal block of the Hessian to the memory at `d`, stored by columns.
    virtual void mapHessianMemory(double* d) = 0;
    /// Copies b = −Σ JᵀΩe, the sum over the edges of this vertex, to `b_`. Returns the number of entries.
    virtual int copyB(double* b_) const = 0;
    virtual const double& b(int i) const = 0;
    virtual double& b(int i) = 0;
    virtual double* bData() = 0;
    virtual void clearQuadraticForm() = 0;
    /// Moves only this vertex, by the solution of (A + λI) x = b, with the vertex's diagonal block A of the
    /// Hessian. Returns the determinant of A + λI.
    virtual double solveDirect(double lambda = 0) = 0;

    /// Set or get the estimate as an array of estimateDimension() values. These functions return false if the
    /// type does not support this.
    bool setEstimateData(const double* estimate);
    bool setEstimateData(const std::vector<double>& estimate) {
      const int dim = estimateDimension();
      return dim != -1 && static_cast<int>(estimate.size()) == dim && setEstimateData(estimate.data());
    }
    template <typename Derived>
    bool setEstimateData(const Eigen::MatrixBase<Derived>& estimate) {
      const VectorX copy = estimate;
      const int dim = estimateDimension();
      return dim != -1 && static_cast<int>(copy.size()) == dim && setEstimateData(copy.data());
    }
    virtual bool getEstimateData(double* estimate) const;
    virtual bool getEstimateData(std::vector<double>& estimate) const {
      const int dim = estimateDimension();
      if (dim < 0) return false;
      estimate.resize(static_cast<size_t>(dim));
      return getEstimateData(estimate.data());
    }
    template <typename Derived>
    bool getEstimateData(Eigen::MatrixBase<Derived>& estimate) const {
      const int dim = estimateDimension();
      if (dim != estimate.size()) return false;
      VectorX copy(dim);
      if (!getEstimateData(copy.data())) return false;
      estimate = copy;
      return true;
    }
    virtual int estimateDimension() const;

    /// Set or get the estimate as an array of minimalEstimateDimension() values.
    bool setMinimalEstimateData(const double* estimate);
    bool setMinimalEstimateData(const std::vector<double>& estimate) {
      const int dim = minimalEstimateDimension();
      return dim != -1 && static_cast<int>(estimate.size()) == dim && setMinimalEstimateData(estimate.data());
    }
    template <typename Derived>
    bool setMinimalEstimateData(const Eigen::MatrixBase<Derived>& estimate) {
      const VectorX copy = estimate;
      const int dim = minimalEstimateDimension();
      return dim != -1 && static_cast<int>(copy.size()) == dim && setMinimalEstimateData(copy.data());
    }
    virtual bool getMinimalEstimateData(double* estimate) const;
    virtual bool getMinimalEstimateData(std::vector<double>& estimate) const {
      const int dim = minimalEstimateDimension();
      if (dim < 0) return false;
      estimate.resize(static_cast<size_t>(dim));
      return getMinimalEstimateData(estimate.data());
    }
    template <typename Derived>
    bool getMinimalEstimateData(Eigen::MatrixBase<Derived>& estimate) const {
      const int dim = minimalEstimateDimension();
      if (dim != estimate.size()) return false;
      VectorX copy(dim);
      if (!getMinimalEstimateData(copy.data())) return false;
      estimate = copy;
      return true;
    }
    virtual int minimalEstimateDimension() const;

    /// push() saves a copy of the estimate, pop() restores the last copy, and discardTop() drops it.
    virtual void push() = 0;
    virtual void pop() = 0;
    virtual void discardTop() = 0;
    virtual int stackSize() const = 0;

    /// Replaces the estimate x by x ⊞ v.
    void oplus(const double* v) {
      oplusImpl(v);
      updateCache();
    }

    /// The block row of this vertex in the Hessian of the last initializeOptimization(), or −1 if the vertex
    /// is not in the Hessian.
    int hessianIndex() const { return _hessianIndex; }
    int G2O_ATTRIBUTE_DEPRECATED(tempIndex() const) { return hessianIndex(); }
    void setHessianIndex(int ti) { _hessianIndex = ti; }
    void G2O_ATTRIBUTE_DEPRECATED(setTempIndex(int ti)) { setHessianIndex(ti); }

    /// The optimization does not change the estimate of a fixed vertex.
    bool fixed() const { return _fixed; }
    void setFixed(bool fixed) { _fixed = fixed; }
    /// The Schur complement eliminates a marginalized vertex.
    bool marginalized() const { return _marginalized; }
    void setMarginalized(bool marginalized) { _marginalized = marginalized; }

    int dimension() const { return _dimension; }
    void setId(int id) override { _id = id; }
    void setColInHessian(int c) { _colInHessian = c; }
    int colInHessian() const { return _colInHessian; }

    const OptimizableGraph* graph() const { return _graph; }
    OptimizableGraph* graph() { return _graph; }

    void lockQuadraticForm() { _quadraticFormMutex.lock(); }
    void unlockQuadraticForm() { _quadraticFormMutex.unlock(); }

    virtual bool read(std::istream& is) = 0;
    virtual bool write(std::ostream& os) const = 0;
    virtual void updateCache();
    CacheContainer* cacheContainer();

   protected:
    OptimizableGraph* _graph = nullptr;
    int _hessianIndex = -1;
    bool _fixed = false;
    bool _marginalized = false;
    int _dimension = -1;
    int _colInHessian = -1;
    OpenMPMutex _quadraticFormMutex;
    std::unique_ptr<CacheContainer> _cacheContainer;

    /// Implements ⊞. Override one of the two overloads. By default, the overload for const double* calls the
    /// overload for double*, which the library's types override.
    virtual void oplusImpl(const double* v);
    virtual void oplusImpl(double* v);
    virtual void setToOriginImpl() = 0;
    virtual bool setEstimateDataImpl(const double*) { return false; }
    virtual bool setMinimalEstimateDataImpl(const double*) { return false; }

   private:
    int addedAs_ = InvalidId;  // the key of the vertex in vertices()
  };

  /// A measurement. BaseUnaryEdge, BaseBinaryEdge, … implement everything except computeError(), read() and
  /// write().
  class G2O_CORE_API Edge : public HyperGraph::Edge {
    friend struct OptimizableGraph;

   public:
    Edge();
    ~Edge() override;

    virtual bool allVerticesFixed() const = 0;
    virtual void computeError() = 0;
    virtual const double* errorData() const = 0;
    virtual double* errorData() = 0;
    virtual const double* informationData() const = 0;
    virtual double* informationData() = 0;
    /// Returns eᵀΩe with the error e of the last computeError(), without the robust kernel.
    virtual double chi2() const = 0;

    /// Sets the measurement from an array of measurementDimension() values.
    virtual bool setMeasurementData(const double* m);
    virtual bool getMeasurementData(double* m) const;
    virtual int measurementDimension() const;
    /// Sets the measurement to the value that the current estimates predict.
    virtual bool setMeasurementFromState();

    RobustKernel* robustKernel() const { return _robustKernel; }
    /// Takes ownership of the kernel and deletes the previous kernel.
    void setRobustKernel(RobustKernel* ptr);

    /// Adds JᵀΩJ to the mapped blocks of the Hessian, and −JᵀΩe to b of each vertex.
    virtual void constructQuadraticForm() = 0;
    /// Maps the Hessian block of the vertices at positions i < j to the memory at `d`: block (i, j), stored
    /// by columns, or block (j, i) if `rowMajor` is true.
    virtual void mapHessianMemory(double* d, int i, int j, bool rowMajor) = 0;
    /// Writes the Jacobians to the workspace.
    virtual void linearizeOplus(JacobianWorkspace& jacobianWorkspace) = 0;

    /// Sets the estimate of `to` from the estimates of `from`.
    virtual void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) = 0;
    /// Returns the cost of initialEstimate(), or a value ≤ 0 if the edge cannot compute an estimate of `to`.
    virtual double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                           OptimizableGraph::Vertex* to) {
      (void)from;
      (void)to;
      return -1.;
    }

    /// An optimization uses only the edges of one level, unless initializeOptimization() selects several
    /// levels.
    int level() const { return _level; }
    void setLevel(int l) { _level = l; }
    /// The number of rows of the error.
    int dimension() const { return _dimension; }

    G2O_ATTRIBUTE_DEPRECATED(virtual Vertex* createFrom()) { return createVertex(0); }
    G2O_ATTRIBUTE_DEPRECATED(virtual Vertex* createTo()) { return createVertex(1); }
    /// Returns a new vertex of the type that the edge expects at position i.
    virtual Vertex* createVertex(int) { return nullptr; }

    virtual bool read(std::istream& is) = 0;
    virtual bool write(std::ostream& os) const = 0;

    /// Returns whether the assigned vertices have the types that the edge expects.
    virtual bool verticesFit() const { return true; }

    /// The number of the edge in the order in which edges were added to the graph.
    long long internalId() const { return _internalId; }
    OptimizableGraph* graph();
    const OptimizableGraph* graph() const;

    bool setParameterId(int argNum, int paramId);
    /// Returns nullptr if there is no such parameter.
    const Parameter* parameter(int argNo) const {
      const auto at = static_cast<size_t>(argNo);
      return argNo < 0 || at >= _parameters.size() || _parameters[at] == nullptr ? nullptr : *_parameters[at];
    }
    size_t numParameters() const { return _parameters.size(); }
    void resizeParameters(size_t newSize);
    const std::vector<int>& parameterIds() const { return _parameterIds; }

   protected:
    int _dimension = -1;
    int _level = 0;
    RobustKernel* _robustKernel = nullptr;
    long long _internalId = -1;
    std::vector<int> _cacheIds;

    /// Declares that parameter `argNo` of this edge has the type ParameterType. addEdge() then sets `p` to
    /// the parameter.
    template <typename ParameterType>
    bool installParameter(ParameterType*& p, size_t argNo, int paramId = -1) {
      if (argNo >= _parameters.size()) return false;
      _parameterIds[argNo] = paramId;
      _parameters[argNo] = reinterpret_cast<Parameter**>(&p);
      _parameterTypes[argNo] = typeid(ParameterType).name();
      _parameterSetters[argNo] = &assignParameter<ParameterType>;
      return true;
    }

    template <typename CacheType>
    void resolveCache(CacheType*& cache, OptimizableGraph::Vertex*, const std::string& type,
                      const ParameterVector& parameters);

    bool resolveParameters();
    virtual bool resolveCaches();

    std::vector<std::string> _parameterTypes;
    std::vector<Parameter**> _parameters;
    std::vector<int> _parameterIds;

   private:
    using ParameterSetter = bool (*)(Parameter** slot, Parameter* parameter);
    template <typename ParameterType>
    static bool assignParameter(Parameter** slot, Parameter* parameter) {
      auto* typed = dynamic_cast<ParameterType*>(parameter);
      if (typed == nullptr) return false;
      *reinterpret_cast<ParameterType**>(slot) = typed;
      return true;
    }
    std::vector<ParameterSetter> _parameterSetters;
  };

  OptimizableGraph();
  ~OptimizableGraph() override;

  Vertex* vertex(int id) { return static_cast<Vertex*>(HyperGraph::vertex(id)); }
  const Vertex* vertex(int id) const { return static_cast<const Vertex*>(HyperGraph::vertex(id)); }

  /// Returns false if the id of the vertex is taken or if the vertex is already in a graph. Attaches
  /// `userData` to the vertex.
  bool addVertex(HyperGraph::Vertex* v) override;
  virtual bool addVertex(HyperGraph::Vertex* v, Data* userData);
  bool addVertex(OptimizableGraph::Vertex* v, Data* userData);
  bool addVertex(OptimizableGraph::Vertex* v) { return addVertex(v, nullptr); }

  /// Returns false if a vertex or a parameter of the edge is missing, if the same vertex appears twice, or if
  /// a vertex has the wrong type.
  bool addEdge(HyperGraph::Edge* e) override;
  bool addEdge(OptimizableGraph::Edge* e);

  /// Adds an edge that does not have all its vertices yet, because its data association is unknown. In files,
  /// a missing vertex has the id −1. save() writes the edge, but the optimization ignores the edge until
  /// setEdgeVertex() has set all its vertices.
  bool addUnassignedEdge(OptimizableGraph::Edge* e);

  /// Returns false and changes nothing if the vertex is already at another position of the edge, is not in
  /// the graph, or has the wrong type, or if a parameter is missing.
  bool setEdgeVertex(HyperGraph::Edge* e, int pos, HyperGraph::Vertex* v) override;
  bool changeId(HyperGraph::Vertex* v, int newId) override;

  /// The sum of eᵀΩe over all edges, without robust kernels. Uses the errors that were computed last.
  double chi2() const;
  int maxDimension() const;
  /// The distinct dimensions of the vertices.
  std::set<int> dimensions() const;

  virtual int optimize(int iterations, bool online = false);
  virtual void preIteration(int);
  virtual void postIteration(int);
  /// The caller still owns the action.
  bool addPreIterationAction(HyperGraphAction* action);
  bool addPostIterationAction(HyperGraphAction* action);
  bool removePreIterationAction(HyperGraphAction* action);
  bool removePostIterationAction(HyperGraphAction* action);

  /// Save, restore and drop copies of the estimates of all vertices, or of the vertices in `vset`.
  virtual void push();
  virtual void pop();
  virtual void discardTop();
  virtual void push(HyperGraph::VertexSet& vset);
  virtual void pop(HyperGraph::VertexSet& vset);
  virtual void discardTop(HyperGraph::VertexSet& vset);
  virtual void setFixed(HyperGraph::VertexSet& vset, bool fixed);

  /// Reads a .g2o file with the types of the Factory. Returns false if the file cannot be opened or if a line
  /// cannot be read. Logs an error for each line that cannot be read, and still reads the other lines. Skips
  /// lines whose tag is unknown, and logs one error for each unknown tag, which names the library of the tag.
  virtual bool load(std::istream& is);
  bool load(const char* filename);
  bool load(const std::string& filename) { return load(filename.c_str()); }
  /// Writes the parameters, the vertices, and the edges of one level.
  virtual bool save(std::ostream& os, int level = 0) const;
  bool save(const char* filename, int level = 0) const;
  bool save(const std::string& filename, int level = 0) const { return save(filename.c_str(), level); }
  bool saveSubset(std::ostream& os, HyperGraph::VertexSet& vset, int level = 0);
  bool saveSubset(std::ostream& os, HyperGraph::EdgeSet& eset);
  bool saveVertex(std::ostream& os, Vertex* v) const;
  bool saveParameter(std::ostream& os, Parameter* v) const;
  bool saveEdge(std::ostream& os, Edge* e) const;
  bool saveUserData(std::ostream& os, HyperGraph::Data* v) const;

  /// Sets the tags that load() replaces. With "A=B,C=D", tag A in a file means tag B of the factory, and tag
  /// C in a file means tag D of the factory. An empty string removes all replacements.
  void setRenamedTypesFromString(const std::string& types);

  /// Returns whether an algorithm supports vertices with these dimensions. If `vertDims` is empty, checks the
  /// dimensions of the graph's vertices.
  bool isSolverSuitable(const OptimizationAlgorithmProperty& solverProperty,
                        const std::set<int>& vertDims = std::set<int>()) const;

  /// Deletes the parameters. Also deletes all vertices and edges, because edges use the parameters.
  virtual void clearParameters();
  bool addParameter(Parameter* p) { return _parameters.addParameter(p); }
  Parameter* parameter(int id) { return _parameters.getParameter(id); }
  ParameterContainer& parameters() { return _parameters; }
  const ParameterContainer& parameters() const { return _parameters; }

  /// Returns whether the information matrices of all edges are finite, symmetric and positive semi-definite.
  /// If `verbose` is true, logs a warning for each edge with an invalid information matrix.
  bool verifyInformationMatrices(bool verbose = false) const;

  JacobianWorkspace& jacobianWorkspace() { return _jacobianWorkspace; }
  const JacobianWorkspace& jacobianWorkspace() const { return _jacobianWorkspace; }
  void recomputeJacobianWorkspaceSize();

  /// Does nothing, because no initialization is necessary. The function exists because g2o has a function
  /// with this name.
  static bool initMultiThreading();

  void forEachVertex(const std::function<void(OptimizableGraph::Vertex*)>& fn);
  void forEachVertex(HyperGraph::VertexSet& vset, const std::function<void(OptimizableGraph::Vertex*)>& fn);

 protected:
  bool addAction(int type, HyperGraphAction* action);
  /// Calls the actions of a type. An action may remove itself or other actions, and may delete the removed
  /// actions.
  void callActions(int type, HyperGraphAction::Parameters* parameters = nullptr);

  std::map<std::string, std::string> _renamedTypesLookup;
  long long _nextEdgeId = 0;
  std::vector<HyperGraphActionSet> _graphActions;
  ParameterContainer _parameters{true};
  JacobianWorkspace _jacobianWorkspace;
};

}  // namespace g2o

#include "g2o/core/cache.h"

#endif  // G2O_AIS_OPTIMIZABLE_GRAPH_HH_
