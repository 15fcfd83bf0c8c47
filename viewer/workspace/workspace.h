// SPDX-License-Identifier: BSD-3-Clause
// The graph of the viewer, the thread that works on it, and what its readers see.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "viewer/server/messages.h"

namespace boxplus::viewer {

/// Owns a graph and one worker thread, which optimizes it. Commands come from any thread and return at once.
/// Any number of readers on other threads get the messages of PROTOCOL.md. A slow reader misses frames; it
/// never delays the worker.
///
/// While the worker runs, a frame is made at most 30 times a second, in at most 1/25 of the time, and only if
/// there is a reader.
class Workspace {
 public:
  /// The graph must have estimates. `name` is shown to the user.
  Workspace(GraphFile file, std::string name);
  /// Stops the run.
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  static constexpr int kMostIterations = 10'000;
  /// These throw InvalidArgument while a run is in progress, and if `iterations` is not in [1,
  /// kMostIterations].
  void optimize(int iterations);
  void step();
  /// Restores the estimates of the file.
  void reset();
  /// Asks the run to stop. Its best estimates are kept.
  void stop();

  /// Stops the run, refuses all later commands, and wakes all readers.
  void end();

  /// A reader of the messages. It must not outlive the workspace.
  class Reader {
   public:
    /// `greeting` is a JSON object whose members become members of the first state.
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
  enum class Job : std::uint8_t { kNone, kOptimize, kStep, kReset };
  struct Line {
    const char* level;
    std::string text;
  };

  void request(Job job, int iterations);
  void work();
  void run(Job job, int iterations);
  void restore();
  bool note(const IterationRecord& record);
  void finish(const Report& report);
  void add_line(const char* level, std::string text);
  void make_frame(int iteration, double chi2, bool at_rest);

  // Used by the worker only, after the constructor.
  GraphFile file_;
  Structure structure_;
  std::unique_ptr<Optimizer> optimizer_;
  std::chrono::steady_clock::time_point next_frame_{};

  const std::string name_;
  std::atomic<bool> stop_ = false, ending_ = false;
  std::atomic<int> readers_ = 0;

  // What readers see; guarded by mutex_.
  mutable std::mutex mutex_;
  std::condition_variable has_job_, has_news_;
  Job job_ = Job::kNone;
  int iterations_ = 0;
  bool is_busy_ = false;
  std::uint64_t version_ = 1, structure_number_ = 1, sequence_ = 0;
  Message structure_message_, frame_message_;
  double chi2_ = 0, chi2_initial_ = 0;
  int run_number_ = 0;
  std::string status_, headline_, summary_;
  std::vector<IterationRecord> rows_;
  std::vector<Line> log_;

  std::thread worker_;
};

}  // namespace boxplus::viewer
