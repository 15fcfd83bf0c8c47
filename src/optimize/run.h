// SPDX-License-Identifier: BSD-3-Clause
// One call of optimize(): what its parts share.
#pragma once

#include "boxplus/base/function_ref.h"
#include "boxplus/optimize/optimize.h"
#include "optimize/minimize.h"
#include "optimize/session.h"

namespace boxplus {

class Run {
 public:
  /// The clock runs from here on.
  Run(Graph& graph, const Options& options, Report& report);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Finds or makes the plan, evaluates chi2 and begins the report. Throws Stopped if there is no time for a
  /// plan.
  void prepare();

  Graph& graph() { return graph_; }
  const Options& options() const { return options_; }
  Report& report() { return report_; }
  Session& session() { return *session_; }
  BatchSystem& system() { return session_->system(); }
  double seconds() const { return clock_.seconds(); }
  /// Raised by Options::stop, and at the end of Options::time_limit_s.
  const StopToken& stop() const { return stop_; }
  /// Neither stopped nor out of iterations.
  bool may_go_on() const { return iterations_left() > 0 && !stop_.raised(); }

  /// Rows of the enabled active edges beyond the unknowns: the chi2 to expect if the noise is that of Ω.
  double degrees_of_freedom() const { return rows_ - scalars_; }

  /// Runs the algorithm from the current estimates, whose chi2 is given.
  RunResult minimize(double chi2);
  /// The same, but for an end with Reason::kCallback after the first iteration that `wanted` refuses.
  RunResult minimize_while(FunctionRef<bool(const IterationRecord&)> wanted, double chi2);

 private:
  int iterations_left() const { return options_.max_iterations - report_.iterations; }
  void describe_problem();
  bool call_back(const IterationRecord& record);

  Graph& graph_;
  const Options& options_;
  Report& report_;
  Stopwatch clock_;
  StopToken stop_;
  Session* session_ = nullptr;
  double rows_ = 0, scalars_ = 0;
  /// Marks the session as in use, also where the constructor throws.
  struct InUse {
    Graph& graph;
    Session* session = nullptr;
    ~InUse() {
      if (session != nullptr && graph.cache().get() == session) session->set_in_use(false);
    }
  } in_use_{graph_};
};

}  // namespace boxplus
