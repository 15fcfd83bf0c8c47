// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/whole_run.h"

#include <fmt/core.h>
#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace boxplus::bench {
namespace {

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

}  // namespace

double peak_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  }
  throw std::runtime_error("/proc/self/status: expected a line VmHWM");
}

void print_whole_run(double seconds, double chi2) {
  fmt::print("{:.9g} {:.17g} {:.9g}\n", seconds, chi2, peak_mib());
}

std::string output_of(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += quoted(word) + " ";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string line;
  for (int c = std::fgetc(pipe); c != EOF && c != '\n'; c = std::fgetc(pipe)) line += static_cast<char>(c);
  const int status = pclose(pipe);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("failed: " + command);
  return line;
}

WholeRun run_process(const std::vector<std::string>& words) {
  WholeRun run;
  const std::string line = output_of(words);
  if (std::sscanf(line.c_str(), "%lf %lf %lf", &run.seconds, &run.chi2, &run.peak_mib) != 3)
    throw std::runtime_error(words.front() + ": cannot read '" + line + "'");
  return run;
}

}  // namespace boxplus::bench
