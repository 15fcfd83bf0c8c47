// SPDX-License-Identifier: BSD-3-Clause
// A directed hyper-graph. Vertices are identified by integer ids, and edges are identified by pointers.
#pragma once
#ifndef G2O_AIS_HYPER_GRAPH_HH
#define G2O_AIS_HYPER_GRAPH_HH

#include <bitset>
#include <cstddef>
#include <iosfwd>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// Owns its vertices and edges: remove…(), clear() and the destructor delete them. If add…() returns false,
/// the caller still owns the element.
class G2O_CORE_API HyperGraph {
 public:
  enum HyperGraphElementType {
    HGET_VERTEX,
    HGET_EDGE,
    HGET_PARAMETER,
    HGET_CACHE,
    HGET_DATA,
    HGET_NUM_ELEMS
  };

  static constexpr int UnassignedId = -1;
  static constexpr int InvalidId = -2;

  using GraphElemBitset = std::bitset<HGET_NUM_ELEMS>;

  class Data;
  class DataContainer;
  class Vertex;
  class Edge;

  struct G2O_CORE_API HyperGraphElement {
    HyperGraphElement() = default;
    HyperGraphElement(const HyperGraphElement&) = default;
    HyperGraphElement& operator=(const HyperGraphElement&) = default;
    virtual ~HyperGraphElement();
    virtual HyperGraphElementType elementType() const = 0;
  };

  using EdgeSet = std::set<Edge*>;
  using VertexSet = std::set<Vertex*>;
  using VertexIDMap = std::unordered_map<int, Vertex*>;
  using VertexContainer = std::vector<Vertex*>;
  using EdgeContainer = std::vector<Edge*>;

  /// User data that is attached to an element. All user data of an element form a list, linked by next().
  class G2O_CORE_API Data : public HyperGraphElement {
    friend struct OptimizableGraph;

   public:
    Data();
    ~Data() override;
    virtual bool read(std::istream& is) = 0;
    virtual bool write(std::ostream& os) const = 0;
    HyperGraphElementType elementType() const override { return HGET_DATA; }
    const Data* next() const { return _next; }
    Data* next() { return _next; }
    void setNext(Data* next) { _next = next; }
    DataContainer* dataContainer() { return _dataContainer; }
    const DataContainer* dataContainer() const { return _dataContainer; }
    void setDataContainer(DataContainer* container) { _dataContainer = container; }

   protected:
    Data* _next = nullptr;
    DataContainer* _dataContainer = nullptr;
  };

  /// The base class of elements that can have user data. It owns the data.
  class G2O_CORE_API DataContainer {
   public:
    DataContainer() = default;
    DataContainer(const DataContainer&) = delete;
    DataContainer& operator=(const DataContainer&) = delete;
    virtual ~DataContainer();
    const Data* userData() const { return _userData; }
    Data* userData() { return _userData; }
    /// Replaces the list of user data. The caller then owns the previous list.
    void setUserData(Data* data) {
      _userData = data;
      for (Data* d = data; d != nullptr; d = d->next()) d->setDataContainer(this);
    }
    /// Puts `data` at the front of the list.
    void addUserData(Data* data) {
      if (data == nullptr) return;
      data->setNext(_userData);
      data->setDataContainer(this);
      _userData = data;
    }

   protected:
    Data* _userData = nullptr;
  };

  class G2O_CORE_API Vertex : public HyperGraphElement, public DataContainer {
   public:
    explicit Vertex(int id = InvalidId);
    ~Vertex() override;
    int id() const { return _id; }
    /// Only for vertices that are not in a graph. For other vertices, use HyperGraph::changeId().
    virtual void setId(int newId) { _id = newId; }
    const EdgeSet& edges() const { return _edges; }
    EdgeSet& edges() { return _edges; }
    HyperGraphElementType elementType() const override { return HGET_VERTEX; }

   protected:
    int _id;
    EdgeSet _edges;
  };

  class G2O_CORE_API Edge : public HyperGraphElement, public DataContainer {
   public:
    explicit Edge(int id = InvalidId);
    ~Edge() override;
    virtual void resize(size_t size);
    const VertexContainer& vertices() const { return _vertices; }
    VertexContainer& vertices() { return _vertices; }
    const Vertex* vertex(size_t i) const { return _vertices[i]; }
    Vertex* vertex(size_t i) { return _vertices[i]; }
    /// Only for edges that are not in a graph. For other edges, use HyperGraph::setEdgeVertex().
    void setVertex(size_t i, Vertex* v);
    int id() const { return _id; }
    void setId(int id) { _id = id; }
    HyperGraphElementType elementType() const override { return HGET_EDGE; }
    int numUndefinedVertices() const;

   protected:
    VertexContainer _vertices;
    int _id;
  };

  HyperGraph();
  HyperGraph(const HyperGraph&) = delete;
  HyperGraph& operator=(const HyperGraph&) = delete;
  virtual ~HyperGraph();

  /// Returns the vertex with this id, or nullptr if there is none.
  Vertex* vertex(int id);
  const Vertex* vertex(int id) const;

  /// Removes an element and deletes it. Returns false if the element is not in the graph. If `detach` is
  /// true, the edges of the vertex remain in the graph, with a nullptr at the position of the vertex.
  virtual bool removeVertex(Vertex* v, bool detach = false);
  virtual bool removeEdge(Edge* e);
  /// Deletes all vertices and edges.
  virtual void clear();

  const VertexIDMap& vertices() const { return _vertices; }
  VertexIDMap& vertices() { return _vertices; }
  const EdgeSet& edges() const { return _edges; }
  EdgeSet& edges() { return _edges; }

  /// Returns false if the id of the vertex is taken.
  virtual bool addVertex(Vertex* v);
  /// Returns false if the edge is already in the graph, has an empty position, or has the same vertex twice.
  virtual bool addEdge(Edge* e);
  /// Sets position `pos` of an edge to `v`, which may be nullptr.
  virtual bool setEdgeVertex(Edge* e, int pos, Vertex* v);
  /// Replaces `small` by `big` in all edges and removes the edges between the two vertices. If `erase` is
  /// true, also removes `small`. Returns false and changes nothing if an edge does not accept `big`.
  virtual bool mergeVertices(Vertex* big, Vertex* small, bool erase);
  /// Sets the position of `v` in each of its edges to nullptr.
  virtual bool detachVertex(Vertex* v);
  /// Returns false if `newId` is taken.
  virtual bool changeId(Vertex* v, int newId);

 protected:
  VertexIDMap _vertices;
  EdgeSet _edges;

 private:
  /// Returns whether `v` is in the graph. If not, logs an error that names the caller.
  bool has(const Vertex* v, const char* caller) const;
};

}  // namespace g2o

#endif  // G2O_AIS_HYPER_GRAPH_HH
