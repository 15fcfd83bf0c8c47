// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

namespace g2o {

/// Writes into the buffer of another stream. Every double becomes the shortest text that reads back as the
/// same double, in any locale. The destructor sets badbit of the other stream if writing to the buffer
/// failed.
class ShortestNumbers {
 public:
  explicit ShortestNumbers(std::ostream& os);
  ShortestNumbers(const ShortestNumbers&) = delete;
  ShortestNumbers& operator=(const ShortestNumbers&) = delete;
  ~ShortestNumbers();
  std::ostream& stream() { return stream_; }
  /// Whether everything so far was written.
  bool good() const { return stream_.good() && to_.good(); }

 private:
  std::ostream& to_;
  std::ostream stream_;
};

}  // namespace g2o
