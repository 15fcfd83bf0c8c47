// SPDX-License-Identifier: BSD-3-Clause
// Memory for many arrays of numbers that come and go, such as the fronts of a factor that changes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <vector>

namespace boxplus {

/// Gives out arrays of doubles. An array that is given back is reused for the next array of its class: sizes
/// whose rooms are equal. There are four rooms between a power of two and the next, so that at most a fifth
/// of an array is unused. Arrays are not initialized.
class SizedMemory {
 public:
  double* take(std::size_t size) {
    std::vector<double*>& free = free_[class_of(size)];
    if (!free.empty()) {
      double* const array = free.back();
      free.pop_back();
      return array;
    }
    const std::size_t room = room_of(size);
    if (room > kSlab / 8) {
      slabs_.push_back(std::make_unique_for_overwrite<double[]>(room));
      return slabs_.back().get();
    }
    if (left_ < room) {
      slabs_.push_back(std::make_unique_for_overwrite<double[]>(kSlab));
      next_ = slabs_.back().get();
      left_ = kSlab;
    }
    double* const array = next_;
    next_ += room;
    left_ -= room;
    return array;
  }
  /// `size` must be the size with which the array was taken, or one of the same class.
  void give_back(double* array, std::size_t size) { free_[class_of(size)].push_back(array); }

  /// The room of arrays of this size: the smallest of 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, … that suffices.
  static std::size_t room_of(std::size_t size) {
    if (size <= kSmallest) return kSmallest;
    const std::size_t step = std::bit_floor(size - 1) / 4;
    return (size + step - 1) / step * step;
  }
  static std::size_t class_of(std::size_t size) {
    const std::size_t room = room_of(size);
    const auto power = static_cast<std::size_t>(std::bit_width(room)) - 1;
    return (power - 3) * 4 + (room - (std::size_t{1} << power)) / ((std::size_t{1} << power) / 4);
  }

 private:
  static constexpr std::size_t kSmallest = 8, kSlab = std::size_t{1} << 17;

  std::array<std::vector<double*>, 240> free_;
  std::vector<std::unique_ptr<double[]>> slabs_;
  double* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace boxplus
