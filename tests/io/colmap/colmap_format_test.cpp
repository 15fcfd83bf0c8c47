// SPDX-License-Identifier: BSD-3-Clause
#include "io/colmap/colmap_format.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "boxplus/boxplus.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/types/position_prior.h"
#include "io/colmap/model_folder.h"
#include "io/model/camera_types.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// The vertex of point 30: the largest id of an image is 11, so the points begin at 100.
constexpr Id kPoint30 = 130, kPoint4 = 104;

GraphFile model() {
  return read_model_texts({});
}

TEST(ColmapFormat, IsReadAsCamerasPosesPointsAndReprojectionErrors) {
  const GraphFile file = model();
  const Graph& graph = file.graph;
  EXPECT_EQ(file.format, "COLMAP-text");
  EXPECT_EQ(graph.vertex_count(), 6u);
  EXPECT_EQ(graph.parameter_count(), 3u);
  EXPECT_THAT(file.edges, SizeIs(5));
  const Vector3 t(1, 2, 3);
  const SO3 R(detail::Quaternion<double>{0, 0.6, 0, 0.8});
  const SE3& pose = graph.estimate(graph.vertex<SE3>(11));
  EXPECT_TRUE(pose.vector().isApprox(SE3(t, R).inverse().vector(), 1e-15));
  EXPECT_EQ(graph.estimate(graph.vertex<Vector3>(kPoint30)), Vector3(0.1, 0.2, 5));
  EXPECT_TRUE(graph.is_eliminated(*graph.find_vertex(kPoint30)));
  EXPECT_TRUE(graph.estimate(graph.parameter<PinholeCamera>(2)).parameters ==
              PinholeCamera(700, 710, 400.5, 300.25).parameters);
}

TEST(ColmapFormat, HasTheReprojectionErrorsOfItsDefinition) {
  const GraphFile file = model();
  // The first edge: image 11 sees point 30. p = R X + t, u = p / p_z, and the pixel is f (1 + k u²) u + c.
  const SO3 R(detail::Quaternion<double>{0, 0.6, 0, 0.8});
  const Vector3 p = R * Vector3(0.1, 0.2, 5) + Vector3(1, 2, 3);
  const Vector2 u(p[0] / p[2], p[1] / p[2]);
  const Vector2 pixel = 500 * (1 - 0.1 * u.squaredNorm()) * u + Vector2(320, 240);
  const std::vector<double> error = file.graph.error(file.edges[0]);
  EXPECT_NEAR(error[0], pixel[0] - 320, 1e-10);
  EXPECT_NEAR(error[1], pixel[1] - 250, 1e-10);
}

TEST(ColmapFormat, LeavesIntrinsicsFreeExceptForThePrincipalPoint) {
  const GraphFile file = model();
  const auto directions = [&](Id id) {
    const std::span<const int> fixed = file.graph.fixed_directions(*file.graph.find_parameter(id));
    return std::vector<int>(fixed.begin(), fixed.end());
  };
  EXPECT_FALSE(file.graph.is_fixed(*file.graph.find_parameter(7)));
  EXPECT_THAT(directions(7), ElementsAre(1, 2));
  EXPECT_THAT(directions(2), ElementsAre(2, 3));
}

TEST(ColmapFormat, NotesUnusualPartsOfAModel) {
  ModelTexts texts;
  texts.points.replace(texts.points.find(" 11 0 5 1"), 9, " 11 0 11 1");
  std::vector<std::string> notes;
  for (const GraphFile::Note& note : read_model_texts(texts).notes) notes.push_back(note.text);
  EXPECT_THAT(
      notes,
      ElementsAre("1 camera has no image", "1 image has no observations", "1 point has no observations",
                  "1 observation is a duplicate: its image shows the same point at another place, too",
                  "1 observation of an image is in no track",
                  "1 entry of a track is ignored, because its image shows no point or another one there"));
}

TEST(ColmapFormat, KeepsEverythingIfAModelIsReadAndWritten) {
  EXPECT_EQ(written_texts(model()), ModelTexts());
}

TEST(ColmapFormat, KeepsEverythingIfTextBecomesBinaryAndTextAgain) {
  const TestFolder binary("binary"), again("again");
  write_graph(binary.path() + "/", model(), {.format = "COLMAP"});
  const GraphFile file = read_graph(binary.path());
  EXPECT_EQ(file.format, "COLMAP");
  EXPECT_EQ(written_texts(file), ModelTexts());
  write_graph(again.path(), file);
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin"})
    EXPECT_TRUE(again.content(name) == binary.content(name)) << name;
}

TEST(ColmapFormat, HasTheDocumentedBytes) {
  const TestFolder folder("model");
  write_graph(folder.path(), model(), {.format = "COLMAP"});
  const std::string cameras = folder.content("cameras.bin"), images = folder.content("images.bin"),
                    points = folder.content("points3D.bin");
  EXPECT_EQ(cameras.size(), 8 + 3 * 24 + 8 * (4 + 4 + 8));
  EXPECT_EQ(cameras.substr(0, 24), std::string("\3\0\0\0\0\0\0\0\7\0\0\0\2\0\0\0\x80\2\0\0\0\0\0\0", 24));
  EXPECT_EQ(images.size(), 8 + 3 * (4 + 56 + 4 + 8) + 14 + 13 + 10 + 24 * 6);
  EXPECT_EQ(points.size(), 8 + 3 * 51 + 8 * 5);
  EXPECT_EQ(points.substr(8, 8), std::string("\x1e\0\0\0\0\0\0\0", 8));
  EXPECT_EQ(points.substr(40, 3), std::string("\xff\x80\0", 3));
}

TEST(ColmapFormat, IsReadFromTextWithoutTheEmptyLastLineAndWithOtherLineEnds) {
  ModelTexts texts;
  texts.images.pop_back();
  for (std::string* text : {&texts.cameras, &texts.images, &texts.points}) {
    for (std::size_t at = 0; (at = text->find('\n', at)) != std::string::npos; at += 2)
      text->insert(at, "\r");
  }
  texts.cameras.insert(0, "\xEF\xBB\xBF");
  EXPECT_EQ(written_texts(read_model_texts(texts)), ModelTexts());
}

TEST(ColmapFormat, KeepsEveryCameraModel) {
  for (const CameraType& type : camera_types()) {
    ModelTexts texts;
    texts.cameras = std::string("# CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS...\n# Cameras: 1\n7 ") +
                    std::string(type.name) + " 640 480";
    for (int i = 0; i < type.parameters; ++i)
      texts.cameras += i == 0 ? " 500" : " 0.0" + std::to_string(i) + "1";
    texts.cameras += "\n";
    texts.images.replace(texts.images.find(" 2 b/"), 3, " 7 ");
    const GraphFile file = read_model_texts(texts);
    EXPECT_TRUE(std::isfinite(file.graph.chi2())) << type.name;
    EXPECT_EQ(written_texts(file), texts) << type.name;
  }
}

TEST(ColmapFormat, HasNewReprojectionErrorsIfAnEstimateHasChanged) {
  GraphFile file = model();
  file.graph.set_estimate(file.graph.vertex<Vector3>(kPoint30), Vector3(0.1, 0.2, 5.5));
  const double error =
      (std::sqrt(file.graph.chi2(file.edges[0])) + std::sqrt(file.graph.chi2(file.edges[4]))) / 2;
  const SparseModel written = sparse_model(file);
  EXPECT_DOUBLE_EQ(written.points[0].error, error);
  EXPECT_EQ(written.points[1].error, 1.25) << "no vertex of its observations has changed";
  EXPECT_EQ(written.points[0].position[2], 5.5);
}

TEST(ColmapFormat, WritesThePoseOfAnImageThatHasMoved) {
  GraphFile file = model();
  const SE3 T_camera_world(Vector3(4, 5, 6), SO3(detail::Quaternion<double>{0, 0, 0.28, 0.96}));
  file.graph.set_estimate(file.graph.vertex<SE3>(5), T_camera_world.inverse());
  const SparseModel::Image image = sparse_model(file).images[1];
  EXPECT_NEAR(image.rotation[0], 0.96, 1e-15);
  EXPECT_NEAR(image.rotation[3], 0.28, 1e-15);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(image.translation[i], 4.0 + static_cast<double>(i), 1e-14);
  EXPECT_EQ(image.name, "b/second.png");
}

TEST(ColmapFormat, WritesNoObservationOfARemovedEdge) {
  GraphFile file = model();
  file.graph.remove(file.edges[0]);
  const SparseModel written = sparse_model(file);
  EXPECT_EQ(written.images[0].features[0].point, SparseModel::Feature::kNoPoint);
  EXPECT_EQ(written.images[0].features[0].pixel[0], 320);
  EXPECT_THAT(written.points[0].track, ElementsAre(SparseModel::Observation{5, 1}));
}

TEST(ColmapFormat, WritesWhatIsLeftIfAPointOrAnImageIsRemoved) {
  GraphFile file = model();
  file.graph.remove(*file.graph.find_vertex(kPoint4));
  file.graph.remove(*file.graph.find_vertex(5));
  const GraphFile again = read_model_texts(written_texts(file));
  EXPECT_EQ(again.graph.vertex_count(), 4u);
  EXPECT_THAT(again.edges, SizeIs(1));
  EXPECT_THAT(again.model->points[0].track, ElementsAre(SparseModel::Observation{11, 0}));
}

TEST(ColmapFormat, WritesNewPointsAndEdges) {
  GraphFile file = model();
  Graph& graph = file.graph;
  const auto point = graph.add_vertex(Vector3(0, 0, 9));
  graph.add_edge(Reprojection<PinholeCamera>(Vector2(7, 8)), graph.vertex<SE3>(5), point,
                 graph.parameter<PinholeCamera>(2));
  const SparseModel written = sparse_model(file);
  ASSERT_THAT(written.points, SizeIs(4));
  EXPECT_EQ(written.points[3].id, 31u);
  EXPECT_THAT(written.points[3].track, ElementsAre(SparseModel::Observation{5, 2}));
  EXPECT_EQ(written.images[1].features[2].point, 31u);
  EXPECT_EQ(written.images[1].features[2].pixel[1], 8);
}

TEST(ColmapFormat, CanBeConvertedToBalAndBackIfTheCamerasAllowIt) {
  ModelTexts texts;
  texts.images.replace(texts.images.find(" 2 b/"), 3, " 7 ");
  EXPECT_THAT(complaint_of([&] { format_graph(read_model_texts(texts), {.format = "BAL"}); }),
              HasSubstr("camera 2: expected SIMPLE_PINHOLE, PINHOLE with fx = fy, SIMPLE_RADIAL or RADIAL"));
  texts.cameras = "7 SIMPLE_RADIAL 640 480 500 320 240 -0.1\n";
  const GraphFile file = read_model_texts(texts);
  const GraphFile bal = parse_graph(format_graph(file, {.format = "BAL"}), "bal");
  EXPECT_NEAR(bal.graph.chi2(), file.graph.chi2(), 1e-9 * file.graph.chi2());
  const TestFolder folder("model");
  write_graph(folder.path(), bal);
  const GraphFile again = read_graph(folder.path());
  EXPECT_NEAR(again.graph.chi2(), file.graph.chi2(), 1e-9 * file.graph.chi2());
  EXPECT_EQ(again.graph.parameter_count(), 3u) << "one camera per image";
  EXPECT_EQ(again.model->images[0].camera, 1u);
  EXPECT_EQ(again.model->cameras[0].model, "RADIAL");
}

TEST(ColmapFormat, IsNotWrittenIfItsReaderWouldHaveOtherErrors) {
  const auto complaint_about = [](const SE3& pose, double f, const Vector3& seen) {
    Graph graph;
    const auto image = graph.add_vertex(pose, 3);
    const auto point = graph.add_vertex(Vector3(pose * seen), 8);
    const auto camera = graph.add_parameter(SimplePinholeCamera(f, 0, 0));
    const Vector2 pixel = graph.estimate(camera).project(Vector3(pose.inverse_times(graph.estimate(point))));
    const EdgeRef edge = graph.add_edge(Reprojection<SimplePinholeCamera>(pixel), image, point, camera);
    EXPECT_THAT(graph.error(edge), testing::Each(0));
    const TestFolder folder("model");
    return complaint_of([&] { write_graph(folder.file("new"), graph, {.format = "COLMAP"}); });
  };
  const SO3 rotation = SO3::from_rotation_vector(Vector3(0.1, -0.2, 0.3));
  const SE3 near(Vector3(1, 2, 3), rotation), far(Vector3(1.1e18, -2.3e18, 3.7e18), rotation);
  EXPECT_EQ(complaint_about(near, 500, Vector3(1, 2, 10)), "no complaint");
  EXPECT_THAT(complaint_about(near, 1e18, Vector3(1, 2, 10)),
              HasSubstr("cannot write a COLMAP model: image 1 and point 1: expected values so moderate that "
                        "the file keeps the reprojection error of 0 pixels, got"));
  EXPECT_THAT(complaint_about(far, 500, Vector3(1e4, 2e4, 1e5)), HasSubstr("image 1 and point 1"));
  EXPECT_THAT(complaint_about(SE3(Vector3(1e151, 0, 0), rotation), 500, Vector3(0, 0, 1)),
              HasSubstr("got image 1 with a pose that overflows"));
}

TEST(ColmapFormat, IsNotConvertedToBalIfItsCenterHidesTheErrors) {
  ModelTexts texts;
  texts.cameras = "7 SIMPLE_PINHOLE 640 480 500 1e18 240\n2 SIMPLE_PINHOLE 640 480 500 320 240\n";
  texts.images.replace(texts.images.find("320 250 30"), 3, "1e18");
  EXPECT_THAT(complaint_of([&] { format_graph(read_model_texts(texts), {.format = "BAL"}); }),
              HasSubstr("cannot write BAL's .bal: image 11 and point 30: expected values so moderate"));
}

TEST(ColmapFormat, HasAnUnknownReprojectionErrorIfTheErrorOverflows) {
  const GraphFile bal =
      parse_graph("1 2 2\n0 0 1e200 0\n0 1 3 4\n0\n0\n0\n0\n0\n0\n500\n0\n0\n0\n0\n-9\n0\n0\n-8\n", "bal");
  for (const char* format : {"COLMAP", "COLMAP-text"}) {
    const TestFolder folder("model");
    write_graph(folder.file("new"), bal, {.format = format});
    const GraphFile again = read_graph(folder.file("new"));
    EXPECT_EQ(again.model->points[0].error, -1);
    EXPECT_NEAR(again.model->points[1].error, 5, 1e-6);
  }
}

TEST(ColmapFormat, CannotRepresentOtherGraphs) {
  const TestFolder folder("model");
  EXPECT_THAT(complaint_of([&] { write_graph(folder.path(), parse_graph("VERTEX_SE2 0 0 0 0\n", "g")); }),
              HasSubstr("got vertex 0 of type SE2"));
  EXPECT_THAT(complaint_of(
                  [&] { write_graph(folder.path(), parse_graph("VERTEX_SE3:QUAT 3 0 0 0 0 0 0 1\n", "g")); }),
              HasSubstr("got pose 3 without an edge, so that its camera is unknown"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THAT(complaint_of([] { format_graph(model()); }), HasSubstr("as one text"));
}

TEST(ColmapFormat, LeavesOutInformationAndOtherEdgesAndSaysSo) {
  const TestFolder folder("model"), plain("plain");
  GraphFile file = model();
  write_graph(plain.path(), file, {.format = "COLMAP-text"});
  EXPECT_TRUE(losses(folder.path(), file).empty());
  file.graph.set_information(file.edges[2], 4.0);
  file.graph.add_edge(PositionPrior(Vector3(1, 2, 3)), file.graph.vertex<SE3>(11));
  EXPECT_THAT(losses(folder.path(), file),
              testing::ElementsAre("the information of 1 edge", HasSubstr("1 edge PositionPrior")));
  write_graph(folder.path(), file, {.format = "COLMAP-text"});
  for (const char* name : {"cameras.txt", "images.txt", "points3D.txt"})
    EXPECT_EQ(folder.content(name), plain.content(name)) << name;
}

TEST(ColmapFormat, CannotHaveEveryNameOfAnImage) {
  const TestFolder folder("model");
  const auto complaint = [&](const std::string& name, const char* format) {
    GraphFile file = model();
    SparseModel renamed = *file.model;
    renamed.images[1].name = name;
    file.model = std::make_shared<const SparseModel>(std::move(renamed));
    return complaint_of([&] { write_graph(folder.file("new"), file, {.format = format}); });
  };
  for (const char* name : {"", " a", "a ", "a\nb"})
    EXPECT_THAT(complaint(name, "COLMAP-text"), HasSubstr("image 5: expected a name of one line")) << name;
  for (const char* format : {"COLMAP-text", "COLMAP"}) {
    EXPECT_THAT(complaint(std::string("a\0b", 3), format),
                HasSubstr("image 5: expected a name without bytes of"));
    EXPECT_EQ(complaint("a b", format), "no complaint");
  }
  EXPECT_EQ(complaint("", "COLMAP"), "no complaint");
}

TEST(ColmapFormat, IsNotWrittenIntoAFolderWithFilesThatColmapPrefers) {
  const TestFolder folder("model");
  write_graph(folder.path(), model(), {.format = "COLMAP"});
  EXPECT_THAT(complaint_of([&] { write_graph(folder.path(), model(), {.format = "COLMAP-text"}); }),
              HasSubstr("expected a folder without cameras.bin"));
}

TEST(ColmapFormat, CreatesAFolderForAGraphThatWasReadInIt) {
  const TestFolder folder("model");
  write_graph(folder.file("new/0"), model());
  EXPECT_EQ(read_graph(folder.file("new/0")).format, "COLMAP-text");
}

TEST(ColmapFormat, NamesAMissingFile) {
  const TestFolder folder("model");
  EXPECT_THAT(complaint_of([&] { read_graph(folder.path()); }),
              HasSubstr("expected a file or a COLMAP folder, COLMAP-text folder, got a folder without"));
  folder.write({});
  std::filesystem::remove(folder.file("images.txt"));
  EXPECT_EQ(complaint_of([&] { read_graph(folder.path()); }),
            "images.txt: cannot be opened: No such file or directory");
}

}  // namespace
}  // namespace boxplus
