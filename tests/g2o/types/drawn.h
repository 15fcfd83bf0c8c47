// SPDX-License-Identifier: BSD-3-Clause
// Functions that read graphs from text, and that return the output of the actions "draw" and "writeGnuplot"
// as text.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/sparse_optimizer.h"

namespace drawn_graph {

inline std::unique_ptr<g2o::SparseOptimizer> read(const std::string& text) {
  auto graph = std::make_unique<g2o::SparseOptimizer>();
  std::istringstream in(text);
  EXPECT_TRUE(graph->load(in));
  return graph;
}

inline g2o::HyperGraphElementAction* action(const std::string& name) {
  return g2o::HyperGraphActionLibrary::instance()->actionByName(name);
}

/// Records the drawn shapes as text.
struct Record : g2o::Drawing {
  static std::string words(const g2o::Vector3& v) {
    std::ostringstream text;
    text << "(" << v.x() << " " << v.y() << " " << v.z() << ")";
    return text.str();
  }

  void polyline(const std::vector<g2o::Vector3>& corners, bool isClosed, const g2o::Color&,
                double width) override {
    out << (isClosed ? "ring" : "line") << width;
    for (const g2o::Vector3& c : corners) out << " " << words(c);
    out << '\n';
  }
  void point(const g2o::Vector3& at, const g2o::Color&, double diameter) override {
    out << "point" << diameter << " " << words(at) << "\n";
  }
  void pose(const g2o::Isometry3& pose, const g2o::Color&, double length, double width) override {
    out << "pose" << length << "x" << width << " " << words(pose.translation()) << "\n";
  }
  void text(const g2o::Vector3&, const std::string& words, const g2o::Color&, double) override {
    out << "text " << words << '\n';
  }
  std::ostringstream out;
};

inline std::string drawn(g2o::HyperGraph& graph) {
  Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  g2o::applyAction(&graph, action("draw"), &parameters);
  return record.out.str();
}

inline std::string gnuplot(g2o::HyperGraph& graph) {
  std::ostringstream out;
  g2o::WriteGnuplotAction::Parameters parameters;
  parameters.os = &out;
  g2o::applyAction(&graph, action("writeGnuplot"), &parameters);
  return out.str();
}

inline int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

}  // namespace drawn_graph
