// SPDX-License-Identifier: BSD-3-Clause
#include "testing/town_route.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boxplus {
namespace {

constexpr double kQuarterCircle = kPi / 2 * Town::kHalfStreet;
constexpr double kTurnTime = 2 * kQuarterCircle;

Vector2 unit(int direction) {
  constexpr std::array kX{1, 0, -1, 0}, kY{0, 1, 0, -1};
  const auto d = static_cast<std::size_t>(direction);
  return {static_cast<double>(kX[d]), static_cast<double>(kY[d])};
}

/// Decides at each crossing where to go.
class Driver {
 public:
  Driver(double length, bool returns) : returns_(returns) {
    constexpr double kPasses = 3;
    const double streets = length / Town::kBlock / kPasses;  // 2 n (n + 1) streets have n × n blocks
    blocks_ = std::max(1, static_cast<int>(std::lround(std::sqrt(streets / 2))));
  }

  int direction() const { return direction_; }

  /// Drives to the next crossing. Returns the turn there: 1 is left, 0 is straight on, −1 is right.
  int turn(RandomNumbers& random) {
    x_ += static_cast<int>(unit(direction_)[0]);
    y_ += static_cast<int>(unit(direction_)[1]);
    int turn = 0;
    do {
      const double choice = random.uniform();
      turn = choice < kStraight ? 0 : choice < (1 + kStraight) / 2 ? 1 : -1;
    } while (!is_allowed((direction_ + turn + 4) % 4));
    direction_ = (direction_ + turn + 4) % 4;
    return turn;
  }

 private:
  static constexpr double kStraight = 0.4;

  bool is_allowed(int direction) const {
    if (!returns_) return direction < 2;
    const double x = x_ + unit(direction)[0], y = y_ + unit(direction)[1];
    return x >= 0 && x <= blocks_ && y >= 0 && y <= blocks_;
  }

  bool returns_;
  int blocks_, x_ = 0, y_ = 0, direction_ = 0;
};

}  // namespace

TownRoute::TownRoute(double length, bool returns, RandomNumbers& random) {
  Driver driver(length, returns);
  while (time_ < length) {
    const int direction = driver.direction(), turn = driver.turn(random);
    drive(Town::kBlock - 2 * Town::kHalfStreet, direction, 0);
    drive(2 * Town::kHalfStreet, direction, turn);
  }
}

void TownRoute::drive(double length, int direction, int turn) {
  pieces_.push_back({time_, end_, direction, turn});
  if (turn == 0) {
    end_ += length * unit(direction);
    time_ += length;
  } else {
    end_ += Town::kHalfStreet * (unit(direction) + unit((direction + turn + 4) % 4));
    time_ += kTurnTime;
  }
}

TownRoute::Place TownRoute::at(double time) const {
  const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), time,
                                     [](double t, const Piece& piece) { return t < piece.begin_time; });
  const Piece& piece = *(next - 1);
  const double elapsed = time - piece.begin_time, heading = piece.direction * kPi / 2;
  const Vector2 ahead = unit(piece.direction);
  if (piece.turn == 0) return {piece.begin + elapsed * ahead, heading};
  const Vector2 side = unit((piece.direction + piece.turn + 4) % 4);
  const double angle = elapsed / kTurnTime * kPi / 2;
  return {piece.begin + Town::kHalfStreet * (std::sin(angle) * ahead + (1 - std::cos(angle)) * side),
          heading + piece.turn * angle};
}

}  // namespace boxplus
