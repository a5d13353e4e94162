#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 74, Fixed text message (7.4.2.24), system version 3.0.
struct Packet74 {
  static constexpr PacketInfo info{
      74, "Fixed text message", Direction::to_train, v3_0, media::balise | media::RBC, "7.4.2.24", "76 before 2.2"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TEXTCLASS Q_TEXTCLASS;
  var::Q_TEXTDISPLAY Q_TEXTDISPLAY;
  var::D_TEXTDISPLAY D_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_3 M_MODETEXTDISPLAY_START;
  var::M_LEVELTEXTDISPLAY_V3 M_LEVELTEXTDISPLAY_START;
  var::NID_NTC NID_NTC_START;  ///< only if M_LEVELTEXTDISPLAY_START == 1
  var::L_TEXTDISPLAY L_TEXTDISPLAY;
  var::T_TEXTDISPLAY T_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_3 M_MODETEXTDISPLAY_END;
  var::M_LEVELTEXTDISPLAY_V3 M_LEVELTEXTDISPLAY_END;
  var::NID_NTC NID_NTC_END;  ///< only if M_LEVELTEXTDISPLAY_END == 1
  var::Q_TEXTCONFIRM Q_TEXTCONFIRM;
  var::Q_CONFTEXTDISPLAY Q_CONFTEXTDISPLAY;  ///< only if Q_TEXTCONFIRM != 0
  var::Q_TEXTREPORT Q_TEXTREPORT;            ///< only if Q_TEXTCONFIRM != 0
  var::NID_TEXTMESSAGE NID_TEXTMESSAGE;      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_C NID_C;                          ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_RBC NID_RBC;                      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::Q_TEXT Q_TEXT;
  friend constexpr bool operator==(const Packet74&, const Packet74&) = default;
};

template <>
inline constexpr auto layout_of<Packet74> =
    layout(&Packet74::Q_DIR, &Packet74::Q_SCALE, &Packet74::Q_TEXTCLASS, &Packet74::Q_TEXTDISPLAY,
           &Packet74::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet74::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet74::M_LEVELTEXTDISPLAY_START),
           when(&Packet74::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet74::NID_NTC_START)),
           &Packet74::L_TEXTDISPLAY, &Packet74::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet74::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet74::M_LEVELTEXTDISPLAY_END),
           when(&Packet74::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet74::NID_NTC_END)),
           &Packet74::Q_TEXTCONFIRM,
           when(&Packet74::Q_TEXTCONFIRM, is_not(0), &Packet74::Q_CONFTEXTDISPLAY, &Packet74::Q_TEXTREPORT,
                when(&Packet74::Q_TEXTREPORT, is(1), &Packet74::NID_TEXTMESSAGE, &Packet74::NID_C, &Packet74::NID_RBC)),
           &Packet74::Q_TEXT);

/// Packet 74, Fixed text message (7.4.2.24), system version 2.3.
struct Packet74_v2_3 {
  static constexpr PacketInfo info{
      74, "Fixed text message", Direction::to_train, v2_3, media::balise | media::RBC, "7.4.2.24", "76 before 2.2"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TEXTCLASS Q_TEXTCLASS;
  var::Q_TEXTDISPLAY Q_TEXTDISPLAY;
  var::D_TEXTDISPLAY D_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_3 M_MODETEXTDISPLAY_START;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_START;
  var::NID_NTC NID_NTC_START;  ///< only if M_LEVELTEXTDISPLAY_START == 1
  var::L_TEXTDISPLAY L_TEXTDISPLAY;
  var::T_TEXTDISPLAY T_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_3 M_MODETEXTDISPLAY_END;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_END;
  var::NID_NTC NID_NTC_END;  ///< only if M_LEVELTEXTDISPLAY_END == 1
  var::Q_TEXTCONFIRM Q_TEXTCONFIRM;
  var::Q_CONFTEXTDISPLAY Q_CONFTEXTDISPLAY;  ///< only if Q_TEXTCONFIRM != 0
  var::Q_TEXTREPORT Q_TEXTREPORT;            ///< only if Q_TEXTCONFIRM != 0
  var::NID_TEXTMESSAGE NID_TEXTMESSAGE;      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_C NID_C;                          ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_RBC NID_RBC;                      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::Q_TEXT Q_TEXT;
  friend constexpr bool operator==(const Packet74_v2_3&, const Packet74_v2_3&) = default;
};

template <>
inline constexpr auto layout_of<Packet74_v2_3> = layout(
    &Packet74_v2_3::Q_DIR, &Packet74_v2_3::Q_SCALE, &Packet74_v2_3::Q_TEXTCLASS, &Packet74_v2_3::Q_TEXTDISPLAY,
    &Packet74_v2_3::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet74_v2_3::M_MODETEXTDISPLAY_START),
    named("M_LEVELTEXTDISPLAY_START", &Packet74_v2_3::M_LEVELTEXTDISPLAY_START),
    when(&Packet74_v2_3::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet74_v2_3::NID_NTC_START)),
    &Packet74_v2_3::L_TEXTDISPLAY, &Packet74_v2_3::T_TEXTDISPLAY,
    named("M_MODETEXTDISPLAY_END", &Packet74_v2_3::M_MODETEXTDISPLAY_END),
    named("M_LEVELTEXTDISPLAY_END", &Packet74_v2_3::M_LEVELTEXTDISPLAY_END),
    when(&Packet74_v2_3::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet74_v2_3::NID_NTC_END)),
    &Packet74_v2_3::Q_TEXTCONFIRM,
    when(&Packet74_v2_3::Q_TEXTCONFIRM, is_not(0), &Packet74_v2_3::Q_CONFTEXTDISPLAY, &Packet74_v2_3::Q_TEXTREPORT,
         when(&Packet74_v2_3::Q_TEXTREPORT, is(1), &Packet74_v2_3::NID_TEXTMESSAGE, &Packet74_v2_3::NID_C,
              &Packet74_v2_3::NID_RBC)),
    &Packet74_v2_3::Q_TEXT);

/// Packet 74, Fixed text message (7.4.2.24 with 6.5.2.3.6.2), system version 2.2.
struct Packet74_v2_2 {
  static constexpr PacketInfo info{74,
                                   "Fixed text message",
                                   Direction::to_train,
                                   v2_2,
                                   media::balise | media::RBC,
                                   "7.4.2.24 with 6.5.2.3.6.2",
                                   "76 before 2.2"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TEXTCLASS Q_TEXTCLASS;
  var::Q_TEXTDISPLAY Q_TEXTDISPLAY;
  var::D_TEXTDISPLAY D_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_2 M_MODETEXTDISPLAY_START;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_START;
  var::NID_NTC NID_NTC_START;  ///< only if M_LEVELTEXTDISPLAY_START == 1
  var::L_TEXTDISPLAY L_TEXTDISPLAY;
  var::T_TEXTDISPLAY T_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V2_2 M_MODETEXTDISPLAY_END;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_END;
  var::NID_NTC NID_NTC_END;  ///< only if M_LEVELTEXTDISPLAY_END == 1
  var::Q_TEXTCONFIRM Q_TEXTCONFIRM;
  var::Q_CONFTEXTDISPLAY Q_CONFTEXTDISPLAY;  ///< only if Q_TEXTCONFIRM != 0
  var::Q_TEXTREPORT Q_TEXTREPORT;            ///< only if Q_TEXTCONFIRM != 0
  var::NID_TEXTMESSAGE NID_TEXTMESSAGE;      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_C NID_C;                          ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_RBC NID_RBC;                      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::Q_TEXT Q_TEXT;
  friend constexpr bool operator==(const Packet74_v2_2&, const Packet74_v2_2&) = default;
};

template <>
inline constexpr auto layout_of<Packet74_v2_2> = layout(
    &Packet74_v2_2::Q_DIR, &Packet74_v2_2::Q_SCALE, &Packet74_v2_2::Q_TEXTCLASS, &Packet74_v2_2::Q_TEXTDISPLAY,
    &Packet74_v2_2::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet74_v2_2::M_MODETEXTDISPLAY_START),
    named("M_LEVELTEXTDISPLAY_START", &Packet74_v2_2::M_LEVELTEXTDISPLAY_START),
    when(&Packet74_v2_2::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet74_v2_2::NID_NTC_START)),
    &Packet74_v2_2::L_TEXTDISPLAY, &Packet74_v2_2::T_TEXTDISPLAY,
    named("M_MODETEXTDISPLAY_END", &Packet74_v2_2::M_MODETEXTDISPLAY_END),
    named("M_LEVELTEXTDISPLAY_END", &Packet74_v2_2::M_LEVELTEXTDISPLAY_END),
    when(&Packet74_v2_2::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet74_v2_2::NID_NTC_END)),
    &Packet74_v2_2::Q_TEXTCONFIRM,
    when(&Packet74_v2_2::Q_TEXTCONFIRM, is_not(0), &Packet74_v2_2::Q_CONFTEXTDISPLAY, &Packet74_v2_2::Q_TEXTREPORT,
         when(&Packet74_v2_2::Q_TEXTREPORT, is(1), &Packet74_v2_2::NID_TEXTMESSAGE, &Packet74_v2_2::NID_C,
              &Packet74_v2_2::NID_RBC)),
    &Packet74_v2_2::Q_TEXT);

}  // namespace evc::lang
