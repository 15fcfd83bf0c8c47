// SPDX-License-Identifier: BSD-3-Clause
// The content of COLMAP's sparse models: cameras.txt, images.txt and points3D.txt, and rigs.txt and
// frames.txt if the model has them, or the same as .bin.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boxplus/graph/handle.h"

namespace boxplus {

struct GraphFile;

namespace detail {

/// Cameras, images with their 2-D points, and 3-D points with their tracks, in the order of the files. Each
/// kind has its own ids. Pixels are in COLMAP's coordinates: the upper left corner of the image is (0, 0).
///
/// In the graph of a model, a camera is a parameter with the id of the camera, and is not fixed; only its
/// principal point is. An image is a vertex SE3 (T_world_camera) with the id of the image. A 3-D point is a
/// vertex Vector3 with the id first_point_vertex() + its own id.
///
/// In a model with frames, the images of a frame share one vertex, T_world_rig. Its id is that of the frame's
/// image of the reference sensor; if there is none, that of the first image of the frame. The other images
/// have edges with a parameter SE3, the pose of their sensor on the rig (T_rig_camera), which is fixed and
/// has the id first_sensor_parameter() + the id of the camera.
struct SparseModel {
  struct Camera {
    std::uint32_t id = 0;
    std::string model;  ///< COLMAP's name: "SIMPLE_RADIAL"
    std::uint64_t width = 0, height = 0;
    std::vector<double> parameters;
  };
  struct Feature {
    static constexpr std::uint64_t kNoPoint = ~std::uint64_t{0};
    std::array<double, 2> pixel{};
    std::uint64_t point = kNoPoint;  ///< the id of the 3-D point that it shows, if any
  };
  struct Image {
    std::uint32_t id = 0;
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< of T_camera_world, as qw qx qy qz
    std::array<double, 3> translation{};         ///< of T_camera_world
    std::uint32_t camera = 0;
    std::string name;
    std::vector<Feature> features;
  };
  /// A feature that shows a point: an image, and the index of the feature in this image.
  struct Observation {
    std::uint32_t image = 0, feature = 0;
    bool operator==(const Observation&) const = default;
  };
  struct Point {
    std::uint64_t id = 0;
    std::array<double, 3> position{};
    std::array<std::uint8_t, 3> color{};  ///< red, green, blue
    double error = -1;                    ///< mean reprojection error in pixels; −1 if it is unknown
    std::vector<Observation> track;
  };
  struct Pose {
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< qw qx qy qz
    std::array<double, 3> translation{};
    bool operator==(const Pose&) const = default;
  };
  enum class SensorType : std::uint8_t { kCamera, kImu };  ///< with COLMAP's numbers
  struct Sensor {
    SensorType type = SensorType::kCamera;
    std::uint32_t id = 0;  ///< of a camera, for this type
    auto operator<=>(const Sensor&) const = default;
  };
  struct RigSensor {
    Sensor sensor;
    std::optional<Pose> pose;  ///< T_sensor_rig, if it is known; none for the reference sensor
  };
  /// Sensors that move together. The first one is the reference sensor, which is the frame of the rig.
  struct Rig {
    std::uint32_t id = 0;
    std::vector<RigSensor> sensors;
  };
  /// Data that a sensor has recorded: of a camera, the image with this id.
  struct Data {
    Sensor sensor;
    std::uint64_t id = 0;
  };
  /// What the sensors of a rig have recorded at one time.
  struct Frame {
    std::uint32_t id = 0, rig = 0;
    Pose pose;  ///< T_rig_world
    std::vector<Data> data;
  };
  std::vector<Camera> cameras;
  std::vector<Image> images;
  std::vector<Point> points;
  bool has_frames = false;  ///< whether there are files about rigs and frames (COLMAP 3.12 and later)
  std::vector<Rig> rigs;
  std::vector<Frame> frames;

  /// The smallest power of ten that is larger than all ids of images.
  Id first_point_vertex() const;
  /// The smallest power of ten that is larger than all ids of cameras.
  Id first_sensor_parameter() const;
};

}  // namespace detail

using detail::SparseModel;

/// The model that describes a graph of bundle adjustment. Everything that the graph does not contain is as in
/// file.model. Poses, parameters and points that have not changed since they were read have the same bits as
/// there. If anything that concerns a point has changed, its reprojection error is computed again. A graph
/// that was not read from a model gets the ids 1, 2, …, the ids of its poses as names of images, and images
/// large enough for all of their features. Throws InvalidArgument if the graph is none of bundle adjustment:
/// if it has other elements than cameras, poses, points and reprojection errors with the identity as
/// information, if an image has no camera or several, if the camera model is unknown to COLMAP, or if the
/// rounded values of the model would have other reprojection errors than the graph. BAL's cameras become
/// RADIAL.
SparseModel sparse_model(const GraphFile& file);

}  // namespace boxplus
