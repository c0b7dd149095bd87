#pragma once
// SPDX-License-Identifier: MIT
// Shape: the robot's hardware as its driver shows it: servos, a gait engine that turns leg movement into way, a sense
// of balance, a camera's last picture. Units: geometry.hpp; a tick is 10 ms. Errors: none; a servo stops at its limits.

#include "behaviours/soccer/messages.hpp"
#include "behaviours/soccer/world/random.hpp"

#include <array>

namespace sim {

inline constexpr Milliseconds tick = 10;

enum class Servo : std::uint8_t {
  left_hip_yaw,
  left_knee,
  left_ankle,
  right_hip_yaw,
  right_knee,
  right_ankle,
  left_arm,
  right_arm,
  neck,
};
inline constexpr std::size_t servos = 9, leg_servos = 6;

enum class Posture : std::uint8_t { upright, falling, lying, kneeling };

struct Pose {
  Point place;
  Angle heading = 0;
};

/// What the camera made of its last picture; `ball` keeps what was seen last.
struct Picture {
  Milliseconds at = 0;
  bool seen = false;
  Point ball; ///< on the field
};

class Robot {
public:
  // What the behaviour may do.
  Milliseconds move(Servo servo, Angle to); ///< returns how long it will take
  void engage() { gait_ = true; }           ///< from now on leg movement is way
  void release();                           ///< and now it is not; whoever walked fast keeps swaying
  void stride(soccer::Stride stride) { stride_ = stride; }
  Pose pose() const { return {{static_cast<int>(x_ / 1000), static_cast<int>(y_ / 1000)}, heading_}; }
  const Picture& picture() const { return picture_; }
  Posture posture() const { return posture_; }
  bool still() const { return sway_ < still_sway; } ///< it stands, and nothing of it swings
  Angle angle(Servo servo) const { return angle_[static_cast<std::size_t>(servo)]; }

  // What the world does to it.
  Robot(Point place, Random& random);
  void step();
  void see(const Picture& picture) { picture_ = picture; }
  void fall();
  bool swings(soccer::Side leg) const; ///< in this tick that leg swings through, as for a kick

private:
  static constexpr int still_sway = 3'000, brisk_sway = 20'000;

  Angle servo_speed() const;
  void walk(int moved);
  void balance();

  Random& random_;
  std::array<Angle, servos> angle_{}, target_{}, before_{};
  soccer::Stride stride_{};
  Picture picture_{};
  std::int64_t x_, y_; ///< micrometres
  Angle heading_ = 0;
  int sway_ = 0;
  int until_stumble_; ///< ticks of walking
  int fallen_for_ = 0;
  Posture posture_ = Posture::upright;
  bool gait_ = false;
};

} // namespace sim
