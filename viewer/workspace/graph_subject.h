// SPDX-License-Identifier: BSD-3-Clause
// A boxplus graph in the viewer.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "settings/run_settings.h"
#include "viewer/scene/scans.h"
#include "viewer/scene/truth.h"
#include "viewer/scene/verdicts.h"
#include "viewer/workspace/subject.h"

namespace boxplus::viewer {

/// The end of a run of boxplus.
Outcome outcome_of(const Report& report);
Outcome outcome_of(const OutlierReport& found);

class GraphSubject final : public Subject {
 public:
  /// Owns the graph of a file. It must have estimates.
  GraphSubject(GraphFile file, std::string name);
  /// Shows a graph of the program, which must outlive this subject. `file` may be null; otherwise the graph
  /// is the one in this file, which must outlive this subject, too.
  GraphSubject(Graph& graph, std::string name, const GraphFile* file = nullptr, Drawn drawn = Drawn::kAll);

  Facts facts() const override;
  double chi2() override { return graph_->chi2(); }
  Message form() const override;
  bool update_structure() override;
  Message structure(std::uint64_t graph, std::uint64_t number) const override;
  Message frame(const FrameFacts& facts, bool at_rest) const override;
  Message uncertain_frame(const FrameFacts& facts, Listener& listener) const override;
  void open_truth(const std::string& name, const std::string& text, Listener& listener) override;
  Message truth(std::uint64_t structure) override;
  std::string describe(const ElementName& name, std::uint64_t structure) const override;
  /// Refused if the graph is that of a program, because the program does not expect it.
  std::string edit(const Edit& edit) override;
  std::string remove_false_edges() override;
  void check(const Settings& settings) const override;
  Outcome run(const Settings& settings, Listener& listener) override;
  Outcome step(const Settings& settings, Listener& listener) override;
  void set_verdicts(const std::vector<EdgeVerdict>& verdicts) override { verdicts_ = Verdicts(verdicts); }
  bool guess(const std::string& start, Listener& listener) override;
  void keep_estimates() override { graph_->push(); }
  void restore() override;
  void drop_estimates() override;
  std::string diagnosis(std::uint64_t structure, const std::atomic<bool>& stop) const override;
  Message pattern(const std::atomic<bool>& stop) const override;
  std::string formatted(const std::string& format) const override;

  /// Compares the estimates with this truth from now on. Throws as Truth::match() does, and then changes
  /// nothing.
  void set_truth(Truth truth, Listener& listener);
  /// Adds the notes on the file to the log.
  void log_notes(Listener& listener) const;

 private:
  using Callback = std::function<bool(const IterationRecord&)>;
  Options begin_run(const RunSettings& settings, Listener& listener, const Callback& callback);
  Report optimize(const RunSettings& settings, Listener& listener, const Callback& callback);
  Outcome search(const RunSettings& settings, Listener& listener);
  void try_odometry(const RunSettings& settings, double chi2_before, Listener& listener,
                    std::vector<IterationRecord>& stages);
  Outcome outcome(Outcome outcome) const;
  Message frame(const FrameFacts& facts, bool at_rest, const Uncertainty& uncertainty) const;
  void set_kernels(const RunSettings& settings, Listener& listener);
  void note_verdicts(const OutlierReport& found, Listener& listener);

  std::optional<GraphFile> own_;
  Graph* graph_;
  const GraphFile* file_;
  std::string name_;
  Drawn drawn_ = Drawn::kAll;
  Structure structure_;
  ScansOfFile scans_;
  std::optional<Truth> truth_;
  std::unique_ptr<Optimizer> optimizer_;
  bool has_kernels_ = false;
  Verdicts verdicts_;  // of the last run
};

/// Reads a file in any format that is no folder. If it has no estimates, makes an initial guess.
std::unique_ptr<Subject> open_graph(const std::string& name, const std::string& text, Listener& listener);

}  // namespace boxplus::viewer
