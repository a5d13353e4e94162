#pragma once
#include <cstdint>
#include <optional>
#include <type_traits>

#include "openevc/base/step_function.h"
#include "openevc/base/units.h"
#include "openevc/terms/reaction.h"

namespace evc::train {

/// A_NVMAXREDADH1..3: the maximum deceleration under reduced adhesion (3.13.6.2.1.8). The codes 61, 62, 63 mean no
/// maximum and differ in what is displayed in ceiling speed monitoring.
struct MaxReducedAdhesion {
  enum class Display : std::uint8_t { none, target_information, time_to_indication };
  Acceleration A{};
  bool no_maximum = false;
  Display display = Display::none;

  static constexpr MaxReducedAdhesion at_most(Acceleration a) { return {a, false, Display::none}; }
  static constexpr MaxReducedAdhesion without_maximum(Display shown) { return {{}, true, shown}; }
  friend constexpr bool operator==(const MaxReducedAdhesion&, const MaxReducedAdhesion&) = default;
};

/// One value of each of the two subsets of Kv_int for conventional passenger trains (A.3.7, 3.13.6.2.1.5).
struct KvPair {
  double a = 0.7;
  double b = 0.7;
  friend constexpr bool operator==(const KvPair&, const KvPair&) = default;
};

/// A step function with one step that begins at 0.
template <class Function, class Value>
constexpr Function single_step(Value value) {
  Function f;
  // A function with capacity accepts its first step always.
  if (!f.append({}, value)) __builtin_trap();
  return f;
}

/// D_NVROLL where it is infinite.
inline constexpr Distance kUnlimited{1e9};

/// The national values (3.18.2, packet 3) in SI units; a default-constructed one holds the default
/// values of A.3.2. `std::nullopt` is the standard's "infinity".
struct NationalValues {
  using KvFreight = StepFunction<Speed, double, 5>;
  using KvPassenger = StepFunction<Speed, KvPair, 5>;
  using Kr = StepFunction<Distance, double, 5>;

  // Speeds of modes and procedures.
  Speed V_NVSHUNT{30.0 / 3.6};
  Speed V_NVSTFF{40.0 / 3.6};
  Speed V_NVONSIGHT{30.0 / 3.6};
  Speed V_NVLIMSUPERV{100.0 / 3.6};
  Speed V_NVUNFIT{100.0 / 3.6};
  Speed V_NVREL{40.0 / 3.6};
  Speed V_NVALLOWOVTRP{0.0};
  Speed V_NVSUPOVTRP{30.0 / 3.6};
  // Distances and times.
  Distance D_NVROLL{2.0};
  Distance D_NVOVTRP{200.0};
  Distance D_NVPOTRP{200.0};
  std::optional<Distance> D_NVSTFF;  // infinity
  Duration T_NVOVTRP{60.0};
  std::optional<Duration> T_NVCONTACT;  // infinity
  Distance Q_NVLOCACC{12.0};
  // Reactions and permissions.
  Reaction M_NVCONTACT = Reaction::none;
  bool M_NVDERUN = true;          // driver identity may change while running
  bool Q_NVDRIVER_ADHES = false;  // the driver may modify the adhesion factor
  bool Q_NVSBTSMPERM = true;      // service brake in target speed monitoring
  bool Q_NVEMRRLS = false;        // true: emergency brake released when no longer needed, false: at standstill
  bool Q_NVGUIPERM = false;       // guidance curves
  bool Q_NVSBFBPERM = false;      // service brake feedback
  bool Q_NVINHSMICPERM = false;   // true: speed measurement inaccuracy is not compensated
  // Brake model.
  std::uint8_t M_NVEBCL = 9;  // confidence level: 0 is 50 %, n is 1 - 10^-n
  double M_NVAVADH = 0.0;     // weighting of the available wheel/rail adhesion, 0..1
  MaxReducedAdhesion A_NVMAXREDADH1 = MaxReducedAdhesion::at_most({1.0});
  MaxReducedAdhesion A_NVMAXREDADH2 = MaxReducedAdhesion::at_most({0.7});
  MaxReducedAdhesion A_NVMAXREDADH3 = MaxReducedAdhesion::at_most({0.7});
  // Correction factors of the conversion model; steps include their upper limit (see speed_steps.h).
  KvFreight Kv_int_freight = single_step<KvFreight>(0.7);
  KvPassenger Kv_int_passenger = single_step<KvPassenger>(KvPair{});
  Acceleration A_NVP12{0.0};
  Acceleration A_NVP23{0.0};
  Kr Kr_int = single_step<Kr>(0.9);  // by train length
  double Kt_int = 1.1;

  friend constexpr bool operator==(const NationalValues&, const NationalValues&) = default;
};
static_assert(std::is_trivially_copyable_v<NationalValues>);
static_assert(sizeof(NationalValues) <= 1024);

}  // namespace evc::train
