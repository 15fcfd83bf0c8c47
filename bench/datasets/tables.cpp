// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>

#include "datasets/results.h"

namespace boxplus::bench {
namespace {

using Cells = std::vector<std::string>;

std::string line_of(const Cells& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

/// Returns the head of a table in Markdown. The first column is left-aligned, the others are right-aligned.
std::string head_of(const Cells& titles) {
  std::string rule = "|---|";
  for (std::size_t k = 1; k < titles.size(); ++k) rule += "--:|";
  return line_of(titles) + rule + "\n";
}

std::string milliseconds(double seconds) {
  const double ms = 1e3 * seconds;
  return fmt::format("{:.{}f}", ms, ms < 1 ? 3 : ms < 100 ? 2 : ms < 1000 ? 1 : 0);
}

std::string times(double theirs, double ours) {
  return fmt::format("{:.2f}", theirs / ours);
}

/// Returns one row per file. If `cells` returns nothing for a file, the row contains the error message.
std::string rows_of(const Results& results, const std::function<Cells(const DatasetResults&)>& cells) {
  std::string rows;
  for (const DatasetResults& result : results.datasets) {
    Cells row{result.dataset.name()};
    const Cells rest = cells(result);
    row.insert(row.end(), rest.begin(), rest.end());
    if (rest.empty()) row.push_back(result.trouble);
    rows += line_of(row);
  }
  return rows;
}

std::string rate(const LinearFigures& figures, const Results& results) {
  return fmt::format("{:.1f} ({:.0f} %)", figures.rate(), 100 * figures.rate() / results.dgemm_rate);
}

std::string linear_tables(const Results& results) {
  std::string out =
      "## One linear system\n\n"
      "Times in ms for H at the estimates of the file. For CHOLMOD, the table shows the configuration\n"
      "that factorizes fastest, of eight: AMD or METIS, on scalars or on blocks, supernodal or\n"
      "simplicial. \"Analyze\" is the time of boxplus's analysis with minimum degree. The next columns\n"
      "are CHOLMOD's analyses with AMD, supernodal or simplicial, whichever factorizes faster.\n"
      "\"Dissect\" is the time of boxplus's analysis with nested dissection, if boxplus chooses this\n"
      "ordering. The columns after \"in float\" have values if boxplus chooses to factorize in float,\n"
      "and to refine the solution in double to a residual of 1e-10.\n\n";
  out +=
      head_of({"file", "scalars", "analyze", "CHOLMOD AMD", "×", "AMD on blocks", "×", "dissect", "factorize",
               "CHOLMOD", "×", "solve", "CHOLMOD", "×", "in float: factorize", "×", "solve", "both ×"});
  out += rows_of(results, [](const DatasetResults& result) -> Cells {
    if (!result.linear) return {};
    const LinearComparison& d = *result.linear;
    const double analyze = d.analyze_by_degree_s;
    return {std::to_string(d.scalars),
            milliseconds(analyze),
            milliseconds(d.cholmod_amd_analyze_s),
            times(d.cholmod_amd_analyze_s, analyze),
            milliseconds(d.cholmod_block_amd_analyze_s),
            times(d.cholmod_block_amd_analyze_s, analyze),
            d.dissected ? milliseconds(d.ours.analyze_s) : "–",
            milliseconds(d.ours.factorize_s),
            milliseconds(d.cholmod.factorize_s),
            times(d.cholmod.factorize_s, d.ours.factorize_s),
            milliseconds(d.ours.solve_s),
            milliseconds(d.cholmod.solve_s),
            times(d.cholmod.solve_s, d.ours.solve_s),
            d.mixed ? milliseconds(d.automatic.factorize_s) : "–",
            d.mixed ? times(d.cholmod.factorize_s, d.automatic.factorize_s) : "–",
            d.mixed ? milliseconds(d.automatic.solve_s) : "–",
            times(d.cholmod.factorize_s + d.cholmod.solve_s, d.automatic.factorize_s + d.automatic.solve_s)};
  });
  out += fmt::format(
      "\n"
      "The useful operations per second of the factorization, also as a percentage of DGEMM with\n"
      "n = 1024, which runs at {:.1f} GFLOP/s.\n\n",
      results.dgemm_rate);
  out += head_of({"file", "boxplus Mflop", "GFLOP/s", "CHOLMOD Mflop", "GFLOP/s",
                  "CHOLMOD's fastest configuration", "largest difference of the solutions"});
  return out + rows_of(results, [&](const DatasetResults& result) -> Cells {
           if (!result.linear) return {};
           const LinearComparison& d = *result.linear;
           return {fmt::format("{:.1f}", d.ours.flops * 1e-6),
                   rate(d.ours, results),
                   fmt::format("{:.1f}", d.cholmod.flops * 1e-6),
                   rate(d.cholmod, results),
                   d.cholmod_settings,
                   fmt::format("{:.0e}", d.largest_difference)};
         });
}

std::string iteration_table(const Results& results) {
  std::string out =
      "## Linearization and iterations\n\n"
      "Times in ms, from the runs of the next table: the mean time of a linearization, including the\n"
      "first, and the median time of an iteration, without the first. The linearization of boxplus\n"
      "includes the assembly of H and the gradient. The evaluation by Ceres computes the Jacobian and\n"
      "the gradient; its linear solver multiplies JᵀJ later.\n\n";
  out += head_of({"file", "linearize + assemble", "Ceres autodiff", "×", "Ceres analytic", "×", "iteration",
                  "Ceres analytic", "×", "Ceres autodiff", "×"});
  return out + rows_of(results, [](const DatasetResults& result) -> Cells {
           if (!result.solve) return {};
           const SolveFigures &ours = result.solve->ours, &analytic = result.solve->analytic,
                              &autodiff = result.solve->autodiff;
           return {milliseconds(ours.linearize_s),
                   milliseconds(autodiff.linearize_s),
                   times(autodiff.linearize_s, ours.linearize_s),
                   milliseconds(analytic.linearize_s),
                   times(analytic.linearize_s, ours.linearize_s),
                   milliseconds(ours.iteration_s),
                   milliseconds(analytic.iteration_s),
                   times(analytic.iteration_s, ours.iteration_s),
                   milliseconds(autodiff.iteration_s),
                   times(autodiff.iteration_s, ours.iteration_s)};
         });
}

std::string arrival(const SolveFigures& figures) {
  return figures.arrived() ? milliseconds(figures.arrival_s) : fmt::format("stuck at {:.6g}", figures.chi2);
}

std::string arrival_times(const SolveFigures& theirs, const SolveFigures& ours) {
  if (!ours.arrived()) return "–";
  return theirs.arrived() ? times(theirs.arrival_s, ours.arrival_s) : "∞";
}

std::string iterations(const SolveFigures& figures) {
  return fmt::format("{:.0f}", figures.iterations);
}

std::string arrival_table(const Results& results) {
  std::string out =
      "## To within 1e-6 of the best chi2\n\n"
      "Times in ms from the call until chi2 is within 1e-6 of the best, including the analysis. boxplus\n"
      "and Ceres start at the estimates of the file. In the columns \"automatic\", boxplus uses\n"
      "Start::kAutomatic, which chooses between these estimates and the chordal guess. For Ceres, the\n"
      "table shows the fastest configuration of six:\n"
      "Levenberg-Marquardt (LM); LM with post-ordering, with a radius of 1e16, or non-monotonic;\n"
      "dogleg; subspace dogleg. If a run did not get there, \"stuck at\" shows its final chi2 after at\n"
      "most 100 iterations.\n\n";
  out += head_of({"file", "chi2 of the file", "best chi2", "iterations", "ms", "automatic: iterations", "ms",
                  "Ceres", "iterations", "analytic", "×", "autodiff", "×"});
  return out + rows_of(results, [](const DatasetResults& result) -> Cells {
           if (!result.solve) return {};
           const SolveComparison& d = *result.solve;
           return {fmt::format("{:.9g}", d.chi2_initial),
                   fmt::format("{:.9g}", result.dataset.best_chi2),
                   iterations(d.ours),
                   arrival(d.ours),
                   iterations(d.ours_automatic),
                   arrival(d.ours_automatic),
                   d.ceres_settings,
                   iterations(d.analytic),
                   arrival(d.analytic),
                   arrival_times(d.analytic, d.ours),
                   arrival(d.autodiff),
                   arrival_times(d.autodiff, d.ours)};
         });
}

std::string whole_table(const Results& results) {
  std::string out =
      "## From file to file\n\n"
      "Each program runs in its own process. It loads the file, optimizes until the relative decrease\n"
      "of chi2 is below 1e-10, and writes the result. boxplus runs like `boxplus optimize --threads 1`,\n"
      "which may start from the chordal guess. Ceres starts from the estimates of the file, with\n"
      "analytic Jacobians and the configuration above, and uses our reader and our writer.\n\n";
  out += head_of({"file", "ms", "chi2", "peak MiB", "Ceres ms", "chi2", "peak MiB", "time ×", "memory ×"});
  return out + rows_of(results, [](const DatasetResults& result) -> Cells {
           if (!result.whole) return {};
           const auto [ours, ceres] = *result.whole;
           const bool stuck = ceres.chi2 > result.dataset.target();
           return {milliseconds(ours.seconds),
                   fmt::format("{:.9g}", ours.chi2),
                   fmt::format("{:.1f}", ours.peak_mib),
                   milliseconds(ceres.seconds),
                   fmt::format("{}{:.9g}", stuck ? "stuck at " : "", ceres.chi2),
                   fmt::format("{:.1f}", ceres.peak_mib),
                   stuck ? "∞" : times(ceres.seconds, ours.seconds),
                   times(ceres.peak_mib, ours.peak_mib)};
         });
}

Cells thread_cells(const ThreadComparison& comparison) {
  return {milliseconds(comparison.one_s), milliseconds(comparison.two_s),
          times(comparison.one_s, comparison.two_s)};
}

std::string thread_table(const Results& results) {
  std::string out =
      "## Two threads\n\n"
      "Times in ms of a call of optimize() with Start::kAutomatic. The final chi2 with one thread and\n"
      "with two threads has the same bits.\n\n";
  out += head_of({"file", "one thread", "two threads", "×"});
  out += rows_of(results, [](const DatasetResults& result) -> Cells {
    return result.threads ? thread_cells(*result.threads) : Cells{};
  });
  for (const auto& [poses, comparison] : results.tori) {
    Cells torus = thread_cells(comparison);
    torus.insert(torus.begin(), fmt::format("torus of {} poses, simulated", poses));
    out += line_of(torus);
  }
  return out;
}

std::string scale_table(const Results& results) {
  std::string out =
      "## Scale\n\n"
      "Simulated worlds: one run of each, in its own process, with one thread and five iterations from\n"
      "the odometry. LinearSolverKind::kAutomatic chooses the solver. It chooses Cholesky, unless the\n"
      "factor is predicted not to fit into half of the memory, or a factorization is predicted to take\n"
      "several times as long as a rough solution by pcg.\n\n";
  out += head_of({"world", "poses", "edges", "load s", "plan s", "iteration s", "µs per pose", "write s",
                  "all s", "peak MiB", "solver", "predicted: factorize s", "pcg s"});
  for (const ScaleResult& result : results.scale) {
    const ScaleFigures& f = result.figures;
    out += line_of({result.world, std::to_string(f.vertices), std::to_string(f.edges),
                    fmt::format("{:.2f}", f.load_s), fmt::format("{:.2f}", f.plan_s),
                    fmt::format("{:.3f}", f.iteration_s),
                    fmt::format("{:.2f}", 1e6 * f.iteration_s / f.vertices), fmt::format("{:.2f}", f.write_s),
                    fmt::format("{:.1f}", f.total_s), fmt::format("{:.0f}", f.peak_mib),
                    f.factor_gb > 0 ? fmt::format("{} (factor: {:.1f} GB)", f.solver, f.factor_gb) : f.solver,
                    fmt::format("{:.2g}", f.predicted_factor_s), fmt::format("{:.2g}", f.predicted_pcg_s)});
  }
  return out;
}

}  // namespace

std::string tables_of(const Results& results) {
  std::string out;
  for (const auto& table : {linear_tables(results), iteration_table(results), arrival_table(results),
                            whole_table(results), thread_table(results), scale_table(results)}) {
    out += "\n" + table;
  }
  return out;
}

}  // namespace boxplus::bench
