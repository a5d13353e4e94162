#include "kernel/intake/message.h"

#include "lang/decode.h"
#include "lang/instances.h"
#include "lang/packets/packet_44.h"
#include "lang/translate.h"
#include "terms/packet_numbers.h"
#include "track/from_packets.h"

namespace evc::kernel {

lang::SystemVersion session_version(std::uint8_t M_VERSION, SrsVersion srs) {
  if (M_VERSION == 0) return {2, 1};
  return lang::as_known(lang::system_version(M_VERSION), lang::newest_version(srs));
}

namespace {

/// 3.6.3.1.4.1: data for a national system are accepted where the direction is not known.
bool for_national_system(const lang::PacketView& view) {
  lang::Packet44 p;
  return view.NID_PACKET == packet::external_application_data && lang::decode(view, p) == lang::Fault::none &&
         p.NID_XUSER.raw == lang::kNationalSystem;
}

}  // namespace

bool gather(Information& information, const lang::PacketViews& packets, const Log* log) {
  const bool unknown = information.orientation == Direction::unknown;
  for (const lang::PacketView& p : packets)
    if (track::valid_direction(p.Q_DIR, information.orientation) || (unknown && for_national_system(p))) {
      if (!information.packets.push_back(p)) return false;
    } else if (log != nullptr) {
      log->note({.what = unknown ? What::packet_refused : What::packet_other_direction,
                 .id = p.NID_PACKET,
                 .clause = unknown ? "3.6.3.1.4"_srs : "3.6.3.1.3"_srs});
    }
  return true;
}

void drop_superseded(Information& information, const Log* log) {
  const lang::Superseding newer = lang::superseding_in({information.packets.begin(), information.packets.size()});
  information.packets.erase_if([&](const lang::PacketView& p) {
    if (!newer.drops(p)) return false;
    if (log != nullptr) log->note({.what = What::packet_superseded, .id = p.NID_PACKET, .clause = "6.6.3.2.3"_srs});
    return true;
  });
}

}  // namespace evc::kernel
