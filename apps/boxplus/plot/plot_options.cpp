// SPDX-License-Identifier: BSD-3-Clause
#include "plot/plot_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/number_from_chars.h"
#include "boxplus/base/error.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

const Choices<PlotFormat> kFormats{{"svg", PictureFormat::kSvg},
                                   {"pdf", PictureFormat::kPdf},
                                   {"png", PictureFormat::kPng},
                                   {"html", std::nullopt}};
constexpr const char* kLookGroup = "Look";
const Choices<View> kViews{{"top", {0, 90}}, {"side", {0, 0}}, {"iso", {-45, 35.264389682754654}}};

/// Parses "A<separator>B" as two finite numbers.
std::optional<std::pair<double, double>> two_numbers(const std::string& text, char separator) {
  std::pair<double, double> values;
  const char *begin = text.data(), *end = begin + text.size(), *middle = std::find(begin, end, separator);
  if (middle == end) return std::nullopt;
  const auto first = number_from_chars(begin, middle, values.first);
  const auto second = number_from_chars(middle + 1, end, values.second);
  const bool good = first.ec == std::errc() && first.ptr == middle && second.ec == std::errc() &&
                    second.ptr == end && std::isfinite(values.first) && std::isfinite(values.second);
  return good ? std::optional(values) : std::nullopt;
}

std::optional<View> view_of(const std::string& text) {
  for (const auto& [word, view] : kViews) {
    if (word == text) return view;
  }
  const auto angles = two_numbers(text, ',');
  if (!angles || std::abs(angles->first) > 360 || std::abs(angles->second) > 90) return std::nullopt;
  return View{angles->first, angles->second};
}

std::string complaint_about_view(const std::string& text) {
  if (view_of(text)) return {};
  return fmt::format(
      "expected top, side, iso or AZIMUTH,ELEVATION in degrees (within ±360 and ±90), got '{}'", text);
}

std::string complaint_about_size(const std::string& text) {
  constexpr double kLeast = 16, kMost = 10'000;
  const auto in_range = [](double value) { return value >= kLeast && value <= kMost; };
  const auto size = two_numbers(text, 'x');
  if (size && in_range(size->first) && in_range(size->second)) return {};
  return fmt::format("expected WIDTHxHEIGHT, each from {} to {}, got '{}'", kLeast, kMost, text);
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

void add_input_options(CLI::App& command, PlotArguments& arguments) {
  command.add_option("BEFORE", arguments.before, "The graph to draw; - is standard input")
      ->check(file_name())
      ->required();
  command.add_option("AFTER", arguments.after, "The same graph after optimization")->check(file_name());
  command
      .add_option("-o,--output", arguments.output,
                  "Where to write the picture (.svg, .pdf or .png) or the page (.html), in which one can "
                  "move and zoom; - is standard output")
      ->type_name("FILE")
      ->check(file_name())
      ->required();
  command
      .add_option_function<std::string>(
          "--format",
          [&arguments](const std::string& chosen) {
            for (const auto& [word, format] : kFormats) {
              if (word == chosen) arguments.format = format;
            }
          },
          "The format of the output, if the file name has no extension")
      ->check(one_of({"svg", "pdf", "png", "html"}));
  command
      .add_option(
          "--truth", arguments.truth,
          "A graph with the true poses; they are aligned with the last graph and drawn as a band behind the "
          "trajectory, or as lines from cameras to their true places")
      ->type_name("FILE")
      ->check(file_name());
}

void add_look_options(CLI::App& command, PlotArguments& arguments) {
  PictureOptions& picture = arguments.picture;
  command.add_option("--title", picture.title, "The title of the picture")
      ->type_name("TEXT")
      ->group(kLookGroup);
  command
      .add_option_function<std::string>(
          "--size",
          [&picture](const std::string& text) {
            const auto size = two_numbers(text, 'x');
            picture.width = size->first;
            picture.height = size->second;
          },
          "The size of the picture in pixels (in PDF, points of 1/72 inch); the default is 620x666 per panel")
      ->type_name("WIDTHxHEIGHT")
      ->check(CLI::Validator(complaint_about_size, ""))
      ->group(kLookGroup);
  command
      .add_option("--font-size", picture.font_size,
                  "The size of the text; the default is proportional to the panels")
      ->type_name("X")
      ->check(number_within(1, 200))
      ->group(kLookGroup);
  command
      .add_option("--resolution", arguments.resolution,
                  "PNG: the number of pixels in the file per pixel of the picture")
      ->type_name("X")
      ->check(number_within(0.1, 10))
      ->capture_default_str()
      ->group(kLookGroup);
  command
      .add_flag("--bare", picture.is_bare,
                "For papers: draw only the graphs, without frame, header, legend, scale bar and background")
      ->group(kLookGroup);
  command
      .add_flag("--axes", picture.has_axes,
                "Draw axes with values in meters, or arrows if the view is not along an axis")
      ->group(kLookGroup);
  command
      .add_flag(
          "--ellipses", arguments.has_ellipses,
          "Draw ellipses that contain the poses and points of the last graph with 95 % probability; optimize "
          "this graph first")
      ->group(kLookGroup);
  command
      .add_flag("--reprojection-errors", arguments.has_error_chart,
                "Bundle adjustment: draw the reprojection errors of each image as a box chart, not the graph")
      ->excludes(command.get_option("--truth"))
      ->group(kLookGroup);
  command
      .add_flag("--equal-scale", picture.has_one_scale,
                "Always use one scale for both panels; by default, each panel has its own if one graph would "
                "be tiny")
      ->group(kLookGroup);
  command
      .add_option_function<std::string>(
          "--view", [&arguments](const std::string& text) { arguments.view = *view_of(text); },
          "The view of graphs in space: top, side (along y), iso or AZIMUTH,ELEVATION in degrees")
      ->type_name("VIEW")
      ->check(CLI::Validator(complaint_about_view, ""))
      ->default_str("-31.5,24")
      ->group(kLookGroup);
}

}  // namespace

void add_plot_options(CLI::App& command, PlotArguments& arguments) {
  add_input_options(command, arguments);
  add_look_options(command, arguments);
  add_robust_options(command, arguments.kernel);
  add_reading_options(command, arguments.reading);
}

PlotFormat format_of(const PlotArguments& arguments) {
  const std::string extension = arguments.output == kStandardStream ? "" : extension_of(arguments.output);
  if (extension.empty()) return arguments.format ? *arguments.format : PictureFormat::kSvg;
  for (const auto& [word, format] : kFormats) {
    if (word != extension) continue;
    if (arguments.format && *arguments.format != format)
      throw InvalidArgument(
          fmt::format("--format: expected {} for '{}', got another format", word, arguments.output));
    return format;
  }
  throw InvalidArgument(fmt::format(
      "--output: expected a name that ends with .svg, .pdf, .png or .html, got '{}'", arguments.output));
}

void refuse_options_of_pictures(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool is_of_pictures = option->get_group() == kLookGroup || name == "AFTER" || name == "--truth";
    if (!is_of_pictures || option->count() == 0) continue;
    throw InvalidArgument(name + ": expected a picture (.svg, .pdf or .png), got a page (.html)");
  }
}

}  // namespace boxplus::app
