// SPDX-License-Identifier: BSD-3-Clause
// The exceptions of boxplus. A numerical failure is never an exception; it is a status in the Report.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace boxplus {

/// The base class of all exceptions of boxplus. For misuse, what() names the expected and the given value.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument that breaks the contract of the called function (wrong size, stale handle, indefinite
/// information …).
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

/// Bad input in a file: what() is "file:line:column: expected …, got …".
class InputError : public Error {
 public:
  InputError(const std::string& file, std::int64_t line, std::int64_t column, const std::string& message)
      : Error(file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message),
        line_(line),
        column_(column) {}
  std::int64_t line() const noexcept { return line_; }
  std::int64_t column() const noexcept { return column_; }

 private:
  std::int64_t line_, column_;
};

/// A file that cannot be opened, read or written.
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace boxplus
