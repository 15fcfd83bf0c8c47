// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_DATA_QUEUE_H
#define G2O_DATA_QUEUE_H

#include <map>

#include "g2o/types/data/g2o_types_data_api.h"

namespace g2o {

class RobotData;

/// Data in the order of its timestamps. It does not own the data. All searches take logarithmic time, and
/// return nullptr if there is no such data.
class G2O_TYPES_DATA_API DataQueue {
 public:
  using Buffer = std::map<double, RobotData*>;

  DataQueue();
  ~DataQueue();

  /// Adds data. Replaces data with the same timestamp. If the pointer is nullptr or the timestamp is not a
  /// number, reports an error and adds nothing.
  void add(RobotData* rd);

  /// The data whose timestamp is nearest; of two equally near ones, the earlier one.
  RobotData* findClosestData(double timestamp) const;
  /// The latest data with at most this timestamp; nullptr for the first timestamp, as in g2o.
  RobotData* before(double timestamp) const;
  /// The earliest data with a larger timestamp.
  RobotData* after(double timestamp) const;
  RobotData* lastElement() const;

  const Buffer& buffer() const { return _buffer; }

 protected:
  Buffer _buffer;
};

}  // namespace g2o

#endif  // G2O_DATA_QUEUE_H
