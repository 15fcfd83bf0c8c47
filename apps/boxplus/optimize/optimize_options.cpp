// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "boxplus/base/error.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "settings/setting_table.h"

namespace boxplus::app {
namespace {

/// Accepts the texts that `setting` accepts.
CLI::Validator value_of(const Setting& setting) {
  const auto check = [&setting](const std::string& text) {
    try {
      RunSettings scratch;
      setting.set(scratch, text);
      return std::string();
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  return {check, setting.words.empty() ? "" : fmt::format("{{{}}}", fmt::join(setting.words, ","))};
}

/// Adds the settings of one group of the table as options.
void add_settings(CLI::App& command, std::string_view group, RunSettings& settings) {
  for (const Setting& setting : setting_table()) {
    if (setting.group != group) continue;
    const auto set = [&settings, &setting](const std::string& text) { setting.set(settings, text); };
    CLI::Option* option = command.add_option_function<std::string>("--" + setting.name, set, setting.help);
    option->check(value_of(setting))->default_str(setting.default_text)->group(setting.group);
    if (!setting.unit.empty()) option->type_name(setting.unit);
    // Whether another option has the needed value is known after parsing (require_needed_values()).
    if (!setting.needed_setting.empty() && setting.needed_value.empty())
      option->needs(command.get_option("--" + setting.needed_setting));
  }
}

void add_output_options(CLI::App& command, OptimizeArguments& arguments) {
  command.add_option("FILE", arguments.input, graph_to_read())->required()->check(file_name());
  command
      .add_option("-o,--output", arguments.output,
                  fmt::format("Where to write the optimized graph ({}); - is stdout", writable_formats()))
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  command
      .add_flag(
          "--strict-output", arguments.strict_output,
          "If the format of the output cannot hold the new estimates, fail instead of writing JSON beside it")
      ->group("Output");
  command.add_option("--json", arguments.json, "Where to write the report as JSON; - is stdout")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", arguments.quiet, "Print no report and no progress, only messages")
          ->group("Output");
  command.add_flag("-v,--verbose", arguments.verbose, "Print one line per iteration to stderr")
      ->group("Output")
      ->excludes(quiet);
}

void add_id_option(CLI::App& command, const std::string& name, std::vector<IdRange>& ids,
                   const std::string& text) {
  const auto complaint = [](const std::string& value) {
    try {
      parse_id_ranges(value);
      return std::string();
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  command
      .add_option_function<std::string>(
          name, [&ids](const std::string& value) { ids = parse_id_ranges(value); }, text)
      ->type_name("ID,ID-ID,...")
      ->check(CLI::Validator(complaint, ""))
      ->join(',')
      ->group("Problem");
}

void add_problem_options(CLI::App& command, OptimizeArguments& arguments) {
  add_settings(command, "Problem", arguments);
  add_id_option(command, "--fix", arguments.fixed,
                "Hold these vertices fixed in this run; the output file does not mark them as fixed");
  add_id_option(command, "--only-vertices", arguments.moving,
                "Move only these vertices; all others keep their estimates");
}

void add_bundle_options(CLI::App& command, OptimizeArguments& arguments) {
  std::vector<std::string_view> names;
  for (const BundlePart part : bundle_parts()) names.push_back(to_string(part));
  const std::string known = fmt::format(" (of {})", fmt::join(names, ", "));
  const auto complaint = [known](const std::string& words) {
    for (const std::string& word : CLI::detail::split(words, ',')) {
      if (!find_bundle_part(word)) return fmt::format("expected parts{}, got '{}'", known, word);
    }
    return std::string();
  };
  const auto add = [&](const char* option, std::vector<BundlePart>& parts, const std::string& text) {
    const auto set = [&parts](const std::string& words) {
      for (const std::string& word : CLI::detail::split(words, ',')) parts.push_back(*find_bundle_part(word));
    };
    command.add_option_function<std::string>(option, set, text + known)
        ->check(CLI::Validator(complaint, ""))
        ->join(',')
        ->type_name("PART,...")
        ->group("Bundle adjustment");
  };
  add("--hold", arguments.held, "Hold these parts at their estimates in this run");
  add("--free", arguments.freed,
      "Free these parts in this run, such as the principal points of COLMAP's cameras, which are held "
      "unless they are named here");
  command
      .add_option("--pixel-sigma", arguments.pixel_sigma,
                  "The standard deviation of each coordinate of a pixel: Ω = I / σ² for all reprojection "
                  "errors, so that chi2 per degree of freedom is about 1")
      ->check(number_above(0))
      ->type_name("PIXELS")
      ->group("Bundle adjustment");
  command
      .add_option("--position-priors", arguments.position_priors,
                  "A CSV file with measured positions of images and directions of gravity: the model moves "
                  "onto them, and they take part (docs/colmap.md)")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Bundle adjustment");
}

void add_outlier_options(CLI::App& command, OptimizeArguments& arguments) {
  CLI::Option* outliers = add_suspects_option(
      command, arguments.suspects,
      "Find false edges, and optimize without them: among the loop closures (edges between "
      "poses whose ids are not consecutive) or among all edges. Begins with the odometry, "
      "if there is any, not with --start");
  for (const char* other : {"--kernel", "--only-vertices", "--view"})
    outliers->excludes(command.get_option(other));
  command
      .add_option("--write-outliers", arguments.outlier_list,
                  "Where to write a list of the edges that --outliers does not accept; - is stdout")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Outliers")
      ->needs(outliers);
  command.add_flag("--remove-outliers", arguments.remove_outliers, "Leave the false edges out of the output")
      ->group("Outliers")
      ->needs(outliers)
      ->needs(command.get_option("--output"));
}

void add_view_options(CLI::App& command, OptimizeArguments& arguments) {
  CLI::Option* view = command.add_flag("--view", arguments.view,
                                       "Show the run in a browser, and serve the page after it until Ctrl-C");
  view->group("View");
  add_serving_options(command, arguments, view);
}

void add_petsc_option(CLI::App& command, OptimizeArguments& arguments) {
  CLI::Option* petsc =
      command
          .add_option("--petsc", arguments.petsc,
                      "Solve the linear systems with PETSc and these options of it, such as \"-ksp_type cg "
                      "-pc_type pbjacobi\"; if they are empty, with the Cholesky factorization of MUMPS. "
                      "Needs a plug-in (see docs/solving.md)")
          ->type_name("OPTIONS")
          ->group("Method");
  for (const char* other : {"--solver", "--precision", "--outliers", "--certify"})
    petsc->excludes(command.get_option(other));
}

void add_certify_option(CLI::App& command, OptimizeArguments& arguments) {
  CLI::Option* certify =
      command.add_flag("--certify", arguments.certify,
                       "Prove that the minimum of a pose graph is global, or look for a better one, which "
                       "becomes the result (see docs/certificate.md)");
  certify->group("Method");
  for (const char* other :
       {"--kernel", "--only-vertices", "--fix", "--hold", "--free", "--outliers", "--view"})
    certify->excludes(command.get_option(other));
}

}  // namespace

void add_robust_options(CLI::App& command, RunSettings& settings) {
  add_settings(command, "Outliers", settings);
}

CLI::Option* add_suspects_option(CLI::App& command, std::optional<Suspects>& suspects,
                                 const std::string& help) {
  const auto table = setting_table();
  const Setting& setting = *std::ranges::find(table, "outliers", &Setting::name);
  const auto set = [&suspects, &setting](const std::string& text) {
    RunSettings scratch;
    setting.set(scratch, text);
    suspects = scratch.suspects;
  };
  return command.add_option_function<std::string>("--outliers", set, help)
      ->check(CLI::IsMember(setting.words))
      ->type_name("NAME")
      ->default_str("none")
      ->group("Outliers");
}

void add_optimize_options(CLI::App& command, OptimizeArguments& arguments) {
  add_output_options(command, arguments);
  add_settings(command, "Method", arguments);
  add_robust_options(command, arguments);
  add_problem_options(command, arguments);
  add_bundle_options(command, arguments);
  add_settings(command, "Stop", arguments);
  add_view_options(command, arguments);
  add_outlier_options(command, arguments);
  add_certify_option(command, arguments);
  add_petsc_option(command, arguments);
  add_reading_options(command, arguments.reading);
}

}  // namespace boxplus::app
