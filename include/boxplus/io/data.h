// SPDX-License-Identifier: BSD-3-Clause
// Data that .g2o files attach to vertices and edges: laser scans, names and ellipses. A line of data belongs
// to the element before it. Reading a graph keeps the lines of data as they are (GraphFile::kept), and
// writing puts them back behind their elements. The optimization does not use them.
//
//     GraphFile file = read_graph("log.g2o");
//     for (const AttachedData& attached : read_data(file, "log.g2o")) {
//       if (const auto* laser = std::get_if<RobotLaser>(&attached.data))
//         use(attached.after, laser->end_points_of_robot());
//     }
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/raw_laser.h"
#include "boxplus/io/robot_laser.h"
#include "boxplus/io/vertex_ellipse.h"
#include "boxplus/io/vertex_tag.h"

namespace boxplus {

using Data = std::variant<RobotLaser, RawLaser, VertexTag, VertexEllipse>;

/// The tags of all alternatives of Data.
std::span<const std::string_view> data_tags();
/// The first of the tags above with which this line begins, without blanks; empty if the line is no data.
std::string_view data_tag_of(std::string_view line);

/// The data in a line that was kept; no value if the line is no data. Throws InputError ("name:line:column:
/// …") if a field of the data is missing or wrong. Takes time and memory proportional to the length of the
/// line.
std::optional<Data> parse_data(const GraphFile::KeptLine& line, const std::string& name);
/// A line of data: the tag and the fields. Throws InvalidArgument if the data cannot be written.
std::string format_data(const Data& data);

/// Data and the element that it belongs to, as in KeptLine: a vertex with the id `after`, or the edge at the
/// position `after` of GraphFile::edges. Data before the first vertex belongs to no element (kBegin).
struct AttachedData {
  GraphFile::KeptLine::Place place = GraphFile::KeptLine::Place::kBegin;
  std::int64_t after = 0;
  Data data;
};
/// All data of a file in the order of the file. Messages use `name` as the name of the file. Throws
/// InputError if a line of data is malformed.
std::vector<AttachedData> read_data(const GraphFile& file, const std::string& name);

}  // namespace boxplus
