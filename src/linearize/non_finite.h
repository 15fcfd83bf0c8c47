// SPDX-License-Identifier: BSD-3-Clause
// Finds the edge because of which a linearization is not finite.
#pragma once

#include <optional>
#include <string>

#include "linearize/linearizer.h"

namespace boxplus {

/// The first active, enabled edge, in pool and slot order, whose ρ(eᵀΩe) is not finite.
/// find_non_finite_jacobian() checks the error, the Jacobian and the weight instead.
std::optional<EdgeRef> find_non_finite_error(const Graph& graph, const Plan& plan);
std::optional<EdgeRef> find_non_finite_jacobian(const Graph& graph, const Plan& plan,
                                                const LinearizeOptions& options);

/// "the edge Between<SE2> between vertices 3 4"
std::string edge_text(const Graph& graph, const EdgeRef& edge);

/// One sentence on the cause at the current estimates, where F is `chi2`.
std::string describe_non_finite(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                double chi2);

}  // namespace boxplus
