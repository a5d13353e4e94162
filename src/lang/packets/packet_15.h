#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet15_sections {
  var::L_SECTION L_SECTION;
  var::Q_SECTIONTIMER Q_SECTIONTIMER;
  var::T_SECTIONTIMER T_SECTIONTIMER;                ///< only if Q_SECTIONTIMER == 1
  var::D_SECTIONTIMERSTOPLOC D_SECTIONTIMERSTOPLOC;  ///< only if Q_SECTIONTIMER == 1
  friend constexpr bool operator==(const Packet15_sections&, const Packet15_sections&) = default;
};

/// Packet 15, Level 2/3 movement authority (7.4.2.4), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet15 {
  static constexpr PacketInfo info{15,
                                   "Level 2/3 movement authority",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::RBC,
                                   "7.4.2.4",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::V_EMA V_EMA;
  var::T_EMA T_EMA;
  InplaceVector<Packet15_sections, 31> sections;
  var::L_ENDSECTION L_ENDSECTION;
  var::Q_SECTIONTIMER Q_SECTIONTIMER;
  var::T_SECTIONTIMER T_SECTIONTIMER;                ///< only if Q_SECTIONTIMER == 1
  var::D_SECTIONTIMERSTOPLOC D_SECTIONTIMERSTOPLOC;  ///< only if Q_SECTIONTIMER == 1
  var::Q_ENDTIMER Q_ENDTIMER;
  var::T_ENDTIMER T_ENDTIMER;                  ///< only if Q_ENDTIMER == 1
  var::D_ENDTIMERSTARTLOC D_ENDTIMERSTARTLOC;  ///< only if Q_ENDTIMER == 1
  var::Q_DANGERPOINT Q_DANGERPOINT;
  var::D_DP D_DP;                ///< only if Q_DANGERPOINT == 1
  var::V_RELEASEDP V_RELEASEDP;  ///< only if Q_DANGERPOINT == 1
  var::Q_OVERLAP Q_OVERLAP;
  var::D_STARTOL D_STARTOL;      ///< only if Q_OVERLAP == 1
  var::T_OL T_OL;                ///< only if Q_OVERLAP == 1
  var::D_OL D_OL;                ///< only if Q_OVERLAP == 1
  var::V_RELEASEOL V_RELEASEOL;  ///< only if Q_OVERLAP == 1
  friend constexpr bool operator==(const Packet15&, const Packet15&) = default;
};

template <>
inline constexpr auto layout_of<Packet15_sections> = layout(&Packet15_sections::L_SECTION,
                                                            &Packet15_sections::Q_SECTIONTIMER,
                                                            when(&Packet15_sections::Q_SECTIONTIMER, is(1),
                                                                 &Packet15_sections::T_SECTIONTIMER,
                                                                 &Packet15_sections::D_SECTIONTIMERSTOPLOC));

template <>
inline constexpr auto layout_of<Packet15> = layout(
    &Packet15::Q_DIR, &Packet15::Q_SCALE, &Packet15::V_EMA, &Packet15::T_EMA,
    repeat<var::N_ITER>("sections", &Packet15::sections), &Packet15::L_ENDSECTION, &Packet15::Q_SECTIONTIMER,
    when(&Packet15::Q_SECTIONTIMER, is(1), &Packet15::T_SECTIONTIMER, &Packet15::D_SECTIONTIMERSTOPLOC),
    &Packet15::Q_ENDTIMER, when(&Packet15::Q_ENDTIMER, is(1), &Packet15::T_ENDTIMER, &Packet15::D_ENDTIMERSTARTLOC),
    &Packet15::Q_DANGERPOINT, when(&Packet15::Q_DANGERPOINT, is(1), &Packet15::D_DP, &Packet15::V_RELEASEDP),
    &Packet15::Q_OVERLAP,
    when(&Packet15::Q_OVERLAP, is(1), &Packet15::D_STARTOL, &Packet15::T_OL, &Packet15::D_OL, &Packet15::V_RELEASEOL));

}  // namespace evc::lang
