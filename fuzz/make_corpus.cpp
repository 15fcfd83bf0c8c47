// SPDX-License-Identifier: BSD-3-Clause
// make_corpus FORMAT FOLDER: writes the seeds of a fuzz target to FOLDER, and the tags of the format to
// FOLDER.dict. The seeds are small graphs in the given format.
#include <cstdio>
#include <filesystem>
#include <fstream>
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

/// One graph per tag, with the example of the tag.
std::vector<std::string> examples(const Registry& registry) {
  std::vector<std::string> texts;
  for (const std::string& name : registry.names()) texts.push_back(registry.example(name));
  return texts;
}

/// A text with features that the other seeds do not have: comments, unknown tags, the vertex id −1,
/// and several ids after FIX.
std::string odds() {
  return "# a comment\nVERTEX_SE2 0 0 0 0 # another\nROBOTLASER1 0 1 2\n"
         "ROBOTLASER1 0 -1 2 1 10 0 0 2 1.5 2 1 0.5 0 0 0 0 0 0 0 0 0 0 0 1.0 robot 2\nVERTEX_TAG x 1 0 0 0 "
         "0 0 1 h 2\n"
         "VERTEX_ELLIPSE 1 0 0 1 0 1 1 2 3\nRAWLASER1 0 -1 2 1 10 0 0 1 1.5 0 1 h 2\nVERTEX_SE2 3 1 +0 "
         "1e-3\r\n"
         "FIX 0 3\n\nEDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 3 1 0 0 1 0 0 1 0 1\nUNKNOWN\n";
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
  for (const char* name : {"cameras", "images", "points3D", "rigs", "frames"}) {
    const std::filesystem::path path = (std::filesystem::path(folder) / name).string() + extension;
    if (!std::filesystem::exists(path)) break;
    std::string memory;
    if (!text.empty()) text += "====\n";
    text += TextSource::of_file(path.string()).text(memory);
  }
  return text;
}

/// A model of two cameras and an IMU on a rig, whose files are in the folder for a moment.
GraphFile rig(const std::string& folder) {
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(std::filesystem::path(folder) / name) << text;
  };
  write("cameras.txt", "1 PINHOLE 9 9 5 5 3 3\n2 PINHOLE 9 9 5 5 3 3\n");
  write("images.txt", "1 1 0 0 0 0 0 2 1 a\n2 2 1\n2 1 0 0 0 3 0 2 2 b\n1 2 1\n");
  write("points3D.txt", "1 0 0 5 0 0 0 -1 1 0 2 0\n");
  write("rigs.txt", "1 3 CAMERA 1 CAMERA 2 1 1 0 0 0 3 0 0 IMU 1 0\n");
  write("frames.txt", "1 1 1 0 0 0 0 0 2 3 CAMERA 1 1 CAMERA 2 2 IMU 1 7\n");
  GraphFile file = read_graph(folder);
  std::filesystem::remove_all(folder);
  return file;
}

/// A model with two images of one camera as text and binary, one with a camera of each image, and one with a
/// rig.
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
  std::filesystem::remove_all(folder);
  for (const GraphFile& each : {file, parse_graph(bal(), "bal"), rig(folder)}) {
    for (const auto& [format, extension] : {std::pair{"COLMAP-text", ".txt"}, {"COLMAP", ".bin"}}) {
      std::filesystem::remove_all(folder);
      write_graph(folder, each, {.format = format});
      seeds.push_back(joined_files(folder, extension));
    }
  }
  std::filesystem::remove_all(folder);
  return seeds;
}

/// A graph with every member that an element may have.
std::string attributes() {
  return R"({"kept": [{"after_edge": 0, "text": "# \u00e9"}, {"bytes": [35, 255]}], "format": "boxplus graph",
"parameters": [{"tag": "PARAMS_SE2OFFSET", "id": 5, "fields": [1, 0, 0.25], "fixed": false}], "version": 1,
"vertices": [{"tag": "VERTEX_SE2", "id": 0, "fields": [0, 0, 0], "fixed": true},
{"tag": "VERTEX_XY", "id": 2, "fields": [2, 3e0], "fixed_directions": [1], "eliminated": true}],
"edges": [{"ids": [0, 2, 5], "tag": "EDGE_SE2_POINTXY_OFFSET", "information": [1, 0, 1], "fields": [1, 1],
"kernel": {"width": 0.5, "name": "Barron:1.5"}, "level": -1, "enabled": false}]})";
}

/// The messages of a log, with a scan before the first pose and a pose that occurs twice.
std::string carmen() {
  return "# CARMEN Logfile\nPARAM robot_length 0.5 1 host 0.1\n"
         "RAWLASER1 0 -1 2 1 10 0 0 2 1.5 2 0 1 host 0.2\nODOM 0 0 0 0 0 0 1 host 0.3\n"
         "FLASER 3 1 2 81.9 0.1 0 0 0 0 0 1 host 0.4\nODOM 1 0.1 0.2 0.5 0 0 2 host 0.5\n"
         "RLASER 2 1 2 0.9 0 3.1 1.5 0.1 0.2 2 host 0.6\nSYNC x 2 host 0.7\n"
         "ROBOTLASER1 0 -1 2 1 10 0 0 2 1.5 2 1 0.5 2 0 0 2 0.1 3 0 0 0 0 0 3 host 0.8\n";
}

/// Poses with a scan, with the older names of tags.
std::string gm2dl() {
  return "VERTEX 0 0 0 0\nROBOTLASER1 0 -1 2 1 10 0 0 1 1.5 0 0 0 0 0 0 0 0 0 0 0 0 1 host 2\n"
         "VERTEX 1 1 0 0.5\nEDGE 0 1 1 0 0.5 4 1 3 2 0 0.5\n";
}

/// Measurements in the plane and in space. The first text has a landmark with the id of a pose.
std::vector<std::string> isam() {
  const std::string plane =
      "ODOMETRY 0 1 1 0 0.5 10 0 0 10 0 20\nODOMETRY 1 2 1 0 0.5 10 1 2 10 3 20\n"
      "LANDMARK 0 1 2 3 5 1 5\nLANDMARK 2 1 -1 3 5 0 5\nEDGE2 0 2 2 0 1 1 0 0 1 0 1\nCAMERA 1 2\n";
  const std::string space =
      "ODOMETRY3 0 1 1 0 0.5 0.1 -0.2 3 3 0 0 0 0 0 3 0 0 0 0 3 0 0 0 2 0 0 2 0 2\n"
      "POINT3 1 7 1 2 3 5 0 1 5 0 5\n";
  return {plane, space};
}

/// Commands, and the parts of requests as lines (fuzz_view_request.cpp).
std::vector<std::string> view_requests() {
  const std::string post =
      "POST\n/command\n127.0.0.1:8743\nhttp://127.0.0.1:8743\nsame-origin\napplication/json\n"
      "0123456789abcdef0123456789abcdef\n";
  return {R"({"type": "optimize", "settings": {"algorithm": "dogleg", "iterations": "20"}})",
          R"({"type": "edit", "edit": "scale", "factor": "0.5", "structure": "3", "line": "7"})",
          R"({"type": "guess", "start": "odometry"})", "structure\n3\nvertex\n7\n", post};
}

/// Streams of commands (fuzz_protocol.cpp).
std::vector<std::string> protocols() {
  return {
      "ADD VERTEX_XYT 0 1 2 0.5;\nFIX 0; # a comment\nADD VERTEX_XYT 1;\n"
      "ADD EDGE_XYT 7 0 1 1 0 0.1 1 0 0 1 0 1; ADD EDGE_XYT 1 2 1 0\n0.1 1 0 0 1 0 1;\n"
      "SOLVE_STATE;QUERY_STATE;\nQUERY_STATE 1 2;",
      "ADD VERTEX_XYZRPY 3 1 2 3 0.1 1.5707963267948966 -0.3;\n"
      "ADD EDGE_XYZRPY 3 4 1 0 0 0.1 0 0.2 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1;\nQUERY_STATE;\n"};
}

/// The tags of the lines of a format. A TORO file has only the tags of TORO.
Registry tags(const std::string& format) {
  Registry registry;
  if (format == "g2o" || format == "json") registry = default_registry();
  if (format == "toro" || format == "gm2dl") register_toro(registry);
  return registry;
}

/// Returns the seeds for a format. The list is empty if there are no seeds for the format.
std::vector<std::string> seeds(const std::string& format) {
  if (format == "bal") return {bal(), "1 1 0\n0 0 0 0 0 0 500 0 0\n1 2 3\n", "0 0 0\n"};
  if (format == "colmap") return colmap();
  if (format == "carmen") return {carmen()};
  if (format == "gm2dl") return {gm2dl()};
  if (format == "isam") return isam();
  if (format == "view_request") return view_requests();
  if (format == "protocol") return protocols();
  std::vector<std::string> all = examples(tags(format));
  if (format == "toro") return all;
  all.push_back(odds());
  for (const World world : kWorlds) all.push_back(simulated(world));
  if (format != "json") return all;
  for (std::string& text : all) text = format_graph(parse_graph(text, "seed"), {.format = "json"});
  all.push_back(attributes());
  return all;
}

void write_corpus(const std::string& format, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int count = 0;
  for (const std::string& text : seeds(format))
    write_file(folder / (std::to_string(count++) + "." + format), text);
  std::string dictionary;
  for (const std::string& name : tags(format).names()) dictionary += '"' + name + "\"\n";
  write_file(folder.string() + ".dict", dictionary);
}

}  // namespace
}  // namespace boxplus

int main(int argc, char** argv) {
  if (argc != 3 || boxplus::seeds(argv[1]).empty()) {
    std::fprintf(
        stderr,
        "usage: make_corpus bal|carmen|colmap|g2o|gm2dl|isam|json|protocol|toro|view_request FOLDER\n");
    return 2;
  }
  boxplus::write_corpus(argv[1], argv[2]);
}
