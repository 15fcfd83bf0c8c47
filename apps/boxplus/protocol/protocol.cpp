// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/protocol.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "io/without_place.h"

namespace boxplus::app {
namespace {

/// A type of the protocol, and the tag of a file whose lines have the same fields.
struct TypeName {
  std::string_view name, tag;
};
constexpr std::array kTypes{TypeName{"VERTEX_XYT", "VERTEX_SE2"}, TypeName{"VERTEX_XYZRPY", "VERTEX3"},
                            TypeName{"EDGE_XYT", "EDGE_SE2"}, TypeName{"EDGE_XYZRPY", "EDGE3"}};

[[noreturn]] void refuse(FieldReader& in, FieldPlace place, const char* expected, std::string_view came) {
  in.fail(place, fmt::format("expected {}, got '{}'", expected, came));
}

int count_fields(FieldReader in) {
  int count = 0;
  for (; !in.at_end(); in.token("a field")) ++count;
  return count;
}

/// Roll, pitch and yaw of R = Rz(yaw) Ry(pitch) Rx(roll). If the pitch is ±π/2, the roll is 0.
std::array<double, 3> angles_of(const Matrix<double, 3, 3>& R) {
  const double cosine = std::hypot(R(0, 0), R(1, 0)), pitch = std::atan2(-R(2, 0), cosine);
  constexpr double kVertical = 1e-12;
  if (cosine < kVertical) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

void write_vertex(const Graph& graph, VertexRef vertex, std::string& text) {
  FieldWriter out(text);
  const bool in_plane = graph.tangent_dim(vertex) == Manifold<SE2>::kDim;
  out.token(in_plane ? "VERTEX_XYT" : "VERTEX_XYZRPY");
  out.integer(graph.id(vertex));
  if (in_plane) {
    const SE2& pose = graph.estimate(graph.typed<SE2>(vertex));
    for (const double value : {pose.x(), pose.y(), pose.theta()}) out.number(value);
  } else {
    const SE3& pose = graph.estimate(graph.typed<SE3>(vertex));
    for (const double value : pose.translation()) out.number(value);
    for (const double value : angles_of(pose.rotation())) out.number(value);
  }
  out.end_line();
}

}  // namespace

Protocol::Protocol(Graph& graph, std::string name, std::function<void()> solve, const ProtocolLimits& limits)
    : graph_(graph), placement_(graph), name_(std::move(name)), solve_(std::move(solve)), limits_(limits) {}

void Protocol::execute(const CommandText& command, std::string& answer) {
  FieldReader in(name_, 1, command.text);
  try {
    execute(in, answer);
  } catch (const InputError& error) {
    const auto [line, column] = command.place_of(static_cast<std::size_t>(error.column() - 1));
    throw InputError(name_, line, column, without_place(error, name_));
  }
}

void Protocol::execute(FieldReader& in, std::string& answer) {
  const FieldPlace place = in.place();
  const std::string_view word = in.token("a command");
  if (word == "ADD") return add(in);
  if (word == "FIX") return fix(in);
  if (word == "QUERY_STATE") return query(in, answer);
  if (word != "SOLVE_STATE") refuse(in, place, "ADD, FIX, QUERY_STATE or SOLVE_STATE", word);
  in.expect_end();
  solve_();
}

void Protocol::add(FieldReader& in) {
  const FieldPlace place = in.place();
  const std::string_view name = in.token("a type");
  for (const TypeName& type : kTypes) {
    if (type.name != name) continue;
    const Tag& tag = *default_registry().find(type.tag);
    return tag.kind == Tag::Kind::kVertex ? add_vertex(tag, in) : add_edge(tag, in);
  }
  refuse(in, place, "VERTEX_XYT, VERTEX_XYZRPY, EDGE_XYT or EDGE_XYZRPY", name);
}

Id Protocol::read_id(FieldReader& in, const char* what) const {
  const FieldPlace place = in.place();
  const Id id = in.integer(what);
  if (id < 0 || id > limits_.max_id)
    in.fail(place, fmt::format("expected {} from 0 to {}, got {}", what, limits_.max_id, id));
  return id;
}

void Protocol::add_vertex(const Tag& tag, FieldReader& in) {
  const FieldPlace place = in.place();
  const Id id = read_id(in, "the id of a vertex");
  if (graph_.find_vertex(id))
    in.fail(place, fmt::format("expected a new id, but vertex {} is already there", id));
  if (graph_.vertex_count() >= limits_.max_vertices)
    in.fail(place, fmt::format("expected at most {} vertices", limits_.max_vertices));
  if (!in.at_end()) {
    tag.read_vertex(graph_, id, in);
    return;
  }
  const bool in_plane = tag.name == "VERTEX_SE2";
  placement_.expect(in_plane ? VertexRef(graph_.add_vertex(SE2(), id)) : graph_.add_vertex(SE3(), id));
}

void Protocol::add_edge(const Tag& tag, FieldReader& in) {
  const bool in_plane = tag.name == "EDGE_SE2";
  const int values = in_plane ? 3 + 6 : 6 + 21, ids = 2;
  if (count_fields(in) != ids + values) read_id(in, "the id of an edge");
  std::array<Id, 2> ends{};
  std::array<FieldPlace, 2> places;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    places[k] = in.place();
    ends[k] = read_id(in, "the id of a vertex");
    const std::optional<VertexRef> vertex = graph_.find_vertex(ends[k]);
    const int dimension = in_plane ? Manifold<SE2>::kDim : Manifold<SE3>::kDim;
    if (vertex && graph_.tangent_dim(*vertex) != dimension) {
      in.fail(places[k], fmt::format("expected a pose {}, but vertex {} is another one",
                                     in_plane ? "in the plane" : "in space", ends[k]));
    }
  }
  if (ends[0] == ends[1]) in.fail(places[1], fmt::format("expected two vertices, got {} twice", ends[0]));
  FieldReader rest = in;
  tag.check_edge(rest);  // before vertices are added
  if (graph_.edge_count() >= limits_.max_edges || graph_.vertex_count() + 2 > limits_.max_vertices)
    in.fail(places[0], fmt::format("expected at most {} vertices and {} edges", limits_.max_vertices,
                                   limits_.max_edges));
  std::array<VertexRef, 2> vertices;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (const std::optional<VertexRef> vertex = graph_.find_vertex(ends[k])) {
      vertices[k] = *vertex;
    } else {
      vertices[k] =
          in_plane ? VertexRef(graph_.add_vertex(SE2(), ends[k])) : graph_.add_vertex(SE3(), ends[k]);
      placement_.expect(vertices[k]);
    }
  }
  placement_.place_by(tag.read_edge(graph_, vertices, in));
}

VertexRef Protocol::known(FieldReader& in) const {
  const FieldPlace place = in.place();
  const Id id = read_id(in, "the id of a vertex");
  if (const std::optional<VertexRef> vertex = graph_.find_vertex(id)) return *vertex;
  in.fail(place, fmt::format("expected the id of a vertex, but there is no vertex {}", id));
}

std::vector<VertexRef> Protocol::known_to_end(FieldReader& in) const {
  std::vector<VertexRef> vertices;
  while (!in.at_end()) vertices.push_back(known(in));
  return vertices;
}

void Protocol::fix(FieldReader& in) {
  std::vector<VertexRef> vertices{known(in)};
  for (const VertexRef& vertex : known_to_end(in)) vertices.push_back(vertex);
  for (const VertexRef& vertex : vertices) {
    graph_.fix(vertex);
    placement_.keep(vertex);
  }
}

void Protocol::query(FieldReader& in, std::string& answer) const {
  const std::vector<VertexRef> vertices = in.at_end() ? graph_.all_vertices() : known_to_end(in);
  answer += "BEGIN\n";
  for (const VertexRef& vertex : vertices) write_vertex(graph_, vertex, answer);
  answer += "END\n";
}

}  // namespace boxplus::app
