// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

#include "g2o/core/g2o_core_api.h"

namespace g2o {
namespace internal {

/// A line of a file that load() reads. A type's read() stores its error message here, and load() logs the
/// message with the line number.
class G2O_CORE_API LineStream : public std::istringstream {
 public:
  explicit LineStream(const std::string& line);
  ~LineStream() override;

  std::string problem;
};

/// If `is` is a LineStream, stores the error message in it. Otherwise logs the message.
G2O_CORE_API void complain(std::istream& is, const std::string& problem);

}  // namespace internal
}  // namespace g2o
