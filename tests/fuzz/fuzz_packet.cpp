#include "language.h"

// The first byte chooses direction and version, the others are the packet.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evc;
  if (size < 2) return 0;
  const auto direction = (data[0] & 1) != 0 ? lang::Direction::to_track : lang::Direction::to_train;
  constexpr lang::SystemVersion versions[]{{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 0}};
  fuzz::check_alone({data + 1, size - 1}, direction, versions[(data[0] >> 1) & 3]);
  return 0;
}
