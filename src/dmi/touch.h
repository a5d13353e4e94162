#pragma once
#include "dmi/state.h"

// Where the parts of windows are (015560 5.3.1 and 10), for drawing and touch alike: absolute.
namespace evc::dmi {

/// The place of menu button 1 to 12 of a half window.
constexpr Rect menu_place(int number) {
  return {static_cast<std::int16_t>(number % 2 == 1 ? 334 : 487),
          static_cast<std::int16_t>(65 + 50 * ((number - 1) / 2)), 153, 50};
}
/// The place of key 1 to 12.
constexpr Rect key_place(int number) {
  return {static_cast<std::int16_t>(334 + 102 * ((number - 1) % 3)),
          static_cast<std::int16_t>(215 + 50 * ((number - 1) / 3)), 102, 50};
}
inline constexpr Rect kClosePlace{334, 415, 82, 50}, kPreviousPlace{416, 415, 82, 50}, kNextPlace{498, 415, 82, 50};
inline constexpr Rect kHalfField{334, 65, 306, 50};
/// The place of input field 1 to 4 of a full window.
constexpr Rect full_field(int number) { return {334, static_cast<std::int16_t>(15 + 50 * (number - 1)), 306, 50}; }
/// The data part of a field with a label.
constexpr Rect data_part(const Rect& field) {
  return {static_cast<std::int16_t>(field.x + 204), field.y, 102, field.h};
}
inline constexpr Rect kNoPlace{334, 315, 102, 50}, kYesPlace{436, 315, 102, 50};
/// "entry complete?" with its answer: the question belongs to the touched place.
inline constexpr Rect kCompletePlace{0, 365, 334, 100};
inline constexpr Rect kSwitchPlace{580, 415, 60, 50};
inline constexpr Rect kNumberPlace{476, 415, 82, 50}, kSettingsPlace{558, 415, 82, 50};

/// Whether the window offers the switch between train types and train data.
bool has_switch(const State&);
/// Whether the window Driver ID offers the settings and the train running number (015560 11.7.2 S1).
bool has_shortcuts(const State&);

}  // namespace evc::dmi
