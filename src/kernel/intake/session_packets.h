#pragma once
#include "kernel/intake/evaluation.h"

// Packets that concern sessions and the radio network.
namespace evc::kernel {

/// Packet 42: a session is established or terminated; without a registered terminal only the contact is stored
/// (3.5.6.7).
void take_session_order(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);
/// Packet 45 (3.5.6.5), and 245 of 2.3, which says whether there is GSM-R at all (6.6.5.2.5, 6.6.5.2.6).
void take_network(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);
void take_network_type(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);

/// 4.8.3 [15] of 4.0.0: the packet orders to establish a session, beside an order for a network with which no terminal
/// is registered. Of packet 42 the context says already whether it does.
bool calls_without_network(const Evaluation& evaluation, const lang::PacketView& view);

}  // namespace evc::kernel
