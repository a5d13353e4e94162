#pragma once
#include <type_traits>

#include "openevc/base/units.h"

namespace evc::train {

/// The fixed values of A.3.1 that speed and distance monitoring uses, in SI units, and the numbers
/// that 3.13 states in its text. They can be overridden one by one for studies.
struct FixedValues {
  // Ceiling limits (3.13.9.2).
  Speed dV_ebi_min{7.5 / 3.6}, dV_ebi_max{15.0 / 3.6}, V_ebi_min{110.0 / 3.6}, V_ebi_max{210.0 / 3.6};
  Speed dV_sbi_min{5.5 / 3.6}, dV_sbi_max{10.0 / 3.6}, V_sbi_min{110.0 / 3.6}, V_sbi_max{210.0 / 3.6};
  Speed dV_warning_min{4.0 / 3.6}, dV_warning_max{5.0 / 3.6}, V_warning_min{110.0 / 3.6}, V_warning_max{140.0 / 3.6};
  // Times.
  Duration T_warning{2.0};
  Duration T_driver{4.0};
  Duration T_preindication{7.0};  // 3.4.0 only
  Duration T_dispTTI{14.0};       // 3.6.0 on
  // Rotating mass, % of the train's weight.
  double M_rotating_max = 15.0;
  double M_rotating_min = 2.0;
  // Numbers given in the text of 3.13.
  Acceleration g{9.81};
  Acceleration A_est2_max{0.4};       // 3.13.9.3.2.9
  Duration T_bs2_min{2.0};            // 3.13.9.3.3.4.1, A.3.10
  Duration T_indication_min{5.0};     // 3.13.9.3.6.2
  double T_indication_factor = 0.8;   // 3.13.9.3.6.2
  Distance d_trip_constant{10.0};     // 3.13.9.4.8.2: twice SUBSET-041's 5 m
  double d_trip_relative = 0.1;       // 3.13.9.4.8.2: twice SUBSET-041's 5 %
  Speed PBD_rounding{5.0 / 3.6};      // 3.11.11
  Speed search_tolerance{1.0 / 3.6};  // 3.13.9.4.8, 3.11.11
  // SUBSET-041 of the set of 4.0.0: two clauses, two parameters (5.2.1.1 and 5.2.1.13).
  Duration T41_balise{1.0};
  Duration T41_eoa{1.0};

  friend constexpr bool operator==(const FixedValues&, const FixedValues&) = default;
};
static_assert(std::is_trivially_copyable_v<FixedValues>);

}  // namespace evc::train
