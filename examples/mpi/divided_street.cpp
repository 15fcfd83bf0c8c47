// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment in several processes: `mpirun -n 4 divided_street`. Each process makes its own points,
// and the cameras that see them. No process has the whole graph.
#include <boxplus/boxplus.h>
#include <boxplus/mpi/distributed_optimizer.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

/// The image of a point in a camera that looks along its z axis.
struct Image {
  Vector2 measurement;
  template <class S, class Point>
  Vector<S, 2> error(const BasicSE3<S>& camera, const Point& point) const {
    const auto p = camera.inverse_times(point);
    return Vector<S, 2>(p[0] / p[2], p[1] / p[2]) - measurement;
  }
};

constexpr int kCameras = 40, kPointsPerCamera = 15, kPoints = kCameras * kPointsPerCamera;
SE3 true_camera(int i) {
  return SE3(Vector3(i, 0, 0), SO3());
}
Vector3 true_point(int k) {
  return Vector3(k / kPointsPerCamera, 3 * std::sin(2.1 * k), 8 + 3 * std::sin(3.7 * k));
}

/// Every process gives a camera the same id and the same estimate. Two known cameras determine the scale.
VertexHandle<SE3> camera(Graph& graph, int i) {
  if (graph.find_vertex(i)) return graph.vertex<SE3>(i);
  const Vector3 offset = i < 2 ? Vector3(0, 0, 0) : 0.1 * Vector3(std::sin(i), std::cos(i), std::sin(2 * i));
  const auto vertex = graph.add_vertex(true_camera(i) * SE3(offset, SO3()), i);
  if (i < 2) graph.fix(vertex);
  return vertex;
}

/// A point is in one process, with all of its edges, and is eliminated there.
void add_point(Graph& graph, int k) {
  const auto point = graph.add_vertex(Vector3(1.05 * true_point(k)), kCameras + k);
  graph.set_eliminated(point, true);
  const int nearest = k / kPointsPerCamera;
  for (int i = std::max(0, nearest - 3); i <= std::min(kCameras - 1, nearest + 3); ++i)
    graph.add_edge(Image{Image{Vector2(0, 0)}.error(true_camera(i), true_point(k))}, camera(graph, i), point);
}

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, processes = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &processes);
  Graph graph;
  for (int k = rank * kPoints / processes; k < (rank + 1) * kPoints / processes; ++k) add_point(graph, k);
  const DistributedReport report = DistributedOptimizer(MPI_COMM_WORLD, graph).run();
  std::printf("process %d has %u of %u edges; chi2 %.3g -> %.1g\n", rank, report.own_edges, report.edges,
              report.chi2_initial, report.chi2_final);
  MPI_Finalize();
  return report.converged() && report.chi2_final < 1e-12 ? 0 : 1;
}
