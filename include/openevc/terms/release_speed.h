#pragma once
#include <cstdint>

namespace evc {

/// Source of the release speed (3.13.9.4.3): none is supervised, a value given by trackside, the national value, or it
/// is calculated on-board (V_RELEASEDP, V_RELEASEOL).
enum class ReleaseSpeedChoice : std::uint8_t { none, value, national, on_board };

}  // namespace evc
