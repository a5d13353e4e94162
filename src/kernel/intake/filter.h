#pragma once
#include "kernel/intake/evaluation.h"

namespace evc::kernel {

/// The facts of the exceptions that do not depend on the single packet.
modes::AcceptanceContext context_of(const Reception& r, const Information& information);
/// Adds what the packet is to what is stored: 4.8.3 [8], [12].
void add_facts_of_stores(modes::AcceptanceContext& c, const State& s, const lang::PacketView& view);
/// Whether it is message 4, an authorisation for a supervised manoeuvre.
bool authorises_manoeuvre(const Information& information);

/// Evaluates a message (4.8): level orders first, then linking, then the rest together; stores accepted data and
/// executes orders that are not stored. Events name everything that was accepted, refused or buffered. Returns what is
/// buffered.
Waiting evaluate(Reception& r, const Information& information);

/// Judges packet `i` by the rows of its route (4.8.3, 4.8.4), logs it, and buffers it if the filter requires it.
modes::Acceptance judge_packet(Evaluation& e, std::size_t i);

}  // namespace evc::kernel
