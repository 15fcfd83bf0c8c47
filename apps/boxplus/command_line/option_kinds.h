// SPDX-License-Identifier: BSD-3-Clause
// Options whose values are checked; error messages name the expected and the given value.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace boxplus::app {

/// Names and their values, in the order of the help texts.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// Accepts only these words. The description is "{a,b,…}", which help texts and completions read.
CLI::Validator one_of(std::vector<std::string> words);
/// Accepts any text that is not empty: an empty name is a mistake, such as an unset shell variable.
CLI::Validator file_name();
/// Accepts whole numbers ≥ `low`.
CLI::Validator whole_number_from(long low);
/// The first accepts whole numbers in [low, high], the second any finite numbers in [low, high].
CLI::Validator whole_number_within(long low, long high);
CLI::Validator number_within(double low, double high);
/// The first accepts finite numbers ≥ `low`, the second those > `low`.
CLI::Validator number_from(double low);
CLI::Validator number_above(double low);

/// An option that chooses one of `choices`; the default is the current value.
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
