// SPDX-License-Identifier: BSD-3-Clause
// The collective operations of processes that share a problem.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "boxplus/base/function_ref.h"

namespace boxplus::mpi {

/// A communicator of its own. Every operation begins with an exchange of errors, so that an exception of one
/// process ends the operation in all of them (together()), whichever operation they have reached.
///
/// Sums add the contributions in the order of ranks, so that their bits repeat, and are the same everywhere.
class Communicator {
 public:
  explicit Communicator(MPI_Comm parent);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_first() const { return rank_ == 0; }
  /// The number of processes on this machine.
  int neighbors() const;

  /// Calls f. If it throws in any process, throws in all of them: InvalidArgument, std::bad_alloc or Error,
  /// as the process with the lowest rank did, and with its message.
  void together(detail::FunctionRef<void()> f);

  /// Calls f, in which processes wait for each other without this class. If memory runs out in one of them,
  /// it calls MPI's error handler, which ends all processes, unless the program has replaced it.
  template <class F>
  auto while_others_wait(F&& f) const {
    try {
      return f();
    } catch (const std::bad_alloc&) {
      (void)MPI_Comm_call_errhandler(communicator_, MPI_ERR_NO_MEM);
      throw;
    }
  }

  double sum(double here);
  double max(double here);
  bool any(bool here) { return max(here ? 1 : 0) > 0; }
  /// Replaces each entry by the sum of the entries of all processes. The vectors have the same size.
  void add_up(std::span<double> entries);
  /// The items of all processes, in the order of ranks. `counts` gets the number of each process.
  std::vector<std::uint64_t> gather(std::span<const std::uint64_t> here, std::vector<int>* counts = nullptr);
  /// Calls f in the first process, with the items of one process after the other, in the order of ranks. The
  /// first process holds the items of one other process at a time.
  void visit_at_first(std::span<const std::uint64_t> here,
                      detail::FunctionRef<void(std::span<const std::uint64_t>)> f);
  /// The texts of all processes.
  std::vector<std::string> gather(const std::string& here);

  /// The bytes that this process has sent. (Of operations of MPI, those that it passes to each other
  /// process.)
  std::uint64_t sent_bytes() const { return sent_; }

 private:
  enum class Failure : int { kNone, kError, kInvalidArgument, kNoMemory };

  void exchange_errors();
  [[noreturn]] void fail_together(Failure failure, const std::string& message);
  void gather_values(double here);
  std::vector<char> gather_bytes(const void* data, std::size_t bytes, std::vector<int>& counts);

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
  std::uint64_t sent_ = 0;
  std::vector<double> values_;  // of sum() and max(): one of each process
  std::vector<double> piece_;   // of add_up()
};

}  // namespace boxplus::mpi
