#pragma once
#include "base/bit_cursor.h"
#include "lang/schema.h"
#include "lang/variables.h"

// Writing of packets, telegrams and messages. L_PACKET, L_MESSAGE and the counters are computed. The
// writer becomes faulty when the space is too small or a value too wide; its content is then not valid.
namespace evc::lang {

/// Appends a packet in the layout of its struct (`Packet27` the newest, `Packet27_v1_0` the older one).
template <class P>
void encode(BitWriter& out, const P& packet);

struct TelegramHeader {
  var::Q_UPDOWN Q_UPDOWN{1};
  var::M_VERSION M_VERSION{33};
  var::Q_MEDIA Q_MEDIA{0};
  var::N_PIG N_PIG;
  var::N_TOTAL N_TOTAL;
  var::M_DUP M_DUP;
  var::M_MCOUNT M_MCOUNT{255};
  var::NID_C NID_C;
  var::NID_BG NID_BG;
  var::Q_LINK Q_LINK;
};
/// Header of a balise telegram (8.4.2.1).
void begin_telegram(BitWriter& out, const TelegramHeader& header);
/// Packet 255, then ones up to `bits` (210 or 830); 0: no filling.
void end_telegram(BitWriter& out, std::size_t bits);

/// NID_MESSAGE, space for L_MESSAGE, and the variables of the message before its packets. A message starts at bit 0 of
/// the writer.
template <class M>
void begin_message(BitWriter& out, const M& message);
/// Padding to a whole byte, and L_MESSAGE.
void end_message(BitWriter& out);

/// A whole message: `encode_message(out, TrainMessage136{...}, TrainPacket0{...})`.
template <class M, class... P>
void encode_message(BitWriter& out, const M& message, const P&... packets) {
  begin_message(out, message);
  (encode(out, packets), ...);
  end_message(out);
}

}  // namespace evc::lang
