// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/command_args.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <locale>
#include <sstream>

namespace g2o {

namespace {

enum Type { kDouble, kFloat, kInt, kString, kBool, kIntegers, kNumbers, kTypeCount };
constexpr std::array<const char*, kTypeCount> kTypeNames = {
    "<double>", "<float>", "<int>", "<string>", "<bool>", "<vector_int>", "<vector_double>"};
/// What a parameter expects on the command line. A flag expects nothing.
constexpr std::array<const char*, kTypeCount> kExpectations = {"a number",
                                                               "a number",
                                                               "an integer",
                                                               "a value",
                                                               "",
                                                               "integers separated by commas",
                                                               "numbers separated by commas"};

template <class T>
bool read(const std::string& text, T& value) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  T read_value{};
  if (!(in >> read_value) || !(in >> std::ws).eof()) return false;
  value = read_value;
  return true;
}

bool read(const std::string& text, std::string& value) {
  value = text;
  return true;
}

template <class T>
bool read(std::string text, std::vector<T>& values) {
  std::replace(text.begin(), text.end(), ';', ',');
  std::istringstream in(text);
  std::vector<T> read_values;
  for (std::string item; std::getline(in, item, ',');) {
    if (!read(item, read_values.emplace_back())) return false;
  }
  values = std::move(read_values);
  return true;
}

template <class T>
std::string to_text(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

template <class T>
std::string to_text(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ",") + to_text(value);
  return text;
}

/// Calls `visit` with the variable that stores the value of a parameter.
template <class Argument, class Visit>
auto visit_value(const Argument& argument, Visit visit) {
  switch (argument.type) {
    case kDouble:
      return visit(*static_cast<double*>(argument.data));
    case kFloat:
      return visit(*static_cast<float*>(argument.data));
    case kInt:
      return visit(*static_cast<int*>(argument.data));
    case kBool:
      return visit(*static_cast<bool*>(argument.data));
    case kIntegers:
      return visit(*static_cast<std::vector<int>*>(argument.data));
    case kNumbers:
      return visit(*static_cast<std::vector<double>*>(argument.data));
    default:
      return visit(*static_cast<std::string*>(argument.data));
  }
}

template <class Argument>
bool set_from_text(const Argument& argument, const std::string& text) {
  return visit_value(argument, [&](auto& value) { return read(text, value); });
}

}  // namespace

CommandArgs::CommandArgs() = default;
CommandArgs::~CommandArgs() = default;

#define G2O_VALUE_PARAMETER_(Type, number, Default)                                                      \
  void CommandArgs::param(const std::string& name, Type& p, Default defValue, const std::string& desc) { \
    p = defValue;                                                                                        \
    _args.push_back({name, desc, number, &p, false, true, to_text(defValue)});                           \
  }
G2O_VALUE_PARAMETER_(int, kInt, int)
G2O_VALUE_PARAMETER_(float, kFloat, float)
G2O_VALUE_PARAMETER_(double, kDouble, double)
G2O_VALUE_PARAMETER_(std::string, kString, const std::string&)
G2O_VALUE_PARAMETER_(std::vector<int>, kIntegers, const std::vector<int>&)
G2O_VALUE_PARAMETER_(std::vector<double>, kNumbers, const std::vector<double>&)
#undef G2O_VALUE_PARAMETER_

void CommandArgs::param(const std::string& name, bool& p, bool defValue, const std::string& desc) {
  p = defValue;
  _args.push_back({name, desc, kBool, &p, false, true, defValue ? "on" : "off"});
}

void CommandArgs::paramLeftOver(const std::string& name, std::string& p, const std::string& defValue,
                                const std::string& desc, bool optional) {
  p = defValue;
  _leftOvers.push_back({name, desc, kString, &p, false, optional, defValue});
}

bool CommandArgs::parseArgs(int argc, char** argv, bool exitOnError) {
  if (argc > 0) _progName = argv[0];
  return parseArgs(std::vector<std::string>(argv + std::min(1, argc), argv + argc), exitOnError);
}

bool CommandArgs::parseArgs(const std::vector<std::string>& args, bool exitOnError) {
  if (parse(args)) return true;
  if (!exitOnError) return false;
  if (!error_.empty()) std::cerr << error_ << "\n\n";
  printHelp(error_.empty() ? std::cout : std::cerr);
  std::exit(error_.empty() ? EXIT_SUCCESS : EXIT_FAILURE);
}

bool CommandArgs::parse(const std::vector<std::string>& args) {
  error_.clear();
  for (CommandArgument& argument : _args) argument.parsed = false;
  size_t left_over = 0;
  for (size_t i = 0; i < args.size(); ++i) {
    const std::string& text = args[i];
    if (text == "-h" || text == "-help" || text == "--help") return false;
    if (text.size() < 2 || text[0] != '-') {
      if (left_over == _leftOvers.size()) {
        error_ = "too many arguments: " + text;
        return false;
      }
      set_from_text(_leftOvers[left_over++], text);
      continue;
    }
    const std::string name = text.substr(text.compare(0, 2, "--") == 0 ? 2 : 1);
    const auto argument =
        std::find_if(_args.begin(), _args.end(), [&](const auto& a) { return a.name == name; });
    if (argument == _args.end()) {
      error_ = "unknown parameter: " + text;
      return false;
    }
    argument->parsed = true;
    if (argument->type == kBool) {
      *static_cast<bool*>(argument->data) = argument->default_text == "off";
    } else if (++i == args.size() || !set_from_text(*argument, args[i])) {
      error_ = "parameter " + text + ": expected " + kExpectations[static_cast<size_t>(argument->type)] +
               ", got " + (i == args.size() ? "nothing" : "'" + args[i] + "'");
      return false;
    }
  }
  while (left_over < _leftOvers.size() && _leftOvers[left_over].optional) ++left_over;
  if (left_over == _leftOvers.size()) return true;
  error_ = "missing argument: " + _leftOvers[left_over].name;
  return false;
}

const char* CommandArgs::type2str(int t) const {
  return t >= 0 && t < kTypeCount ? kTypeNames[static_cast<size_t>(t)] : "";
}

void CommandArgs::str2arg(const std::string& input, CommandArgument& ca) const {
  set_from_text(ca, input);
}

std::string CommandArgs::arg2str(const CommandArgument& ca) const {
  return visit_value(ca, [](const auto& value) { return to_text(value); });
}

void CommandArgs::setBanner(const std::string& banner) {
  _banner = banner;
}

bool CommandArgs::parsedParam(const std::string& paramFlag) const {
  return std::any_of(_args.begin(), _args.end(),
                     [&](const auto& a) { return a.name == paramFlag && a.parsed; });
}

void CommandArgs::printHelp(std::ostream& os) {
  if (!_banner.empty()) os << _banner << "\n";
  os << "Usage: " << _progName << " [options]";
  for (const CommandArgument& argument : _leftOvers)
    os << (argument.optional ? " [" : " <") << argument.name << (argument.optional ? "]" : ">");
  os << "\n\nOptions:\n";
  size_t width = std::string("help").size();
  for (const CommandArgument& argument : _args) width = std::max(width, argument.name.size());
  const auto line = [&](const std::string& name, const std::string& text) {
    os << "-" << name << std::string(width + 4 - name.size(), ' ') << text << "\n";
  };
  for (const CommandArgument& argument : _args) {
    const std::string& value = argument.default_text;
    line(argument.name, argument.description + (value.empty() ? "" : " (default: " + value + ")"));
  }
  line("help", "displays this help");
  for (const CommandArgument& argument : _leftOvers)
    os << "\n" << argument.name << ": " << argument.description << "\n";
}

}  // namespace g2o
