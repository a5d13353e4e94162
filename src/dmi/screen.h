#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "openevc/base/inplace_vector.h"
#include "openevc/terms/picture.h"
#include "openevc/terms/row.h"

// The display list, evc-screen/1: what stands on the screen, in drawing order. One unit is a cell, x to the right, y
// down; angles are degrees, 0 up, clockwise positive.
namespace evc::dmi {

/// The colours of 015560 5.2.1.3.
enum class Colour : std::uint8_t {
  none,
  white,
  black,
  grey,
  medium_grey,
  dark_grey,
  dark_blue,
  shadow,
  yellow,
  orange,
  red,
  pasp_dark,
  pasp_light,
  count
};

struct ColourRow {
  Colour value;
  const char* name;
  std::array<std::uint8_t, 3> rgb;
};
inline constexpr auto kColourRows = std::to_array<ColourRow>({
    {Colour::none, "none", {0, 0, 0}},
    {Colour::white, "white", {255, 255, 255}},
    {Colour::black, "black", {0, 0, 0}},
    {Colour::grey, "grey", {195, 195, 195}},
    {Colour::medium_grey, "medium_grey", {150, 150, 150}},
    {Colour::dark_grey, "dark_grey", {85, 85, 85}},
    {Colour::dark_blue, "dark_blue", {3, 17, 34}},
    {Colour::shadow, "shadow", {8, 24, 57}},
    {Colour::yellow, "yellow", {223, 223, 0}},
    {Colour::orange, "orange", {234, 145, 0}},
    {Colour::red, "red", {191, 0, 2}},
    {Colour::pasp_dark, "pasp_dark", {33, 49, 74}},
    {Colour::pasp_light, "pasp_light", {41, 74, 107}},
});
static_assert(terms::in_order(kColourRows) && kColourRows.size() == terms::index(Colour::count));
constexpr const char* name(Colour colour) { return terms::kNames<kColourRows>[terms::index(colour)]; }

/// A rectangle of the screen.
struct Rect {
  std::int16_t x = 0, y = 0, w = 0, h = 0;
  friend constexpr bool operator==(const Rect&, const Rect&) = default;
};
constexpr bool inside(const Rect& r, int x, int y) { return x >= r.x && y >= r.y && x < r.x + r.w && y < r.y + r.h; }

// clang-format off
/// The areas of 015560 6.3, the areas that objects span, and the parts of windows.
enum class Area : std::uint8_t {
  screen, Z, Y, A, B, C, D, E, F, G,
  A1, A2, A3, A4, B0, B1, B2, B3, B4, B5, B6, B7, B8, C1, C2, C3, C4, C5, C6, C7, C8, C9,
  D1, D2, D3, D4, D5, D6, D7, D8, D9, D10, D11, D12, D13, D14,
  E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11,
  F1, F2, F3, F4, F5, F6, F7, F8, F9, G1, G2, G3, G4, G5, G6, G7, G8, G9, G10, G11, G12, G13,
  A2_A3, C2_C3_C4, C3_C4, C8_C9_E1, D6_D7, D7_D8, E5_E9, G2_G3_G4,
  half,  ///< windows in D, F and G
  full,  ///< windows in A to G
  count
};

struct AreaRow {
  Area value;
  const char* name;
  Rect at;  ///< absolute; B0 and B2 are rings round (194, 165): their bounding boxes
};
inline constexpr auto kAreaRows = std::to_array<AreaRow>({
    {Area::screen, "screen", {0, 0, 640, 480}}, {Area::Z, "Z", {0, 0, 640, 15}}, {Area::Y, "Y", {0, 465, 640, 15}},
    {Area::A, "A", {0, 15, 54, 300}}, {Area::B, "B", {54, 15, 280, 300}}, {Area::C, "C", {0, 315, 334, 50}},
    {Area::D, "D", {334, 15, 246, 300}}, {Area::E, "E", {0, 365, 334, 100}}, {Area::F, "F", {580, 15, 60, 450}},
    {Area::G, "G", {334, 315, 246, 150}},
    {Area::A1, "A1", {0, 15, 54, 54}}, {Area::A2, "A2", {0, 69, 54, 30}}, {Area::A3, "A3", {0, 99, 54, 191}},
    {Area::A4, "A4", {0, 290, 54, 25}}, {Area::B0, "B0", {69, 40, 250, 250}}, {Area::B1, "B1", {169, 140, 50, 50}},
    {Area::B2, "B2", {57, 28, 274, 274}}, {Area::B3, "B3", {140, 271, 36, 36}}, {Area::B4, "B4", {176, 271, 36, 36}},
    {Area::B5, "B5", {212, 271, 36, 36}}, {Area::B6, "B6", {62, 271, 36, 36}}, {Area::B7, "B7", {290, 271, 36, 36}},
    {Area::B8, "B8", {176, 213, 36, 36}}, {Area::C1, "C1", {165, 315, 58, 50}}, {Area::C2, "C2", {54, 315, 37, 50}},
    {Area::C3, "C3", {91, 315, 37, 50}}, {Area::C4, "C4", {128, 315, 37, 50}}, {Area::C5, "C5", {223, 315, 37, 50}},
    {Area::C6, "C6", {260, 315, 37, 50}}, {Area::C7, "C7", {297, 315, 37, 50}}, {Area::C8, "C8", {0, 315, 54, 25}},
    {Area::C9, "C9", {0, 340, 54, 25}},
    {Area::D1, "D1", {334, 30, 40, 270}}, {Area::D2, "D2", {374, 30, 25, 270}}, {Area::D3, "D3", {399, 30, 25, 270}},
    {Area::D4, "D4", {424, 30, 25, 270}}, {Area::D5, "D5", {449, 30, 18, 270}}, {Area::D6, "D6", {467, 30, 14, 270}},
    {Area::D7, "D7", {481, 30, 93, 270}}, {Area::D8, "D8", {574, 30, 6, 270}}, {Area::D9, "D9", {334, 300, 40, 15}},
    {Area::D10, "D10", {374, 300, 166, 15}}, {Area::D11, "D11", {540, 300, 40, 15}}, {Area::D12, "D12", {334, 15, 40, 15}},
    {Area::D13, "D13", {374, 15, 166, 15}}, {Area::D14, "D14", {540, 15, 40, 15}},
    {Area::E1, "E1", {0, 365, 54, 25}}, {Area::E2, "E2", {0, 390, 54, 25}}, {Area::E3, "E3", {0, 415, 54, 25}},
    {Area::E4, "E4", {0, 440, 54, 25}}, {Area::E5, "E5", {54, 365, 234, 20}}, {Area::E6, "E6", {54, 385, 234, 20}},
    {Area::E7, "E7", {54, 405, 234, 20}}, {Area::E8, "E8", {54, 425, 234, 20}}, {Area::E9, "E9", {54, 445, 234, 20}},
    {Area::E10, "E10", {288, 365, 46, 50}}, {Area::E11, "E11", {288, 415, 46, 50}},
    {Area::F1, "F1", {580, 15, 60, 50}}, {Area::F2, "F2", {580, 65, 60, 50}}, {Area::F3, "F3", {580, 115, 60, 50}},
    {Area::F4, "F4", {580, 165, 60, 50}}, {Area::F5, "F5", {580, 215, 60, 50}}, {Area::F6, "F6", {580, 265, 60, 50}},
    {Area::F7, "F7", {580, 315, 60, 50}}, {Area::F8, "F8", {580, 365, 60, 50}}, {Area::F9, "F9", {580, 415, 60, 50}},
    {Area::G1, "G1", {334, 315, 49, 50}}, {Area::G2, "G2", {383, 315, 49, 50}}, {Area::G3, "G3", {432, 315, 49, 50}},
    {Area::G4, "G4", {481, 315, 49, 50}}, {Area::G5, "G5", {530, 315, 50, 50}}, {Area::G6, "G6", {334, 365, 49, 50}},
    {Area::G7, "G7", {383, 365, 49, 50}}, {Area::G8, "G8", {432, 365, 49, 50}}, {Area::G9, "G9", {481, 365, 49, 50}},
    {Area::G10, "G10", {530, 365, 50, 50}}, {Area::G11, "G11", {334, 415, 63, 50}}, {Area::G12, "G12", {397, 415, 120, 50}},
    {Area::G13, "G13", {517, 415, 63, 50}},
    {Area::A2_A3, "A2+A3", {0, 69, 54, 221}}, {Area::C2_C3_C4, "C2+C3+C4", {54, 315, 111, 50}},
    {Area::C3_C4, "C3+C4", {91, 315, 74, 50}}, {Area::C8_C9_E1, "C8+C9+E1", {0, 315, 54, 75}},
    {Area::D6_D7, "D6+D7", {467, 30, 107, 270}}, {Area::D7_D8, "D7+D8", {481, 30, 99, 270}},
    {Area::E5_E9, "E5-E9", {54, 365, 234, 100}}, {Area::G2_G3_G4, "G2+G3+G4", {383, 315, 147, 50}},
    {Area::half, "half", {334, 15, 306, 450}}, {Area::full, "full", {0, 15, 640, 450}},
});
// clang-format on
static_assert(terms::in_order(kAreaRows) && kAreaRows.size() == terms::index(Area::count));
constexpr const char* name(Area area) { return terms::kNames<kAreaRows>[terms::index(area)]; }
constexpr Rect rect_of(Area area) { return kAreaRows[terms::index(area)].at; }

/// A short text in UTF-8; what does not fit is cut off.
template <std::size_t Capacity>
struct Text {
  std::array<char, Capacity> characters{};
  std::uint8_t length = 0;

  constexpr Text() = default;
  constexpr Text(std::string_view text) { append(text); }
  constexpr Text(const char* text) { append(text); }
  constexpr void append(char c) {
    if (length < Capacity) characters[length++] = c;
  }
  constexpr void append(std::string_view text) {
    for (const char c : text) append(c);
  }
  constexpr void append(const char* text) {
    for (; *text != '\0'; ++text) append(*text);
  }
  constexpr std::string_view view() const { return {characters.data(), length}; }
  constexpr bool empty() const { return length == 0; }
  constexpr void clear() { length = 0; }
  friend constexpr bool operator==(const Text& a, const Text& b) { return a.view() == b.view(); }
};
using Words = Text<64>;

/// What an item is. A comment says which fields of Item it has besides `area` and `colour`.
enum class Kind : std::uint8_t {
  arc,          ///< ring sector round (194, 165): from_deg, to_deg, r_in, r_out
  pointer,      ///< needle and hub: deg (from_deg); shape of kPointer
  digits,       ///< the three columns of B1: text (three characters, ' ' is an empty column), height
  dial_line,    ///< radial line: from_deg, r_in, r_out, w (its width), number (the speed in km/h)
  dial_number,  ///< text, from_deg, r_in (radius of its centre), w (cells that it is set aside to the right), height
  hook,         ///< from_deg (its leading edge), w tangential towards zero, r_in, r_out
  disc,         ///< from_deg, r_in (radius of its centre), w (its diameter)
  text,         ///< at (its box, relative), text, height, align, indent, bold
  text_symbol,  ///< a name that stands for a symbol: picture, text, at
  symbol,       ///< picture, at
  rect,         ///< filled with `colour`: at, name
  bar,          ///< filled: at
  frame,        ///< flashing frame inside `at`: w of its line is 2
  border,       ///< border of an area, button or field: at, style
  button,       ///< a button: at, name, text or picture, type, enabled, pressed, background, colour of the label
  field,        ///< an input field: at (label and data), data_at, name (label), text, number, state, background
  echo,         ///< echo text: name (label), text, number, colour of the value, label_right, data_left, baseline
  key,          ///< a key: at, text or picture, number, enabled, pressed, height, bold
  view_item,    ///< name (label), text, number, label_right, data_left, baseline
  pasp_step,    ///< filled: at, from_m, to_m, number (quarters of the width)
  edge,         ///< one-cell lines of a rectangle: at, sides (bits of Side)
  cursor        ///< underscore: at
};
inline constexpr std::array<const char*, 22> kKindNames{
    "arc",         "pointer", "digits",    "dial_line", "dial_number", "hook",   "disc",   "text",
    "text_symbol", "symbol",  "rect",      "bar",       "frame",       "border", "button", "field",
    "echo",        "key",     "view_item", "pasp_step", "edge",        "cursor"};
static_assert(kKindNames.size() == terms::index(Kind::cursor) + 1);
constexpr const char* name(Kind kind) { return kKindNames[terms::index(kind)]; }

enum class Align : std::uint8_t { left, centre, right };
enum class ButtonType : std::uint8_t { up, down, down_repeat, delay };
enum class FieldState : std::uint8_t { not_selected, selected, accepted };
/// Borders of 015560 5.1.1: an area has one line (left and top black, right and bottom shadow), a button two, an input
/// field one of medium grey.
enum class Border : std::uint8_t { none, area, button, field };
inline constexpr std::uint8_t kTop = 1, kLeft = 2, kBottom = 4, kRight = 8;  ///< sides of Kind::edge

struct Item {
  Kind kind{};
  Area area{};
  Colour colour = Colour::none;
  Colour background = Colour::none;
  Rect at;  ///< relative to the corner of `area`
  double from_deg = 0.0, to_deg = 0.0;
  double r_in = 0.0, r_out = 0.0;
  std::int32_t from_m = 0, to_m = 0;
  std::int16_t w = 0;
  std::int16_t number = 0;
  std::int16_t label_right = 0, data_left = 0, baseline = 0;  ///< absolute
  std::uint8_t height = 0;                                    ///< of capital letters
  std::uint8_t indent = 0;                                    ///< of text from the side to which it is aligned
  Align align = Align::left;
  bool bold = false;
  bool enabled = true, pressed = false;
  ButtonType type = ButtonType::up;
  FieldState state = FieldState::not_selected;
  Border border = Border::none;
  std::uint8_t sides = 0;
  std::optional<Picture> picture;
  Rect data_at;   ///< with Kind::field: the data part, relative to the corner of `area`
  Text<32> name;  ///< "title", "button 1 Start", "Length (m)"
  Words text;
  friend constexpr bool operator==(const Item&, const Item&) = default;
};
static_assert(std::is_trivially_copyable_v<Item>);

/// Where the item is on the screen.
constexpr Rect absolute(Area area, Rect at) {
  const Rect base = rect_of(area);
  return {static_cast<std::int16_t>(base.x + at.x), static_cast<std::int16_t>(base.y + at.y), at.w, at.h};
}
constexpr Rect absolute(const Item& item) { return absolute(item.area, item.at); }

/// A place that reacts to touch, the topmost first.
struct Touch {
  Text<32> name;  ///< "F1", "C1", "key 5", "close", "field 2"
  Rect abs;
  Text<32> action;  ///< "main", "ack MO08", "toggle speed"
  bool enabled = true;
  ButtonType type = ButtonType::up;
};

enum class Sound : std::uint8_t { click, Sinfo, S1, S2, count };
inline constexpr std::array<const char*, 4> kSoundNames{"click", "Sinfo", "S1", "S2"};
constexpr const char* name(Sound sound) { return kSoundNames[terms::index(sound)]; }
enum class SoundDo : std::uint8_t { once, loop, stop };
/// A sound that starts or stops.
struct SoundOrder {
  Sound sound{};
  SoundDo what = SoundDo::once;
  friend constexpr bool operator==(const SoundOrder&, const SoundOrder&) = default;
};

/// The shape of the pointer (015560 8.2.1.2.4), in cells.
struct PointerShape {
  std::int16_t hub_radius = 25, tip_radius = 105, tip_width = 3, base_width = 9, taper_from = 82, taper_to = 90;
};
inline constexpr PointerShape kPointer;
inline constexpr std::int16_t kDialX = 194, kDialY = 165;  ///< the centre of the dial

inline constexpr std::size_t kMostItems = 1024;

struct Screen {
  double t_ms = 0.0;
  Text<32> window;  ///< "default", "Main", "Train data"
  InplaceVector<Item, kMostItems> items;
  InplaceVector<Area, 8> flashing;  ///< areas whose frame flashes now (also while it is in its invisible half)
  InplaceVector<Touch, 64> touch;
  InplaceVector<SoundOrder, 16> sounds;       ///< ordered since the last `take`
  std::uint8_t brightness = 50, volume = 50;  ///< percent
};
static_assert(std::is_trivially_copyable_v<Screen>);

}  // namespace evc::dmi
