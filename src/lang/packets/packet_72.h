#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet72_text {
  var::X_TEXT X_TEXT;
  friend constexpr bool operator==(const Packet72_text&, const Packet72_text&) = default;
};

/// Packet 72, Plain text message (7.4.2.23), system version 2.0, 2.1.
struct Packet72 {
  static constexpr PacketInfo info{72,
                                   "Plain text message",
                                   Direction::to_train,
                                   v2_0 | v2_1,
                                   media::balise | media::RBC,
                                   "7.4.2.23",
                                   "Q_TEXTREPORT and identities exist only inside Q_TEXTCONFIRM != 0"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TEXTCLASS Q_TEXTCLASS;
  var::Q_TEXTDISPLAY Q_TEXTDISPLAY;
  var::D_TEXTDISPLAY D_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY M_MODETEXTDISPLAY_START;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_START;
  var::NID_NTC NID_NTC_START;  ///< only if M_LEVELTEXTDISPLAY_START == 1
  var::L_TEXTDISPLAY L_TEXTDISPLAY;
  var::T_TEXTDISPLAY T_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY M_MODETEXTDISPLAY_END;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_END;
  var::NID_NTC NID_NTC_END;  ///< only if M_LEVELTEXTDISPLAY_END == 1
  var::Q_TEXTCONFIRM Q_TEXTCONFIRM;
  var::Q_CONFTEXTDISPLAY Q_CONFTEXTDISPLAY;  ///< only if Q_TEXTCONFIRM != 0
  var::Q_TEXTREPORT Q_TEXTREPORT;            ///< only if Q_TEXTCONFIRM != 0
  var::NID_TEXTMESSAGE NID_TEXTMESSAGE;      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_C NID_C;                          ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  var::NID_RBC NID_RBC;                      ///< only if Q_TEXTCONFIRM != 0 && Q_TEXTREPORT == 1
  InplaceVector<Packet72_text, 255> text;
  friend constexpr bool operator==(const Packet72&, const Packet72&) = default;
};

template <>
inline constexpr auto layout_of<Packet72_text> = layout(&Packet72_text::X_TEXT);

template <>
inline constexpr auto layout_of<Packet72> =
    layout(&Packet72::Q_DIR, &Packet72::Q_SCALE, &Packet72::Q_TEXTCLASS, &Packet72::Q_TEXTDISPLAY,
           &Packet72::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet72::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet72::M_LEVELTEXTDISPLAY_START),
           when(&Packet72::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet72::NID_NTC_START)),
           &Packet72::L_TEXTDISPLAY, &Packet72::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet72::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet72::M_LEVELTEXTDISPLAY_END),
           when(&Packet72::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet72::NID_NTC_END)),
           &Packet72::Q_TEXTCONFIRM,
           when(&Packet72::Q_TEXTCONFIRM, is_not(0), &Packet72::Q_CONFTEXTDISPLAY, &Packet72::Q_TEXTREPORT,
                when(&Packet72::Q_TEXTREPORT, is(1), &Packet72::NID_TEXTMESSAGE, &Packet72::NID_C, &Packet72::NID_RBC)),
           repeat<var::L_TEXT>("text", &Packet72::text));

/// Packet 72, Plain text message (6.5.1.5.15), system version 1.0, 1.1.
struct Packet72_v1_0 {
  static constexpr PacketInfo info{
      72, "Plain text message", Direction::to_train, v1_0 | v1_1, media::balise | media::RBC, "6.5.1.5.15", ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_TEXTCLASS Q_TEXTCLASS;
  var::Q_TEXTDISPLAY Q_TEXTDISPLAY;
  var::D_TEXTDISPLAY D_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V1 M_MODETEXTDISPLAY_START;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_START;
  var::NID_NTC NID_NTC_START;  ///< only if M_LEVELTEXTDISPLAY_START == 1
  var::L_TEXTDISPLAY L_TEXTDISPLAY;
  var::T_TEXTDISPLAY T_TEXTDISPLAY;
  var::M_MODETEXTDISPLAY_V1 M_MODETEXTDISPLAY_END;
  var::M_LEVELTEXTDISPLAY M_LEVELTEXTDISPLAY_END;
  var::NID_NTC NID_NTC_END;  ///< only if M_LEVELTEXTDISPLAY_END == 1
  var::Q_TEXTCONFIRM_V1 Q_TEXTCONFIRM;
  InplaceVector<Packet72_text, 255> text;
  friend constexpr bool operator==(const Packet72_v1_0&, const Packet72_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet72_v1_0> =
    layout(&Packet72_v1_0::Q_DIR, &Packet72_v1_0::Q_SCALE, &Packet72_v1_0::Q_TEXTCLASS, &Packet72_v1_0::Q_TEXTDISPLAY,
           &Packet72_v1_0::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet72_v1_0::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet72_v1_0::M_LEVELTEXTDISPLAY_START),
           when(&Packet72_v1_0::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet72_v1_0::NID_NTC_START)),
           &Packet72_v1_0::L_TEXTDISPLAY, &Packet72_v1_0::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet72_v1_0::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet72_v1_0::M_LEVELTEXTDISPLAY_END),
           when(&Packet72_v1_0::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet72_v1_0::NID_NTC_END)),
           named("Q_TEXTCONFIRM", &Packet72_v1_0::Q_TEXTCONFIRM), repeat<var::L_TEXT>("text", &Packet72_v1_0::text));

}  // namespace evc::lang
