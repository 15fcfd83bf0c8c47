// SPDX-License-Identifier: BSD-3-Clause
#include "communicator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>

#include "boxplus/base/error.h"

namespace boxplus::mpi {
namespace {

/// The numbers that one message of add_up() has. Processes pass these messages on, one after the other, so
/// that all of them work at the same time.
constexpr std::size_t kPiece = 1 << 14;

/// Thrown by an operation if another process has failed.
struct FailedTogether : std::exception {};

}  // namespace

Communicator::Communicator(MPI_Comm parent) {
  MPI_Comm_dup(parent, &communicator_);
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &size_);
  values_.resize(2 * static_cast<std::size_t>(size_));
  piece_.resize(kPiece);
}

Communicator::~Communicator() {
  int ended = 0;
  if (MPI_Finalized(&ended) == MPI_SUCCESS && ended == 0) MPI_Comm_free(&communicator_);
}

int Communicator::neighbors() const {
  MPI_Comm here = MPI_COMM_NULL;
  int count = 1;
  MPI_Comm_split_type(communicator_, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &count);
  MPI_Comm_free(&here);
  return count;
}

void Communicator::together(detail::FunctionRef<void()> f) {
  Failure failure = Failure::kNone;
  std::string message;
  try {
    f();
    exchange_errors();  // those of processes that have come further, or that have failed at last
    return;
  } catch (const FailedTogether&) {
    // Another process has failed.
  } catch (const std::bad_alloc&) {
    failure = Failure::kNoMemory;
  } catch (const InvalidArgument& error) {
    failure = Failure::kInvalidArgument;
    message = error.what();
  } catch (const std::exception& error) {
    failure = Failure::kError;
    message = error.what();
  }
  if (failure != Failure::kNone) {  // takes part in the exchange that the others have reached
    int worst = static_cast<int>(failure);
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, communicator_);
  }
  fail_together(failure, message);
}

/// Throws FailedTogether if another process has failed.
void Communicator::exchange_errors() {
  int worst = static_cast<int>(Failure::kNone);
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, communicator_);
  if (worst != static_cast<int>(Failure::kNone)) throw FailedTogether();
}

/// Throws what the failed process with the lowest rank has thrown.
void Communicator::fail_together(Failure failure, const std::string& message) {
  int first = failure == Failure::kNone ? size_ : rank_;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator_);
  int kind = static_cast<int>(failure), length = static_cast<int>(message.size());
  MPI_Bcast(&kind, 1, MPI_INT, first, communicator_);
  MPI_Bcast(&length, 1, MPI_INT, first, communicator_);
  std::string text = message;
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, first, communicator_);
  switch (static_cast<Failure>(kind)) {
    case Failure::kNoMemory:
      throw std::bad_alloc();
    case Failure::kInvalidArgument:
      throw InvalidArgument(text);
    default:
      throw Error(text);
  }
}

/// Fills values_ with the values of all processes.
void Communicator::gather_values(double here) {
  exchange_errors();
  MPI_Allgather(&here, 1, MPI_DOUBLE, values_.data(), 1, MPI_DOUBLE, communicator_);
  sent_ += sizeof(double) * static_cast<std::uint64_t>(size_ - 1);
}

double Communicator::sum(double here) {
  gather_values(here);
  return std::accumulate(values_.begin() + 1, values_.begin() + size_, values_.front());
}

double Communicator::max(double here) {
  gather_values(here);
  const std::span<const double> values(values_.data(), static_cast<std::size_t>(size_));
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
    return std::numeric_limits<double>::quiet_NaN();
  return *std::ranges::max_element(values);
}

/// Each piece goes from the first process to the last one, which has the sum, and then around to all others.
void Communicator::add_up(std::span<double> entries) {
  exchange_errors();
  if (size_ == 1) return;
  const int last = size_ - 1, next = (rank_ + 1) % size_, previous = (rank_ + last) % size_;
  const auto for_each_piece = [&](auto&& f) {
    for (std::size_t first = 0; first < entries.size(); first += kPiece)
      f(entries.subspan(first, std::min(kPiece, entries.size() - first)));
  };
  const auto receive = [&](double* to, std::size_t count) {
    MPI_Recv(to, static_cast<int>(count), MPI_DOUBLE, previous, 0, communicator_, MPI_STATUS_IGNORE);
  };
  const auto send = [&](std::span<const double> piece) {
    MPI_Send(piece.data(), static_cast<int>(piece.size()), MPI_DOUBLE, next, 0, communicator_);
    sent_ += piece.size_bytes();
  };
  for_each_piece([&](std::span<double> piece) {
    if (rank_ > 0) {
      receive(piece_.data(), piece.size());
      for (std::size_t i = 0; i < piece.size(); ++i) piece[i] = piece_[i] + piece[i];
    }
    if (rank_ < last) send(piece);
  });
  for_each_piece([&](std::span<double> piece) {
    if (rank_ < last) receive(piece.data(), piece.size());
    if (next != last) send(piece);
  });
}

std::vector<char> Communicator::gather_bytes(const void* data, std::size_t bytes, std::vector<int>& counts) {
  if (sum(static_cast<double>(bytes)) > std::numeric_limits<int>::max())
    throw Error("a message of MPI would have more than 2 GiB");
  const int here = static_cast<int>(bytes);
  counts.resize(static_cast<std::size_t>(size_));
  MPI_Allgather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator_);
  std::vector<int> first(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), first.begin(), 0);
  std::vector<char> all(static_cast<std::size_t>(first.back()) + static_cast<std::size_t>(counts.back()));
  MPI_Allgatherv(data, here, MPI_CHAR, all.data(), counts.data(), first.data(), MPI_CHAR, communicator_);
  sent_ += (bytes + sizeof(int)) * static_cast<std::uint64_t>(size_ - 1);
  return all;
}

std::vector<std::uint64_t> Communicator::gather(std::span<const std::uint64_t> here,
                                                std::vector<int>* counts) {
  std::vector<int> bytes;
  const std::vector<char> all = gather_bytes(here.data(), here.size_bytes(), bytes);
  std::vector<std::uint64_t> result(all.size() / sizeof(std::uint64_t));
  std::copy_n(all.data(), all.size(), reinterpret_cast<char*>(result.data()));
  if (counts != nullptr) {
    counts->clear();
    for (const int count : bytes) counts->push_back(count / static_cast<int>(sizeof(std::uint64_t)));
  }
  return result;
}

void Communicator::visit_at_first(std::span<const std::uint64_t> here,
                                  detail::FunctionRef<void(std::span<const std::uint64_t>)> f) {
  constexpr std::size_t kMost = 1 << 20;  // the items of a message
  const auto most = static_cast<std::size_t>(max(static_cast<double>(here.size())));
  std::vector<std::uint64_t> items;
  if (is_first()) items.reserve(most);
  exchange_errors();  // from here on, the others rely on it that the first process receives everything
  if (!is_first()) {
    const std::uint64_t count = here.size();
    MPI_Send(&count, 1, MPI_UINT64_T, 0, 0, communicator_);
    sent_ += sizeof(count) + here.size_bytes();
    for (; !here.empty(); here = here.subspan(std::min(kMost, here.size())))
      MPI_Send(here.data(), static_cast<int>(std::min(kMost, here.size())), MPI_UINT64_T, 0, 0,
               communicator_);
    return;
  }
  std::exception_ptr failure;
  const auto visit = [&](std::span<const std::uint64_t> of_process) {
    try {
      if (!failure) f(of_process);
    } catch (...) {
      failure = std::current_exception();
    }
  };
  visit(here);
  for (int rank = 1; rank < size_; ++rank) {
    std::uint64_t count = 0;
    MPI_Recv(&count, 1, MPI_UINT64_T, rank, 0, communicator_, MPI_STATUS_IGNORE);
    items.resize(count);
    for (std::size_t first = 0; first < count; first += kMost)
      MPI_Recv(items.data() + first, static_cast<int>(std::min(kMost, count - first)), MPI_UINT64_T, rank, 0,
               communicator_, MPI_STATUS_IGNORE);
    visit(items);
  }
  if (failure) std::rethrow_exception(failure);
}

std::vector<std::string> Communicator::gather(const std::string& here) {
  std::vector<int> counts;
  const std::vector<char> all = gather_bytes(here.data(), here.size(), counts);
  std::vector<std::string> result;
  const char* next = all.data();
  for (const int count : counts) {
    result.emplace_back(next, static_cast<std::size_t>(count));
    next += count;
  }
  return result;
}

}  // namespace boxplus::mpi
