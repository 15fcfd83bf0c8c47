// SPDX-License-Identifier: BSD-3-Clause
// Checks the values of options. Error messages name the expected and the given value.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace boxplus::app {

/// The names that an option accepts and the value for each name, in the order of the help texts.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// Accepts only the given words. The description of the validator is "{a,b,…}". Help texts and shell
/// completions get the words from this description.
CLI::Validator one_of(std::vector<std::string> words);
/// Accepts any text that is not empty. An empty file name usually comes from a shell variable that is not
/// set.
CLI::Validator file_name();
/// Accepts whole numbers from `low` to the largest int.
CLI::Validator whole_number_from(long low);
/// Accepts whole numbers from `low` to `high`.
CLI::Validator whole_number_within(long low, long high);
/// Accepts finite numbers from `low` to `high`.
CLI::Validator number_within(double low, double high);
/// Accepts finite numbers ≥ `low`.
CLI::Validator number_from(double low);
/// Accepts finite numbers > `low`.
CLI::Validator number_above(double low);

/// Adds an option that accepts the names of `choices` and sets `value`. Its default is the current `value`.
template <class T>
CLI::Option* add_choice(CLI::App& command, const std::string& name, T& value, const Choices<T>& choices,
                        const std::string& text) {
  std::vector<std::string> words;
  std::string default_word;
  for (const auto& [word, meaning] : choices) {
    words.push_back(word);
    if (meaning == value) default_word = word;
  }
  const auto choose = [&value, choices](const std::string& chosen) {
    for (const auto& [word, meaning] : choices) {
      if (word == chosen) value = meaning;
    }
  };
  return command.add_option_function<std::string>(name, choose, text)
      ->check(one_of(std::move(words)))
      ->default_str(default_word);
}

}  // namespace boxplus::app
