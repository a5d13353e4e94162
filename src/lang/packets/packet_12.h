#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet12_sections {
  var::L_SECTION L_SECTION;
  var::Q_SECTIONTIMER Q_SECTIONTIMER;
  var::T_SECTIONTIMER T_SECTIONTIMER;                ///< only if Q_SECTIONTIMER == 1
  var::D_SECTIONTIMERSTOPLOC D_SECTIONTIMERSTOPLOC;  ///< only if Q_SECTIONTIMER == 1
  friend constexpr bool operator==(const Packet12_sections&, const Packet12_sections&) = default;
};

/// Packet 12, Level 1 movement authority (7.4.2.3), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet12 {
  static constexpr PacketInfo info{12,
                                   "Level 1 movement authority",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RIU,
                                   "7.4.2.3",
                                   "V_EMA/T_EMA were V_LOA/T_LOA up to SRS 3.3.0; bits unchanged"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::V_MAIN V_MAIN;
  var::V_EMA V_EMA;
  var::T_EMA T_EMA;
  InplaceVector<Packet12_sections, 31> sections;
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
  friend constexpr bool operator==(const Packet12&, const Packet12&) = default;
};

template <>
inline constexpr auto layout_of<Packet12_sections> = layout(&Packet12_sections::L_SECTION,
                                                            &Packet12_sections::Q_SECTIONTIMER,
                                                            when(&Packet12_sections::Q_SECTIONTIMER, is(1),
                                                                 &Packet12_sections::T_SECTIONTIMER,
                                                                 &Packet12_sections::D_SECTIONTIMERSTOPLOC));

template <>
inline constexpr auto layout_of<Packet12> = layout(
    &Packet12::Q_DIR, &Packet12::Q_SCALE, &Packet12::V_MAIN, &Packet12::V_EMA, &Packet12::T_EMA,
    repeat<var::N_ITER>("sections", &Packet12::sections), &Packet12::L_ENDSECTION, &Packet12::Q_SECTIONTIMER,
    when(&Packet12::Q_SECTIONTIMER, is(1), &Packet12::T_SECTIONTIMER, &Packet12::D_SECTIONTIMERSTOPLOC),
    &Packet12::Q_ENDTIMER, when(&Packet12::Q_ENDTIMER, is(1), &Packet12::T_ENDTIMER, &Packet12::D_ENDTIMERSTARTLOC),
    &Packet12::Q_DANGERPOINT, when(&Packet12::Q_DANGERPOINT, is(1), &Packet12::D_DP, &Packet12::V_RELEASEDP),
    &Packet12::Q_OVERLAP,
    when(&Packet12::Q_OVERLAP, is(1), &Packet12::D_STARTOL, &Packet12::T_OL, &Packet12::D_OL, &Packet12::V_RELEASEOL));

}  // namespace evc::lang
