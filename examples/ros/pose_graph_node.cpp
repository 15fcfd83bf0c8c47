// SPDX-License-Identifier: BSD-3-Clause
// A node of ROS 2: the path of a robot in the plane, from its odometry and from measured positions.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/smoother.h>
#include <boxplus/types/slam2d.h>

#include <Eigen/LU>
#include <cmath>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <memory>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>
#include <rclcpp/rclcpp.hpp>
#include <vector>

using namespace boxplus;
using geometry_msgs::msg::PoseWithCovarianceStamped, nav_msgs::msg::Odometry, nav_msgs::msg::Path;

class PoseGraph : public rclcpp::Node {
 public:
  PoseGraph() : Node("pose_graph"), smoother_(graph_) {
    path_.header.frame_id = "map";
    publisher_ = create_publisher<Path>("path", rclcpp::QoS(1).transient_local());
    odometry_ = create_subscription<Odometry>("odom", 50, [this](const Odometry& m) { drive(m); });
    positions_ = create_subscription<PoseWithCovarianceStamped>(
        "position", 10, [this](const PoseWithCovarianceStamped& m) { correct(m.pose); });
  }

 private:
  /// Adds a pose if the robot has moved 0.2 m or turned 0.1 rad since the last one.
  void drive(const Odometry& message) {
    const auto& [position, q] = message.pose.pose;  // q is a unit quaternion
    const SE2 now(position.x, position.y, 2 * std::atan2(q.z, q.w));
    const SE2 moved = poses_.empty() ? now : odometry_pose_.inverse() * now;
    if (!poses_.empty() && std::hypot(moved.x(), moved.y()) < 0.2 && std::abs(moved.theta()) < 0.1) return;
    odometry_pose_ = now;
    poses_.push_back(graph_.add_vertex(poses_.empty() ? now : graph_.estimate(poses_.back()) * moved));
    const double weights[] = {2500, 2500, 40000};  // of x, y and θ: 2 cm, 2 cm, 5 mrad
    if (poses_.size() > 1)
      graph_.add_edge(Between(moved), Information::diagonal(weights), poses_.end()[-2], poses_.back());
    path_.header.stamp = message.header.stamp;
    path_.poses.emplace_back().header = path_.header;
    optimize_and_publish();
  }

  /// Adds a position in the map, for example of a satellite receiver, to the newest pose.
  void correct(const geometry_msgs::msg::PoseWithCovariance& measured) {
    if (poses_.empty()) return;
    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> cov(measured.covariance.data());
    const Vector2 position(measured.pose.position.x, measured.pose.position.y);
    graph_.add_edge(PositionPrior(position), Information(cov.topLeftCorner<2, 2>().inverse()), poses_.back());
    optimize_and_publish();
  }

  void optimize_and_publish() {
    const SmootherReport report = smoother_.update();
    if (!report.message.empty()) RCLCPP_WARN(get_logger(), "%s", report.message.c_str());
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const SE2& pose = graph_.estimate(poses_[k]);
      auto& [position, q] = path_.poses[k].pose;
      position.x = pose.x(), position.y = pose.y();
      q.z = std::sin(pose.theta() / 2), q.w = std::cos(pose.theta() / 2);
    }
    publisher_->publish(path_);
  }

  Graph graph_;
  Smoother smoother_;
  std::vector<VertexHandle<SE2>> poses_;
  SE2 odometry_pose_;
  Path path_;
  rclcpp::Publisher<Path>::SharedPtr publisher_;
  rclcpp::SubscriptionBase::SharedPtr odometry_, positions_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<PoseGraph>());
  rclcpp::shutdown();
}
