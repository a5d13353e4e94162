#include "kernel/intake/message.h"

#include "lang/instances.h"
#include "track/from_packets.h"

namespace evc::kernel {

lang::SystemVersion session_version(std::uint8_t M_VERSION) {
  return M_VERSION == 0 ? lang::SystemVersion{2, 1} : lang::system_version(M_VERSION);
}

bool gather(Information& information, const lang::PacketViews& packets) {
  for (const lang::PacketView& p : packets)
    if (track::valid_direction(p.Q_DIR, information.orientation) && !information.packets.push_back(p)) return false;
  return true;
}

void drop_superseded(Information& information) {
  const lang::Superseding newer = lang::superseding_in({information.packets.begin(), information.packets.size()});
  information.packets.erase_if([&](const lang::PacketView& p) { return newer.drops(p); });
}

}  // namespace evc::kernel
