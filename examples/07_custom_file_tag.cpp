// SPDX-License-Identifier: BSD-3-Clause
// Custom tags in files: if a type is in the registry, boxplus reads, optimizes and writes it like a
// ready-made type.
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
/// The fields in a file: x and y of the beacon, then the distance. boxplus itself reads and writes the vertex
/// ids before these fields, and Ω after them. (FileFields<T> defines the fields of a vertex of type T in the
/// same way.)
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
    "SCAN is an unknown tag; the line is kept\n";

int main() {
  // [registry]
  Registry registry = default_registry();
  registry.edge<BeaconRange, Vector2>("EDGE_BEACON_RANGE");

  ReadOptions options;
  options.registry = &registry;
  GraphFile file = parse_graph(kText, "beacons.g2o", options);  // for a file: read_graph(path, options)
  const Report report = optimize(file.graph);
  std::cout << format_graph(file, {.registry = &registry});  // for a file: write_graph(path, …)
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
