// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/data/data_queue.h"

#include <cmath>
#include <iterator>

#include "g2o/stuff/logger.h"
#include "g2o/types/data/robot_data.h"

namespace g2o {

DataQueue::DataQueue() = default;
DataQueue::~DataQueue() = default;

void DataQueue::add(RobotData* rd) {
  if (rd == nullptr || std::isnan(rd->timestamp())) {
    G2O_ERROR("DataQueue: expected data with a timestamp, got {}", rd == nullptr ? "nullptr" : "NaN");
    return;
  }
  _buffer[rd->timestamp()] = rd;
}

RobotData* DataQueue::findClosestData(double timestamp) const {
  if (_buffer.empty() || std::isnan(timestamp)) return nullptr;
  const auto later = _buffer.upper_bound(timestamp);
  if (later == _buffer.begin()) return later->second;
  const auto earlier = std::prev(later);
  if (later == _buffer.end()) return earlier->second;
  return timestamp - earlier->first <= later->first - timestamp ? earlier->second : later->second;
}

RobotData* DataQueue::before(double timestamp) const {
  // As in g2o, nothing is before the first timestamp itself.
  if (_buffer.empty() || !(_buffer.begin()->first < timestamp)) return nullptr;
  return std::prev(_buffer.upper_bound(timestamp))->second;
}

RobotData* DataQueue::after(double timestamp) const {
  if (std::isnan(timestamp)) return nullptr;
  const auto later = _buffer.upper_bound(timestamp);
  return later == _buffer.end() ? nullptr : later->second;
}

RobotData* DataQueue::lastElement() const {
  return _buffer.empty() ? nullptr : std::prev(_buffer.end())->second;
}

}  // namespace g2o
