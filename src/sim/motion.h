#pragma once
#include <vector>

#include "sim/dynamics.h"
#include "sim/line.h"

namespace evc::sim {

/// The height of the track under the wheels: the gradient along a train is a difference of two heights.
class Heights {
 public:
  explicit Heights(const std::vector<GradientSegment>& gradient);
  /// Metres above the height at the first segment's start.
  double at(double position_m) const;

 private:
  struct Point {
    double position, height, permille;  // the slope from here on
  };
  std::vector<Point> points_;
};

/// Control of the train: the driver's handle and the commands of the on-board.
struct Handle {
  double traction = 0.0;  // 0..1 of the tractive effort
  double brake = 0.0;     // 0..1 of the service brake
  bool cut_off = false, service = false, emergency = false;
  double sense = 1.0;  // of the traction: 1 forwards, -1 backwards
};

/// A train on a track: its mass, resistance, traction, brakes with build-up, and gradient along its
/// length (no coupler forces).
class Motion {
 public:
  Motion(const Dynamics& dynamics, double length_m, double rotating_pct, const Heights& heights, double front_m,
         double adhesion_mps2);

  /// Moves for `step_s`; the distance run is front() after minus front() before.
  void move(const Handle& handle, double step_s);

  double front() const { return front_; }
  double speed() const { return v_; }
  double acceleration() const { return a_; }
  /// Work of the traction at the wheels so far, in joules; the brakes give nothing back.
  double traction_energy() const { return traction_energy_; }
  /// The acceleration with neither traction nor brake (resistance and gradient).
  double coasting() const;
  /// The acceleration that full traction adds, and the deceleration of the full service brake.
  double full_traction() const;
  double full_service_brake() const;
  /// The time of the brakes from no effort to full effort.
  double brake_build_up_s() const { return dynamics_.build_up_s; }

 private:
  Dynamics dynamics_;
  double length_, mass_kg_, inertia_kg_;
  const Heights& heights_;
  double front_, v_ = 0.0, a_ = 0.0;
  double service_level_ = 1.0,
         emergency_level_ = 0.0;  // 0..1; at the start the train is at standstill with brakes applied
  double traction_level_ = 0.0;   // 0..1
  double traction_energy_ = 0.0;  // J
  double adhesion_;
};

}  // namespace evc::sim
