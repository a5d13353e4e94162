#pragma once
#include "kernel/intake/evaluation.h"

// Packets that concern sessions and the radio network.
namespace evc::kernel {

/// Packet 42: a session is established or terminated; without a registered terminal only the contact is stored
/// (3.5.6.7).
void take_session_order(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);
/// Packet 45 (3.5.6.5).
void take_network(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);

}  // namespace evc::kernel
