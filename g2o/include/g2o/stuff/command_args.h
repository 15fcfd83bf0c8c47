// SPDX-License-Identifier: BSD-3-Clause
// Command lines: -name value, and what is left over.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// Declare parameters, then parse. A flag (a bool) stands alone and turns its default over; lists are
/// separated by commas (numbers) or semicolons.
class G2O_STUFF_API CommandArgs {
 public:
  CommandArgs();
  CommandArgs(const CommandArgs&) = delete;
  CommandArgs& operator=(const CommandArgs&) = delete;
  virtual ~CommandArgs();

  void param(const std::string& name, bool& p, bool defValue, const std::string& desc);
  void param(const std::string& name, int& p, int defValue, const std::string& desc);
  void param(const std::string& name, float& p, float defValue, const std::string& desc);
  void param(const std::string& name, double& p, double defValue, const std::string& desc);
  void param(const std::string& name, std::string& p, const std::string& defValue, const std::string& desc);
  void param(const std::string& name, std::vector<int>& p, const std::vector<int>& defValue,
             const std::string& desc);
  void param(const std::string& name, std::vector<double>& p, const std::vector<double>& defValue,
             const std::string& desc);
  /// What stands without a name, in the order of declaration.
  void paramLeftOver(const std::string& name, std::string& p, const std::string& defValue,
                     const std::string& desc, bool optional = false);

  /// False where a name is unknown, a value is missing or none, or -h or -help was given. `exitOnError` ends
  /// the program then, with the help on standard error (output, for -help).
  bool parseArgs(int argc, char** argv, bool exitOnError = true);
  bool parseArgs(const std::vector<std::string>& args, bool exitOnError = true);
  const std::string& getBanner() const { return _banner; }
  void setBanner(const std::string& banner);
  void printHelp(std::ostream& os);
  /// Whether the last command line gave this parameter.
  bool parsedParam(const std::string& paramFlag) const;
  /// Why parseArgs() failed; empty where the help was asked for.
  const std::string& error() const { return error_; }

 protected:
  struct CommandArgument;
  std::vector<CommandArgument> _args;
  std::vector<CommandArgument> _leftOvers;
  std::string _banner;
  std::string _progName;

 private:
  bool parse(const std::vector<std::string>& args);
  std::string error_;
};

}  // namespace g2o
