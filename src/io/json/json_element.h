// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/graph/vertex_pool.h"
#include "io/json/json_scanner.h"

namespace boxplus {

/// A list of fields: numbers, and rarely words.
struct JsonFields {
  std::vector<double> values;       ///< 0 for a word
  std::vector<const char*> places;  ///< of the texts of the fields
  std::size_t integers = 0;         ///< the number of leading fields that are written as integers
  bool is_numeric = true;           ///< whether no field is a word, and no integer is too large for a double
  const char *begin = nullptr, *end = nullptr;  ///< [ and ]

  void clear();
  void read(JsonScanner& in, std::string_view what);
  void read_id(JsonScanner& in, std::string_view what);
};

/// A vertex, a parameter or an edge, as it is in a JSON text. All pointers point into the text.
struct JsonElement {
  /// The members that an element may have. A set of them is a sum.
  enum Member : unsigned {
    kTag = 1u << 0,
    kId = 1u << 1,
    kIds = 1u << 2,
    kFields = 1u << 3,
    kInformation = 1u << 4,
    kKernel = 1u << 5,
    kLevel = 1u << 6,
    kEnabled = 1u << 7,
    kFixed = 1u << 8,
    kFixedDirections = 1u << 9,
    kEliminated = 1u << 10,
    kRest = 1u << 11,
    kBounds = 1u << 12
  };
  struct Kernel {
    std::string name;
    double width = 0;
    const char* at = nullptr;
  };
  const char* at = nullptr;
  unsigned given = 0;  ///< the members that the text has
  std::string_view tag;
  const char* tag_at = nullptr;
  JsonFields ids, fields, information, rest;
  Kernel kernel;
  int level = 0;
  bool enabled = true, fixed = false, eliminated = false;
  std::vector<int> fixed_directions;
  const char* fixed_directions_at = nullptr;
  std::vector<detail::Bound> bounds;
  const char* bounds_at = nullptr;

  /// Throws JsonError. Afterwards, the element is incomplete.
  void read_vertex(JsonScanner& in);
  void read_edge(JsonScanner& in);

 private:
  struct Form;
  void read(JsonScanner& in, const Form& form);
  void read_member(JsonScanner& in, Member member);
  void read_kernel(JsonScanner& in);
  void read_fixed_directions(JsonScanner& in);
  void read_bounds(JsonScanner& in);

  std::string tag_memory_;
};

}  // namespace boxplus
