// SPDX-License-Identifier: BSD-3-Clause
// The facts about a graph that `boxplus info` prints.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxplus/diagnose/diagnose.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/outliers/outliers.h"
#include "graph/graph_view.h"
#include "info/components.h"
#include "optimize/report_json.h"

namespace boxplus::app {

struct Degrees {
  std::size_t min = 0, max = 0;
  double mean = 0;
};

struct VertexTypeFacts {
  std::string tag;  ///< the tag in the file, or the name of the type if it has no tag
  VertexRole role = VertexRole::kOther;
  bool parameter = false;
  std::size_t count = 0, fixed = 0;
  std::size_t unknowns = 0;  ///< counted as by Report::scalars: without held vertices, and without vertices
                             ///< that have no edges
  Degrees degrees;           ///< the number of edges per vertex
};

struct EdgeFacts {
  EdgeRef edge;
  std::string tag;
  std::vector<Id> vertices;  ///< the ids of the vertices, without parameters
  double chi2 = 0;
  std::int64_t line = 0;  ///< the line in the file; 0 if it is not known
};

struct EdgeTypeFacts {
  std::string tag;
  std::size_t count = 0, rows = 0;  ///< `rows` is the sum of the rows (dimensions) of the errors of all edges
  double chi2 = 0;
  EdgeFacts worst;
};

struct FindingFacts {
  Finding finding;
  std::vector<EdgeFacts> edges;  ///< of `finding`
};

struct DiagnosisFacts {
  bool at_minimum = false;
  std::vector<FindingFacts> findings;
};

/// The verdicts on edges that may be false.
struct OutlierFacts {
  std::optional<OutlierReport> found;
  std::string obstacle;          ///< why there are no verdicts; empty if there are some
  std::vector<EdgeFacts> worst;  ///< the outliers with the largest chi2 against the estimates of the search
};

struct GraphFacts {
  std::vector<VertexTypeFacts> vertex_types;
  std::vector<EdgeTypeFacts> edge_types;
  std::array<std::size_t, kEdgeRoles> roles{};  ///< the number of edges with each EdgeRole
  std::vector<ComponentFacts> components;       ///< the components with edges, the largest first
  std::vector<Id> isolated;                     ///< the ids of the vertices without edges
  std::vector<EdgeFacts> worst;                 ///< the edges with the largest chi2, the worst one first
  std::size_t vertices = 0, parameters = 0, edges = 0, unknowns = 0, rows = 0;
  bool keeps_indefinite = false;  ///< they are used as given
  std::size_t indefinite = 0;     ///< edges whose Ω is indefinite in the file
  double chi2 = 0;
  KernelFacts kernel;        ///< the kernel of the command line; chi2 and `worst` are computed without it
  std::size_t rejected = 0;  ///< edges to which this kernel gives a weight below Report::kRejectedWeight
  int dimension = 0;         ///< the dimension of the world; 0 if no vertex has a position
  std::array<double, 3> extent{};  ///< the size of the box that contains all positions, in meters
  std::optional<DiagnosisFacts> diagnosis;
  std::optional<OutlierFacts> outliers;
  std::map<std::string, std::size_t> data;  ///< the number of lines of data with each tag
};

/// Finds all facts. `edge_lines` is the result of find_edge_lines(); `worst` is the number of edges to list.
GraphFacts find_facts(const GraphFile& file, const std::vector<std::int64_t>& edge_lines, std::size_t worst);
/// Diagnoses the graph of the file.
DiagnosisFacts find_diagnosis(const GraphFile& file, const std::vector<std::int64_t>& edge_lines);
/// Finds the false edges in a copy of the graph, and shows progress on a terminal.
OutlierFacts find_false_edges(const GraphFile& file, const std::vector<std::int64_t>& edge_lines,
                              const Options& options, Suspects suspects);

}  // namespace boxplus::app
