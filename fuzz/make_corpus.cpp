// SPDX-License-Identifier: BSD-3-Clause
// make_corpus FORMAT FOLDER: writes the seeds of a fuzz target to FOLDER. The seeds are small graphs in the
// given format.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "boxplus/io/text_source.h"
#include "boxplus/io/write_file.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

std::string simulated(World world) {
  Simulation simulation = simulate(world, {.poses = 4});
  GraphFile file;
  file.graph = std::move(simulation.graph);
  file.edges = std::move(simulation.edges);
  return format_graph(file);
}

/// A 2-D graph with the tags that the simulators do not write.
std::string plane() {
  GraphFile file;
  Graph& graph = file.graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0)), b = graph.add_vertex(SE2(1, 0.5, -3));
  const auto p = graph.add_vertex(Vector2(2, 1)), q = graph.add_vertex(Vector2(-2, 1e-300));
  const auto wheels = graph.add_vertex(DifferentialDrive{1, 1, 0.5});
  const auto mount = graph.add_vertex(SE2(0.1, 0, 0.2));
  const auto sensor = graph.add_parameter(SE2(0.2, 0, 0)), other = graph.add_parameter(SE2(0, 0.3, 1));
  graph.fix(a);
  Eigen::Matrix3d full;
  full << 4, 1, 0, 1, 3, 0.5, 0, 0.5, 2;
  graph.add_edge(Between(SE2(1, 0, 0)), full, a, b);
  graph.add_edge(BearingObservation2(0.5), 10.0, a, p);
  graph.add_edge(Prior(SE2(0, 0, 0)), a);
  graph.add_edge(PositionPrior(Vector2(1, 0)), b);
  graph.add_edge(Prior(Vector2(1, 0)), p);
  graph.add_edge(Between(Vector2(1, 0)), p, q);
  graph.add_edge(OffsetPointObservation2(Vector2(1, 0)), a, p, sensor);
  graph.add_edge(OffsetPointObservation2(Vector2(1, 0)), a, p, mount);
  graph.add_edge(OffsetBetween(SE2(1, 0, 0)), a, b, sensor, other);
  graph.add_edge(OffsetBetween(SE2(1, 0, 0)), a, b, sensor);
  graph.add_edge(OffsetBetween(SE2(1, 0, 0)), a, b, mount);
  graph.add_edge(WheelOdometry(WheelSpeeds{1, 1.1, 0.1}), a, b, wheels);
  graph.add_edge(TwoPointsObservation2({1, 0, 2, 0}), a, p, q);
  graph.add_edge(PointsObservation2(Vector<double, kDynamic>(Eigen::VectorXd::Ones(4))), a,
                 std::vector{p, q});
  return format_graph(file);
}

std::string space() {
  GraphFile file;
  Graph& graph = file.graph;
  const auto a = graph.add_vertex(SE3()), b = graph.add_vertex(SE3(Vector3(1, 0, 0), SO3()));
  const auto p = graph.add_vertex(Vector3(2, 1, 0)), q = graph.add_vertex(Vector3(-2, 1, 5));
  const auto sensor = graph.add_parameter(SE3()), other = graph.add_parameter(SE3());
  graph.fix(a);
  graph.add_edge(OffsetPointObservation3(Vector3(1, 0, 0)), a, p, sensor);
  graph.add_edge(OffsetPrior(SE3()), a, sensor);
  graph.add_edge(PositionPrior(Vector3(1, 0, 0)), b, sensor);
  graph.add_edge(OffsetBetween(SE3()), a, b, sensor, other);
  graph.add_edge(OffsetBetween(SE3()), a, b, sensor);
  graph.add_edge(Between(Vector3(1, 0, 0)), p, q);
  graph.add_edge(Prior(Vector3(1, 0, 0)), p);
  graph.add_edge(PointsObservation3(Vector<double, kDynamic>(Eigen::VectorXd::Ones(6))), a,
                 std::vector{p, q});
  return format_graph(file);
}

/// A text with features that the other seeds do not have: comments, unknown tags, the vertex id −1,
/// and several ids after FIX.
std::string odds() {
  return "# a comment\nVERTEX_SE2 0 0 0 0 # another\nROBOTLASER1 0 1 2\nVERTEX_SE2 3 1 +0 1e-3\r\n"
         "FIX 0 3\n\nEDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 3 1 0 0 1 0 0 1 0 1\nUNKNOWN\n";
}

/// A graph in the format of TORO, which has other tags and another order of the entries of Ω. boxplus can
/// read this format, but cannot write it.
std::string toro_plane() {
  const Simulation simulation = simulate(World::kManhattan, {.poses = 4});
  std::string text;
  FieldWriter out(text);
  for (const VertexRef& vertex : simulation.graph.all_vertices()) {
    out.token("VERTEX2");
    out.integer(simulation.graph.id(vertex));
    FileFields<SE2>::write(simulation.graph.estimate(simulation.graph.typed<SE2>(vertex)), out);
    out.end_line();
  }
  for (const EdgeRef& edge : simulation.edges) {
    out.token("EDGE2");
    for (const VertexRef& vertex : simulation.graph.vertices(edge)) out.integer(simulation.graph.id(vertex));
    FileFields<SE2>::write(simulation.graph.measurement(EdgeHandle<Between<SE2>>{edge}).measurement, out);
    const detail::InformationView omega = simulation.graph.information(edge);
    for (const auto& [i, j] : {std::pair{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}})
      out.number(omega(i, j));
    out.end_line();
  }
  return text;
}

std::string toro_space() {
  return "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 0 0.5 0.1 -0.2 3\n"
         "EDGE3 0 1 1 0 0.5 0.1 -0.2 3 9 0 0 0 0 0 9 0 0 0 0 9 0 0 0 4 0 0 4 0 4\n";
}

/// Two cameras, three points, and an observation that occurs twice.
std::string bal() {
  GraphFile file;
  Graph& graph = file.graph;
  using Camera = Product<SE3, BalCamera>;
  const auto a = graph.add_vertex(Camera(SE3(), BalCamera(500, -0.1, 0.01)));
  const auto b = graph.add_vertex(
      Camera(SE3(Vector3(1, 0, 0), SO3::from_rotation_vector(Vector3(0.1, 2, -0.3))), BalCamera(400, 0, 0)));
  const auto p = graph.add_vertex(Vector3(0.5, 1, -10)), q = graph.add_vertex(Vector3(-2, 0, -8));
  graph.add_vertex(Vector3(0, 1e-300, 0));
  for (const auto& [u, v] : {std::pair{-10.5, 20.0}, {3.0, 4e-5}}) {
    graph.add_edge(Reprojection<BalCamera>(Vector2(u, v)), a, p);
    graph.add_edge(Reprojection<BalCamera>(Vector2(v, u)), b, q);
  }
  return format_graph(file, {.format = "BAL"});
}

/// Returns the files of a model, as fuzz_colmap.cpp expects them. `extension` is that of the files.
std::string joined_files(const std::string& folder, const std::string& extension) {
  std::string text;
  for (const char* name : {"cameras", "images", "points3D"}) {
    std::string memory;
    if (!text.empty()) text += "====\n";
    text += TextSource::of_file((std::filesystem::path(folder) / name).string() + extension).text(memory);
  }
  return text;
}

/// A model with two images of one camera as text and binary, and one with a camera of each image.
std::vector<std::string> colmap() {
  GraphFile file;
  Graph& graph = file.graph;
  const auto camera = graph.add_parameter(OpenCvCamera(500, 510, 320, 240, -0.1, 0.01, 1e-3, -1e-3));
  const auto a = graph.add_vertex(SE3());
  const auto b = graph.add_vertex(SE3(Vector3(1, 0, 0), SO3::from_rotation_vector(Vector3(0.1, 0.2, -0.3))));
  const auto p = graph.add_vertex(Vector3(0.5, 1, 10)), q = graph.add_vertex(Vector3(-2, 0, 8));
  for (const auto& pose : {a, b}) {
    graph.add_edge(Reprojection<OpenCvCamera>(Vector2(10.5, 20)), pose, p, camera);
    graph.add_edge(Reprojection<OpenCvCamera>(Vector2(300, 1e-5)), pose, q, camera);
  }
  std::vector<std::string> seeds;
  const std::string folder = (std::filesystem::temp_directory_path() / "boxplus_make_corpus").string();
  for (const GraphFile& each : {file, parse_graph(bal(), "bal")}) {
    for (const auto& [format, extension] : {std::pair{"COLMAP-text", ".txt"}, {"COLMAP", ".bin"}}) {
      std::filesystem::remove_all(folder);
      write_graph(folder, each, {.format = format});
      seeds.push_back(joined_files(folder, extension));
    }
  }
  std::filesystem::remove_all(folder);
  return seeds;
}

/// Commands, and the parts of requests as lines (fuzz_view_request.cpp).
std::vector<std::string> view_requests() {
  return {R"({"type": "optimize", "settings": {"algorithm": "dogleg", "iterations": "20"}})",
          R"({"type": "edit", "edit": "scale", "factor": "0.5", "structure": "3", "line": "7"})",
          R"({"type": "guess", "start": "odometry"})", "structure\n3\nvertex\n7\n",
          "POST\n/command\n127.0.0.1:8743\nhttp://127.0.0.1:8743\nsame-origin\napplication/json\n"
          "0123456789abcdef0123456789abcdef\n"};
}

/// Returns the seeds for a format. The list is empty if there are no seeds for the format.
std::vector<std::string> seeds(const std::string& format) {
  if (format == "toro") return {toro_plane(), toro_space()};
  if (format == "bal") return {bal(), "1 1 0\n0 0 0 0 0 0 500 0 0\n1 2 3\n", "0 0 0\n"};
  if (format == "colmap") return colmap();
  if (format == "view_request") return view_requests();
  if (format != "g2o") return {};
  std::vector<std::string> all{plane(), space(), odds()};
  for (const World world : kWorlds) all.push_back(simulated(world));
  return all;
}

void write_corpus(const std::string& format, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int count = 0;
  for (const std::string& text : seeds(format))
    write_file(folder / (std::to_string(count++) + "." + format), text);
}

}  // namespace
}  // namespace boxplus

int main(int argc, char** argv) {
  if (argc != 3 || boxplus::seeds(argv[1]).empty()) {
    std::fprintf(stderr, "usage: make_corpus bal|colmap|g2o|toro|view_request FOLDER\n");
    return 2;
  }
  boxplus::write_corpus(argv[1], argv[2]);
}
