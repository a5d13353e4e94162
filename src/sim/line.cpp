#include "sim/line.h"

namespace evc::sim {

std::uint32_t Bits::number(std::size_t first, unsigned width) const {
  std::uint32_t value = 0;
  for (std::size_t i = first; i < first + width; ++i) {
    const bool inside = i < size && i / 8 < bytes.size();
    const unsigned bit = inside ? (bytes[i / 8] >> (7 - i % 8)) & 1u : 0u;
    value = (value << 1) | bit;
  }
  return value;
}

}  // namespace evc::sim
