#pragma once
#include "lang/telegram.h"

// Reading of single packets and of the fixed part of messages. Templates are instantiated in
// packet_codec_*.cpp and message_codec.cpp for every struct of lang/packets.h and lang/messages.h.
namespace evc::lang {

/// Reads the packet into `packet`; members whose condition does not hold become 0. With the newest
/// layout of a packet (`Packet27`) a view of an older version is read with the layout of that version and translated
/// (SUBSET-026-6 6.6.3), so the caller always gets the form of 2.1; packets 200, 206, 207 and 239 of version 1.1 are
/// read as Packet0, Packet68, Packet70 and Packet39. Spare codes of a later version Y are accepted (3.17.3.11).
template <class P>
Fault decode(const PacketView& view, P& packet);
/// The same, with the place of the fault.
template <class P>
FaultAt decode_at(const PacketView& view, P& packet);

/// Reads the variables of a message before its packets. Messages 15 and 34 of versions 1.Y are read with D_REF = 0.
template <class M>
Fault decode(const MessageToTrainView& view, M& message);
template <class M>
Fault decode(const MessageToTrackView& view, M& message);

}  // namespace evc::lang
