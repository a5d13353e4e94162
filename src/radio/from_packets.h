#pragma once
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_57.h"
#include "lang/si.h"
#include "radio/radio.h"

// Packets 42, 57 and 131 in the types of this room.
namespace evc::radio {

inline MaRequestParameters ma_request_of(const lang::Packet57& p) {
  return {lang::seconds(p.T_MAR), lang::seconds(p.T_TIMEOUTRQST), lang::seconds(p.T_CYCRQST)};
}
inline SessionOrder session_order_of(const lang::Packet42& p) {
  return {p.Q_RBC.raw == 1,
          {p.NID_C.raw, p.NID_RBC.raw, p.NID_RADIO.raw},
          p.Q_SLEEPSESSION.raw == 1,
          Cause::trackside_order};
}
/// The order to establish a session with the accepting RBC, as contained in an RBC transition order (3.15.1).
inline SessionOrder session_order_of(const lang::Packet131& p) {
  return {true, {p.NID_C.raw, p.NID_RBC.raw, p.NID_RADIO.raw}, p.Q_SLEEPSESSION.raw == 1, Cause::trackside_order};
}

}  // namespace evc::radio
