// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

namespace g2o {

/// A stream into the buffer of another that writes every double as the shortest text that reads back to the
/// same double, whatever the locale. In the end the other knows where the buffer took no more.
class ShortestNumbers {
 public:
  explicit ShortestNumbers(std::ostream& os);
  ShortestNumbers(const ShortestNumbers&) = delete;
  ShortestNumbers& operator=(const ShortestNumbers&) = delete;
  ~ShortestNumbers();
  std::ostream& stream() { return stream_; }
  /// Whether all has been written so far.
  bool good() const { return stream_.good() && to_.good(); }

 private:
  std::ostream& to_;
  std::ostream stream_;
};

}  // namespace g2o
