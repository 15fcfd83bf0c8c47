// SPDX-License-Identifier: BSD-3-Clause
// Says what is wrong with a graph: why an optimization fails, or why its result is doubtful.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/optimize/options.h"

namespace boxplus {

/// Something that is wrong with a graph, or unusual, with the vertices and edges concerned. docs/diagnosis.md
/// explains each kind.
struct Finding {
  enum class Kind : std::uint8_t {
    kNonFiniteEstimate,  ///< an estimate is NaN or infinite
    kNonFiniteError,     ///< an error, or its chi2, is NaN or infinite
    kNonFiniteJacobian,
    kNothingMoves,           ///< there are edges, but no vertex of an edge may move
    kWrongJacobian,          ///< the member jacobians() of an edge type differs from the numeric derivative
    kIsolatedVertex,         ///< a vertex without edges
    kFreeComponent,          ///< a motion of a connected component changes no error
    kZeroJacobian,           ///< all Jacobians of a vertex are zero
    kUndeterminedDirection,  ///< the edges of a vertex leave one of its directions free
    kSeenOnce,               ///< the only edge of a point leaves one of its directions free
    kBehindCameras,          ///< a point is behind all cameras that see it
    kFarPoint,               ///< a point is far away from all cameras that see it
    kZeroInformation,        ///< an edge whose Ω is zero
    kMixedUnits,             ///< an Ω has another scale than the others of its type
    kDuplicateEdge,          ///< the same measurement twice
    kOutlier,                ///< an edge whose chi2 noise does not explain
    kFixedEdge,              ///< an edge whose vertices are all fixed
    kNotAtMinimum,           ///< single vertices can lower chi2 noticeably
    kChi2Ratio,              ///< chi2 is far from the degrees of freedom
  };
  enum class Severity : std::uint8_t {
    kNote,     ///< unusual, but not a fault
    kWarning,  ///< the result is probably not what the user wants
    kError     ///< optimize() fails, or its result is meaningless
  };

  /// A direction that is free or wrong.
  struct Direction {
    enum class Kind : std::uint8_t {
      kAlong,   ///< a translation of the component along `axis`, in the world
      kAbout,   ///< a rotation of the component about `axis`, in the world
      kScale,   ///< a scaling of the component
      kTangent  ///< `tangent`, a unit vector in the tangent space of `vertex`
    };
    Kind kind = Kind::kTangent;
    std::array<double, 3> axis{};  ///< a unit vector; (0, 0, 1) for a rotation in the plane
    VertexRef vertex = {};
    std::vector<double> tangent = {};
  };

  Kind kind = Kind::kIsolatedVertex;
  Severity severity = Severity::kNote;
  std::string text;  ///< one line: what is wrong, and how to mend it
  /// All vertices and edges concerned, in the order of ids (pools and slots). They stay valid until they are
  /// removed from the graph.
  std::vector<VertexRef> vertices = {};
  std::vector<Id> ids = {};  ///< of `vertices`
  std::vector<EdgeRef> edges = {};
  std::vector<Direction> directions = {};
};

/// "isolated-vertex"
std::string_view to_string(Finding::Kind kind);
/// "warning"
std::string_view to_string(Finding::Severity severity);

struct [[nodiscard]] Diagnosis {
  std::vector<Finding> findings;  ///< errors first, then warnings, then notes
  /// False if Options::stop or Options::time_limit_s ended the diagnosis. `findings` is then not complete.
  bool is_complete = true;
  /// Whether chi2 is at a minimum as far as single vertices show: no vertex can lower it noticeably while all
  /// others stay where they are. If it is false, the diagnosis does not look for outliers or judge chi2.
  bool at_minimum = false;

  /// Whether there are only notes.
  bool ok() const;
  /// The number of findings of this severity.
  std::size_t count(Finding::Severity severity) const;
};
/// One line per finding, such as "warning: vertex 20 has no edge: … [isolated-vertex]".
std::string to_string(const Diagnosis& diagnosis);
std::ostream& operator<<(std::ostream& out, const Diagnosis& diagnosis);

/// Examines a graph at its current estimates: before a run, after a run that failed, or after a run whose
/// result is doubtful. Changes nothing. The options `level`, `vertices`, `edges`, `numeric_jacobians`, `stop`
/// and `time_limit_s` mean the same as for optimize(); all other options are ignored. Disabled edges are
/// ignored, too.
///
/// Evaluates each edge and its Jacobians once, in one thread. Examines samples of the edges to find wrong
/// Jacobians, and looks for the gauge freedom of each component as optimize() does. O(n log n).
///
/// Throws InvalidArgument for stale handles in the options, and passes on the exceptions of error functions.
Diagnosis diagnose(const Graph& graph, const Options& options = {});

}  // namespace boxplus
