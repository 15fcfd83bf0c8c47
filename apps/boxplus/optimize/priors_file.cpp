// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/priors_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/number_from_chars.h"
#include "boxplus/base/error.h"
#include "command_line/message.h"

namespace boxplus::app {
namespace {

/// The fields of one line, each with the column at which it begins.
struct Field {
  std::string_view text;
  std::int64_t column;
};

std::vector<Field> fields_of(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view text = line.substr(begin, end - begin);
    const std::size_t blanks = std::min(text.find_first_not_of(" \t\""), text.size());
    text.remove_prefix(blanks);
    while (!text.empty() && std::string_view(" \t\r\"").find(text.back()) != std::string_view::npos)
      text.remove_suffix(1);
    fields.push_back({text, static_cast<std::int64_t>(begin + blanks + 1)});
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

class PriorsParser {
 public:
  PriorsParser(std::string_view text, std::string name) : name_(std::move(name)) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      read(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (columns_.empty()) fail({{}, 1}, "expected a row with the names of columns, got an empty file");
  }
  std::vector<ImagePriors> take() { return std::move(rows_); }

 private:
  void read(std::string_view line) {
    const std::vector<Field> fields = fields_of(line);
    if (fields.size() == 1 && fields[0].text.empty()) return;
    if (columns_.empty()) return read_names(fields);
    if (fields.size() != columns_.size()) {
      fail(fields.back(),
           fmt::format("expected {} fields, as in the first row, got {}", columns_.size(), fields.size()));
    }
    fields_ = &fields;
    ImagePriors row;
    row.line = line_;
    row.image = fields[columns_.at("image")].text;
    if (const auto [at, is_new] = lines_.try_emplace(row.image, line_); !is_new)
      fail(fields[columns_.at("image")],
           fmt::format("expected each image once, got the image of line {} again", at->second));
    row.position = vector("x", "y", "z");
    row.gravity = vector("gx", "gy", "gz");
    if (row.gravity) {
      const double length = row.gravity->norm();
      if (!(length > 0)) fail(fields[columns_.at("gx")], "expected a direction, got zeros");
      *row.gravity /= length;
    }
    constexpr std::array kSigmas{"sigma_x", "sigma_y", "sigma_z"};
    for (int i = 0; i < 3; ++i) row.sigma[i] = sigma(kSigmas[i], sigma("sigma", 1));
    row.gravity_sigma = sigma("gravity_sigma", row.gravity_sigma);
    rows_.push_back(std::move(row));
  }

  void read_names(const std::vector<Field>& fields) {
    constexpr std::array kNames{"image",   "x",       "y",  "z",  "sigma", "sigma_x",
                                "sigma_y", "sigma_z", "gx", "gy", "gz",    "gravity_sigma"};
    for (std::size_t k = 0; k < fields.size(); ++k) {
      if (std::find(kNames.begin(), kNames.end(), fields[k].text) == kNames.end()) {
        fail(fields[k], fmt::format("expected one of the columns {}, got '{}'", fmt::join(kNames, ", "),
                                    escaped(fields[k].text)));
      }
      if (!columns_.try_emplace(std::string(fields[k].text), k).second)
        fail(fields[k], fmt::format("expected each column once, got '{}' again", fields[k].text));
    }
    const auto require_all = [&](std::initializer_list<const char*> names) {
      for (const char* name : names) {
        if (!columns_.contains(name)) fail(fields[0], fmt::format("expected a column '{}'", name));
      }
    };
    require_all({"image"});
    if (!columns_.contains("gx")) require_all({"x"});
    if (columns_.contains("x")) require_all({"y", "z"});
    if (columns_.contains("gx")) require_all({"gy", "gz"});
  }

  /// The three fields, or nothing if there are no such columns, or if the fields are empty.
  std::optional<Vector3> vector(const char* x, const char* y, const char* z) const {
    if (!columns_.contains(x)) return std::nullopt;
    const auto is_empty = [&](const char* name) { return (*fields_)[columns_.at(name)].text.empty(); };
    if (is_empty(x) && is_empty(y) && is_empty(z)) return std::nullopt;
    return Vector3(number(x), number(y), number(z));
  }
  double sigma(const char* name, double otherwise) const {
    if (!columns_.contains(name) || (*fields_)[columns_.at(name)].text.empty()) return otherwise;
    const double value = number(name);
    if (!(value > 0))
      fail((*fields_)[columns_.at(name)], fmt::format("expected {} above 0, got {}", name, value));
    return value;
  }
  double number(const char* name) const {
    const Field& field = (*fields_)[columns_.at(name)];
    double value = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [stop, error] = number_from_chars(field.text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      fail(field, fmt::format("expected {}, got '{}'", name, escaped(field.text)));
    return value;
  }
  [[noreturn]] void fail(const Field& field, const std::string& message) const {
    throw InputError(name_, line_, field.column, message);
  }

  std::string name_;
  std::int64_t line_ = 0;
  std::map<std::string, std::size_t, std::less<>> columns_;
  const std::vector<Field>* fields_ = nullptr;
  std::map<std::string, std::int64_t> lines_;  // of images
  std::vector<ImagePriors> rows_;
};

}  // namespace

std::vector<ImagePriors> parse_priors(std::string_view text, const std::string& name) {
  return PriorsParser(text, name).take();
}

}  // namespace boxplus::app
