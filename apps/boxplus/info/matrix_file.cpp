// SPDX-License-Identifier: BSD-3-Clause
#include "info/matrix_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "linearize/linearizer.h"

namespace boxplus::app {
namespace {

struct Entry {
  std::uint32_t row, column;  ///< from 1
  double value;
};

/// A block of H in a column of blocks, perhaps stored as its transpose.
struct PlacedBlock {
  std::uint32_t row_block, block;
  bool is_transposed;
};

/// H in the order of columns, and of rows within a column.
class NormalMatrix {
 public:
  explicit NormalMatrix(const Graph& graph)
      : plan_(make_plan(graph, {.gauge = GaugePolicy::kDamp})), linearizer_(graph, plan_) {
    linearizer_.linearize({});
  }

  const Plan& plan() const { return plan_; }

  /// The entries that are not zero: all, or only those on and below the diagonal.
  std::vector<Entry> entries(bool lower_only) const {
    const std::vector<std::vector<PlacedBlock>> columns = block_columns(lower_only);
    const BlockStructure& structure = plan_.structure;
    std::vector<Entry> entries;
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
      for (std::uint32_t c = 0; c < structure.dim(j); ++c) {
        for (const PlacedBlock& placed : columns[j]) add_column(placed, j, c, lower_only, entries);
      }
    }
    return entries;
  }

 private:
  std::vector<std::vector<PlacedBlock>> block_columns(bool lower_only) const {
    const BlockStructure& structure = plan_.structure;
    std::vector<std::vector<PlacedBlock>> columns(structure.blocks());
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
      for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
        const std::uint32_t i = structure.row[k];
        columns[j].push_back({i, k, false});
        if (i != j && !lower_only) columns[i].push_back({j, k, true});
      }
    }
    return columns;
  }

  /// Appends the entries of column c of a block that is in column j of blocks.
  void add_column(const PlacedBlock& placed, std::uint32_t j, std::uint32_t c, bool lower_only,
                  std::vector<Entry>& entries) const {
    const BlockStructure& structure = plan_.structure;
    const std::uint32_t i = placed.row_block, rows = structure.dim(i), columns = structure.dim(j);
    const double* values = linearizer_.values().data() + structure.value_start[placed.block];
    for (std::uint32_t r = i == j && lower_only ? c : 0; r < rows; ++r) {
      const double value = placed.is_transposed ? values[c + columns * r] : values[r + rows * c];
      if (!std::isfinite(value))
        throw InvalidArgument(fmt::format("expected a finite matrix H, got {} in row {}, column {}", value,
                                          structure.offset[i] + r + 1, structure.offset[j] + c + 1));
      if (value != 0) entries.push_back({structure.offset[i] + r + 1, structure.offset[j] + c + 1, value});
    }
  }

  Plan plan_;
  Linearizer linearizer_;
};

bool is_parameter(const Graph& graph, VertexRef vertex) {
  return graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
}

/// A comment for each block: "% rows 1 to 3: vertex 0 (VERTEX_SE2)".
std::string names_of_rows(const Graph& graph, const Plan& plan, char comment) {
  std::string text;
  for (std::uint32_t k = 0; k < plan.structure.blocks(); ++k) {
    const VertexRef vertex = plan.block_vertex[k];
    const Tag* tag = default_registry().tag_of(graph, vertex);
    fmt::format_to(std::back_inserter(text), "{} rows {} to {}: {} {} ({})\n", comment,
                   plan.structure.offset[k] + 1, plan.structure.offset[k + 1],
                   is_parameter(graph, vertex) ? "parameter" : "vertex", graph.id(vertex),
                   tag ? std::string_view(tag->name) : graph.vertex_pools()[vertex.pool]->type_name());
  }
  return text;
}

std::string market_text(const Graph& graph, const NormalMatrix& H) {
  const std::vector<Entry> entries = H.entries(true);
  const std::uint32_t rows = H.plan().scalars();
  std::string text = "%%MatrixMarket matrix coordinate real symmetric\n% H of the normal equations\n" +
                     names_of_rows(graph, H.plan(), '%');
  fmt::format_to(std::back_inserter(text), "{} {} {}\n", rows, rows, entries.size());
  for (const Entry& entry : entries)
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", entry.row, entry.column, entry.value);
  return text;
}

std::string octave_text(const Graph& graph, const NormalMatrix& H) {
  const std::vector<Entry> entries = H.entries(false);
  const BlockStructure& structure = H.plan().structure;
  std::string text = "# H of the normal equations\n" + names_of_rows(graph, H.plan(), '#');
  fmt::format_to(std::back_inserter(text),
                 "# name: H\n# type: sparse matrix\n# nnz: {}\n# rows: {}\n# columns: {}\n", entries.size(),
                 structure.scalars(), structure.scalars());
  for (const Entry& entry : entries)
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", entry.row, entry.column, entry.value);
  fmt::format_to(std::back_inserter(text), "\n\n# name: blocks\n# type: matrix\n# rows: {}\n# columns: 4\n",
                 structure.blocks());
  for (std::uint32_t k = 0; k < structure.blocks(); ++k) {
    const VertexRef vertex = H.plan().block_vertex[k];
    fmt::format_to(std::back_inserter(text), " {} {} {} {}\n", graph.id(vertex), structure.offset[k] + 1,
                   structure.dim(k), is_parameter(graph, vertex) ? 1 : 0);
  }
  return text;
}

}  // namespace

std::string matrix_text(const Graph& graph, const std::string& path) {
  const NormalMatrix H(graph);
  return path.ends_with(".mtx") ? market_text(graph, H) : octave_text(graph, H);
}

}  // namespace boxplus::app
