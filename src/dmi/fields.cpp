#include <array>
#include <optional>

#include "dmi/acks.h"
#include "dmi/drawing.h"
#include "dmi/labels.h"
#include "openevc/terms/mode_symbol.h"

namespace evc::dmi {
namespace {

/// SN shows that of the national system (015560 8.1.1.2).
std::optional<Picture> mode_picture(Mode mode) {
  const std::optional<Symbol> of_mode = mode == Mode::SN ? std::nullopt : symbol(mode);
  return of_mode ? std::optional(picture_of(*of_mode)) : std::nullopt;
}

void draw_conditions(const Drawing& to) {
  constexpr std::array<Area, 3> kSlots{Area::B3, Area::B4, Area::B5};
  for (std::size_t slot = 0; slot < kSlots.size(); ++slot)
    for (const port::DisplayedCondition& condition : to.display.conditions)
      if (condition.id == to.state.slots[slot] && condition.id != 0) {
        to.symbol(kSlots[slot], condition.picture);
        break;
      }
}

/// Tunnel stopping area (015560 8.2.3.6).
void draw_tunnel(const Drawing& to) {
  if (!to.display.tunnel) return;
  if (!to.state.toggles.tunnel) return to.symbol(Area::C2_C3_C4, Picture::DR05);
  to.symbol(Area::C2, to.display.tunnel->inside ? Picture::TC36 : Picture::TC37);
  if (!to.display.tunnel->inside)
    to.text(Area::C3_C4, number_words(whole(to.display.tunnel->distance.si, 0, 99999)), Colour::grey, 12, Align::right,
            10);
}

void draw_level(const Drawing& to) {
  const port::Display& display = to.display;
  if (!display.level_valid) return;
  if (display.level == Level::NTC) {
    if (display.mode == Mode::SN || display.mode == Mode::NL) return;
    Item item = to.item(Kind::text_symbol, Area::C8, Colour::grey, {3, 3, 48, 19});
    item.picture = Picture::LE02;
    item.text = ntc_label(display, display.nid_ntc);
    item.height = 12;
    item.align = Align::centre;
    return to.add(item);
  }
  to.symbol(Area::C8, picture_of(symbol(display.level)));
}

/// A symbol of C1. In that of level NTC the abbreviation of the national system replaces the letters NTC, where the
/// display knows one (015560 8.2.3.2.9).
void draw_in_C1(const Drawing& to, Picture picture) {
  const port::Display& display = to.display;
  const std::uint8_t nid_ntc = display.announced_level ? display.announced_level->nid_ntc : display.nid_ntc;
  if ((picture != Picture::LE08 && picture != Picture::LE09) || !has_ntc_name(display, nid_ntc))
    return to.symbol(Area::C1, picture);
  const Rect area = rect_of(Area::C1);
  Item item = to.item(Kind::text_symbol, Area::C1, picture == Picture::LE09 ? Colour::yellow : Colour::grey,
                      {0, 0, area.w, area.h});
  item.picture = picture;
  item.text = ntc_label(display, nid_ntc);
  item.height = 12;
  item.align = Align::centre;
  to.add(item);
}

void draw_announcements(const Drawing& to) {
  const State& state = to.state;
  if (state.offered && place_of(state.offered->ack.what).frame == Area::C1) {
    if (const auto picture = ack_picture(state.display, state.offered->ack.what)) draw_in_C1(to, *picture);
  } else if (to.display.announced_level) {
    draw_in_C1(to, picture_of(announcement_symbol(to.display.announced_level->level, false)));
  }
  const bool brake_ack = state.offered && state.offered->ack.what == Ack::brake;
  if (to.display.brake || brake_ack) to.symbol(Area::C9, Picture::ST01);
}

Words time_words(std::uint32_t second_of_day) {
  Words time;
  append_number(time, second_of_day / 3600 % 24, 2);
  time.append(':');
  append_number(time, second_of_day / 60 % 60, 2);
  time.append(':');
  append_number(time, second_of_day % 60, 2);
  return time;
}

/// Geographical position (015560 8.4.4); its metres are 10 high.
void draw_geo(const Drawing& to) {
  if (!to.display.geo) return;
  if (!to.state.toggles.geo) return to.symbol(Area::G12, Picture::DR03);
  to.rect(Area::G12, Colour::grey, {0, 0, 120, 50}, "background");
  const std::int32_t metres = whole(to.display.geo->si, -9999999, 9999999);
  Words words;
  if (metres < 0) words.append('-');
  const std::int32_t size = metres < 0 ? -metres : metres;
  append_number(words, size / 1000);
  words.append(' ');
  append_number(words, size % 1000, 3);
  Item item = to.text_item(Area::G12, words, Colour::black, 12, Align::centre, 0);
  item.name.append("geo");
  to.add(item);
}

/// The dwell time (015560 8.5.5): "59s", "1:09".
void draw_dwell(const Drawing& to, std::uint16_t seconds) {
  Words words;
  if (seconds <= 59) {
    append_number(words, seconds);
    Item item = to.text_item(Area::G3, words, Colour::grey, 12, Align::right, 18);
    item.text.append('s');
    item.name.append("dwell");
    return to.add(item);
  }
  append_number(words, seconds / 60);
  words.append(':');
  append_number(words, seconds % 60, 2);
  to.text(Area::G3, words, Colour::grey, 12, Align::right, 11);
}

/// Automatic train operation in G1 to G5 (015560 8.5).
void draw_ato(const Drawing& to) {
  const port::DisplayedAto& ato = to.display.ato;
  if (!is_400(to.display) || !ato.on) return;
  const auto shifted = [](Picture first, auto value) {
    return static_cast<Picture>(static_cast<int>(first) + static_cast<int>(value) - 1);
  };
  if (ato.status != port::AtoStatus::none) to.symbol(Area::G1, shifted(Picture::ATO01, ato.status));
  if (ato.skip != port::AtoSkip::none) to.symbol(Area::G5, shifted(Picture::ATO17, ato.skip));
  const bool stopped = ato.stop != port::AtoStop::none || ato.doors != port::AtoDoors::none || ato.dwell_s || ato.hold;
  if (stopped) {
    if (ato.stop != port::AtoStop::none) to.symbol(Area::G2, shifted(Picture::ATO06, ato.stop));
    if (ato.hold)
      to.symbol(Area::G3, Picture::ATO09);
    else if (ato.dwell_s)
      draw_dwell(to, *ato.dwell_s);
    if (ato.doors != port::AtoDoors::none) to.symbol(Area::G4, shifted(Picture::ATO10, ato.doors));
    return;
  }
  if (ato.name_length == 0) return;
  Words name_words;
  for (std::size_t i = 0; i < ato.name_length && i < ato.name.size(); ++i) append_latin(name_words, ato.name[i]);
  Item line = to.text_item(Area::G2_G3_G4, name_words, Colour::grey, 12, Align::centre, 0);
  line.at = {0, 0, 147, 25};
  to.add(line);
  if (!ato.arrival_second_of_day) return;
  line.text = time_words(*ato.arrival_second_of_day);
  line.at.y = 25;
  to.add(line);
}

void draw_menu_buttons(const Drawing& to) {
  struct Row {
    Area area;
    const char* label;
    WindowId opens;
  };
  constexpr auto kRows =
      std::to_array<Row>({Row{Area::F1, "Main", WindowId::main}, Row{Area::F2, "Over-ride", WindowId::override_},
                          Row{Area::F3, "Data view", WindowId::data_view}, Row{Area::F4, "Spec", WindowId::special},
                          Row{Area::F5, "", WindowId::settings}});
  for (const Row& row : kRows) {
    Item button = to.item(Kind::button, row.area, Colour::grey, {0, 0, 60, 50});
    button.name.append(name(row.area));
    button.text.append(row.label);
    if (row.opens == WindowId::settings) button.picture = Picture::SE04;
    button.height = 12;
    button.align = Align::centre;
    button.border = Border::button;
    button.pressed = looks_pressed(to.state, {ActionKind::open, static_cast<std::uint8_t>(row.opens)}, to.now);
    to.add(button);
  }
}

}  // namespace

void draw_fields(const Drawing& to) {
  const port::Display& display = to.display;
  if (display.slippery_rail) to.symbol(Area::A4, Picture::ST02);
  draw_conditions(to);
  if (const auto picture = mode_picture(display.mode)) to.symbol(Area::B7, *picture);
  if (is_400(display) && display.sm && display.mode == Mode::SM)
    to.symbol(Area::B8, *display.sm == port::SmDirection::forward ? Picture::SM01 : Picture::SM02);
  else if (is_400(display) && display.ato.on && display.ato.coasting_advice)
    to.symbol(Area::B8, Picture::ATO20);
  draw_tunnel(to);
  draw_announcements(to);
  // Where both hold there is no precedence: reversing is on top.
  if (display.bmm_inhibited && is_400(display) && !display.reversing_permitted) to.symbol(Area::C6, Picture::ST07);
  if (display.reversing_permitted) to.symbol(Area::C6, Picture::ST06);
  if (display.override_active) to.symbol(Area::C7, Picture::MO03);
  draw_level(to);
  if (display.radio == RadioIndication::up) to.symbol(Area::E1, Picture::ST03);
  if (display.radio == RadioIndication::failed) to.symbol(Area::E1, Picture::ST04);
}

void draw_side(const Drawing& to) {
  draw_menu_buttons(to);
  draw_ato(to);
  draw_geo(to);
  if (to.display.second_of_day)
    to.text(Area::G13, time_words(*to.display.second_of_day), Colour::grey, 12, Align::centre, 0);
}

}  // namespace evc::dmi
