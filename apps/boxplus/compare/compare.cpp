// SPDX-License-Identifier: BSD-3-Clause
// boxplus compare RESULT TRUTH: measures the distance of a trajectory from the truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/option_kinds.h"
#include "compare/comparison.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "files/trajectory_input.h"

namespace boxplus::app {
namespace {

constexpr const char* kCompareFooter =
    "The poses of two graphs are matched by id. The images of two COLMAP models are matched by name. The\n"
    "cameras of two BAL problems, or of a BAL problem and a COLMAP model, are matched by position, which\n"
    "needs equally many of them, or by name if the images are named 0, 1, ..., like the cameras.\n"
    "The poses of two TUM files (lines of the form \"time x y z qx qy qz qw\") are matched by time: two\n"
    "poses match if each is the nearest in time to the other one and they are at most --max-difference\n"
    "apart. Landmarks are ignored.\n"
    "ATE, the absolute trajectory error, is the distance of each position from the true position, after\n"
    "the whole result has been aligned with the truth. RPE, the relative pose error, is the error of\n"
    "the motion from one pose to a later pose.\n"
    "\n"
    "Examples:\n"
    "  boxplus simulate streets -o before.g2o --truth truth.g2o\n"
    "  boxplus optimize before.g2o -o after.g2o\n"
    "  boxplus compare after.g2o truth.g2o\n"
    "  boxplus compare estimate.txt groundtruth.txt --scale --distance 10 --json - | jq .ate_m.rmse\n"
    "\n"
    "Exit codes: 0 compared; 2 bad input or usage, or no poses match.";

struct CompareArguments {
  std::string result, truth, json;
  AlignmentKind alignment = AlignmentKind::kRigid;
  bool scale = false;
  double most_seconds = 0.01;
  RelativeSpan span;
  ReadOptions reading;
};

/// The RMSE of the ATE with a scale, if the result is of bundle adjustment, whose scale is free, and the
/// scale makes a large difference. Otherwise negative.
double much_lower_with_scale(const CompareArguments& arguments, const Trajectory& result,
                             const std::vector<PosePair>& pairs, double rmse) {
  const bool is_bundle =
      result.source == TrajectorySource::kBal || result.source == TrajectorySource::kColmap;
  constexpr std::size_t kFewest = 3;  // a scale always fits two positions
  if (!is_bundle || pairs.size() < kFewest || arguments.scale || arguments.alignment != AlignmentKind::kRigid)
    return -1;
  try {
    const Alignment scaled = align_poses(pairs, result.dimension, AlignmentKind::kRigid, true);
    const double scaled_rmse = absolute_error(pairs, scaled).rmse;
    return scaled_rmse < 0.5 * rmse ? scaled_rmse : -1;
  } catch (const InvalidArgument&) {
    return -1;  // no scale fits, for example because all poses are at one position
  }
}

Comparison compare(const CompareArguments& arguments) {
  const Trajectory result = read_trajectory(arguments.result, arguments.reading);
  const Trajectory truth = read_trajectory(arguments.truth, arguments.reading);
  const PosePairs matched = matched_poses(result, truth, arguments.most_seconds);
  const std::vector<PosePair>& pairs = matched.pairs;
  if (pairs.empty()) {
    throw FileError(fmt::format("{}: expected poses that match {} by {}, found none",
                                input_name(arguments.result), input_name(arguments.truth),
                                matched.matched_by));
  }
  Comparison comparison;
  comparison.result = input_name(arguments.result);
  comparison.truth = input_name(arguments.truth);
  comparison.result_poses = result.poses.size();
  comparison.truth_poses = truth.poses.size();
  comparison.matched = pairs.size();
  comparison.matched_by = matched.matched_by;
  comparison.kind = arguments.alignment;
  comparison.alignment = align_poses(pairs, truth.dimension, arguments.alignment, arguments.scale);
  comparison.span = arguments.span;
  comparison.absolute = absolute_error(pairs, comparison.alignment);
  comparison.scaled_rmse = much_lower_with_scale(arguments, result, pairs, comparison.absolute.rmse);
  comparison.relative = relative_error(pairs, comparison.alignment.scale, arguments.span);
  return comparison;
}

int compare_files(const CompareArguments& arguments) {
  if (arguments.result == kStandardStream && arguments.truth == kStandardStream)
    throw InvalidArgument("compare: expected at most one file from standard input, got '-' twice");
  const std::vector<Output> outputs{{"--json", arguments.json}};
  refuse_to_replace(outputs.front(), {arguments.result, arguments.truth});
  check_outputs(outputs);
  const Comparison comparison = compare(arguments);
  if (!arguments.json.empty()) write_output(arguments.json, comparison_json(comparison));
  if (!takes_stdout(outputs)) print_summary(outputs, comparison_text(comparison));
  return kSuccess;
}

void add_options(CLI::App& command, CompareArguments& arguments) {
  const std::string forms = fmt::format(": {}, a TUM file, or - for standard input", readable_formats());
  command.add_option("RESULT", arguments.result, "The trajectory to measure" + forms)
      ->required()
      ->check(file_name());
  command.add_option("TRUTH", arguments.truth, "The true trajectory" + forms)->required()->check(file_name());
  add_choice(
      command, "--align", arguments.alignment,
      {{"rigid", AlignmentKind::kRigid}, {"first", AlignmentKind::kFirst}, {"none", AlignmentKind::kNone}},
      "How to align the result with the truth; rigid: minimize the sum of squared distances (Umeyama); "
      "first: let the first poses agree; none: do not align");
  command.add_flag("--scale", arguments.scale, "Let --align rigid also estimate the scale");
  command
      .add_option("--max-difference", arguments.most_seconds,
                  "TUM files: match poses that are at most this many seconds apart")
      ->type_name("SECONDS")
      ->check(number_from(0))
      ->capture_default_str();
  CLI::Option* steps = command
                           .add_option("--steps", arguments.span.steps,
                                       "Compute the RPE between matched poses that are this many poses apart")
                           ->type_name("N")
                           ->check(whole_number_from(1))
                           ->capture_default_str();
  command
      .add_option("--distance", arguments.span.distance,
                  "Instead of --steps: compute the RPE between poses that are this many meters apart along "
                  "the true path")
      ->type_name("METERS")
      ->check(number_above(0))
      ->excludes(steps);
  command
      .add_option("--json", arguments.json,
                  "Where to write the result as JSON; - is stdout, and then no text is printed")
      ->type_name("FILE")
      ->check(file_name())
      ->group("Output");
  add_reading_options(command, arguments.reading);
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Measures the distance of a trajectory from the truth: ATE and RPE");
  add_options(*command, *arguments);
  command->footer(kCompareFooter);
  command->callback([&action, arguments] {
    if (arguments->scale && arguments->alignment != AlignmentKind::kRigid)
      throw CLI::RequiresError("--scale", "--align rigid");
    action = [arguments] { return compare_files(*arguments); };
  });
}

}  // namespace boxplus::app
