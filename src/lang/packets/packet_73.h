#pragma once
#include "lang/packets/packet_72.h"

namespace evc::lang {

/// Packet 73, Plain text message (7.4.2.23), system version 3.0.
struct Packet73 {
  static constexpr PacketInfo info{
      73, "Plain text message", Direction::to_train, v3_0, media::balise | media::RBC, "7.4.2.23", "72 before 2.2"};
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
  InplaceVector<Packet72_text, 255> text;
  friend constexpr bool operator==(const Packet73&, const Packet73&) = default;
};

template <>
inline constexpr auto layout_of<Packet73> =
    layout(&Packet73::Q_DIR, &Packet73::Q_SCALE, &Packet73::Q_TEXTCLASS, &Packet73::Q_TEXTDISPLAY,
           &Packet73::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet73::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet73::M_LEVELTEXTDISPLAY_START),
           when(&Packet73::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet73::NID_NTC_START)),
           &Packet73::L_TEXTDISPLAY, &Packet73::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet73::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet73::M_LEVELTEXTDISPLAY_END),
           when(&Packet73::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet73::NID_NTC_END)),
           &Packet73::Q_TEXTCONFIRM,
           when(&Packet73::Q_TEXTCONFIRM, is_not(0), &Packet73::Q_CONFTEXTDISPLAY, &Packet73::Q_TEXTREPORT,
                when(&Packet73::Q_TEXTREPORT, is(1), &Packet73::NID_TEXTMESSAGE, &Packet73::NID_C, &Packet73::NID_RBC)),
           repeat<var::L_TEXT>("text", &Packet73::text));

/// Packet 73, Plain text message (7.4.2.23), system version 2.3.
struct Packet73_v2_3 {
  static constexpr PacketInfo info{
      73, "Plain text message", Direction::to_train, v2_3, media::balise | media::RBC, "7.4.2.23", "72 before 2.2"};
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
  InplaceVector<Packet72_text, 255> text;
  friend constexpr bool operator==(const Packet73_v2_3&, const Packet73_v2_3&) = default;
};

template <>
inline constexpr auto layout_of<Packet73_v2_3> = layout(
    &Packet73_v2_3::Q_DIR, &Packet73_v2_3::Q_SCALE, &Packet73_v2_3::Q_TEXTCLASS, &Packet73_v2_3::Q_TEXTDISPLAY,
    &Packet73_v2_3::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet73_v2_3::M_MODETEXTDISPLAY_START),
    named("M_LEVELTEXTDISPLAY_START", &Packet73_v2_3::M_LEVELTEXTDISPLAY_START),
    when(&Packet73_v2_3::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet73_v2_3::NID_NTC_START)),
    &Packet73_v2_3::L_TEXTDISPLAY, &Packet73_v2_3::T_TEXTDISPLAY,
    named("M_MODETEXTDISPLAY_END", &Packet73_v2_3::M_MODETEXTDISPLAY_END),
    named("M_LEVELTEXTDISPLAY_END", &Packet73_v2_3::M_LEVELTEXTDISPLAY_END),
    when(&Packet73_v2_3::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet73_v2_3::NID_NTC_END)),
    &Packet73_v2_3::Q_TEXTCONFIRM,
    when(&Packet73_v2_3::Q_TEXTCONFIRM, is_not(0), &Packet73_v2_3::Q_CONFTEXTDISPLAY, &Packet73_v2_3::Q_TEXTREPORT,
         when(&Packet73_v2_3::Q_TEXTREPORT, is(1), &Packet73_v2_3::NID_TEXTMESSAGE, &Packet73_v2_3::NID_C,
              &Packet73_v2_3::NID_RBC)),
    repeat<var::L_TEXT>("text", &Packet73_v2_3::text));

/// Packet 73, Plain text message (7.4.2.23 with 6.5.2.3.6.2), system version 2.2.
struct Packet73_v2_2 {
  static constexpr PacketInfo info{73,
                                   "Plain text message",
                                   Direction::to_train,
                                   v2_2,
                                   media::balise | media::RBC,
                                   "7.4.2.23 with 6.5.2.3.6.2",
                                   "72 before 2.2"};
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
  InplaceVector<Packet72_text, 255> text;
  friend constexpr bool operator==(const Packet73_v2_2&, const Packet73_v2_2&) = default;
};

template <>
inline constexpr auto layout_of<Packet73_v2_2> = layout(
    &Packet73_v2_2::Q_DIR, &Packet73_v2_2::Q_SCALE, &Packet73_v2_2::Q_TEXTCLASS, &Packet73_v2_2::Q_TEXTDISPLAY,
    &Packet73_v2_2::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet73_v2_2::M_MODETEXTDISPLAY_START),
    named("M_LEVELTEXTDISPLAY_START", &Packet73_v2_2::M_LEVELTEXTDISPLAY_START),
    when(&Packet73_v2_2::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet73_v2_2::NID_NTC_START)),
    &Packet73_v2_2::L_TEXTDISPLAY, &Packet73_v2_2::T_TEXTDISPLAY,
    named("M_MODETEXTDISPLAY_END", &Packet73_v2_2::M_MODETEXTDISPLAY_END),
    named("M_LEVELTEXTDISPLAY_END", &Packet73_v2_2::M_LEVELTEXTDISPLAY_END),
    when(&Packet73_v2_2::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet73_v2_2::NID_NTC_END)),
    &Packet73_v2_2::Q_TEXTCONFIRM,
    when(&Packet73_v2_2::Q_TEXTCONFIRM, is_not(0), &Packet73_v2_2::Q_CONFTEXTDISPLAY, &Packet73_v2_2::Q_TEXTREPORT,
         when(&Packet73_v2_2::Q_TEXTREPORT, is(1), &Packet73_v2_2::NID_TEXTMESSAGE, &Packet73_v2_2::NID_C,
              &Packet73_v2_2::NID_RBC)),
    repeat<var::L_TEXT>("text", &Packet73_v2_2::text));

}  // namespace evc::lang
