// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's rigs and frames.
#include <gmock/gmock.h>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/ba/bundle_parts.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// The small model with image 5 beside image 11, so that both can be on a rig. Camera 2 is on the rig of
/// camera 7, and half a meter left of it. `frames` can also have the frames of trivial rigs.
struct FrameTexts {
  ModelTexts model = [] {
    ModelTexts texts;
    const std::string pose = "5 1 0 0 0 0 0.125 -0.25 2 b";
    texts.images.replace(texts.images.find(pose), pose.size(), "5 0.8 0 0.6 0 1.5 2 3 2 b");
    return texts;
  }();
  std::string rigs =
      "# RIG_ID NUM_SENSORS REF_SENSOR_TYPE REF_SENSOR_ID (SENSOR_TYPE SENSOR_ID HAS_POSE [QW QX QY QZ TX TY "
      "TZ])...\n"
      "# Rigs: 2\n"
      "1 3 CAMERA 7 CAMERA 2 1 1 0 0 0 0.5 0 0 IMU 4 0\n"
      "2 1 CAMERA 9\n";
  std::string frames =
      "# FRAME_ID RIG_ID QW QX QY QZ TX TY TZ NUM_DATA_IDS (SENSOR_TYPE SENSOR_ID DATA_ID)...\n"
      "# Frames: 3\n"
      "8 1 0.8 0 0.6 0 1 2 3 3 CAMERA 7 11 CAMERA 2 5 IMU 4 99\n"
      "3 1 1 0 0 0 0 0 0 1 CAMERA 7 6\n"
      "4 2 1 0 0 0 0 0 0 0\n";
  bool operator==(const FrameTexts&) const = default;
};

FrameTexts with_trivial_rigs() {
  FrameTexts texts;
  texts.rigs = "1 1 CAMERA 7\n2 1 CAMERA 2\n";
  texts.frames =
      "1 1 0.8 0 0.6 0 1 2 3 1 CAMERA 7 11\n"
      "2 2 0.8 0 0.6 0 1.5 2 3 1 CAMERA 2 5\n"
      "3 1 1 0 0 0 0 0 0 1 CAMERA 7 6\n";
  return texts;
}

/// The images of the rig, each in a frame of its own. Then the one of image 5 has no image of the reference
/// sensor.
FrameTexts with_split_frames() {
  FrameTexts texts;
  texts.frames =
      "8 1 0.8 0 0.6 0 1 2 3 1 CAMERA 7 11\n"
      "9 1 0.8 0 0.6 0 1 2 3 1 CAMERA 2 5\n"
      "3 1 1 0 0 0 0 0 0 1 CAMERA 7 6\n";
  return texts;
}

void PrintTo(const FrameTexts& texts, std::ostream* out) {
  PrintTo(texts.model, out);
  *out << texts.rigs << texts.frames;
}

void write(const TestFolder& folder, const FrameTexts& texts) {
  folder.write(texts.model);
  folder.write("rigs.txt", texts.rigs);
  folder.write("frames.txt", texts.frames);
}

GraphFile read(const FrameTexts& texts) {
  const TestFolder folder("model");
  write(folder, texts);
  return read_graph(folder.path());
}

FrameTexts written(const GraphFile& file) {
  const TestFolder folder("written");
  write_graph(folder.path(), file, {.format = "COLMAP-text"});
  return {folder.texts(), folder.content("rigs.txt"), folder.content("frames.txt")};
}

std::vector<double> chi2_of_edges(const GraphFile& file) {
  std::vector<double> chi2;
  for (const EdgeRef& edge : file.edges) chi2.push_back(file.graph.chi2(edge));
  return chi2;
}

TEST(ColmapFrames, AreKeptIfAModelIsReadAndWritten) {
  EXPECT_EQ(written(read({})), FrameTexts());
  const TestFolder binary("binary"), again("again");
  write_graph(binary.path() + "/", read({}), {.format = "COLMAP"});
  const GraphFile file = read_graph(binary.path());
  EXPECT_EQ(written(file), FrameTexts());
  write_graph(again.path(), file);
  for (const char* name : {"images.bin", "rigs.bin", "frames.bin"})
    EXPECT_TRUE(again.content(name) == binary.content(name)) << name;
}

TEST(ColmapFrames, HaveTheDocumentedBytes) {
  const TestFolder folder("model");
  write_graph(folder.path(), read({}), {.format = "COLMAP"});
  const std::string rigs = folder.content("rigs.bin"), frames = folder.content("frames.bin");
  EXPECT_EQ(rigs.size(), 8 + 2 * (4 + 4 + 8) + (8 + 1 + 56) + (8 + 1));
  EXPECT_EQ(rigs.substr(0, 33), std::string("\2\0\0\0\0\0\0\0\1\0\0\0\3\0\0\0\0\0\0\0\7\0\0\0"
                                            "\0\0\0\0\2\0\0\0\1",
                                            33));
  EXPECT_EQ(rigs.substr(33 + 56, 9), std::string("\1\0\0\0\4\0\0\0\0", 9));
  EXPECT_EQ(frames.size(), 8 + 3 * (4 + 4 + 56 + 4) + 4 * 16);
  EXPECT_EQ(frames.substr(8, 8), std::string("\10\0\0\0\1\0\0\0", 8));
  EXPECT_EQ(frames.substr(72, 20), std::string("\3\0\0\0\0\0\0\0\7\0\0\0\13\0\0\0\0\0\0\0", 20));
}

TEST(ColmapFrames, OfOneCameraAreTheGraphOfTheirImages) {
  const GraphFile file = read(with_trivial_rigs()), without = read_model_texts(FrameTexts().model);
  EXPECT_EQ(file.graph.vertex_count(), 6u);
  EXPECT_EQ(file.graph.parameter_count(), 3u);
  EXPECT_EQ(chi2_of_edges(file), chi2_of_edges(without));
}

TEST(ColmapFrames, OfARigAreOneVertexWithOffsets) {
  const GraphFile file = read({}), without = read_model_texts(FrameTexts().model);
  const Graph& graph = file.graph;
  EXPECT_EQ(graph.vertex_count(), 5u);
  EXPECT_EQ(graph.find_vertex(5), std::nullopt);
  EXPECT_EQ(graph.parameter_count(), 4u);
  const auto offset = graph.parameter<SE3>(12);
  EXPECT_TRUE(graph.is_fixed(offset));
  EXPECT_EQ(graph.estimate(offset).translation(), Vector3(-0.5, 0, 0));
  EXPECT_THAT(graph.vertices(file.edges[3]),
              ElementsAre(*graph.find_vertex(11), *graph.find_vertex(104), offset, *graph.find_parameter(2)));
  const std::vector<double> chi2 = chi2_of_edges(file), expected = chi2_of_edges(without);
  ASSERT_THAT(chi2, SizeIs(5));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(chi2[k], expected[k], 1e-9 * expected[k]) << k;
}

TEST(ColmapFrames, WithoutAnImageOfTheReferenceSensorHaveTheVertexOfAnotherImage) {
  const GraphFile file = read(with_split_frames()), without = read_model_texts(FrameTexts().model);
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<SE3>(5)).vector(),
            file.graph.estimate(file.graph.vertex<SE3>(11)).vector());
  EXPECT_NEAR(file.graph.chi2(), without.graph.chi2(), 1e-9 * without.graph.chi2());
  EXPECT_EQ(written(file).model, FrameTexts().model);
}

TEST(ColmapFrames, HaveTheNewPoseOfTheirImage) {
  GraphFile file = read(with_trivial_rigs());
  const SE3 T_camera_world(Vector3(4, 5, 6), SO3(detail::Quaternion<double>{0, 0, 0.28, 0.96}));
  file.graph.set_estimate(file.graph.vertex<SE3>(5), T_camera_world.inverse());
  const SparseModel model = sparse_model(file);
  EXPECT_NEAR(model.frames[1].pose.rotation[3], 0.28, 1e-15);
  EXPECT_EQ(model.frames[1].pose.rotation, model.images[1].rotation);
  EXPECT_EQ(model.frames[1].pose.translation, model.images[1].translation);
  EXPECT_EQ(model.frames[0].pose.translation, model.images[0].translation);
}

TEST(ColmapFrames, HaveTheSameErrorsInJson) {
  const GraphFile file = read({});
  const std::string text = format_graph(file, {.format = "json"});
  EXPECT_THAT(text, HasSubstr(R"({"tag": "EDGE_REPROJECTION_RIG_PINHOLE", "ids": [11, 104, 12, 2], )"));
  const GraphFile again = parse_graph(text, "g.json");
  EXPECT_EQ(chi2_of_edges(again), chi2_of_edges(file));
  EXPECT_TRUE(again.graph.is_fixed(*again.graph.find_parameter(12)));
  EXPECT_FALSE(again.graph.is_fixed(*again.graph.find_parameter(2)));
  EXPECT_EQ(format_graph(again), text);
}

TEST(ColmapFrames, MoveAllImagesOfARig) {
  GraphFile file = read({});
  file.graph.set_estimate(file.graph.vertex<SE3>(11), SE3(Vector3(-4, -5, -6), SO3()));
  const SparseModel model = sparse_model(file);
  EXPECT_THAT(model.frames[0].pose.translation, ElementsAre(4, 5, 6));
  EXPECT_THAT(model.images[0].translation, ElementsAre(4, 5, 6));
  EXPECT_THAT(model.images[1].translation, ElementsAre(4.5, 5, 6));
  EXPECT_THAT(model.rigs[0].sensors[1].pose->translation, ElementsAre(0.5, 0, 0));
  const GraphFile again = read(written(file));
  EXPECT_NEAR(again.graph.chi2(), file.graph.chi2(), 1e-9 * file.graph.chi2());
}

TEST(ColmapFrames, MoveIfAnOffsetIsFreeAndMoves) {
  GraphFile file = read({});
  file.graph.set_estimate(file.graph.parameter<SE3>(12), SE3(Vector3(-0.75, 0, 0), SO3()));
  const SparseModel model = sparse_model(file);
  EXPECT_THAT(model.rigs[0].sensors[1].pose->translation, ElementsAre(0.75, 0, 0));
  EXPECT_THAT(model.images[1].translation[0], testing::DoubleNear(1.75, 1e-14));
  EXPECT_EQ(model.frames[0].pose.translation[0], 1);
}

TEST(ColmapFrames, LoseAnImageThatIsRemovedAndGetANewOne) {
  GraphFile file = read(with_trivial_rigs());
  Graph& graph = file.graph;
  graph.remove(*graph.find_vertex(5));
  for (const Id camera : {7, 9}) {
    const auto pose = graph.add_vertex(SE3(Vector3(1, 1, static_cast<double>(camera)), SO3()));
    const auto point = graph.vertex<Vector3>(104);
    if (camera == 9)
      graph.add_edge(Reprojection<OpenCvCamera>(Vector2(7, 8)), pose, point,
                     graph.parameter<OpenCvCamera>(9));
    else
      graph.add_edge(Reprojection<SimpleRadialCamera>(Vector2(7, 8)), pose, point,
                     graph.parameter<SimpleRadialCamera>(7));
  }
  const GraphFile again = read(written(file));
  EXPECT_NEAR(again.graph.chi2(), graph.chi2(), 1e-9 * graph.chi2());
  std::vector<std::array<std::uint64_t, 3>> frames;
  for (const SparseModel::Frame& frame : again.model->frames)
    frames.push_back({frame.id, frame.rig, frame.data.at(0).id});
  EXPECT_THAT(frames, ElementsAre(ElementsAre(1, 1, 11), ElementsAre(3, 1, 6), ElementsAre(4, 1, 12),
                                  ElementsAre(5, 3, 13)));
  EXPECT_EQ(again.model->rigs.at(2).sensors.at(0).sensor.id, 9u);
}

TEST(ColmapFrames, AreNotWrittenIfTheGraphContradictsTheRig) {
  const TestFolder folder("written_model");
  const auto complaint = [&](auto&& change) {
    GraphFile file = read({});
    change(file.graph);
    return complaint_of([&] { write_graph(folder.path(), file); });
  };
  const auto see = [](Graph& graph, auto... vertices) {
    graph.add_edge(Reprojection<SimpleRadialCamera>(Vector2(7, 8)), vertices...);
  };
  EXPECT_THAT(complaint([&](Graph& graph) {
                see(graph, graph.vertex<SE3>(6), graph.vertex<Vector3>(104), graph.parameter<SE3>(12),
                    graph.parameter<SimpleRadialCamera>(7));
              }),
              HasSubstr("an edge of pose 6 and offset 12, which are those of no image"));
  EXPECT_THAT(complaint([&](Graph& graph) {
                graph.add_edge(Reprojection<PinholeCamera>(Vector2(7, 8)), graph.add_vertex(SE3()),
                               graph.vertex<Vector3>(104), graph.parameter<PinholeCamera>(2));
              }),
              HasSubstr("the new image 12 of camera 2, which is not the reference sensor of rig 1"));
  EXPECT_THAT(complaint([&](Graph& graph) { graph.remove(*graph.find_parameter(9)); }),
              HasSubstr("got rig 2 without its camera 9"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ColmapFrames, KeepTheirOffsetsIfPosesAreFreed) {
  GraphFile file = read({});
  EXPECT_EQ(hold(file.graph, BundlePart::kPoses, true), 2u);
  EXPECT_EQ(hold(file.graph, BundlePart::kPoses, false), 2u);
  EXPECT_TRUE(file.graph.is_fixed(file.graph.parameter<SE3>(12)));
  EXPECT_EQ(set_pixel_sigma(file.graph, 2), 5u);
}

TEST(ColmapFrames, AreNotKeptByBalWhichIsSaidIfTheyAreRigs) {
  EXPECT_THAT(losses("scene.bal", read({})), ElementsAre("the rig of 1 image"));
  EXPECT_THAT(losses("scene.bal", read(with_trivial_rigs())), IsEmpty());
  EXPECT_THAT(losses("model/", read({})), IsEmpty());
}

TEST(ColmapFrames, BothHaveAFile) {
  const TestFolder folder("model");
  write(folder, {});
  std::filesystem::remove(folder.file("rigs.txt"));
  EXPECT_EQ(complaint_of([&] { read_graph(folder.path()); }),
            "rigs.txt: cannot be opened: No such file or directory");
}

TEST(ColmapFrames, OfTheFolderAreNotLeftBesideAModelWithoutFrames) {
  const TestFolder folder("model");
  folder.write("frames.bin", "");
  for (const char* format : {"COLMAP", "COLMAP-text"})
    EXPECT_THAT(complaint_of([&] { write_graph(folder.path(), read_model_texts({}), {.format = format}); }),
                HasSubstr("expected a folder without frames.bin"));
  write_graph(folder.path(), read({}), {.format = "COLMAP"});
  EXPECT_EQ(written(read_graph(folder.path())), FrameTexts());
}

/// The complaint about the small model with one text replaced.
std::string complaint_after(std::string FrameTexts::*file, const std::string& old, const std::string& fresh) {
  FrameTexts texts;
  std::string& text = texts.*file;
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  text.replace(at, old.size(), fresh);
  return complaint_of([&] { read(texts); });
}

TEST(ColmapFrames, NameTheLineAndTheColumnOfAnErrorInTheRigs) {
  const auto complaint = [](const char* old, const char* fresh) {
    return complaint_after(&FrameTexts::rigs, old, fresh);
  };
  EXPECT_EQ(complaint("2 1 CAMERA 9", "1 1 CAMERA 9"),
            "rigs.txt:4:1: expected the id of a new rig, got 1 again");
  EXPECT_EQ(complaint("CAMERA 9", "CAMERA 8"),
            "rigs.txt:4:12: expected the id of a camera, got 8, which does not exist");
  EXPECT_EQ(complaint("CAMERA 9", "CAMERA 7"),
            "rigs.txt:4:12: expected a sensor that is on no rig yet, got camera 7 again");
  EXPECT_EQ(complaint("CAMERA 9", "LIDAR 9"),
            "rigs.txt:4:5: expected the type of a sensor (CAMERA or IMU), got 'LIDAR'");
  EXPECT_EQ(complaint("2 1 CAMERA 9", "2 2 CAMERA 9"),
            "rigs.txt:4:13: expected the type of a sensor (CAMERA or IMU), got the end of the line");
  EXPECT_EQ(complaint("IMU 4 0", "IMU 4 2"),
            "rigs.txt:3:47: expected 1 if the sensor has a pose, otherwise 0, got 2");
  EXPECT_EQ(complaint("IMU 4 0", "IMU 4 0 1"), "rigs.txt:3:49: expected the end of the line, got '1'");
  EXPECT_EQ(
      complaint("1 0 0 0 0.5", "0 0 0 0 0.5"),
      "rigs.txt:3:25: camera 2 of rig 1: expected a quaternion QW QX QY QZ of length 1 (± 0.001), got one "
      "of length 0");
}

TEST(ColmapFrames, NameTheLineAndTheColumnOfAnErrorInTheFrames) {
  const auto complaint = [](const char* old, const char* fresh) {
    return complaint_after(&FrameTexts::frames, old, fresh);
  };
  EXPECT_EQ(complaint("\n3 1", "\n8 1"), "frames.txt:4:1: expected the id of a new frame, got 8 again");
  EXPECT_EQ(complaint("\n3 1", "\n3 5"),
            "frames.txt:4:3: expected the id of a rig, got 5, which does not exist");
  EXPECT_EQ(complaint("CAMERA 7 6", "CAMERA 9 6"),
            "frames.txt:4:28: expected a sensor of rig 1, got camera 9");
  EXPECT_EQ(complaint("CAMERA 7 6", "CAMERA 7 66"),
            "frames.txt:4:30: expected the id of an image, got 66, which does not exist");
  EXPECT_EQ(complaint("CAMERA 7 6", "CAMERA 2 6"),
            "frames.txt:4:30: expected an image of camera 2, got image 6 of camera 7");
  EXPECT_EQ(complaint("2 3 3 CAMERA 7 11", "2 3 3 CAMERA 7 6"),
            "frames.txt:3:34: expected frame 8 where image 6 is, got a pose that differs by 1.287 rad and "
            "3.74166");
  EXPECT_EQ(complaint("CAMERA 2 5", "CAMERA 7 6"),
            "frames.txt:3:44: frame 8: expected one image of each camera, got two of camera 7");
  EXPECT_EQ(complaint("0 0 0 1 CAMERA 7 6", "0 0 0 1 CAMERA 7 11"),
            "frames.txt:4:30: expected an image that is in no frame yet, got 11 again");
  EXPECT_EQ(complaint("0 0 0 1 CAMERA 7 6", "0 0 0 0"),
            "frames.txt:5:19: expected a frame of image 6, got none");
  EXPECT_THAT(complaint("1 2 3 3 C", "1.001 2 3 3 C"),
              StartsWith("frames.txt:3:38: expected frame 8 where image 11 is, got a pose that differs by"));
  EXPECT_EQ(
      complaint_after(&FrameTexts::rigs, "2 1 1 0 0 0 0.5 0 0", "2 0"),
      "frames.txt:3:46: expected an image of a camera whose pose on rig 1 is known, got image 5 of camera 2");
}

TEST(ColmapFrames, AreRefusedWhereverTheirBinaryFilesAreTruncated) {
  const TestFolder folder("binary_model");
  write_graph(folder.path(), read({}), {.format = "COLMAP"});
  const auto complaint_with = [&](const std::string& name, const std::string& content) {
    const std::string before = folder.content(name);
    folder.write(name, content);
    std::string complaint = complaint_of([&] { read_graph(folder.path()); });
    folder.write(name, before);
    return complaint;
  };
  for (const std::string name : {"rigs.bin", "frames.bin"}) {
    const std::string content = folder.content(name);
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_THAT(complaint_with(name, content.substr(0, size)), StartsWith(name + ":1:")) << size;
    EXPECT_THAT(complaint_with(name, content + "x"),
                HasSubstr("expected the end of the file, got 1 more bytes"));
  }
  std::string rigs = folder.content("rigs.bin");
  rigs.replace(12, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_THAT(complaint_with("rigs.bin", rigs), StartsWith("rigs.bin:1:"));
  rigs.replace(16, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_EQ(complaint_with("rigs.bin", rigs),
            "rigs.bin:1:17: expected the type of a sensor (0 for a camera, 1 for an IMU), got -1");
}

}  // namespace
}  // namespace boxplus
