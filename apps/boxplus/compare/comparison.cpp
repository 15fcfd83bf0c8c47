// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "command_line/message.h"
#include "command_line/table.h"

namespace boxplus::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(AlignmentKind kind) {
  return kind == AlignmentKind::kRigid ? "rigid" : kind == AlignmentKind::kFirst ? "first" : "none";
}

std::string how_aligned(const Comparison& comparison) {
  switch (comparison.kind) {
    case AlignmentKind::kRigid:
      return comparison.alignment.scale == 1
                 ? "after the best rigid alignment"
                 : fmt::format("after the best rigid alignment and scaling by {:.6g}",
                               comparison.alignment.scale);
    case AlignmentKind::kFirst:
      return "after aligning the first pose with the first true pose";
    default:
      return "without alignment";
  }
}

std::string how_far_apart(const RelativeSpan& span) {
  if (span.distance > 0) return fmt::format("over {:g} m", span.distance);
  return span.steps == 1 ? "from pose to pose" : fmt::format("over {} poses", span.steps);
}

std::vector<std::string> row(std::string what, const ErrorStatistics& errors, double unit) {
  std::vector<std::string> cells{std::move(what), fmt::format("{}", errors.count)};
  for (const double value : {errors.rmse, errors.mean, errors.median, errors.max})
    cells.push_back(errors.count > 0 ? fmt::format("{:.6g}", value / unit) : "–");
  return cells;
}

Json json_of(const ErrorStatistics& errors) {
  if (errors.count == 0) return nullptr;
  return {{"rmse", errors.rmse}, {"mean", errors.mean}, {"median", errors.median}, {"max", errors.max}};
}

Json json_of(const Alignment& alignment) {
  Json rotation = Json::array();
  for (int i = 0; i < 3; ++i)
    rotation.push_back({alignment.rotation(i, 0), alignment.rotation(i, 1), alignment.rotation(i, 2)});
  const Vector3& t = alignment.translation;
  return {{"rotation", rotation}, {"translation", {t[0], t[1], t[2]}}, {"scale", alignment.scale}};
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
  constexpr double kDegree = std::numbers::pi / 180;
  Table table({"<", "count", "rmse", "mean", "median", "max"});
  table.add(row("ATE [m]", comparison.absolute, 1));
  table.add(row("RPE [m]", comparison.relative.translation, 1));
  table.add(row("RPE [deg]", comparison.relative.rotation, kDegree));
  std::string hint;
  if (comparison.scaled_rmse >= 0)
    hint = fmt::format(
        "The scale of bundle adjustment is free: with --scale, the RMSE of the ATE is {:.6g} m.\n",
        comparison.scaled_rmse);
  return fmt::format(
      "{} against {}: {} of {} poses match {} of {} true poses by {}\n\n{}\n"
      "ATE: errors of positions {}. RPE: errors of motions {}.\n{}",
      escaped(comparison.result), escaped(comparison.truth), comparison.matched, comparison.result_poses,
      comparison.matched, comparison.truth_poses, comparison.matched_by, table.text(),
      how_aligned(comparison), how_far_apart(comparison.span), hint);
}

std::string comparison_json(const Comparison& comparison) {
  Json alignment = json_of(comparison.alignment);
  alignment["kind"] = name_of(comparison.kind);
  const bool by_distance = comparison.span.distance > 0;
  Json json{{"result", comparison.result},
            {"truth", comparison.truth},
            {"result_poses", comparison.result_poses},
            {"truth_poses", comparison.truth_poses},
            {"matched", comparison.matched},
            {"matched_by", comparison.matched_by},
            {"alignment", alignment},
            {"ate_m", json_of(comparison.absolute)},
            {"rpe",
             {{"count", comparison.relative.translation.count},
              {"steps", by_distance ? Json(nullptr) : Json(comparison.span.steps)},
              {"distance_m", by_distance ? Json(comparison.span.distance) : Json(nullptr)},
              {"translation_m", json_of(comparison.relative.translation)},
              {"rotation_rad", json_of(comparison.relative.rotation)}}}};
  if (comparison.scaled_rmse >= 0) json["ate_rmse_m_with_scale"] = comparison.scaled_rmse;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace boxplus::app
