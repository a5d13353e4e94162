#pragma once
#include "kernel/intake/evaluation.h"
#include "modes/acceptance.h"

// What became of a message and of each of its packets, as events.
namespace evc::kernel {

/// Why the contents of a packet of the message are used by nobody: an unknown number, contents of X = 1 that have no
/// meaning in X = 2, or a packet 203 without the packet 3 that it belongs to. None: they are used.
std::optional<Clause> passed_over(const Information& information, const lang::PacketView& view);

/// `passed_over`: why nothing needs the contents of such a packet. What is rejected counts as refused by the message.
void tell_packet(Evaluation& e, int NID_PACKET, const modes::Acceptance& a, const std::optional<Clause>& passed_over);

/// Packets of the evaluated part that belong to an authority, or to a message that authorises: what becomes of them is
/// what becomes of that; they wait with it.
void tell_belonging(Evaluation& e, const modes::Acceptance& a);

/// Packets that were evaluated before the filters (4.8.2.2), of all parts.
void tell_evaluated_before(Evaluation& e);

/// The evaluated part is infill that waits or is refused as a whole: all other packets of it.
void tell_infill(Evaluation& e, const modes::Acceptance& a);

/// The message itself, after all its packets.
void tell_message(Evaluation& e);

}  // namespace evc::kernel
