#pragma once
#include <cstdint>

#include "balise/group.h"
#include "kernel/intake/message.h"

namespace evc::kernel {

/// The packets after packet 136 in its telegram or message are infill (3.6.2.3.1, 7.4.2.32, 8.4.1.4.4): their
/// reference is another group, announced by linking.
struct Infill {
  std::uint64_t packets = 0;  // bit n: the n-th packet
  GroupId group;
};
using Infills = InplaceVector<Infill, balise::kBalises>;  // at most one in each telegram of a group

/// Those of a message, in their order.
Infills find_infills(const Information& information);

}  // namespace evc::kernel
