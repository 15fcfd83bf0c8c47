// SPDX-License-Identifier: BSD-3-Clause
// The strict reader reports the first bad line. The lenient reader skips and counts bad lines.
#include <gtest/gtest.h>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

struct Malformed {
  const char* name;
  std::string lines;      ///< the lines that follow kGood
  std::string complaint;  ///< the message of the strict reader, without the name of the file
  int bad_lines = 1;      ///< the number of lines that the lenient reader skips
};

void PrintTo(const Malformed& malformed, std::ostream* out) {
  *out << malformed.name;
}

/// Eight valid lines: poses 0, 1 (2-D), point 2, poses 3, 4 (3-D), point 5, and two offsets.
constexpr const char* kGood =
    "VERTEX_SE2 0 0 0 0\n"
    "VERTEX_SE2 1 1 0 0.5\n"
    "VERTEX_XY 2 2 1\n"
    "VERTEX_SE3:QUAT 3 0 0 0 0 0 0 1\n"
    "VERTEX_SE3:QUAT 4 1 0 0 0 0 0 1\n"
    "VERTEX_TRACKXYZ 5 1 1 1\n"
    "PARAMS_SE2OFFSET 0 0 0 0\n"
    "PARAMS_SE3OFFSET 1 0 0 0 0 0 0 1\n";

const std::string kIdentity6 = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";

const std::string kHowToGoOn =
    " (to use the nearest positive semi-definite matrix: --information project; to keep it: --information "
    "as-given; in a "
    "program: ReadOptions::indefinite)";

const Malformed kTable[] = {
    // Fields
    {"VertexWithoutId", "VERTEX_SE2", "9:11: expected the id of a vertex, got the end of the line"},
    {"VertexIdThatIsNotAnInteger", "VERTEX_SE2 1.5 0 0 0",
     "9:12: expected the id of a vertex (an integer), got '1.5'"},
    {"VertexIdThatIsAWord", "VERTEX_SE2 one 0 0 0",
     "9:12: expected the id of a vertex (an integer), got 'one'"},
    {"VertexIdThatIsTooLargeForAnInteger", "VERTEX_SE2 99999999999999999999 0 0 0",
     "9:12: expected the id of a vertex (an integer up to 9223372036854775807), got "
     "'99999999999999999999'"},
    {"VertexIdThatIsTooSmallForAnInteger", "VERTEX_SE2 -9223372036854775809 0 0 0",
     "9:12: expected the id of a vertex (an integer from -9223372036854775808), got "
     "'-9223372036854775809'"},
    {"TagWithBlanks", "VERTEX_SE3 : QUAT 9 0 0 0 0 0 0 1",
     "9:1: expected the tag VERTEX_SE3:QUAT without blanks, got 'VERTEX_SE3 : QUAT'"},
    {"TagWithABlank", "EDGE_SE3: QUAT 3 4 0 0 0 0 0 0 1",
     "9:1: expected the tag EDGE_SE3:QUAT without blanks, got 'EDGE_SE3: QUAT'"},
    {"NegativeVertexId", "VERTEX_SE2 -1 0 0 0", "9:12: expected an id ≥ 0, got -1"},
    {"TruncatedVertex", "VERTEX_SE2 9 0 0", "9:17: expected the heading θ, got the end of the line"},
    {"VertexWithOneFieldTooMany", "VERTEX_SE2 9 0 0 0 7", "9:20: expected the end of the line, got '7'"},
    {"CoordinateThatIsAWord", "VERTEX_SE2 9 0 zero 0", "9:16: expected y (a finite number), got 'zero'"},
    {"CoordinateThatIsNotANumber", "VERTEX_SE2 9 nan 0 0", "9:14: expected x (a finite number), got 'nan'"},
    {"CoordinateThatIsInfinite", "VERTEX_SE2 9 0 -inf 0", "9:16: expected y (a finite number), got '-inf'"},
    {"CoordinateThatOverflows", "VERTEX_SE2 9 0 0 1e999",
     "9:18: expected the heading θ (a finite number), got '1e999'"},
    {"CoordinateWithADecimalComma", "VERTEX_SE2 9 0,5 0 0", "9:14: expected x (a finite number), got '0,5'"},
    {"CoordinateInHexadecimal", "VERTEX_SE2 9 0x10 0 0", "9:14: expected x (a finite number), got '0x10'"},
    {"NumberWithTwoSigns", "VERTEX_SE2 9 +-1 0 0", "9:14: expected x (a finite number), got '+-1'"},
    {"NumberWithAUnit", "VERTEX_SE2 9 1m 0 0", "9:14: expected x (a finite number), got '1m'"},
    {"ControlCharactersInAField", "VERTEX_SE2 9 \x01\x1b[31m 0 0",
     "9:14: expected x (a finite number), got '\\x01\\x1b[31m'"},
    {"OverlongField", "VERTEX_SE2 9 " + std::string(1000, 'x') + " 0 0",
     "9:14: expected x (a finite number), got '" + std::string(40, 'x') + "…'"},
    {"OverlongFieldWithACharacterThatIsNotAscii", "VERTEX_SE2 9 " + std::string(39, 'x') + "ø 0 0",
     "9:14: expected x (a finite number), got '" + std::string(39, 'x') + "…'"},
    {"BadFieldAfterAllKindsOfBlanks", "\t VERTEX_SE2 \t9\t0 \tx 0\r",
     "9:20: expected y (a finite number), got 'x'"},
    {"LastLineThatIsCutOff", "VERTEX_XY 9 1\nVERTEX_XY 10 1",
     "9:14: expected a coordinate, got the end of the line", 2},
    // Quaternions
    {"QuaternionOfZeros", "VERTEX_SE3:QUAT 9 0 0 0 0 0 0 0",
     "9:25: expected a quaternion of length 1 (± 0.001), got one of length 0"},
    {"QuaternionThatIsTooLong", "VERTEX_SE3:QUAT 9 0 0 0 0 0 3 4",
     "9:25: expected a quaternion of length 1 (± 0.001), got one of length 5"},
    {"MeasurementWithAQuaternionThatIsTooLong", "EDGE_SE3:QUAT 3 4 1 0 0 0 0 0 1.002 " + kIdentity6,
     "9:25: expected a quaternion of length 1 (± 0.001), got one of length 1.002"},
    {"QuaternionThatIsCutOff", "VERTEX_SE3:QUAT 9 0 0 0 0 0 1",
     "9:30: expected a quaternion (qx qy qz qw), got the end of the line"},
    // Information
    {"InformationThatIsCutOff", "EDGE_SE2 0 1 1 0 0.5 1 0 0 1 0",
     "9:31: expected an entry of the information matrix, got the end of the line"},
    {"InformationWithOneEntryTooMany", "EDGE_SE2 0 1 1 0 0.5 1 0 0 1 0 1 1",
     "9:34: expected the end of the line, got '1'"},
    {"InformationGivenAsAFullMatrix", "EDGE_SE2 0 1 1 0 0.5 1 0 0 0 1 0 0 0 1",
     "9:22: information: expected a positive semi-definite matrix, got the eigenvalue -1" + kHowToGoOn},
    {"InformationWithANegativeEntryOnTheDiagonal", "EDGE_SE2 0 1 1 0 0.5 1 0 0 -1 0 1",
     "9:22: information: expected a positive semi-definite matrix, got the diagonal entry -1" + kHowToGoOn},
    {"IndefiniteInformation", "EDGE_SE2 0 1 1 0 0.5 1 2 0 1 0 1",
     "9:22: information: expected a positive semi-definite matrix, got the eigenvalue -1" + kHowToGoOn},
    {"InformationOfZeros", "EDGE_SE2 0 1 1 0 0.5 0 0 0 0 0 0",
     "9:22: information: expected a nonzero matrix, got zeros only"},
    {"InformationThatIsNotANumber", "EDGE_SE2 0 1 1 0 0.5 1 0 0 nan 0 1",
     "9:28: expected an entry of the information matrix (a finite number), got 'nan'"},
    // Ids of edges
    {"EdgeWithoutIds", "EDGE_SE2", "9:9: expected the id of a vertex, got the end of the line"},
    {"EdgeThatIsCutOffAfterItsIds", "EDGE_SE2 0 1", "9:13: expected x, got the end of the line"},
    {"EdgeToAnUnknownVertex", "EDGE_SE2 0 77 1 0 0.5 1 0 0 1 0 1",
     "9:12: expected the id of a vertex, but there is no vertex 77"},
    {"EdgeToANegativeId", "EDGE_SE2 0 -7 1 0 0.5 1 0 0 1 0 1",
     "9:12: expected the id of a vertex (a number ≥ 0), got -7"},
    {"EdgeToAnUnassignedVertexWithABadField", "EDGE_SE2 0 -1 1 0 0.5 1 0 0 1 0 x",
     "9:33: expected an entry of the information matrix (a finite number), got 'x'"},
    {"EdgeWithTheSameVertexTwice", "EDGE_SE2 1 1 1 0 0.5 1 0 0 1 0 1",
     "9:1: expected different vertices, but vertex 1 appears twice"},
    {"EdgeToAVertexOfTheWrongType", "EDGE_SE2 0 2 1 0 0.5 1 0 0 1 0 1",
     "9:12: expected the id of a vertex of type SE2, but vertex 2 is a Vector2"},
    {"EdgeBetweenA3DAndA2DVertex", "EDGE_SE3:QUAT 3 1 1 0 0 0 0 0 1 " + kIdentity6,
     "9:17: expected the id of a vertex of type SE3, but vertex 1 is a SE2"},
    {"ObservationWithItsVerticesSwapped", "EDGE_SE2_XY 2 0 1 0 1 0 1",
     "9:13: expected the id of a vertex of type SE2, but vertex 2 is a Vector2"},
    {"EdgeWithAMissingParameter", "EDGE_SE2_POINTXY_OFFSET 0 2 9 1 0 1 0 1",
     "9:29: expected the id of a parameter, but there is no parameter 9; parameters of its "
     "type have the tag PARAMS_SE2OFFSET"},
    {"EdgeWithAMissingParameterInSpace", "EDGE_SE3_TRACKXYZ 3 5 9 0 0 1 1 0 0 1 0 1",
     "9:23: expected the id of a parameter, but there is no parameter 9; parameters of its type have the tag "
     "PARAMS_SE3OFFSET"},
    {"EdgeWithAParameterOfTheWrongType", "EDGE_SE2_POINTXY_OFFSET 0 2 1 1 0 1 0 1",
     "9:29: expected the id of a parameter of type SE2, but parameter 1 is a SE3"},
    {"ListOfPointsWithoutAnEnd", "EDGE_SE2_LOTSOFXY 0 2",
     "9:22: expected the id of a vertex, got the end of the line"},
    {"ListOfPointsWithCountZero", "EDGE_SE2_LOTSOFXY 0 2 || 0 1 0 1",
     "9:26: expected a number of points from 1 to 1000000, got 0"},
    {"ListOfPointsWithAHugeCount", "EDGE_SE2_LOTSOFXY 0 2 || 99999999999 1 1 1 0 1",
     "9:26: expected a number of points from 1 to 1000000, got 99999999999"},
    // Ids that are taken
    {"VertexIdThatIsTaken", "VERTEX_SE2 1 0 0 0", "9:12: expected a new id, but vertex 1 is already defined"},
    {"VertexIdThatIsTakenByAnotherType", "VERTEX_XY 1 0 0",
     "9:11: expected a new id, but vertex 1 is already defined"},
    {"ParameterIdThatIsTaken", "PARAMS_SE2OFFSET 1 0 0 0",
     "9:18: expected a new id, but parameter 1 is already defined"},
    // FIX
    {"FixWithoutId", "FIX", "9:4: expected the id of a vertex, got the end of the line"},
    {"FixOfAnUnknownVertex", "FIX 0 77", "9:7: expected the id of a vertex, but there is no vertex 77"},
    {"FixOfAWord", "FIX all", "9:5: expected the id of a vertex (an integer), got 'all'"},
    // Several bad lines
    {"SeveralBadLinesInARow", "VERTEX_SE2 1 0 0 0\nEDGE_SE2 0 1 1\nFIX x",
     "9:12: expected a new id, but vertex 1 is already defined", 3},
    {"EdgeOfABadVertex", "VERTEX_SE2 9 0 0\nEDGE_SE2 0 9 1 0 0.5 1 0 0 1 0 1",
     "9:17: expected the heading θ, got the end of the line", 2},
};

class MalformedLine : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedLine, IsReportedByTheStrictReader) {
  try {
    parse_graph(kGood + GetParam().lines, "g");
    FAIL() << "the reader accepted the line";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), "g:" + GetParam().complaint);
  }
}

TEST_P(MalformedLine, IsSkippedAndCountedByTheLenientReader) {
  const std::string good_end = "\nEDGE_SE2_XY 0 2 1 1 1 0 1\n";
  ReadOptions lenient;
  lenient.lenient = true;
  const GraphFile file = parse_graph(kGood + GetParam().lines + good_end, "g", lenient);
  EXPECT_EQ(file.skipped, GetParam().bad_lines);
  EXPECT_EQ(std::ssize(file.notes), GetParam().bad_lines);
  EXPECT_EQ(file.graph.vertex_count(), 6u);
  EXPECT_EQ(file.graph.parameter_count(), 2u);
  EXPECT_EQ(file.graph.edge_count(), 1u) << "good lines after bad lines are read";
}

INSTANTIATE_TEST_SUITE_P(Files, MalformedLine, testing::ValuesIn(kTable),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace boxplus
