// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "io/characters.h"
#include "io/g2o/notes.h"
#include "io/json/json_element_adder.h"
#include "io/json/json_format.h"
#include "io/json/json_kept.h"
#include "io/json/json_registry.h"
#include "io/json/json_window.h"

namespace boxplus {
namespace {

enum Section : std::size_t { kParameters, kVertices, kEdges, kKept };
constexpr std::array<std::string_view, 6> kFileMembers = {"parameters", "vertices", "edges",
                                                          "kept",       "format",   "version"};
constexpr std::size_t kFormat = 4, kVersion = 5;

/// Builds a GraphFile. Reads one element at a time. If a section comes before one on which it depends, the
/// reader passes over it, and comes back at the end.
class JsonReader {
 public:
  JsonReader(const TextSource& text, const ReadOptions& options)
      : text_(text),
        options_(options),
        window_(text),
        tags_(options.registry ? *options.registry : json_registry(), options.renames),
        adder_(file_.graph, tags_, options.indefinite),
        kept_(file_, tags_) {}

  GraphFile read() {
    object();
    if (!is_given_[kFormat] || !is_given_[kVersion]) {
      throw InputError(text_.name(), 1, 1,
                       fmt::format("expected a graph with the members \"format\": \"{}\" and \"version\": {}",
                                   kJsonFormat, kJsonVersion));
    }
    file_.lines = window_.position().line - (window_.position().column == 1 ? 1 : 0);
    for (const Section section : {kEdges, kKept}) {
      if (!waiting_[section]) continue;
      window_.go_to(*waiting_[section]);
      read_section(section);
    }
    kept_.add_notes();
    if (file_.indefinite > 0) file_.notes.push_back({0, indefinite_note(file_, options_.indefinite)});
    return std::move(file_);
  }

 private:
  /// Calls read() with a scanner for the next part of the text. If the window is too short for the part, it
  /// calls read() again, with a larger window. So read() must not change anything before it has read the
  /// whole part.
  template <class F>
  void part(F&& read) {
    for (;;) {
      window_.drop_blanks();
      JsonScanner in(window_.begin(), window_.end());
      try {
        read(in);
        return window_.drop(in.at());
      } catch (const JsonError& error) {
        const bool may_go_on =
            error.kind == JsonError::Kind::kSyntax && window_.end() - error.at < JsonScanner::kLookahead;
        if (!may_go_on || !window_.more()) fail(error);
      }
    }
  }

  [[noreturn]] void fail(const JsonError& error) const {
    const JsonWindow::Place at = window_.place(error.at);
    throw InputError(text_.name(), at.line, at.column, error.what());
  }

  void object() {
    bool is_last = false;
    part([&](JsonScanner& in) {
      in.expect('{', "a graph ({)");
      is_last = in.accept('}');
    });
    while (!is_last) {
      std::size_t member = 0;
      part([&](JsonScanner& in) { member = name_of_member(in); });
      is_given_[member] = true;
      read_member(member);
      part([&](JsonScanner& in) {
        is_last = !in.accept(',');
        if (is_last) in.expect('}', "a comma or }");
      });
    }
    window_.drop_blanks();
    if (window_.begin() != window_.end())
      fail(JsonError(window_.begin(), "expected the end of the text after the graph",
                     JsonError::Kind::kSyntax));
  }

  std::size_t name_of_member(JsonScanner& in) const {
    const char* const at = in.at();
    std::string memory;
    const std::string_view name = in.string(memory, "the name of a member (a string)");
    in.expect(':', "a colon");
    for (std::size_t i = 0; i < kFileMembers.size(); ++i) {
      if (name != kFileMembers[i]) continue;
      if (is_given_[i]) refuse_meaning(at, fmt::format("the member {} only once", in_quotes(name)));
      return i;
    }
    refuse_meaning(at,
                   fmt::format("one of the members format, version, parameters, vertices, edges, kept of a "
                               "{}, got {}",
                               kJsonFormat, in_quotes(name)));
  }

  void read_member(std::size_t member) {
    if (member == kFormat) return part([](JsonScanner& in) { check_format(in); });
    if (member == kVersion) return part([](JsonScanner& in) { check_version(in); });
    const bool has_vertices = is_given_[kParameters] && is_given_[kVertices];
    const bool must_wait = (member == kEdges && !has_vertices) ||
                           (member == kKept && (!has_vertices || !is_given_[kEdges] || waiting_[kEdges]));
    if (!must_wait) return read_section(static_cast<Section>(member));
    window_.drop_blanks();
    waiting_[member] = window_.position();
    items([](JsonScanner& in) { in.skip_value(); }, [] {});
  }

  static void check_format(JsonScanner& in) {
    const char* const at = in.at();
    std::string memory;
    const std::string_view format = in.string(memory, "the name of the format (a string)");
    if (format != kJsonFormat)
      refuse_meaning(at, fmt::format("the format '{}', got {}", kJsonFormat, in_quotes(format)));
  }

  static void check_version(JsonScanner& in) {
    const char* const at = in.at();
    if (const std::int64_t version = in.integer("the version of the format"); version != kJsonVersion)
      refuse_meaning(at, fmt::format("version {} of the format, got {}", kJsonVersion, version));
  }

  /// Calls read(scanner) and then take() for each item of an array.
  template <class Read, class Take>
  void items(Read&& read, Take&& take) {
    bool is_last = false;
    part([&](JsonScanner& in) {
      in.expect('[', "a list ([)");
      is_last = in.accept(']');
    });
    while (!is_last) {
      part([&](JsonScanner& in) {
        read(in);
        is_last = !in.accept(',');
        if (is_last) in.expect(']', "a comma or ]");
      });
      take();
    }
  }

  void read_section(Section section) {
    if (section == kEdges) adder_.end_of_vertices();
    const auto read = [&](JsonScanner& in) {
      if (section == kKept) return kept_line_.read(in);
      section == kEdges ? element_.read_edge(in) : element_.read_vertex(in);
    };
    const auto take = [&] {
      if (section == kKept) return kept_.add(kept_line_, window_.place(kept_line_.at).line);
      if (section == kEdges) {
        file_.edges.push_back(adder_.add_edge(element_));
        if (adder_.has_indefinite()) ++file_.indefinite;
      } else {
        adder_.add_vertex(element_, section == kParameters);
      }
      if (!adder_.noted().empty()) file_.notes.push_back({window_.place(element_.at).line, adder_.noted()});
    };
    items([&](JsonScanner& in) { read_guarded(in, read); }, [&] { take_guarded(section, take); });
  }

  /// Reads an element. If its values are wrong, a lenient reader passes over it and remembers the error.
  template <class Read>
  void read_guarded(JsonScanner& in, Read&& read) {
    error_.reset();
    in.next();
    const char* const begin = in.at();
    try {
      read(in);
    } catch (const JsonError& error) {
      if (!options_.lenient || error.kind == JsonError::Kind::kSyntax) throw;
      error_.emplace(error);
      in.go_to(begin);
      in.skip_value();
    }
  }

  template <class Take>
  void take_guarded(Section section, Take&& take) {
    try {
      if (!error_) return take();
    } catch (const JsonError& error) {
      if (!options_.lenient) fail(error);
      error_.emplace(error);
    }
    const JsonWindow::Place at = window_.place(error_->at);
    if (section == kEdges) kept_.skip_edge(static_cast<std::int64_t>(file_.edges.size()) + skipped_edges_++);
    ++file_.skipped;
    file_.notes.push_back({at.line, error_->what(), at.column, true});
  }

  const TextSource& text_;
  const ReadOptions& options_;
  JsonWindow window_;
  const TagLookup tags_;
  GraphFile file_;
  JsonElementAdder adder_;
  JsonKept kept_;
  JsonElement element_;
  JsonKeptLine kept_line_;
  std::optional<JsonError> error_;  // of the element that a lenient reader passes over
  std::int64_t skipped_edges_ = 0;
  std::array<bool, kFileMembers.size()> is_given_{};
  std::array<std::optional<JsonWindow::Position>, 4> waiting_{};
};

}  // namespace

GraphFile read_json(const TextSource& text, const ReadOptions& options) {
  return JsonReader(text, options).read();
}

}  // namespace boxplus
