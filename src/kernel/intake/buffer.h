#pragma once
#include <span>

#include "kernel/intake/message.h"
#include "kernel/intake/reception.h"

// The transition buffer (4.8.5).
namespace evc::kernel {

/// Makes room for the buffered part of `information`; the newest set replaces the oldest (4.8.5.3). The bits of the
/// telegrams or of the message are added with add_bits.
BufferedSet& keep(Reception& r, const Information& information, const Waiting& waiting);
void add_bits(BufferedSet& set, std::span<const std::uint8_t> bytes);
void add_telegram(BufferedSet& set, std::span<const std::uint8_t> bytes, std::uint16_t bits);

/// 4.8.5: all buffered information is filtered again at the new level, in the order of reception.
void release_buffer(Reception& r);

}  // namespace evc::kernel
