// SPDX-License-Identifier: BSD-3-Clause
// Parses command lines with parameters (-name value) and positional arguments.
#pragma once
#ifndef G2O_COMMAND_ARGS_H
#define G2O_COMMAND_ARGS_H

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// Declare all parameters, then call parseArgs(). A bool parameter is a flag: it takes no value, and inverts
/// its default value if it appears on the command line. The numbers of a list are separated by commas or
/// semicolons.
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
  /// Declares a positional argument. Positional arguments are read in the order of their declarations.
  void paramLeftOver(const std::string& name, std::string& p, const std::string& defValue,
                     const std::string& desc, bool optional = false);

  /// Returns false if the command line is invalid or has -h or -help. If `exitOnError` is true, prints the
  /// help and exits instead. The help goes to standard error if the command line is invalid, or to standard
  /// output if it was requested.
  bool parseArgs(int argc, char** argv, bool exitOnError = true);
  bool parseArgs(const std::vector<std::string>& args, bool exitOnError = true);
  const std::string& getBanner() const { return _banner; }
  void setBanner(const std::string& banner);
  void printHelp(std::ostream& os);
  /// Whether the last command line contained this parameter.
  bool parsedParam(const std::string& paramFlag) const;
  /// The reason why parseArgs() failed, or an empty string if help was requested.
  const std::string& error() const { return error_; }

 protected:
  /// A declared parameter. `data` points to the variable that receives the value. `type` is the number of the
  /// variable's type (see type2str()).
  struct CommandArgument {
    std::string name;
    std::string description;
    int type = 0;
    void* data = nullptr;
    bool parsed = false;
    bool optional = true;
    std::string default_text = {};  ///< the default value as text for the help
  };
  std::vector<CommandArgument> _args;
  std::vector<CommandArgument> _leftOvers;
  std::string _banner;
  std::string _progName;

  /// Returns the name of a type, or an empty string for an unknown type. The types double, float, int,
  /// std::string, bool, std::vector<int> and std::vector<double> have the numbers 0 to 6, and the names
  /// <double>, <float>, <int>, <string>, <bool>, <vector_int> and <vector_double>.
  const char* type2str(int t) const;
  /// Sets a parameter from text. If the text is invalid, does not change the parameter.
  void str2arg(const std::string& input, CommandArgument& ca) const;
  /// Returns the current value of a parameter as text.
  std::string arg2str(const CommandArgument& ca) const;

 private:
  bool parse(const std::vector<std::string>& args);
  std::string error_;
};

}  // namespace g2o

#endif  // G2O_COMMAND_ARGS_H
