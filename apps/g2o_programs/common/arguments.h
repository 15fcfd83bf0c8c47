// SPDX-License-Identifier: BSD-3-Clause
// The switches of a program, in g2o's style (-name value).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "g2o/stuff/command_args.h"

namespace boxplus::programs {

/// Declare all switches, then call parse(). Each switch has a range, which the help and the message of an
/// error contain.
class Arguments {
 public:
  explicit Arguments(const std::string& banner) { args_.setBanner(banner); }

  /// A flag, which is off by default.
  void flag(const char* name, bool& value, const char* text) { args_.param(name, value, false, text); }
  /// The default is the value that the variable has.
  void text(const char* name, std::string& value, const char* text);
  void count(const char* name, int& value, int least, int most, const char* text);
  void number(const char* name, double& value, double least, double most, const char* text);
  /// Numbers that are separated by commas or semicolons; as many as the variable has.
  void numbers(const char* name, std::vector<double>& values, double least, double most, const char* text);
  /// An argument without a name, which may be missing.
  void positional(const char* name, std::string& value, const char* text);

  /// Reads the command line. Ends the program with the help if the user asked for it (exit code 0), or if the
  /// command line is wrong (exit code 1).
  void parse(int argc, char** argv);
  /// Whether the command line has this switch.
  bool has(const char* name) const { return args_.parsedParam(name); }

 private:
  /// Returns what was expected if a value is out of its range, and otherwise an empty text.
  using Check = std::function<std::string()>;

  g2o::CommandArgs args_;
  std::vector<std::pair<std::string, Check>> checks_;  // with the names of the switches
};

}  // namespace boxplus::programs
