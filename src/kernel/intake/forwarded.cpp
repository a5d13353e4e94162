#include "kernel/intake/forwarded.h"

#include "lang/decode.h"
#include "lang/packets/packet_44.h"
#include "lang/translate.h"

namespace evc::kernel {

void forward_data(Evaluation& e, const lang::PacketView& view, modes::Verdict) {
  lang::Packet44 p;
  if (e.r.forwarded == nullptr || lang::decode(view, p) != lang::Fault::none) return;
  const bool national = p.NID_XUSER.raw == lang::kNationalSystem;
  const bool by_balise_or_rbc =
      e.information.medium == Medium::rbc || (e.information.medium == Medium::balise && !e.contents.infill);
  if (national && !by_balise_or_rbc) return refuse(e, "3.15.6.5"_srs);
  ForwardedData data;
  data.NID_XUSER = static_cast<std::uint16_t>(p.NID_XUSER.raw);
  if (national) data.NID_NTC = static_cast<std::uint8_t>(p.NID_NTC.raw);
  data.bits = p.OTHER_DATA.bits;
  bool room = true;
  for (const std::uint8_t byte : p.OTHER_DATA.bytes) room = room && data.bytes.push_back(byte);
  if (!room || !e.r.forwarded->push_back(data))
    e.r.log.note({.what = What::packet_refused, .id = view.NID_PACKET, .clause = "3.15.6.5"_srs});
}

}  // namespace evc::kernel
