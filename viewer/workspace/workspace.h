// SPDX-License-Identifier: BSD-3-Clause
// The graph of the viewer, the thread that works on it, and what its readers see.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "viewer/server/messages.h"
#include "viewer/settings/run_settings.h"

namespace boxplus::viewer {

/// Thrown by a command while another one is carried out.
class Busy : public InvalidArgument {
  using InvalidArgument::InvalidArgument;
};

/// Owns a graph and one worker thread, which optimizes it. Commands come from any thread and return at once.
/// Any number of readers on other threads get the messages of PROTOCOL.md. A slow reader misses frames; it
/// never delays the worker.
///
/// While the worker runs, a frame is made at most 30 times a second, in at most 1/25 of the time, and only if
/// there is a reader.
class Workspace {
 public:
  /// Without a graph, until show() or open().
  Workspace();
  /// Stops the run.
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Replaces the graph. It must have estimates. `name` is shown to the user. Throws Busy while a command is
  /// carried out.
  void show(GraphFile file, const std::string& name);

  static constexpr int kMostIterations = 10'000;
  /// These throw Busy while another command is carried out, and InvalidArgument if there is no graph.
  /// optimize() also throws InvalidArgument if there would be more than kMostIterations.
  void optimize(RunSettings settings);
  /// One iteration from the current estimates.
  void step(RunSettings settings);
  /// Replaces the estimates by an initial guess: the start of the settings.
  void guess(RunSettings settings);
  /// Restores the estimates of the file.
  void reset();
  /// Reads a file in any format that is no folder, and replaces the graph. If this fails, the graph stays,
  /// and the state has the message. Throws Busy while another command is carried out.
  void open(std::string name, std::string text);
  /// Throws Busy while a command is carried out.
  void expect_idle() const;
  /// Asks the run to stop. Its best estimates are kept.
  void stop();

  /// Returns the graph with its current estimates as a file of a format (FileFormat::name). Throws Busy while
  /// a command is carried out, and InvalidArgument if there is no graph, or as format_graph() does.
  std::string formatted(const std::string& format);

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
    std::uint64_t version_ = 0, structure_ = 0, frame_ = 0;  ///< the last ones that were returned
    int run_ = 0;
    std::size_t rows_ = 0, lines_ = 0;
  };

 private:
  struct Job {
    enum class Kind : std::uint8_t { kNone, kRun, kGuess, kReset, kOpen };
    Kind kind = Kind::kNone;
    RunSettings settings = {};
    std::string name = {}, text = {};  ///< of the file to open
  };
  struct Line {
    const char* level;
    std::string text;
  };
  /// What readers see of the graph.
  struct FileFacts {
    std::string name, format;
    std::size_t vertices = 0, edges = 0;
    int dimension = 2;
  };

  void claim(bool needs_graph);
  void work_here(bool needs_graph, const char* activity, const std::function<void()>& work);
  void release();
  void request(Job job);
  void work();
  void carry_out(Job& job);
  void replace(GraphFile file, const std::string& name);
  void read(const Job& job);
  void set_kernels(const RunSettings& settings);
  Report run(const RunSettings& settings, bool is_shown);
  void make_guess(const RunSettings& settings);
  void restore();
  bool note(const IterationRecord& record);
  double final_chi2(const Report& report) const;
  void finish(const Report& report);
  void add_line(const char* level, std::string text);
  void make_frame(int iteration, double chi2, bool at_rest);

  // Used only by the thread that has claimed the workspace.
  std::optional<GraphFile> file_;
  Structure structure_;
  std::unique_ptr<Optimizer> optimizer_;
  bool has_kernels_ = false;
  std::chrono::steady_clock::time_point next_frame_{};

  std::atomic<bool> stop_ = false, ending_ = false;
  std::atomic<int> readers_ = 0;

  // What readers see; guarded by mutex_.
  mutable std::mutex mutex_;
  std::condition_variable has_job_, has_news_;
  Job job_;
  bool is_busy_ = false;
  const char* activity_ = "";
  std::uint64_t version_ = 1, structure_number_ = 0, sequence_ = 0;
  Message form_message_, structure_message_, frame_message_;
  std::optional<FileFacts> facts_;
  std::string error_;
  double chi2_ = 0, chi2_initial_ = 0;
  int run_number_ = 0;
  bool has_run_ = false;
  std::string status_, headline_, summary_;
  std::vector<IterationRecord> rows_;
  std::vector<Line> log_;

  std::thread worker_;
};

}  // namespace boxplus::viewer
