// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/command_args.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <locale>
#include <sstream>

namespace g2o {

struct CommandArgs::CommandArgument {
  std::string name, description, default_text;
  const char* expected = "";                    // what a value is
  std::function<bool(const std::string&)> set;  // from the text of a value
  std::function<void()> turn_over;              // flags only
  bool optional = true, parsed = false;
};

namespace {

constexpr const char* what(int) {
  return "an integer";
}
constexpr const char* what(double) {
  return "a number";
}
const char* what(const std::string&) {
  return "a value";
}
const char* what(const std::vector<int>&) {
  return "integers separated by commas";
}
const char* what(const std::vector<double>&) {
  return "numbers separated by commas";
}

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

}  // namespace

CommandArgs::CommandArgs() = default;
CommandArgs::~CommandArgs() = default;

#define G2O_VALUE_PARAMETER_(Type, Default)                                                              \
  void CommandArgs::param(const std::string& name, Type& p, Default defValue, const std::string& desc) { \
    p = defValue;                                                                                        \
    _args.push_back({name, desc, to_text(defValue), what(p),                                             \
                     [&p](const std::string& text) { return read(text, p); }, nullptr});                 \
  }
G2O_VALUE_PARAMETER_(int, int)
G2O_VALUE_PARAMETER_(float, float)
G2O_VALUE_PARAMETER_(double, double)
G2O_VALUE_PARAMETER_(std::string, const std::string&)
G2O_VALUE_PARAMETER_(std::vector<int>, const std::vector<int>&)
G2O_VALUE_PARAMETER_(std::vector<double>, const std::vector<double>&)
#undef G2O_VALUE_PARAMETER_

void CommandArgs::param(const std::string& name, bool& p, bool defValue, const std::string& desc) {
  p = defValue;
  _args.push_back({name, desc, defValue ? "on" : "off", "", nullptr, [&p, defValue] { p = !defValue; }});
}

void CommandArgs::paramLeftOver(const std::string& name, std::string& p, const std::string& defValue,
                                const std::string& desc, bool optional) {
  p = defValue;
  _leftOvers.push_back({name, desc, defValue, "a value",
                        [&p](const std::string& text) { return read(text, p); }, nullptr, optional});
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
      _leftOvers[left_over++].set(text);
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
    if (argument->turn_over) {
      argument->turn_over();
    } else if (++i == args.size() || !argument->set(args[i])) {
      error_ = "parameter " + text + ": expected " + argument->expected + ", got " +
               (i == args.size() ? "nothing" : "'" + args[i] + "'");
      return false;
    }
  }
  while (left_over < _leftOvers.size() && _leftOvers[left_over].optional) ++left_over;
  if (left_over == _leftOvers.size()) return true;
  error_ = "missing argument: " + _leftOvers[left_over].name;
  return false;
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
