// SPDX-License-Identifier: BSD-3-Clause
// A parameter: a constant that many edges share, such as the pose of a sensor on the robot.
//
// A parameter is a vertex that is fixed when it is added. In a .g2o file, the tag of a parameter begins with
// PARAMS_. To calibrate the parameter, call unfix().
#include <boxplus/boxplus.h>
#include <boxplus/types/slam2d.h>

#include <cstdio>
#include <vector>

using namespace boxplus;

int main() {
  const SE2 true_offset(0.3, 0.1, 0.05);

  // [parameter]
  Graph graph;
  const auto offset = graph.add_parameter(SE2(0.3, 0, 0));  // taken from the drawing of the robot
  // [/parameter]
  std::vector<VertexHandle<Vector2>> landmarks;
  for (const Vector2& at : {Vector2(4, 1), Vector2(-2, 5), Vector2(1, -3)})
    landmarks.push_back(graph.add_vertex(at));
  for (int i = 0; i < 6; ++i) {
    const SE2 pose(0.5 * i, 0.1 * i * i, 0.6 * i);
    const auto robot = graph.add_vertex(pose);
    graph.add_edge(Prior(pose), 1e4, robot);  // the pose of the robot is known from another source
    for (const auto& landmark : landmarks) {
      const SE2 sensor = pose * true_offset;
      const OffsetPointObservation2 seen(sensor.inverse() * graph.estimate(landmark));
      graph.add_edge(seen, 100.0, robot, landmark, offset);
    }
  }

  const Report trusted = optimize(graph);
  // [unfix]
  graph.unfix(offset);
  const Report calibrated = optimize(graph);
  // [/unfix]
  const SE2& found = graph.estimate(offset);
  std::printf("chi2 %.3f with the offset from the drawing, %.3f with the calibrated offset\n",
              trusted.chi2_final, calibrated.chi2_final);
  std::printf("the sensor is mounted at (%.3f, %.3f) m, turned by %.3f rad\n", found.x(), found.y(),
              found.theta());
  return trusted.chi2_final > 0.1 && (found.vector() - true_offset.vector()).norm() < 1e-6 ? 0 : 1;
}
