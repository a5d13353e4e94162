#include <optional>

#include "dmi/drawing.h"
#include "dmi/geometry.h"

namespace evc::dmi {
namespace {

using port::Display;

// Rings round the centre of the dial (8.2.1).
constexpr double kDialOut = 125.0;
constexpr double kGaugeIn = 128.0, kGaugeOut = 137.0, kHookIn = 117.0;
constexpr double kReleaseIn = 132.0, kPermittedOut = 131.0;
constexpr double kLongLine = 25.0, kSetSpeedRadius = 111.0;

/// The kinds of monitoring of Tables 8 and 9.
enum class Kinds : std::uint8_t { none, CSM, CSM_target, TSM, RSM };

Kinds kind_of(const Display& display) {
  switch (display.monitoring) {
    case Monitoring::CSM:
      return display.target_information && display.V_target ? Kinds::CSM_target : Kinds::CSM;
    case Monitoring::TSM:
      return Kinds::TSM;
    case Monitoring::RSM:
      return Kinds::RSM;
    case Monitoring::none:
      break;
  }
  return Kinds::none;
}

/// Table 8: colours of the pointer by zone; `none` in the first: no row.
struct PointerRow {
  Kinds kind;
  Colour below_target, to_permitted;
  Colour overspeed;     ///< with the statuses Overspeed and Warning
  Colour intervention;  ///< with Intervention, above the permitted or release speed
};
using PointerRows = std::array<PointerRow, 4>;

constexpr Colour kNo = Colour::none, kGrey = Colour::grey, kWhite = Colour::white, kYellow = Colour::yellow,
                 kOrange = Colour::orange, kRed = Colour::red;
constexpr PointerRows kPointerFull{
    PointerRow{Kinds::CSM, kGrey, kGrey, kOrange, kRed}, PointerRow{Kinds::CSM_target, kGrey, kWhite, kOrange, kRed},
    PointerRow{Kinds::TSM, kGrey, kYellow, kOrange, kRed}, PointerRow{Kinds::RSM, kYellow, kYellow, kYellow, kRed}};
constexpr PointerRows kPointerNoRelease{
    PointerRow{Kinds::CSM, kGrey, kGrey, kOrange, kRed}, PointerRow{Kinds::CSM_target, kGrey, kWhite, kOrange, kRed},
    PointerRow{Kinds::TSM, kGrey, kYellow, kOrange, kRed}, PointerRow{Kinds::RSM, kGrey, kGrey, kGrey, kGrey}};
constexpr PointerRows kPointerLimited{
    PointerRow{Kinds::CSM, kGrey, kGrey, kOrange, kRed}, PointerRow{Kinds::CSM_target, kGrey, kGrey, kOrange, kRed},
    PointerRow{Kinds::TSM, kGrey, kGrey, kOrange, kRed}, PointerRow{Kinds::RSM, kYellow, kYellow, kYellow, kRed}};
constexpr PointerRows kPointerCeiling{
    PointerRow{Kinds::CSM, kGrey, kGrey, kOrange, kRed}, PointerRow{Kinds::CSM_target, kGrey, kGrey, kOrange, kRed},
    PointerRow{Kinds::TSM, kGrey, kGrey, kGrey, kGrey}, PointerRow{Kinds::RSM, kGrey, kGrey, kGrey, kGrey}};
constexpr PointerRows kPointerAutomatic{
    PointerRow{Kinds::CSM, kGrey, kGrey, kGrey, kGrey}, PointerRow{Kinds::CSM_target, kGrey, kWhite, kWhite, kGrey},
    PointerRow{Kinds::TSM, kGrey, kWhite, kWhite, kGrey}, PointerRow{Kinds::RSM, kWhite, kWhite, kWhite, kGrey}};

const PointerRows* pointer_rows(Mode mode) {
  switch (mode) {
    case Mode::FS:
    case Mode::SM:
    case Mode::OS:
      return &kPointerFull;
    case Mode::SR:
    case Mode::UN:
      return &kPointerNoRelease;
    case Mode::LS:
      return &kPointerLimited;
    case Mode::SH:
    case Mode::RV:
      return &kPointerCeiling;
    case Mode::AD:
      return &kPointerAutomatic;
    default:
      return nullptr;
  }
}

Colour pointer_colour(const Display& display) {
  const PointerRows* rows = pointer_rows(display.mode);
  if (rows == nullptr) {
    switch (display.mode) {
      case Mode::TR:
        return kRed;
      case Mode::SB:
      case Mode::NL:
      case Mode::PT:
      case Mode::SN:
        return kGrey;
      default:
        return kNo;  // 7.1: nothing is shown in NP, SL, PS, SF, IS
    }
  }
  const Kinds kind = kind_of(display);
  if (kind == Kinds::none) return kGrey;
  const PointerRow& row = (*rows)[static_cast<std::size_t>(kind) - 1];
  if (display.status == Status::Overspeed || display.status == Status::Warning) return row.overspeed;
  const std::optional<Speed> limit = kind == Kinds::RSM ? display.V_release : display.V_P;
  if (display.status == Status::Intervention && (display.mode == Mode::AD || (limit && display.v > *limit)))
    return row.intervention;
  const bool below = kind != Kinds::CSM && kind != Kinds::RSM && display.V_target && display.v < *display.V_target;
  return below ? row.below_target : row.to_permitted;
}

double angle_of(const Drawing& to, Speed v) { return dial_deg(to.display.config.dial, v.si * kKmh); }

/// The sine of 0 to 180 degrees to 0.002 (Bhaskara), without the mathematics library.
constexpr double sine(double deg) {
  const double product = deg * (180.0 - deg);
  return 4.0 * product / (40500.0 - product);
}

/// The radius of the centre of a number of so many digits at the inner end of a long line (8.2.1.1.5 gives the line,
/// no place for its number): the box of the number ends short of the line, at whichever side the line comes.
constexpr double number_radius(double deg, int digits) {
  constexpr double kClear = 4.0, kHalfHeight = 8.0, kHalfDigit = 6.2;
  const double aside = deg < 0.0 ? -deg : deg;  // 0 to 144
  const double across = sine(aside), along = aside <= 90.0 ? sine(90.0 - aside) : sine(aside - 90.0);
  const double half_width = kHalfDigit * digits;
  // The line leaves the box above or below it, else at its left or right side.
  const double inside = half_width * along < kHalfHeight * across ? half_width / across : kHalfHeight / along;
  return kDialOut - kLongLine - kClear - inside;
}

/// Sets numbers aside, to the right, that would touch the one before at about the same height: 120 and 140 of the dial
/// up to 250 km/h.
class NumbersApart {
 public:
  void set(Item& number) {
    constexpr double kSameHeight = 8.0, kApart = 1.0;
    const double deg = number.from_deg, aside = deg < 0.0 ? -deg : deg;
    const double across = (deg < 0.0 ? -1.0 : 1.0) * sine(aside);
    const double up = number.r_in * (aside <= 90.0 ? sine(90.0 - aside) : -sine(aside - 90.0));
    const double half = width_of(number.text.view(), number.height, false) / 2.0;
    const double lacks = right_ + kApart - (number.r_in * across - half);
    const double higher = up < up_ ? up_ - up : up - up_;
    if (higher < kSameHeight && lacks > 0.0) number.w = cells(lacks + 0.5);
    right_ = number.r_in * across + half + number.w;
    up_ = up;
  }

 private:
  double right_ = -1000.0, up_ = -1000.0;  // of the number before, in cells from the centre of the dial
};

void draw_dial(const Drawing& to) {
  const DialRow& row = dial_row(to.display.config.dial);
  NumbersApart numbers;
  for (std::int16_t v = 0; v <= row.most; v = static_cast<std::int16_t>(v + 10)) {
    const bool is_long = v % row.long_step == 0;
    Item line = to.item(Kind::dial_line, Area::B0, Colour::white);
    line.from_deg = dial_deg(to.display.config.dial, v);
    line.r_out = kDialOut;
    line.r_in = kDialOut - (is_long ? kLongLine : 15.0);
    line.w = 1;
    line.number = v;
    to.add(line);
    if (!is_long || (row.two_parts && v > 200 && v % 100 != 0)) continue;
    Item number = to.item(Kind::dial_number, Area::B0, Colour::white);
    number.from_deg = line.from_deg;
    number.height = 16;
    number.text = number_words(v);
    number.r_in = number_radius(line.from_deg, v < 10 ? 1 : v < 100 ? 2 : 3);
    number.align = Align::centre;
    numbers.set(number);
    to.add(number);
  }
}

void draw_pointer(const Drawing& to) {
  const Colour colour = pointer_colour(to.display);
  if (colour == kNo) return;
  Item pointer = to.item(Kind::pointer, Area::B0, colour);
  pointer.from_deg = angle_of(to, to.display.v);
  to.add(pointer);
  Item digits = to.item(Kind::digits, Area::B1, colour == kRed ? kWhite : Colour::black);
  const std::int32_t v = whole_kmh(to.display.v);
  digits.text.append(v >= 100 ? static_cast<char>('0' + v / 100) : ' ');
  digits.text.append(v >= 10 ? static_cast<char>('0' + v / 10 % 10) : ' ');
  digits.text.append(static_cast<char>('0' + v % 10));
  digits.height = 18;
  digits.align = Align::right;
  to.add(digits);
}

void draw_arc(const Drawing& to, double from_deg, double to_deg, double r_in, double r_out, Colour colour) {
  if (!(to_deg > from_deg)) return;
  Item arc = to.item(Kind::arc, Area::B2, colour);
  arc.from_deg = from_deg;
  arc.to_deg = to_deg;
  arc.r_in = r_in;
  arc.r_out = r_out;
  to.add(arc);
}

void draw_hook(const Drawing& to, Speed v, std::int16_t tangential, Colour colour) {
  Item hook = to.item(Kind::hook, Area::B2, colour);
  hook.from_deg = angle_of(to, v);
  hook.r_in = kHookIn;
  hook.r_out = kGaugeOut;
  hook.w = tangential;
  to.add(hook);
}

/// The part of the gauge from 0 to the permitted and the release speed (8.2.1.6.4).
void draw_release_gauge(const Drawing& to, Speed V_P, Speed V_release, Colour permitted) {
  const double zero = angle_of(to, Speed{}), released = angle_of(to, V_release), limit = angle_of(to, V_P);
  const double inner_end = limit < released ? limit : released;
  draw_arc(to, zero, inner_end, kGaugeIn, kPermittedOut, permitted);
  draw_arc(to, zero, inner_end, kPermittedOut, kReleaseIn, Colour::dark_blue);
  draw_arc(to, zero, inner_end, kReleaseIn, kGaugeOut, Colour::medium_grey);
  draw_arc(to, released, limit, kGaugeIn, kGaugeOut, permitted);
  draw_arc(to, limit, released, kGaugeIn, kReleaseIn, Colour::medium_grey);
  draw_arc(to, limit, released, kReleaseIn, kGaugeOut, Colour::medium_grey);
}

/// The band from the permitted speed to that of the intervention (Table 9); none where it is not drawn.
Colour band_colour(const Display& display, Kinds kind) {
  if (kind == Kinds::RSM) return kNo;
  const bool over = display.status == Status::Overspeed || display.status == Status::Warning;
  if (display.mode == Mode::AD) return !over ? kNo : kind == Kinds::CSM ? Colour::dark_grey : kWhite;
  return over ? kOrange : display.status == Status::Intervention ? kRed : kNo;
}

/// The circular speed gauge (8.2.1.4).
void draw_gauge(const Drawing& to) {
  const Display& display = to.display;
  const Kinds kind = kind_of(display);
  const bool automatic = display.mode == Mode::AD;
  if ((display.mode != Mode::FS && !automatic) || kind == Kinds::none || !display.V_P) return;
  if (automatic && display.status == Status::Intervention) return;
  const Speed V_P = *display.V_P;
  const Colour braking = automatic ? kWhite : kYellow;
  const Colour permitted = kind == Kinds::CSM ? Colour::dark_grey : kind == Kinds::CSM_target ? kWhite : braking;
  const double zero = angle_of(to, Speed{}), limit = angle_of(to, V_P);
  draw_arc(to, -149.0, zero, kGaugeIn, kGaugeOut, Colour::dark_grey);
  const bool released = (kind == Kinds::TSM || kind == Kinds::RSM) && display.V_release.has_value();
  if (released) {
    draw_release_gauge(to, V_P, *display.V_release, permitted);
  } else {
    const bool targeted = (kind == Kinds::CSM_target || kind == Kinds::TSM) && display.V_target.has_value();
    const double aim = targeted ? angle_of(to, *display.V_target) : zero;
    const double dark_end = aim < limit ? aim : limit;
    draw_arc(to, zero, dark_end, kGaugeIn, kGaugeOut, Colour::dark_grey);
    draw_arc(to, dark_end, limit, kGaugeIn, kGaugeOut, permitted);
  }
  const Colour band = band_colour(display, kind);
  if (band != kNo && display.V_SBI) draw_arc(to, limit, angle_of(to, *display.V_SBI), kHookIn, kGaugeOut, band);
  draw_hook(to, V_P, 6, permitted);
}

/// The basic speed hooks (8.2.1.5, Table 10).
void draw_hooks(const Drawing& to) {
  const Display& display = to.display;
  const Mode mode = display.mode;
  const Kinds kind = kind_of(display);
  const bool ceiling_only = mode == Mode::SH || mode == Mode::RV;
  if (!(mode == Mode::SM || mode == Mode::OS || mode == Mode::SR || ceiling_only) || !toggled_on(to.state)) return;
  if (kind == Kinds::none || (ceiling_only && display.monitoring != Monitoring::CSM)) return;
  if (mode == Mode::SR && kind == Kinds::RSM) return;
  const std::int16_t width = is_400(display) ? 10 : 6;
  if (!ceiling_only && kind != Kinds::CSM && display.V_target)
    draw_hook(to, *display.V_target, width, Colour::medium_grey);
  if (display.V_P) draw_hook(to, *display.V_P, width, kWhite);
}

void draw_disc(const Drawing& to, Speed v, Colour colour) {
  Item disc = to.item(Kind::disc, Area::B0, colour);
  disc.from_deg = angle_of(to, v);
  disc.r_in = kSetSpeedRadius;
  disc.w = 10;
  to.add(disc);
}

/// Release speed digits (Table 11).
void draw_release_digits(const Drawing& to) {
  const Display& display = to.display;
  const Mode mode = display.mode;
  const bool has = mode == Mode::FS || mode == Mode::SM || mode == Mode::LS || mode == Mode::AD || mode == Mode::OS;
  if (!has || !toggled_on(to.state) || !display.V_release) return;
  if (display.monitoring != Monitoring::TSM && display.monitoring != Monitoring::RSM) return;
  const Colour colour = mode == Mode::AD || !is_400(display) ? Colour::medium_grey : kYellow;
  to.text(Area::B6, number_words(whole_kmh(*display.V_release)), colour, 17, Align::centre, 0);
}

bool shows_target(const Display& display) {
  const Kinds kind = kind_of(display);
  return kind == Kinds::CSM_target || kind == Kinds::TSM || kind == Kinds::RSM;
}

/// The bar with its scale (8.2.2.1).
void draw_bar(const Drawing& to, Distance d) {
  struct Line {
    std::int16_t x, y;
    bool thick;
  };
  constexpr std::array<Line, 11> kScale{Line{12, -1, true},   Line{16, 6, false},  Line{16, 13, false},
                                        Line{16, 22, false},  Line{16, 32, false}, Line{12, 45, true},
                                        Line{16, 59, false},  Line{16, 79, false}, Line{16, 105, false},
                                        Line{16, 152, false}, Line{12, 185, true}};
  for (const Line& line : kScale) {
    const auto thickness = static_cast<std::int16_t>(line.thick ? 2 : 1);
    to.rect(Area::A3, kGrey, {line.x, line.y, static_cast<std::int16_t>(line.thick ? 13 : 9), thickness});
  }
  constexpr std::int16_t kLowestRow = 186;
  const std::int16_t top = cells(bar_row(d.si));
  to.add(to.item(Kind::bar, Area::A3, kGrey, {29, top, 10, static_cast<std::int16_t>(kLowestRow - top + 1)}));
}

}  // namespace

bool shows_TTI(const State& state) {
  const Display& display = state.display;
  const Mode mode = display.mode;
  const bool has = mode == Mode::FS || mode == Mode::SM || mode == Mode::AD || mode == Mode::OS || mode == Mode::SR;
  return has && toggled_on(state) && display.monitoring == Monitoring::CSM && display.TTI &&
         *display.TTI < display.config.T_dispTTI;
}

void draw_distance(const Drawing& to) {
  const Display& display = to.display;
  const Mode mode = display.mode;
  if (shows_TTI(to.state)) {
    const double tenths = 10.0 * display.TTI->si / display.config.T_dispTTI.si;
    const std::int32_t passed = whole(tenths - 0.5 + 1e-9, 0, 9);
    const auto side = static_cast<std::int16_t>(5 * (10 - passed));
    to.rect(Area::A1, Colour::dark_grey, {2, 2, 50, 50});
    const auto corner = static_cast<std::int16_t>((54 - side) / 2);
    to.rect(Area::A1, kWhite, {corner, corner, side, side});
  }
  if (mode == Mode::LS && display.LSSMA) {
    to.symbol(Area::A1, Picture::LS01);
    to.text(Area::A1, number_words(whole_kmh(*display.LSSMA)), kGrey, 12, Align::centre, 0);
  }
  const bool full = mode == Mode::FS || mode == Mode::AD || mode == Mode::SM;
  const bool reversing = mode == Mode::RV;
  if (!display.d_target || !(reversing || shows_target(display))) return;
  if (full || reversing) draw_bar(to, *display.d_target);
  const bool on_request = (mode == Mode::OS || mode == Mode::SR) && toggled_on(to.state);
  if (!full && !reversing && !on_request) return;
  if (mode == Mode::SR && kind_of(display) == Kinds::RSM) return;
  to.text(Area::A2, number_words(10 * std::int64_t{whole(display.d_target->si / 10.0, 0, 9999)}), kGrey, 10,
          Align::right, 10);
}

void draw_speed(const Drawing& to) {
  draw_dial(to);
  if (is_400(to.display) && to.display.ato.on && to.display.ato.advice_speed)
    draw_disc(to, *to.display.ato.advice_speed, Colour::medium_grey);
  if (to.display.set_speed) draw_disc(to, *to.display.set_speed, kWhite);
  draw_gauge(to);
  draw_hooks(to);
  draw_pointer(to);
  draw_release_digits(to);
}

}  // namespace evc::dmi
