#pragma once
#include <cstdint>

namespace evc::language {

/// What `evc decode` and `evc encode` read and write.
enum class What : std::uint8_t { balise, airgap, radio, packet };

}  // namespace evc::language
