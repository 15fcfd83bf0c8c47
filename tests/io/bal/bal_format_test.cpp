// SPDX-License-Identifier: BSD-3-Clause
#include "io/bal/bal_format.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>

#include "boxplus/boxplus.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kHeader = "2 3 4\n";
const std::string kObservations = "0 0 -10.5 2e1\n1 0 3 4\n0 1 5 6\n1 2 7 8\n";
const std::string kFirstCamera = "0.1\n-0.2\n0.3\n1\n2\n-3\n500\n-0.1\n0.01\n";
const std::string kSecondCamera = "0\n0\n0\n0\n0\n0\n400\n0\n0\n";
const std::string kPoints = "1\n2\n-10\n0\n1\n-9\n-1\n0\n-8\n";
const std::string kProblem = kHeader + kObservations + kFirstCamera + kSecondCamera + kPoints;

GraphFile problem() {
  return parse_graph(kProblem, "g");
}

BalVertex camera(const Graph& graph, Id id) {
  return graph.estimate(graph.vertex<BalVertex>(id));
}

TEST(BalFormat, IsReadAsCamerasPointsAndReprojectionErrors) {
  const GraphFile file = problem();
  const Graph& graph = file.graph;
  EXPECT_EQ(file.format, "BAL");
  EXPECT_EQ(file.lines, 32);
  EXPECT_EQ(graph.vertex_count(), 5u);
  EXPECT_EQ(file.edges.size(), 4u);
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(camera(graph, 0).get<1>().parameters, Vector3(500, -0.1, 0.01));
  EXPECT_EQ(graph.estimate(graph.vertex<Vector3>(3)), Vector3(0, 1, -9));
  for (const Id id : {0, 1}) EXPECT_FALSE(graph.is_eliminated(*graph.find_vertex(id)));
  for (const Id id : {2, 3, 4}) EXPECT_TRUE(graph.is_eliminated(*graph.find_vertex(id)));
}

TEST(BalFormat, HasTheCameraOfItsDefinition) {
  // p = R X + t, u = −(p_x, p_y)/p_z, and the pixel is f (1 + k1 u² + k2 u⁴) u.
  const GraphFile file = problem();
  const Vector3 p =
      SO3::from_rotation_vector(Vector3(0.1, -0.2, 0.3)) * Vector3(0, 1, -9) + Vector3(1, 2, -3);
  const Vector2 u(-p[0] / p[2], -p[1] / p[2]);
  const double u2 = u.squaredNorm();
  const Vector2 pixel = 500 * (1 - 0.1 * u2 + 0.01 * u2 * u2) * u;
  const std::vector<double> error = file.graph.error(file.edges[2]);
  EXPECT_NEAR(error[0], pixel[0] - 5, 1e-11);
  EXPECT_NEAR(error[1], pixel[1] - 6, 1e-11);
}

TEST(BalFormat, IsWrittenSoThatTheSameGraphIsRead) {
  const GraphFile file = problem();
  const std::string text = format_graph(file);
  EXPECT_THAT(text, testing::StartsWith("2 3 4\n0 0 -10.5 20\n1 0 3 4\n0 1 5 6\n1 2 7 8\n"));
  const GraphFile again = parse_graph(text, "again");
  EXPECT_NEAR(again.graph.chi2(), file.graph.chi2(), 1e-12 * file.graph.chi2());
  for (const Id id : {0, 1}) {
    const BalVertex a = camera(file.graph, id), b = camera(again.graph, id);
    EXPECT_LT((a.get<0>().vector() - b.get<0>().vector()).norm(), 1e-14);
    EXPECT_EQ(a.get<1>().parameters, b.get<1>().parameters);
  }
  for (const Id id : {2, 3, 4}) {
    EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector3>(id)),
              again.graph.estimate(again.graph.vertex<Vector3>(id)));
  }
}

TEST(BalFormat, IsWrittenWithIndicesInTheOrderOfTheIds) {
  Graph graph;
  const auto point = graph.add_vertex(Vector3(1, 2, -3), 5);
  const auto second = graph.add_vertex(BalVertex(SE3(), BalCamera(100, 0, 0)), 9);
  const auto first = graph.add_vertex(BalVertex(SE3(), BalCamera(200, 0, 0)), 7);
  graph.add_edge(BalEdge(Vector2(1, 2)), second, point);
  graph.add_edge(BalEdge(Vector2(3, 4)), first, point);
  std::string text;
  bal_format().write({graph}, {}, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text,
            "2 1 2\n1 0 1 2\n0 0 3 4\n"
            "0\n0\n0\n0\n0\n0\n200\n0\n0\n0\n0\n0\n0\n0\n0\n100\n0\n0\n1\n2\n-3\n");
}

TEST(BalFormat, LeavesOutInformationAndOtherEdgesAndSaysSo) {
  GraphFile file;
  const auto camera = file.graph.add_vertex(BalVertex(SE3(), BalCamera(100, 0, 0)));
  const auto point = file.graph.add_vertex(Vector3(0, 0, -1));
  const auto edge = file.graph.add_edge(BalEdge(Vector2(0, 0)), camera, point);
  const std::string text = format_graph(file, {.format = "BAL"});
  EXPECT_TRUE(losses("scene.bal", file).empty());
  file.graph.set_information(edge, 2.0);
  file.graph.add_edge(Prior(Vector3(0, 0, 0)), point);
  EXPECT_THAT(losses("scene.bal", file), ElementsAre("the information of 1 edge", "1 edge Prior<Vector3>"));
  EXPECT_EQ(format_graph(file, {.format = "BAL"}), text);
}

TEST(BalFormat, IsNotWrittenIfItCannotRepresentTheGraph) {
  const auto complaint_about = [](const Graph& graph) -> std::string {
    try {
      bal_format().write({graph}, {}, [](std::string_view) {});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "no complaint";
  };
  Graph graph;
  graph.add_vertex(BalVertex(SE3(), BalCamera(100, 0, 0)));
  graph.add_vertex(Vector3(0, 0, -1));
  EXPECT_EQ(complaint_about(graph), "no complaint");
  Graph pose = graph;
  pose.add_vertex(SE3());
  EXPECT_THAT(complaint_about(pose), HasSubstr("got vertex 2 of type SE3"));
  graph.add_parameter(SE3());
  EXPECT_THAT(complaint_about(graph), HasSubstr("got a parameter"));
}

TEST(BalFormat, IsNotWrittenIfItsReaderWouldHaveOtherErrors) {
  const auto complaint_about = [](const SE3& pose, double f, const Vector3& seen) -> std::string {
    Graph graph;
    const auto camera = graph.add_vertex(BalVertex(pose, BalCamera(f, 0, 0)), 3);
    const auto point = graph.add_vertex(Vector3(pose * seen), 8);
    const Vector2 pixel =
        graph.estimate(camera).get<1>().project(Vector3(pose.inverse_times(graph.estimate(point))));
    graph.add_edge(BalEdge(pixel), camera, point);
    try {
      bal_format().write({graph}, {}, [](std::string_view) {});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "no complaint";
  };
  const SO3 rotation = SO3::from_rotation_vector(Vector3(0.1, -0.2, 0.3));
  const SE3 near(Vector3(1, 2, 3), rotation), far(Vector3(1.1e18, -2.3e18, 3.7e18), rotation);
  EXPECT_EQ(complaint_about(near, 500, Vector3(1, 2, -10)), "no complaint");
  EXPECT_THAT(complaint_about(near, 1e18, Vector3(1, 2, -10)),
              HasSubstr("cannot write BAL's .bal: camera 3 and point 8: expected values so moderate that the "
                        "file keeps the reprojection error of"));
  EXPECT_THAT(complaint_about(far, 500, Vector3(1e4, 2e4, -1e5)), HasSubstr("camera 3 and point 8"));
  EXPECT_THAT(complaint_about(SE3(Vector3(1e151, 0, 0), rotation), 500, Vector3(0, 0, -1)),
              HasSubstr("got vertex 3 with a pose that overflows"));
}

TEST(BalFormat, IsRecognizedByItsFirstTwoLines) {
  const auto recognize = bal_format().recognize;
  EXPECT_TRUE(recognize(kProblem));
  EXPECT_TRUE(recognize("\n 2\t3 1\r\n0 0     -3.8e+02 3.8e+02\n"));
  EXPECT_TRUE(recognize("\xEF\xBB\xBF" + kProblem));
  EXPECT_TRUE(recognize("1 0 0\n0.5\n"));
  EXPECT_TRUE(recognize("2 3 4"));
  for (const char* other : {"", "\n", "1 2\n", "1 2 3 4\n", "1 2 -3\n", "1 2 3.5\n", "1 2 x\n", "1 2 3\nx\n",
                            "1 2 3\n0.5 0 1 2\n", "0 0 0\nVERTEX_SE2 0 0 0 0\n", "# 1 2 3\n"})
    EXPECT_FALSE(recognize(other)) << other;
}

TEST(BalFormat, HasValuesThatBlanksAndNewlinesSeparate) {
  std::string text = kProblem;
  std::replace(text.begin() + static_cast<std::ptrdiff_t>((kHeader + kObservations).size()), text.end(), '\n',
               ' ');
  EXPECT_EQ(format_graph(parse_graph(text, "g")), format_graph(problem()));
  text = kProblem;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3)
    text.replace(at, 1, "\r\n\n");
  EXPECT_EQ(format_graph(parse_graph(text, "g")), format_graph(problem()));
}

TEST(BalFormat, IsReadInBlocksOfAnySize) {
  for (const std::size_t size : {1, 2, 7, 16, 50}) {
    const GraphFile file = bal_format().read(TextSource(kProblem, "g", size), {.threads = 2});
    EXPECT_EQ(file.lines, 32);
    EXPECT_EQ(file.graph.chi2(), problem().graph.chi2());
    try {
      (void)bal_format().read(TextSource(kProblem + "\n x", "g", size), {});
      FAIL();
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "g:34:2: expected the end of the file, got 'x'");
    }
  }
}

TEST(BalFormat, MayRepeatObservations) {
  const GraphFile file = parse_graph("1 1 2\n0 0 1 2\n0 0 1 2\n" + kFirstCamera + "1\n2\n-5\n", "g");
  EXPECT_EQ(file.graph.edge_count(), 2u);
}

TEST(BalFormat, CanBeReadWithoutCoordinates) {
  const BalObservations observations = read_bal_observations(TextSource(kProblem, "g"), {});
  EXPECT_EQ(observations.cameras, 2u);
  EXPECT_EQ(observations.points, 3u);
  const std::uint64_t first = 0, second = std::uint64_t{1} << 32, third = std::uint64_t{2} << 32;
  EXPECT_THAT(observations.pairs, ElementsAre(first, first + 1, second, third + 1));
}

TEST(BalFormat, CanBeReadInPartsWithTheIdsOfTheWholeProblem) {
  const GraphFile part =
      read_bal_part(TextSource(kProblem, "g"), {}, {.is_wanted = {false, true, false}, .observations = 1});
  EXPECT_EQ(part.graph.vertex_count(), 3u);
  ASSERT_EQ(part.edges.size(), 1u);
  EXPECT_EQ(part.graph.estimate(part.graph.vertex<Vector3>(3)), Vector3(0, 1, -9));
  EXPECT_TRUE(part.graph.is_eliminated(*part.graph.find_vertex(3)));
  EXPECT_EQ(camera(part.graph, 1).get<1>().parameters, Vector3(400, 0, 0));
  const GraphFile whole = problem();
  EXPECT_EQ(part.graph.chi2(part.edges[0]), whole.graph.chi2(whole.edges[2]));
  EXPECT_TRUE(part.notes.empty());
}

TEST(BalFormat, CanBeWrittenWithoutHoldingTheEdges) {
  const TextSource text(kProblem, "g");
  GraphFile vertices = read_bal_vertices(text, {});
  EXPECT_EQ(vertices.graph.vertex_count(), 5u);
  EXPECT_EQ(vertices.graph.edge_count(), 0u);
  GraphFile whole = problem();
  for (Graph* graph : {&vertices.graph, &whole.graph}) {
    graph->set_estimate(graph->vertex<Vector3>(3), Vector3(1, 2, -3));
    BalVertex moved = camera(*graph, 1);
    moved.get<1>().parameters[0] = 500;
    graph->set_estimate(graph->vertex<BalVertex>(1), moved);
  }
  std::string written;
  write_bal_vertices(vertices.graph, text, {}, [&](std::string_view piece) { written += piece; });
  EXPECT_EQ(written, format_graph(whole));
}

TEST(BalFormat, IsRefusedInPartsAsItIsAsAWhole) {
  const std::string text = kHeader + kObservations + kFirstCamera + kSecondCamera + "1\n2\nx\n";
  const TextSource source(text, "g");
  const BalPoints none{.is_wanted = std::vector<bool>(3), .observations = 0};
  EXPECT_THAT(complaint(text), HasSubstr("got 'x'"));
  EXPECT_THROW((void)read_bal_observations(source, {}), InputError);
  EXPECT_THROW((void)read_bal_part(source, {}, none), InputError);
  EXPECT_THROW((void)read_bal_vertices(source, {}), InputError);
}

TEST(BalFormat, NotesCamerasAndPointsWithoutObservations) {
  GraphFile file = parse_graph("2 3 1\n1 1 1 2\n" + kFirstCamera + kSecondCamera + kPoints, "g");
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_EQ(file.notes[0].text, "1 camera has no observations");
  EXPECT_EQ(file.notes[1].text, "2 points have no observations");
  const Vector3 before = file.graph.estimate(file.graph.vertex<Vector3>(2));
  EXPECT_TRUE(optimize(file.graph).chi2_final < 1e-9);
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector3>(2)), before);
}

/// The complaint about a text that is long enough for its counts.
std::string long_complaint(const std::string& text) {
  return complaint(text + "\n" + kProblem);
}

TEST(BalFormat, IsRefusedIfAValueIsNotANumberOfItsKind) {
  EXPECT_EQ(long_complaint(kHeader + "0 0 nan 4\n"),
            "g:2:5: expected the x coordinate of a pixel (a finite number), got 'nan'");
  EXPECT_EQ(long_complaint(kHeader + "0 0 1 inf\n"),
            "g:2:7: expected the y coordinate of a pixel (a finite number), got 'inf'");
  EXPECT_EQ(long_complaint(kHeader + "0 0 1 1e999\n"),
            "g:2:7: expected the y coordinate of a pixel (a finite number), got '1e999'");
  EXPECT_EQ(long_complaint(kHeader + "0 0 1 2\n0 1.5 1 2\n"),
            "g:3:3: expected the index of a point (an integer from 0 to 2), got '1.5'");
  EXPECT_EQ(long_complaint(kHeader + "0 0 1 2\n# 0 1 2\n"),
            "g:3:1: expected the index of a camera (an integer from 0 to 1), got '#'");
  EXPECT_EQ(long_complaint(kHeader + kObservations + "0.1\n0.2\nx\n"),
            "g:8:1: expected rz of camera 0 (a finite number), got 'x'");
  EXPECT_EQ(long_complaint(kHeader + kObservations + kFirstCamera + kSecondCamera + "0\n1 2\n 3 -\n"),
            "g:26:4: expected y of point 1 (a finite number), got '-'");
}

TEST(BalFormat, IsRefusedIfAnIndexIsOutOfRange) {
  EXPECT_EQ(long_complaint(kHeader + "2 0 1 2\n"),
            "g:2:1: expected the index of a camera (an integer from 0 to 1), got '2'");
  EXPECT_EQ(long_complaint(kHeader + "0 3 1 2\n"),
            "g:2:3: expected the index of a point (an integer from 0 to 2), got '3'");
  EXPECT_EQ(long_complaint(kHeader + "0 -1 1 2\n"),
            "g:2:3: expected the index of a point (an integer from 0 to 2), got '-1'");
  EXPECT_EQ(long_complaint("1 0 1\n0 0 1 2\n"),
            "g:2:3: expected the index of a point (there are none), got '0'");
}

TEST(BalFormat, IsRefusedIfItsLengthDiffersFromItsCounts) {
  EXPECT_EQ(complaint(kProblem + "1\n"), "g:33:1: expected the end of the file, got '1'");
  EXPECT_EQ(complaint(kProblem.substr(0, kProblem.size() - 3)),
            "g:32:1: expected z of point 2 (a finite number), got the end of the file");
  EXPECT_EQ(complaint(kHeader + kObservations + kFirstCamera + kPoints + "                    "),
            "g:25:1: expected x of point 0 (a finite number), got the end of the file");
}

TEST(BalFormat, IsRefusedAtOnceIfItsCountsDoNotFitIntoItsSize) {
  const std::string short_text = "1000000000000 1000000000000 1000000000000\n0 0 1 2\n" + kFirstCamera;
  EXPECT_THAT(complaint(short_text),
              HasSubstr("g:1:29: expected at most as many cameras, points and observations as fit"));
  EXPECT_THAT(complaint("1 1000000000000 0\n" + kFirstCamera), HasSubstr("got 1, 1000000000000 and 0"));
  EXPECT_THAT(complaint("0 0 999999999999999\n"), HasSubstr("g:1:5: expected at most"));
}

TEST(BalFormat, IsRefusedIfAPoseOverflows) {
  EXPECT_THAT(complaint("1 0 0\n0\n0\n0\n1e200\n0\n0\n1\n0\n0\n"), HasSubstr("values that overflow"));
  EXPECT_EQ(complaint("1 0 0\n1e200\n0\n0\n0\n0\n0\n1\n0\n0\n"),
            "g:10:1: camera 0: expected a pose with moderate values, got values that overflow");
}

TEST(BalFormat, ReadsAPublicProblemAndWritesItBack) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  GraphFile file;
  try {
    file = read_graph(std::string(folder ? folder : "") + "/bal/problem-49-7776-pre.txt");
  } catch (const FileError&) {
    GTEST_SKIP() << "problem-49-7776-pre.txt is not in BOXPLUS_DATA";
  }
  EXPECT_EQ(file.edges.size(), 31843u);
  EXPECT_NEAR(file.graph.chi2() / 2, 8.509125e5, 1);
  const GraphFile again = parse_graph(format_graph(file), "again");
  EXPECT_NEAR(again.graph.chi2(), file.graph.chi2(), 1e-9 * file.graph.chi2());
}

}  // namespace
}  // namespace boxplus
