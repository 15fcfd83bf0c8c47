// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/protocol/messages.h"

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

namespace boxplus::viewer {
namespace {

static_assert(std::endian::native == std::endian::little, "messages are little-endian");

using Json = nlohmann::json;

template <class T>
constexpr const char* kTypeName = nullptr;
template <>
constexpr const char* kTypeName<float> = "f32";
template <>
constexpr const char* kTypeName<std::uint32_t> = "u32";
template <>
constexpr const char* kTypeName<std::uint8_t> = "u8";

void append(std::string& text, std::uint32_t number) {
  std::array<char, sizeof number> bytes;
  std::memcpy(bytes.data(), &number, sizeof number);
  text.append(bytes.data(), bytes.size());
}

void pad(std::string& text, char filler) {
  constexpr std::size_t kAlignment = 4;
  text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, filler);
}

/// Collects arrays for one message.
class ArrayMessage {
 public:
  explicit ArrayMessage(Json header) : header_(std::move(header)) { header_["arrays"] = Json::object(); }

  template <class T>
  void add(const char* name, const std::vector<T>& numbers) {
    header_["arrays"][name] = {{"type", kTypeName<T>}, {"offset", size_}, {"count", numbers.size()}};
    const auto bytes = std::as_bytes(std::span(numbers));
    arrays_.push_back({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    size_ += (bytes.size() + 3) / 4 * 4;
  }

  Message make(MessageKind kind) {
    // Names may contain bytes that are not valid UTF-8.
    std::string header = header_.dump(-1, ' ', false, Json::error_handler_t::replace);
    pad(header, ' ');
    auto text = std::make_shared<std::string>();
    text->reserve(3 * sizeof(std::uint32_t) + header.size() + size_);
    append(*text, static_cast<std::uint32_t>(sizeof(std::uint32_t) + header.size() + size_));
    append(*text, static_cast<std::uint32_t>(kind));
    append(*text, static_cast<std::uint32_t>(header.size()));
    *text += header;
    for (const std::string_view array : arrays_) {
      text->append(array);
      pad(*text, '\0');
    }
    return text;
  }

 private:
  Json header_;
  std::vector<std::string_view> arrays_;
  std::size_t size_ = 0;
};

const char* name_of(Shape shape) {
  switch (shape) {
    case Shape::kPose:
      return "pose";
    case Shape::kCamera:
      return "camera";
    case Shape::kCameraBack:
      return "camera back";
    case Shape::kCorner:
      return "corner";
    default:
      return "point";
  }
}

const char* name_of(Setting::Kind kind) {
  switch (kind) {
    case Setting::Kind::kChoice:
      return "choice";
    case Setting::Kind::kWholeNumber:
      return "whole number";
    case Setting::Kind::kNumber:
      return "number";
    default:
      return "kernel";
  }
}

Json setting_json(const Setting& setting, const WhyUnsuitable& why_unsuitable) {
  Json json = {{"name", setting.name}, {"group", setting.group},          {"kind", name_of(setting.kind)},
               {"help", setting.help}, {"default", setting.default_text}, {"unit", setting.unit}};
  for (const std::string& word : setting.words) {
    const std::string reason = why_unsuitable(setting, word);
    json["choices"].push_back(
        {{"value", word}, {"unsuitable", reason.empty() ? Json(nullptr) : Json(reason)}});
  }
  if (!setting.needed_setting.empty())
    json["needs"] = {{"setting", setting.needed_setting}, {"value", setting.needed_value}};
  return json;
}

Json truth_json(const std::optional<TruthFit>& fit) {
  if (!fit) return nullptr;
  const bool has_motions = fit->motions > 0;
  return {{"rotation", fit->rotation},
          {"translation", fit->translation},
          {"ate_m", fit->ate},
          {"rpe_m", has_motions ? Json(fit->rpe_translation) : Json(nullptr)},
          {"rpe_rad", has_motions ? Json(fit->rpe_rotation) : Json(nullptr)}};
}

}  // namespace

Message make_message(MessageKind kind, std::string_view payload) {
  auto text = std::make_shared<std::string>();
  append(*text, static_cast<std::uint32_t>(payload.size()));
  append(*text, static_cast<std::uint32_t>(kind));
  text->append(payload);
  return text;
}

Message form_message(const std::vector<FormatName>& formats, std::span<const Setting> settings,
                     const WhyUnsuitable& why_unsuitable) {
  Json form = {{"formats", Json::array()}, {"settings", Json::array()}};
  for (const auto& [name, extension] : formats)
    form["formats"].push_back({{"name", name}, {"extension", extension}});
  for (const Setting& setting : settings) form["settings"].push_back(setting_json(setting, why_unsuitable));
  return make_message(MessageKind::kForm, form.dump());
}

Message structure_message(const Structure& structure, std::uint64_t graph, std::uint64_t number,
                          const Scans& scans) {
  Json vertices = Json::array(), edges = Json::array();
  for (const VertexGroup& group : structure.vertices) {
    vertices.push_back({{"name", group.name},
                        {"shape", name_of(group.shape)},
                        {"first", group.first},
                        {"count", group.slots.size()}});
    if (!group.color.empty()) vertices.back()["color"] = group.color;
  }
  for (const LineGroup& group : structure.line_groups) {
    edges.push_back({{"name", group.name},
                     {"role", name_of(group.role, 1)},
                     {"first", group.first},
                     {"count", group.count}});
    if (!group.color.empty()) edges.back()["color"] = group.color;
  }
  ArrayMessage message({{"graph", graph},
                        {"structure", number},
                        {"dimension", structure.dimension},
                        {"is_bundle", structure.is_bundle},
                        {"leveling", structure.leveling},
                        {"vertices", vertices},
                        {"edges", edges},
                        {"left_out", structure.left_out}});
  message.add("edges", structure.lines);
  message.add("fixed", structure.fixed);
  if (structure.is_bundle) message.add("track_lengths", structure.track_lengths);
  if (!scans.empty()) {
    message.add("scan_vertices", scans.vertices);
    message.add("scan_counts", scans.counts);
    message.add("scan_points", scans.points);
  }
  return message.make(MessageKind::kStructure);
}

Message frame_message(const FrameFacts& facts, const Structure& structure, const Positions& positions,
                      const Errors& errors, const Uncertainty& uncertainty,
                      const std::optional<TruthFit>& truth) {
  ArrayMessage message({{"structure", facts.structure},
                        {"sequence", facts.sequence},
                        {"iteration", facts.iteration},
                        {"chi2", facts.chi2},
                        {"center", structure.center},
                        {"uncertainty", uncertainty.note},
                        {"truth", truth_json(truth)}});
  message.add("positions", positions.points);
  message.add("orientations", positions.orientations);
  if (!errors.points.empty()) message.add("errors", errors.points);
  if (!errors.chi2.empty()) message.add("chi2", errors.chi2);
  if (!errors.weights.empty()) message.add("weights", errors.weights);
  if (!errors.verdicts.empty()) message.add("verdicts", errors.verdicts);
  if (!uncertainty.vertices.empty()) {
    message.add("uncertain", uncertainty.vertices);
    message.add("covariances", uncertainty.covariances);
  }
  return message.make(MessageKind::kFrame);
}

Message frame_of_iteration(const std::string& frame, int iteration) {
  constexpr std::size_t kBegin = 3 * sizeof(std::uint32_t);  // of the header
  std::uint32_t size = 0;
  std::memcpy(&size, frame.data() + 2 * sizeof(std::uint32_t), sizeof size);
  Json json = Json::parse(frame.substr(kBegin, size));
  json["iteration"] = iteration;
  std::string header = json.dump();
  pad(header, ' ');
  auto text = std::make_shared<std::string>();
  append(*text, static_cast<std::uint32_t>(frame.size() - kBegin - size + sizeof size + header.size()));
  append(*text, static_cast<std::uint32_t>(MessageKind::kFrame));
  append(*text, static_cast<std::uint32_t>(header.size()));
  *text += header;
  text->append(frame, kBegin + size);
  return text;
}

Message truth_message(std::uint64_t structure, const TruthFacts& facts, const TruthPlaces& places) {
  ArrayMessage message({{"structure", structure},
                        {"name", facts.name},
                        {"matched_by", facts.matched_by},
                        {"matched", facts.matched},
                        {"poses", facts.poses},
                        {"true_poses", facts.true_poses}});
  message.add("positions", places);
  return message.make(MessageKind::kTruth);
}

Message pattern_message(const Pattern& pattern) {
  Json pictures = Json::array();
  const std::array all{std::pair{"H_by_id", &pattern.H_by_id}, std::pair{"H_ordered", &pattern.H_ordered},
                       std::pair{"L_by_id", &pattern.L_by_id}, std::pair{"L_ordered", &pattern.L_ordered}};
  for (const auto& [name, picture] : all)
    pictures.push_back({{"name", name}, {"blocks", picture->blocks}, {"is_complete", picture->is_complete}});
  ArrayMessage message({{"size", pattern.size}, {"cells", pattern.cells}, {"pictures", pictures}});
  for (const auto& [name, picture] : all) message.add(name, picture->counts);
  return message.make(MessageKind::kPattern);
}

}  // namespace boxplus::viewer
