// SPDX-License-Identifier: BSD-3-Clause
// Decides whether a minimum of a pose graph is the global one, and looks for a better minimum if it is not.
//
// The chordal cost of estimates R_i, t_i is
//   F = Σ τ ‖t_j − t_i − R_i t_ij‖² + ‖(R_j − R_i R_ij) W‖²   with  W Wᵀ = M = tr(ω)/2 I − ω  (in the plane
// M = ω/2 I), where τ is the information of the translation, and ω is that of the rotation per squared
// radian. F is quadratic in R_i and t_i, and R_iᵀ R_i = I. Therefore, Lagrange's multipliers give a lower
// bound for F: at a stationary point, a sparse matrix S is positive semi-definite only if the point is a
// global minimum. One factorization of S shows this. (Carlone, Rosen, Calafiore, Leonard & Dellaert,
// "Lagrangian duality in 3D SLAM", IROS 2015; Rosen, Carlone, Bandeira & Leonard, "SE-Sync", IJRR 2019.)
//
// What this proves for chi2 depends on the graph (Certificate::Relation). If chi2 is F, it is a proof. If
// not, F has its global minimum near the minimum of chi2, and the proof is for F only.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"

namespace boxplus {

struct CertificateOptions {
  /// How to optimize, and for how long: `level`, `edges`, `threads`, `stop`, `time_limit_s`, and the options
  /// of the method. The start is always the current estimates, and the callback is not called.
  Options options = {};
  /// The largest relative gap of a global minimum, (F − lower bound of F) / F.
  double tolerance = 1e-6;
  /// How often to leave a minimum that is not global; 0: never. The first time, F is minimized from the
  /// chordal guess (guess_chordal()).
  int max_escapes = 4;
};

struct [[nodiscard]] Certificate {
  enum class Verdict : std::uint8_t {
    kGlobalMinimum,  ///< F has its global minimum here or next to it, and no better minimum of chi2 was found
    kLocalMinimum,   ///< a better minimum of chi2 was found
    kUndecided       ///< `note` says why
  };
  /// How F is related to chi2. In all cases, both agree to second order in the errors of rotation if the
  /// information of the translation is isotropic.
  enum class Relation : std::uint8_t {
    /// F is chi2 for all estimates with normalized quaternions. The edges are Between<SE3>, the information
    /// of the translation is τ I, and Ω has no cross terms between translation and rotation.
    kEqual,
    /// F is at most chi2, for all estimates. The edges are Between<SE2>, and the rest is as above. Each
    /// squared error of rotation θ² is replaced by 2 − 2 cos θ.
    kBelow,
    /// F and chi2 have different weights: τ is the harmonic mean over the directions.
    kSimilar
  };

  Verdict verdict = Verdict::kUndecided;
  Relation relation = Relation::kSimilar;
  /// At the estimates that were to be certified. With kEqual, their quaternions are normalized, so that it
  /// may differ from Graph::chi2() by the rounding of a file. This holds for all chi2 of this struct.
  double chi2 = 0;
  double better_chi2 = 0;   ///< of kLocalMinimum: at the estimates that were found
  double chordal_cost = 0;  ///< F at its best minimum that was found
  double bound = 0;         ///< no estimates have a lower F than this; 0 if no bound was found
  /// The chi2 at which a run from the minimum of F ends; with kEqual, F itself.
  double chi2_from_chordal = 0;
  int steps = 0;       ///< Newton steps in the minimization of F
  int escapes = 0;     ///< how often a minimum of F was left because it was not global
  double time_s = 0;   ///< the whole duration
  std::string note{};  ///< why the verdict is kUndecided

  /// (F − bound) / F
  double relative_gap() const { return chordal_cost > 0 ? (chordal_cost - bound) / chordal_cost : 0; }
  /// A number that chi2 is proved not to fall below, for any estimates. 0 with kSimilar.
  double chi2_bound() const { return relation == Relation::kSimilar ? 0 : bound; }
};

/// "global-minimum"
std::string_view to_string(Certificate::Verdict verdict);
/// "equal"
std::string_view to_string(Certificate::Relation relation);
/// One or two sentences.
std::string to_string(const Certificate& certificate);
std::ostream& operator<<(std::ostream& out, const Certificate& certificate);

/// Says why certify() refuses a graph. Empty if it does not.
std::string why_not_certifiable(const Graph& graph, const Options& options = {});

/// Decides whether the current estimates, at which optimize() has ended, are the global minimum.
///
/// First, minimizes F from the current estimates by Newton's method, and computes a lower bound for F. If F
/// is not close to the bound, tries another start, and then leaves the minimum in a direction of negative
/// curvature of S (the Riemannian staircase: rotations move in a space of more dimensions for a while). Then
/// minimizes chi2 from the best minimum of F. If this leads to a lower chi2 by more than a relative 1e-6, the
/// graph gets these better estimates. Otherwise, the estimates stay as they are. If the verdict is
/// kLocalMinimum, call certify() again to judge the better estimates. If all measurements fit exactly, up to
/// rounding, nothing is searched, because chi2 cannot be lower.
///
/// For graphs whose edges measure relative poses (SE2 or SE3), without robust kernels. At most one vertex per
/// connected component may be fixed. Throws InvalidArgument for other graphs (why_not_certifiable()).
/// Disabled edges are ignored. Takes about as long as one run of optimize(), and longer only if the minimum
/// is not global. All sums and factorizations are in double. The bound includes the probable size of their
/// rounding errors; if a double has too few digits for a proof, the verdict is kUndecided.
Certificate certify(Graph& graph, const CertificateOptions& options = {});

}  // namespace boxplus
