#include "kernel/intake/infill.h"

#include "lang/decode.h"
#include "lang/packets/packet_136.h"
#include "terms/packet_numbers.h"

namespace evc::kernel {
namespace {

GroupId infill_group(const Information& information, const lang::PacketView& view) {
  lang::Packet136 p;
  if (lang::decode(view, p) != lang::Fault::none) return {};
  return {p.Q_NEWCOUNTRY.raw == 1 ? p.NID_C.raw : information.group.NID_C, p.NID_BG.raw};
}

/// Telegrams of one group with the same reference make one part: their packets are evaluated together.
Infill& infill_of(Infills& infills, GroupId group) {
  for (Infill& infill : infills)
    if (infill.group == group) return infill;
  (void)infills.push_back({0, group});
  return infills.back();
}

}  // namespace

Infills find_infills(const Information& information) {
  Infills infills;
  Infill* infill = nullptr;  // of the present telegram
  const std::uint8_t* telegram = nullptr;
  for (std::size_t i = 0; i < information.packets.size(); ++i) {
    const lang::PacketView& view = information.packets[i];
    if (view.bytes.data() != telegram) infill = nullptr;
    telegram = view.bytes.data();
    if (infill == nullptr && view.NID_PACKET == packet::infill_location_reference)
      infill = &infill_of(infills, infill_group(information, view));
    if (infill != nullptr) infill->packets |= std::uint64_t{1} << i;
  }
  return infills;
}

}  // namespace evc::kernel
