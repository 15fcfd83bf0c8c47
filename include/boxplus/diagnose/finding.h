// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis finds. Programs use these names through diagnose/diagnose.h.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/graph/handle.h"

namespace boxplus::detail {

/// Something that is wrong with a graph, or unusual, with the vertices and edges concerned. docs/diagnosis.md
/// explains each kind.
struct Finding {
  enum class Kind : std::uint8_t {
    kNonFiniteEstimate,  ///< an estimate is NaN or infinite
    kNonFiniteError,     ///< an error, or its chi2, is NaN or infinite
    kNonFiniteJacobian,
    kImplausibleEstimate,    ///< an estimate that cannot be right, such as a negative focal length
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
    kDominantVertex,         ///< the edges of one vertex have most of chi2
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

}  // namespace boxplus::detail
