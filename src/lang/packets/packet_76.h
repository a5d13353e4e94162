#pragma once
#include "lang/variables.h"

namespace evc::lang {

/// Packet 76, Fixed text message (7.4.2.24), system version 2.0, 2.1.
struct Packet76 {
  static constexpr PacketInfo info{
      76, "Fixed text message", Direction::to_train, v2_0 | v2_1, media::balise | media::RBC, "7.4.2.24", ""};
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
  var::Q_TEXT Q_TEXT;
  friend constexpr bool operator==(const Packet76&, const Packet76&) = default;
};

template <>
inline constexpr auto layout_of<Packet76> =
    layout(&Packet76::Q_DIR, &Packet76::Q_SCALE, &Packet76::Q_TEXTCLASS, &Packet76::Q_TEXTDISPLAY,
           &Packet76::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet76::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet76::M_LEVELTEXTDISPLAY_START),
           when(&Packet76::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet76::NID_NTC_START)),
           &Packet76::L_TEXTDISPLAY, &Packet76::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet76::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet76::M_LEVELTEXTDISPLAY_END),
           when(&Packet76::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet76::NID_NTC_END)),
           &Packet76::Q_TEXTCONFIRM,
           when(&Packet76::Q_TEXTCONFIRM, is_not(0), &Packet76::Q_CONFTEXTDISPLAY, &Packet76::Q_TEXTREPORT,
                when(&Packet76::Q_TEXTREPORT, is(1), &Packet76::NID_TEXTMESSAGE, &Packet76::NID_C, &Packet76::NID_RBC)),
           &Packet76::Q_TEXT);

/// Packet 76, Fixed text message (SRS 2.3.0 7.4.2.24), system version 1.0.
struct Packet76_v1_0 {
  static constexpr PacketInfo info{76,
                                   "Fixed text message",
                                   Direction::to_train,
                                   v1_0,
                                   media::balise | media::RBC,
                                   "SRS 2.3.0 7.4.2.24",
                                   "not in the X=1 list of SRS >= 3.3.0; B3 on-board rejects it from X=1"};
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
  var::Q_TEXT Q_TEXT;
  friend constexpr bool operator==(const Packet76_v1_0&, const Packet76_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet76_v1_0> =
    layout(&Packet76_v1_0::Q_DIR, &Packet76_v1_0::Q_SCALE, &Packet76_v1_0::Q_TEXTCLASS, &Packet76_v1_0::Q_TEXTDISPLAY,
           &Packet76_v1_0::D_TEXTDISPLAY, named("M_MODETEXTDISPLAY_START", &Packet76_v1_0::M_MODETEXTDISPLAY_START),
           named("M_LEVELTEXTDISPLAY_START", &Packet76_v1_0::M_LEVELTEXTDISPLAY_START),
           when(&Packet76_v1_0::M_LEVELTEXTDISPLAY_START, is(1), named("NID_NTC_START", &Packet76_v1_0::NID_NTC_START)),
           &Packet76_v1_0::L_TEXTDISPLAY, &Packet76_v1_0::T_TEXTDISPLAY,
           named("M_MODETEXTDISPLAY_END", &Packet76_v1_0::M_MODETEXTDISPLAY_END),
           named("M_LEVELTEXTDISPLAY_END", &Packet76_v1_0::M_LEVELTEXTDISPLAY_END),
           when(&Packet76_v1_0::M_LEVELTEXTDISPLAY_END, is(1), named("NID_NTC_END", &Packet76_v1_0::NID_NTC_END)),
           named("Q_TEXTCONFIRM", &Packet76_v1_0::Q_TEXTCONFIRM), &Packet76_v1_0::Q_TEXT);

}  // namespace evc::lang
