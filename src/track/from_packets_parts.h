#pragma once
#include "track/from_packets.h"

// The parts of `add`, one file each.
namespace evc::track {

/// Packets 39, 40, 67-72, 76: conditions of the track and texts.
Added add_condition(Contents& contents, const lang::PacketView& view, const Reference& reference);
/// Packet 49.
Added add_sh_list(AuthorityContents& contents, const lang::PacketView& view, const Reference& reference);
/// Packets 79, 90, 131-133, 135, 137-139, 181: orders and lists.
Added add_order(Contents& contents, const lang::PacketView& view, const Reference& reference);

}  // namespace evc::track
