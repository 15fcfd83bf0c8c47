// SPDX-License-Identifier: BSD-3-Clause
// The protocol with which a robot sends its graph while it drives, and asks for the result:
//
//     ADD VERTEX_XYT id [x y theta];             ADD EDGE_XYT [edge] from to x y theta Ω;
//     ADD VERTEX_XYZRPY id [x y z r p y];        ADD EDGE_XYZRPY [edge] from to x y z r p y Ω;
//     FIX id …;   SOLVE_STATE;   QUERY_STATE [id …];
//
// Meters and radians; Ω is the upper triangle by rows, in the units of the measurement; the rotation of x y z
// r p y is Rz(y) Ry(p) Rx(r). A vertex without an estimate, and a vertex that an edge mentions first, is
// placed by its first edge.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "boxplus/io/tag.h"
#include "guess/placement.h"
#include "protocol/command_stream.h"

namespace boxplus::app {

struct ProtocolLimits {
  Id max_id = 2147483647;  ///< the ids of g2o are ints
  std::size_t max_vertices = 10'000'000, max_edges = 100'000'000;
};

/// Executes commands on a graph.
class Protocol {
 public:
  /// `graph` must outlive this object. `name` is the name of the stream in messages. `solve` is what the
  /// program does at SOLVE_STATE.
  Protocol(Graph& graph, std::string name, std::function<void()> solve, const ProtocolLimits& limits = {});

  /// Executes a command, and appends its answer to `answer`. Only QUERY_STATE has one: a line BEGIN, a line
  /// per vertex as in ADD, by ascending id or as they were asked for, and a line END. Throws InputError for a
  /// command that is unknown or malformed, for unknown, repeated and too large ids, and if the graph becomes
  /// too large. The command has then changed nothing.
  void execute(const CommandText& command, std::string& answer);

 private:
  void execute(FieldReader& in, std::string& answer);
  void add(FieldReader& in);
  void add_vertex(const Tag& tag, FieldReader& in);
  void add_edge(const Tag& tag, FieldReader& in);
  void fix(FieldReader& in);
  void query(FieldReader& in, std::string& answer) const;

  Id read_id(FieldReader& in, const char* what) const;
  VertexRef known(FieldReader& in) const;
  std::vector<VertexRef> known_to_end(FieldReader& in) const;

  Graph& graph_;
  Placement placement_;
  std::string name_;
  std::function<void()> solve_;
  ProtocolLimits limits_;
};

}  // namespace boxplus::app
