// SPDX-License-Identifier: BSD-3-Clause
// The graph of the viewer, the thread that works on it, and what its readers see.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "boxplus/base/error.h"
#include "viewer/protocol/messages.h"
#include "viewer/workspace/frame_history.h"
#include "viewer/workspace/graph_subject.h"

namespace boxplus::viewer {

/// Thrown by a command while another one is carried out.
class Busy : public InvalidArgument {
  using InvalidArgument::InvalidArgument;
};

/// The text about an exception of a function of the user that says nothing itself.
inline constexpr const char* kUnknownException =
    "an error function threw something that is no std::exception";

/// Owns a subject and one worker thread, which optimizes it. Commands come from any thread and return at
/// once. Any number of readers on other threads get the messages of PROTOCOL.md. A slow reader misses frames;
/// it never delays the worker.
///
/// While a run goes on, a frame is made at most 30 times a second, in at most 1/25 of the time, and only if
/// there is a reader.
///
/// A program can hold the workspace of its own graph: it then works on the graph itself, and the pages watch.
class Workspace final : private Listener {
 public:
  /// Without a graph, until show() or open(). If `opener` is empty, open() is refused.
  explicit Workspace(Opener opener = open_graph);
  /// Stops the run.
  ~Workspace() override;
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Replaces the graph. `name` is shown to the user. Throws Busy while a command is carried out.
  void show(std::unique_ptr<Subject> subject);
  /// Throws as GraphSubject::set_truth() does if there is a truth.
  void show(GraphFile file, const std::string& name, std::optional<Truth> truth = {});

  /// These throw Busy while another command is carried out, and InvalidArgument if there is no graph, or if a
  /// setting is wrong.
  void optimize(const Settings& settings);
  /// One iteration from the current estimates.
  void step(const Settings& settings);
  /// Replaces the estimates by an initial guess: a value of the setting "start".
  void guess(const std::string& start);
  /// Computes the covariances of positions. They are in the newest frame, until the estimates change.
  void covariances();
  /// Restores the estimates of the file. Edits stay.
  void reset();
  /// Reads a file and replaces the graph. If this fails, the graph stays, and the state has the message.
  /// Throws Busy while another command is carried out.
  void open(std::string name, std::string text);
  /// Reads a file with the truth of the graph, which frames then have, until another graph is opened. If this
  /// fails, the truth before it stays, and the state has the message. Throws as open() does, and
  /// InvalidArgument if there is no graph.
  void open_truth(std::string name, std::string text);
  /// Throws Busy while a command is carried out.
  void expect_idle() const;
  /// Asks the run to stop. Its best estimates are kept.
  void stop();

  /// Returns the graph with its current estimates as a file of a format (FileFormat::name). Throws Busy while
  /// a command is carried out, and InvalidArgument if there is no graph, or as format_graph() does.
  std::string formatted(const std::string& format);

  /// Changes the graph, and evaluates it. `structure` is the number of the structure to which the element
  /// belongs. Throws as describe() and Subject::edit() do, and then nothing has changed.
  void edit(std::uint64_t structure, const Edit& edit);

  /// Removes the edges that the last run found false, and evaluates the graph. Throws Busy while a command is
  /// carried out, and InvalidArgument if there are no such edges, or if the graph is that of a program.
  void remove_false_edges();

  /// Returns what there is to say about a vertex or an edge, as JSON. Throws Busy while a command is carried
  /// out, and InvalidArgument if there is no graph, if its structure has another number, or if it has no such
  /// element.
  std::string describe(std::uint64_t structure, const ElementName& name) const;

  /// Returns what diagnose() finds at the current estimates, as JSON. All readers get it, too; it stays until
  /// the next diagnosis, or until another graph is opened, and the state says if it is outdated. Throws Busy
  /// while a command is carried out, and InvalidArgument if there is no graph, if it cannot be diagnosed, or
  /// if it was stopped.
  std::string diagnosis();

  /// Returns where H and L have blocks. Throws Busy while a command is carried out, and InvalidArgument if
  /// there is no graph, if it is too large, or if it was stopped.
  Message pattern();

  /// Stops the command that is carried out, and waits for its end. From now on, the calling thread may use
  /// the graph, and commands of pages are refused, except for stop().
  void hold();
  /// Ends hold(): pages may work on the graph again. reset() then restores the current estimates.
  void hand_over();
  /// Call it after each iteration of a run of the program, while the workspace is held. The first iteration
  /// begins a new table. Returns false if a page wants the run to stop.
  bool watch(const IterationRecord& record);
  /// Shows the end of the run, and the estimates. The workspace must be held.
  void watch_end(const Outcome& outcome);
  /// Shows the current estimates, and the structure if it has changed. The workspace must be held.
  void update();
  /// The same for a graph that changes often: at most 30 times a second, in at most 1/25 of the time, and
  /// only if there is a reader.
  void follow();
  bool has_readers() const { return readers_ > 0; }

  /// Stops the run, refuses all later commands, and wakes all readers.
  void end();

  /// A reader of the messages. It must not outlive the workspace.
  class Reader {
   public:
    /// `greeting` is empty, or a JSON object whose members become members of the first state.
    Reader(Workspace& workspace, std::string greeting);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Waits until there is news, but at most for `patience`. Returns the messages in their order; none if
    /// there is no news.
    std::vector<Message> wait(std::chrono::milliseconds patience);
    bool has_ended() const { return workspace_.ending_; }

   private:
    std::string state_json() const;

    Workspace& workspace_;
    std::string greeting_;
    std::uint64_t version_ = 0, structure_ = 0, truth_ = 0, frame_ = 0,
                  diagnosis_ = 0;  ///< the last that were returned
    int run_ = 0;
    std::size_t rows_ = 0, lines_ = 0;
  };

 private:
  struct Job {
    enum class Kind : std::uint8_t { kNone, kRun, kStep, kGuess, kCovariances, kReset, kOpen, kOpenTruth };
    Kind kind = Kind::kNone;
    Settings settings = {};
    std::string name = {}, text = {};  ///< of the file to open; or the name of the initial guess
  };
  struct Line {
    const char* level;
    std::string text;
  };

  bool note(const IterationRecord& record) override;
  void note_stage(const std::string& name, const IterationRecord& record) override;
  void log(const char* level, std::string text) override;
  const std::atomic<bool>& stop_flag() const override { return stop_; }

  /// Older lines leave the log.
  static constexpr std::size_t kMostLines = 1000;

  static constexpr const char* kRunning = "running";  ///< Outcome::status before the end of a run

  static constexpr const char* kOpensNothing = "this viewer shows the graph of a program, and opens no files";

  /// To what the last diagnosis belongs.
  enum class DiagnosisAge : std::uint8_t { kCurrent, kOtherEstimates, kOtherGraph };

  static const char* name_of(DiagnosisAge age);
  static const char* activity_of(Job::Kind kind);
  void claim(bool needs_graph);
  void work_here(bool needs_graph, const char* activity, const std::function<void()>& work);
  void release();
  void request(Job job);
  void work();
  void carry_out(const Job& job);
  void replace(std::unique_ptr<Subject> subject);
  void read(const Job& job);
  void read_truth(const Job& job);
  void set_truth(Message truth);
  void begin_run();
  void make_guess(const std::string& start);
  void restore();
  void leave_run(double chi2);
  void keep_in_history(int iteration);
  void set_chi2(double chi2);
  void finish(const Outcome& outcome);
  void update_structure();
  void make_frame(int iteration, double chi2, bool at_rest);
  void if_due(const std::function<void()>& show);
  void add_covariances();
  void publish(Message frame);
  void set_diagnosis(Message diagnosis);
  void outdate_diagnosis(DiagnosisAge age);

  const Opener opener_;

  // Used only by the thread that has claimed the workspace.
  std::unique_ptr<Subject> subject_;
  int edits_ = 0;
  FrameFacts frame_facts_;  // of the newest frame
  std::chrono::steady_clock::time_point next_frame_{};

  std::atomic<bool> stop_ = false, ending_ = false;
  std::atomic<int> readers_ = 0;

  // What readers see; guarded by mutex_.
  mutable std::mutex mutex_;
  std::condition_variable has_job_, has_news_;
  Job job_;
  bool is_busy_ = false, is_held_ = false;
  const char* activity_ = "";
  std::uint64_t version_ = 1, graph_number_ = 0, structure_number_ = 0, truth_number_ = 0, sequence_ = 0,
                diagnosis_number_ = 0;
  Message form_message_, structure_message_, truth_message_, frame_message_, diagnosis_message_;
  DiagnosisAge diagnosis_age_ = DiagnosisAge::kCurrent;
  std::optional<Subject::Facts> facts_;
  std::string error_;
  double chi2_ = 0, chi2_initial_ = 0;
  int run_number_ = 0;
  bool has_run_ = false;
  std::string status_, headline_, summary_;
  std::vector<IterationRecord> rows_;
  Outcome facts_of_run_;         // its stages during a run; what the state has in common with it at the end
  FrameHistory history_;         // of the run, without the newest frame
  bool is_first_frame_ = false;  // the newest frame is that before the run
  std::deque<Line> log_;
  std::size_t first_line_ = 0;  // the number of the first line in log_

  std::thread worker_;
};

}  // namespace boxplus::viewer
