#include "airgap/candidate.h"

namespace evc::airgap {
namespace {

template <class Code>
Fault examine_as(std::span<const std::uint8_t> coded) {
  if (coded.size() < bytes_for(Code::n)) return Fault::size;
  const Bits<Code::n> bits = load<Code::n>(coded, 0);
  if (Arithmetic<Code>::of(bits) != Code::g) return Fault::parity;
  if (bits.get(kControlAt, 3) != kControlBits) return Fault::control_bits;
  return examine_shape<Code>(bits);
}

}  // namespace

Fault examine(std::span<const std::uint8_t> coded, Format format) {
  return format == Format::long_ ? examine_as<LongCode>(coded) : examine_as<ShortCode>(coded);
}

std::string_view name(Fault fault) {
  switch (fault) {
    case Fault::none:
      break;
    case Fault::size:
      return "size";
    case Fault::too_few_bits:
      return "too few bits";
    case Fault::parity:
      return "check bits";
    case Fault::repetition:
      return "repetition";
    case Fault::synchronisation:
      return "synchronisation";
    case Fault::control_bits:
      return "control bits";
    case Fault::alphabet:
      return "alphabet";
    case Fault::off_synch:
      return "off-synch parsing";
    case Fault::aperiodicity:
      return "aperiodicity";
    case Fault::under_sampling:
      return "under-sampling";
    case Fault::unknown_format:
      return "unknown telegram format";
    case Fault::no_candidate:
      return "no candidate";
  }
  return "none";
}

}  // namespace evc::airgap
