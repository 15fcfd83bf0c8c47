// SPDX-License-Identifier: BSD-3-Clause
// Files with custom tags: a type that is added to the registry is read, optimized and written like any other.
#include <boxplus/boxplus.h>
#include <boxplus/io/registry.h>

#include <iostream>

using namespace boxplus;

/// The distance (meters) of a point from a beacon at a known position.
struct BeaconRange {
  Vector2 beacon;
  double measurement;

  template <class Point>
  auto error(const Point& point) const {
    return (point - beacon).norm() - measurement;
  }
};

// [fields]
/// In a file: the beacon's x and y, then the distance. The reader handles the vertex ids before these fields
/// and Ω after them. (FileFields<T> does the same for the value of a vertex.)
template <>
struct boxplus::EdgeFields<BeaconRange> {
  static BeaconRange read(FieldReader& in) {
    const Vector2 beacon = FileFields<Vector2>::read(in);
    return {beacon, in.number("a distance")};
  }
  static void write(const BeaconRange& edge, FieldWriter& out) {
    FileFields<Vector2>::write(edge.beacon, out);
    out.number(edge.measurement);
  }
};
// [/fields]

constexpr const char* kText =
    "VERTEX_XY 0 2.5 0.5\n"
    "EDGE_BEACON_RANGE 0 10 0 8.06 100\n"
    "EDGE_BEACON_RANGE 0 0 10 9.22 100\n"
    "ROBOTLASER1 a line with an unknown tag is kept\n";

int main() {
  // [registry]
  Registry registry = default_registry();
  registry.edge<BeaconRange, Vector2>("EDGE_BEACON_RANGE");

  ReadOptions options;
  options.registry = &registry;
  GraphFile file = parse_graph(kText, "beacons.g2o", options);  // read_graph(path, options) for a file
  const Report report = optimize(file.graph);
  std::cout << format_graph(file, {.registry = &registry});  // write_graph(path, …) for a file
  // [/registry]

  // [misuse]
  try {
    parse_graph("VERTEX_XY 0 2.5 0.5\nEDGE_BEACON_RANGE 0 10 nought 10 100\n", "beacons.g2o", options);
  } catch (const InputError& error) {
    std::cout << error.what() << "\n";
  }
  // [/misuse]

  const auto robot = file.graph.vertex<Vector2>(0);
  const bool is_right = (file.graph.estimate(robot) - Vector2(2, 1)).norm() < 0.01 && file.kept.size() == 1;
  return report.converged() && is_right ? 0 : 1;
}
