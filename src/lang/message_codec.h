#pragma once
#include "lang/packet_codec.h"
#include "lang/telegram.h"

// The reader of the fixed part of every message. Internal to this folder.
namespace evc::lang {

struct MessageToTrainCodec {
  const MessageInfo* info;
  /// Reads the variables before the packets; `end` is the bit after them.
  FaultAt (*check)(const MessageToTrainView& view, std::size_t& end);
};
struct MessageToTrackCodec {
  const MessageInfo* info;
  FaultAt (*check)(const MessageToTrackView& view, std::size_t& end);
};
/// Null: no such message in this version. With an unknown X the newest form is returned: the caller
/// decides whether the message may be read (8.4.4.1.1).
const MessageToTrainCodec* find_message_to_train(std::uint8_t nid, SystemVersion sv);
const MessageToTrackCodec* find_message_to_track(std::uint8_t nid, SystemVersion sv);

}  // namespace evc::lang
