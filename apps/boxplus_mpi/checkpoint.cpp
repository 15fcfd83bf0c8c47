// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "boxplus/base/error.h"
#include "io/replace_file.h"

namespace boxplus::app {
namespace {

using Words = std::span<const std::uint64_t>;

/// The first word of a file. On a machine with another order of bytes, it differs.
constexpr std::uint64_t kFormat = 0x626f'782b'6d70'6901;

std::string_view bytes_of(Words words) {
  return {reinterpret_cast<const char*>(words.data()), words.size_bytes()};
}

void read(std::ifstream& file, std::span<std::uint64_t> words) {
  file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(words.size_bytes()));
}

}  // namespace

void write_checkpoint(const std::string& path, std::uint64_t edges, Words changes,
                      mpi::Communicator& communicator) {
  const auto words = static_cast<std::uint64_t>(communicator.sum(static_cast<double>(changes.size())));
  if (!communicator.is_first()) return communicator.visit_at_first(changes, [](Words) {});
  replace_file(path, [&](TextSink sink) {
    sink(bytes_of(std::array{kFormat, edges, words}));
    communicator.visit_at_first(changes, [&](Words of_process) { sink(bytes_of(of_process)); });
  });
}

void apply_checkpoint(const std::string& path, std::uint64_t edges, ChangedGraph& graph) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path + ": cannot be read");
  const auto require = [&](bool is_expected) {
    if (!is_expected || !file)
      throw InvalidArgument(path + ": expected a checkpoint of this problem, got another file");
  };
  std::array<std::uint64_t, 3> header{};
  read(file, header);
  require(header[0] == kFormat && header[1] == edges);
  require(std::filesystem::file_size(path) / sizeof(std::uint64_t) == header.size() + header[2]);
  std::vector<std::uint64_t> change;
  for (std::uint64_t words = header[2]; words > 0; words -= change.size()) {
    require(words >= ChangedGraph::kHeader);
    change.resize(ChangedGraph::kHeader);
    read(file, change);
    require(change[1] <= words - change.size());
    change.resize(ChangedGraph::kHeader + change[1]);
    read(file, std::span(change).subspan(ChangedGraph::kHeader));
    require(true);
    graph.apply(change);
  }
}

}  // namespace boxplus::app
