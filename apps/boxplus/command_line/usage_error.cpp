// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/usage_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "command_line/description.h"

namespace boxplus::app {
namespace {

/// Returns the Levenshtein distance: the smallest number of letters to insert, delete or replace in `a` to
/// get `b`.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

/// Returns "; did you mean X?" if the most similar name, X, is close enough to `word`. Otherwise, returns an
/// empty string.
std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
  const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
  const auto best = std::min_element(names.begin(), names.end(),
                                     [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  const bool close = best != names.end() && distance(*best) <= (word.size() + 1) / 4;
  return close ? fmt::format("; did you mean {}?", *best) : std::string();
}

/// Returns "; did you mean boxplus info --diagnose?" if a command has the option --`word`. Otherwise, returns
/// an empty string.
std::string option_suggestion(const std::string& word, const std::vector<CommandDescription>& commands) {
  for (const CommandDescription& command : commands) {
    for (const OptionDescription& option : command.options) {
      const std::string name = "--" + word;
      if (std::find(option.names.begin(), option.names.end(), name) != option.names.end())
        return fmt::format("; did you mean boxplus {} {}?", command.name, name);
    }
  }
  return {};
}

std::string unexpected(const CommandDescription& command, const std::vector<std::string>& words) {
  const bool options_ended = words.size() > 1 && words.front() == "--";
  const std::string& word = options_ended ? words[1] : words.front();
  std::vector<std::string> names;
  if (word.starts_with("-") && !options_ended) {
    for (const OptionDescription& option : command.options)
      names.insert(names.end(), option.names.begin(), option.names.end());
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("unknown option '{}'{}", word, suggestion(name, names));
  }
  if (command.commands.empty()) return fmt::format("unexpected argument '{}'", word);
  for (const CommandDescription& sub : command.commands) names.push_back(sub.name);
  const std::string similar = suggestion(word, names);
  return fmt::format("unknown command '{}'{}", word,
                     similar.empty() ? option_suggestion(word, command.commands) : similar);
}

/// Rephrases the message "NAME is required" of CLI11.
std::string missing(const std::string& text) {
  return fmt::format("expected {}, got none", text.substr(0, text.find(" is required")));
}

/// Rephrases the message "NAME: …", by which CLI11 reports that an option has too few or too many values.
std::string mismatch(const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  return text.ends_with("missing") ? name + ": expected a value, got none"
                                   : name + ": expected one value, got more";
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& used = chosen.empty() ? app : *chosen.front();
  const CommandDescription command = describe(used);
  const std::vector<std::string> extras = used.remaining(true);
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !extras.empty()) {
    text = unexpected(command, extras);
  } else if (dynamic_cast<const CLI::RequiredError*>(&error)) {
    text = chosen.empty() && !extras.empty() ? unexpected(command, extras)
           : chosen.empty()                  ? "expected a command, got none"
                                             : missing(text);
  } else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    text = mismatch(text);
  }
  const std::string prefix = chosen.empty() ? "" : command.name + ": ";
  return fmt::format("{}{} (see boxplus {}--help)", prefix, text, chosen.empty() ? "" : command.name + " ");
}

}  // namespace boxplus::app
