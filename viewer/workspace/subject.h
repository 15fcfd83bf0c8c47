// SPDX-License-Identifier: BSD-3-Clause
// What a workspace shows and works on.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/optimize/report.h"
#include "boxplus/outliers/outliers.h"
#include "settings/run_settings.h"
#include "viewer/protocol/messages.h"
#include "viewer/workspace/edits.h"

namespace boxplus::viewer {

/// Gets what happens while a subject works.
class Listener {
 public:
  virtual ~Listener() = default;
  /// Call it after each iteration. If it returns false, the run must stop.
  virtual bool note(const IterationRecord& record) = 0;
  /// Call it after a stage of a search for false edges. Stages come before the iterations, and count as rows.
  virtual void note_stage(const std::string& /*name*/, const IterationRecord& record) { note(record); }
  /// Adds a line to the log. `level` is "info", "warning" or "error".
  virtual void log(const char* level, std::string text) = 0;
  /// Becomes true if the work must stop.
  virtual const std::atomic<bool>& stop_flag() const = 0;
};

/// The end of a run.
struct Outcome {
  std::string status;    ///< one word, such as "converged"
  std::string headline;  ///< one line
  std::string summary;   ///< several lines
  std::string reason;    ///< one sentence
  bool converged = false;
  double chi2 = 0;
  std::vector<IterationRecord> rows = {};  ///< all that belong to the result
  std::vector<EdgeVerdict> verdicts = {};  ///< if the run looked for false edges
  std::vector<std::string> stages = {};    ///< names of the first rows, if they are no iterations
  std::size_t false_edges = 0;             ///< that the run found, and that are still in the graph
  std::string start = {};  ///< the initial guess before the first row; empty: the estimates before the run
  double chi2_start = 0;   ///< of this guess
  double chi2_per_degree = std::numeric_limits<double>::quiet_NaN();  ///< NaN if it is not known
  std::int64_t degrees_of_freedom = 0;
};

/// A graph with its optimizer. One thread at a time calls its functions.
class Subject {
 public:
  struct Facts {
    std::string name, format;
    std::size_t vertices = 0, edges = 0;
    int dimension = 2;
    std::string no_truth = {};  ///< why open_truth() always fails; empty if it does not
  };

  virtual ~Subject() = default;
  virtual Facts facts() const = 0;
  virtual double chi2() = 0;
  /// What can be chosen.
  virtual Message form() const = 0;
  /// Reads the structure again if it has changed. Returns whether it has.
  virtual bool update_structure() = 0;
  /// `graph` identifies the subject, and `number` its structure.
  virtual Message structure(std::uint64_t graph, std::uint64_t number) const = 0;
  /// The current estimates, in the order of the structure. `at_rest` is false while a run goes on.
  virtual Message frame(const FrameFacts& facts, bool at_rest) const = 0;
  /// The frame at rest with the covariances of positions, or with the reason why there are none.
  virtual Message uncertain_frame(const FrameFacts& facts, Listener& listener) const = 0;

  /// Compares the estimates with those of a file from now on, which frames then tell. Throws InputError,
  /// FileError or InvalidArgument with a text for the user, and changes nothing, if this is impossible.
  virtual void open_truth(const std::string& name, const std::string& text, Listener& listener) = 0;
  /// The truth in the order of the structure, whose number is `structure`; nullptr if there is none.
  virtual Message truth(std::uint64_t structure) = 0;

  /// Describes an element as JSON, with the number of the structure. Must be fast. Throws InvalidArgument if
  /// there is no such element.
  virtual std::string describe(const ElementName& name, std::uint64_t structure) const = 0;
  /// Changes the graph, and returns what was done. Throws InvalidArgument, and changes nothing, if this is
  /// impossible.
  virtual std::string edit(const Edit& edit) = 0;
  /// Removes the edges that the last run found false, and returns what was done. Throws like edit().
  virtual std::string remove_false_edges() { throw InvalidArgument("this graph has no false edges"); }

  /// Throws InvalidArgument if a setting is unknown or has a wrong value.
  virtual void check(const Settings& settings) const = 0;
  /// Optimizes from the estimates that the settings name.
  virtual Outcome run(const Settings& settings, Listener& listener) = 0;
  /// One iteration from the current estimates.
  virtual Outcome step(const Settings& settings, Listener& listener) = 0;
  /// Takes the verdicts of a run of the program, which may be none.
  virtual void set_verdicts(const std::vector<EdgeVerdict>& /*verdicts*/) {}
  /// Replaces the estimates by an initial guess. Returns whether they were replaced.
  virtual bool guess(const std::string& start, Listener& listener) = 0;
  /// Remembers the current estimates for restore().
  virtual void keep_estimates() = 0;
  virtual void restore() = 0;
  /// Ends what keep_estimates() began.
  virtual void drop_estimates() = 0;
  /// What diagnose() finds, as JSON with the number of the structure. Throws InvalidArgument if the subject
  /// cannot be diagnosed, or if it was stopped.
  virtual std::string diagnosis(std::uint64_t structure, const std::atomic<bool>& stop) const = 0;
  /// Where H and L have blocks. Throws as read_pattern() does.
  virtual Message pattern(const std::atomic<bool>& stop) const = 0;
  /// The graph as a file. Throws InvalidArgument if the format cannot contain it.
  virtual std::string formatted(const std::string& format) const = 0;
};

/// Makes a subject of a file. Throws InputError or InvalidArgument with a text for the user.
using Opener =
    std::function<std::unique_ptr<Subject>(const std::string& name, const std::string& text, Listener&)>;

}  // namespace boxplus::viewer
