// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_ROBOT_DATA_H
#define G2O_ROBOT_DATA_H

#include <string>

#include "g2o/core/hyper_graph.h"
#include "g2o/types/data/g2o_types_data_api.h"

namespace g2o {

/// The base class of data that a robot records. Times are in seconds.
class G2O_TYPES_DATA_API RobotData : public HyperGraph::Data {
 public:
  RobotData();
  ~RobotData() override;

  /// The time of the measurement.
  double timestamp() const { return _timestamp; }
  void setTimestamp(double ts) { _timestamp = ts; }

  /// The time of the record.
  double loggerTimestamp() const { return _loggerTimestamp; }
  void setLoggerTimestamp(double ts) { _loggerTimestamp = ts; }

  const std::string& tag() const { return _tag; }
  void setTag(const std::string& tag) { _tag = tag; }

  /// The computer that measured; one word in files.
  const std::string& hostname() const { return _hostname; }
  void setHostname(const std::string& hostname) { _hostname = hostname; }

 protected:
  double _timestamp = 0;
  double _loggerTimestamp = 0;
  std::string _tag;
  std::string _hostname = "hostname";
};

}  // namespace g2o

#endif  // G2O_ROBOT_DATA_H
