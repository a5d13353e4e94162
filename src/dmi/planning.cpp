#include <algorithm>

#include "dmi/drawing.h"
#include "dmi/geometry.h"

namespace evc::dmi {
namespace {

// Columns and rows of D7 and others are relative to those areas, which begin 15 cells below D.
constexpr std::int16_t kBelowD = 15;

/// What the objects of the planning area need to know.
struct Ahead {
  double range;  ///< metres
  double end;    ///< of the authority or the first target of zero speed, at most the range
  std::int16_t row(double metres) const {
    return static_cast<std::int16_t>(cells(planning_row(metres, range)) - kBelowD);
  }
};

/// The end of what is shown in metres: MA end or first target of zero speed (015560 8.3.6.2).
double planning_end(const port::Planning& planning, double range) {
  double end = range;
  if (planning.EOA) end = std::min(end, planning.EOA->si);
  if (planning.LOA) end = std::min(end, planning.LOA->si);
  for (const port::PlannedSpeed& step : planning.speeds)
    if (step.V <= Speed{}) {
      end = std::min(end, step.at.si);
      break;
    }
  return end > 0.0 ? end : 0.0;
}

void draw_scale(const Drawing& to, std::int32_t range) {
  constexpr std::array<std::int16_t, 9> kRows{283, 250, 206, 182, 164, 150, 107, 64, 21};
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    const bool thick = i == 0 || i == 5 || i == 8;
    to.rect(Area::D, thick ? Colour::medium_grey : Colour::dark_grey,
            {40, kRows[i], 200, static_cast<std::int16_t>(thick ? 2 : 1)});
  }
  struct Number {
    std::int16_t row;
    std::int32_t part;
  };
  for (const Number& number : {Number{283, 0}, Number{150, 8}, Number{107, 4}, Number{64, 2}, Number{21, 1}}) {
    Item text = to.item(Kind::text, Area::D1, Colour::medium_grey,
                        {0, static_cast<std::int16_t>(number.row - kBelowD - 5), 37, 10});
    text.text = number_words(number.part == 0 ? 0 : range / number.part);
    text.height = 10;
    text.align = Align::right;
    to.add(text);
  }
}

/// The quarters of the width for a speed below the ceiling speed at the front end (015560 8.3.7.7).
int quarters_of(Speed V, Speed ceiling) {
  if (!(V > Speed{}) || !(ceiling > Speed{})) return 0;
  const double part = V.si / ceiling.si + 1e-9;
  return part >= 0.75 ? 3 : part >= 0.5 ? 2 : 1;
}

void draw_step(const Drawing& to, const Ahead& ahead, double from, double until, int quarters) {
  if (!(until > from) || quarters == 0) return;
  constexpr std::array<std::int16_t, 5> kWidths{0, 23, 46, 70, 93};
  const std::int16_t top = ahead.row(until), bottom = ahead.row(from);
  Item step = to.item(Kind::pasp_step, Area::D7, Colour::pasp_light,
                      {0, top, kWidths[static_cast<std::size_t>(quarters)], static_cast<std::int16_t>(bottom - top)});
  step.from_m = whole(from, 0, 100000);
  step.to_m = whole(until, 0, 100000);
  step.number = static_cast<std::int16_t>(quarters);
  to.add(step);
}

/// The planning area speed profile (015560 8.3.7): up to three decreases below the ceiling at the front end, none after
/// an increase.
void draw_profile(const Drawing& to, const Ahead& ahead) {
  to.rect(Area::D7_D8, Colour::pasp_dark, {0, 0, 99, 270}, "background");
  const auto& speeds = to.display.planning.speeds;
  if (speeds.empty()) return;
  const Speed ceiling = speeds[0].V;
  double from = 0.0;
  int quarters = 4, decreases = 0;
  Speed before = ceiling;
  for (std::size_t i = 1; i < speeds.size() && decreases < 3; ++i) {
    const port::PlannedSpeed& step = speeds[i];
    if (step.V > before || !(step.V > Speed{}) || !(step.at.si < ahead.end)) break;
    before = step.V;
    if (!(step.V < ceiling)) continue;
    ++decreases;
    const int narrower = quarters_of(step.V, ceiling);
    if (narrower == quarters) continue;
    draw_step(to, ahead, from, step.at.si, quarters);
    from = step.at.si;
    quarters = narrower;
  }
  draw_step(to, ahead, from, ahead.end, quarters);
}

void draw_marker(const Drawing& to, const Ahead& ahead) {
  const port::Display& display = to.display;
  if (is_400(display) && display.ato.on && display.ato.advice_change && display.ato.advice_change->si <= ahead.end) {
    // Five dashes of ten cells, ten apart (015560 8.5.11.3).
    for (std::int16_t x = 0; x < 93; x = static_cast<std::int16_t>(x + 20))
      to.rect(Area::D7, Colour::grey,
              {x, static_cast<std::int16_t>(ahead.row(display.ato.advice_change->si) - 1),
               static_cast<std::int16_t>(std::min(10, 93 - x)), 2},
              "advice change");
  }
  if (!display.indication_marker || display.monitoring != Monitoring::CSM) return;
  const double at = display.indication_marker->si;
  if (!(at >= 0.0) || !(at <= ahead.end)) return;
  to.rect(Area::D7, display.mode == Mode::AD ? Colour::white : Colour::yellow,
          {0, static_cast<std::int16_t>(ahead.row(at) - 1), 93, 2}, "indication marker");
}

/// Orders and announcements in D2 to D4 (015560 8.3.4): neighbours in different columns, the nearer one on top.
void draw_orders(const Drawing& to, const Ahead& ahead) {
  constexpr std::array<Area, 3> kColumns{Area::D2, Area::D3, Area::D4};
  struct Mark {
    Picture picture{};
    double at = 0.0;
  };
  InplaceVector<Mark, 101> marks;
  const auto put = [&](Picture picture, double at) {
    if (!(at >= 0.0) || !(at <= ahead.end) || picture >= Picture::count) return;
    std::size_t place = marks.size();
    while (place > 0 && marks[place - 1].at > at) --place;
    if (!marks.insert(place, Mark{picture, at})) return;  // as many as a display can hold
  };
  for (const port::PlannedOrder& order : to.display.orders) put(order.picture, order.at.si);
  if (is_400(to.display) && to.display.ato.on)
    for (const Distance stop : to.display.ato.stopping_points) put(Picture::ATO21, stop.si);
  for (std::size_t i = marks.size(); i-- > 0;) {
    Item mark = to.item(Kind::symbol, kColumns[i % 3], Colour::none,
                        {2, static_cast<std::int16_t>(ahead.row(marks[i].at) - 20), 20, 20});
    mark.picture = marks[i].picture;
    to.add(mark);
  }
}

void draw_gradient(const Drawing& to, const Ahead& ahead, const port::PlannedGradient& element) {
  const double from = std::max(0.0, element.from.si), until = std::min(ahead.end, element.to.si);
  if (!(until > from)) return;
  const std::int16_t top = ahead.row(until), bottom = ahead.row(from);
  const auto height = static_cast<std::int16_t>(bottom - top);
  if (height < 1) return;
  const bool down = element.permille < 0;
  const Rect box{0, top, 18, height};
  const Colour ink = down ? Colour::white : Colour::black;
  to.rect(Area::D5, down ? Colour::dark_grey : Colour::grey, box, "gradient");
  Item edge = to.item(Kind::edge, Area::D5, down ? Colour::grey : Colour::white, box);
  edge.sides = kTop | kLeft;
  edge.w = 1;
  to.add(edge);
  edge.colour = Colour::black;
  edge.sides = kBottom;
  to.add(edge);
  const auto write = [&](const Words& words, std::int16_t y, const char* position) {
    Item text = to.item(Kind::text, Area::D5, ink, {0, y, 18, 10});
    text.text = words;
    text.height = 10;
    text.align = Align::centre;
    text.name.append(position);
    to.add(text);
  };
  // Where two signs would touch one another there is room for one (8.3.5.7).
  const bool signs = height > 14 && element.permille != 0, both = signs && height >= 24;
  const char* sign = down ? "-" : "+";
  if (both) write(sign, static_cast<std::int16_t>(top + 2), "top");
  if (signs && !both) write(sign, static_cast<std::int16_t>(top + height / 2 - 5), "middle");
  if (height > 44 || (height > 14 && element.permille == 0))
    write(number_words(down ? -std::int32_t{element.permille} : element.permille),
          static_cast<std::int16_t>(top + height / 2 - 5), "middle");
  if (both) write(sign, static_cast<std::int16_t>(bottom - 12), "bottom");
}

/// A speed discontinuity (015560 8.3.6) with its symbol.
struct Change {
  double at = 0.0;
  Speed V{};
  Picture picture{};
  bool increase() const { return picture == Picture::PL21; }
  /// PL21 lies under PL22, that under the target of the indication marker (8.3.6.9).
  int layer() const { return picture == Picture::PL21 ? 0 : picture == Picture::PL22 ? 1 : 2; }
};
using Changes = InplaceVector<Change, 130>;

/// Of one symbol the nearer is on top, as for orders (8.3.4.24), at one place the lower speed.
bool lies_under(const Change& a, const Change& b) {
  if (a.layer() != b.layer()) return a.layer() < b.layer();
  return a.at > b.at || (!(a.at < b.at) && a.V > b.V);
}

/// The upper row of the number: above the bar of an increase, else below.
std::int16_t number_row(const Ahead& ahead, const Change& change) {
  const std::int16_t row = ahead.row(change.at);
  return change.increase() ? static_cast<std::int16_t>(row - 10) : row;
}

/// `with_number`: no number on top of this one covers it.
void draw_change(const Drawing& to, const Ahead& ahead, const Change& change, bool with_number) {
  const std::int16_t row = ahead.row(change.at);
  // The lowest row of the symbol's bar is at the place: row 18 of PL21, row 4 of the others.
  Item symbol = to.item(Kind::symbol, Area::D6_D7, Colour::none,
                        {4, static_cast<std::int16_t>(row - (change.increase() ? 18 : 4)), 20, 20});
  symbol.picture = change.picture;
  to.add(symbol);
  if (!with_number) return;
  const Colour colour = change.picture == Picture::PL23   ? Colour::yellow
                        : change.picture == Picture::PL37 ? Colour::white
                                                          : Colour::grey;
  Item text = to.item(Kind::text, Area::D7, colour, {11, number_row(ahead, change), 40, 10});
  text.text = number_words(whole_kmh(change.V));
  text.height = 10;
  to.add(text);
}

/// Every change of the MRSP, and the end of the authority, in drawing order.
Changes changes_ahead(const port::Display& display, const Ahead& ahead) {
  const port::Planning& planning = display.planning;
  Changes changes;
  const auto put = [&](double at, Speed V, bool increase) {
    if (!(at >= 0.0) || !(at <= ahead.end)) return;
    const double away = display.indication_target ? at - display.indication_target->si : 1.0;
    const bool target =
        !increase && display.indication_target && display.monitoring == Monitoring::CSM && away < 0.5 && away > -0.5;
    const Picture aimed = display.mode == Mode::AD ? Picture::PL37 : Picture::PL23;
    const Change change{at, V, increase ? Picture::PL21 : target ? aimed : Picture::PL22};
    std::size_t place = changes.size();
    while (place > 0 && lies_under(change, changes[place - 1])) --place;
    if (!changes.insert(place, change)) return;  // they all fit
  };
  Speed before = planning.speeds.empty() ? Speed{} : planning.speeds[0].V;
  for (std::size_t i = 1; i < planning.speeds.size(); ++i) {
    const port::PlannedSpeed& step = planning.speeds[i];
    put(step.at.si, step.V, step.V > before);
    before = step.V;
  }
  if (planning.EOA) put(planning.EOA->si, Speed{}, false);
  if (planning.LOA) put(planning.LOA->si, planning.V_LOA, false);
  return changes;
}

/// Symbols may overlap; of numbers that would, only the one on top can be read, so the others are left out.
void draw_changes(const Drawing& to, const Ahead& ahead) {
  constexpr int kApart = 11;  // rows from one number to the next: its height and a free one
  const Changes changes = changes_ahead(to.display, ahead);
  InplaceVector<std::int16_t, 130> taken;  // the rows of numbers, from the top layer down
  std::array<bool, 130> numbered{};
  for (std::size_t i = changes.size(); i-- > 0;) {
    const std::int16_t row = number_row(ahead, changes[i]);
    const bool covered = std::any_of(
        taken.begin(), taken.end(), [row](std::int16_t other) { return row - other < kApart && other - row < kApart; });
    numbered[i] = !covered && taken.push_back(row);
  }
  for (std::size_t i = 0; i < changes.size(); ++i) draw_change(to, ahead, changes[i], numbered[i]);
}

}  // namespace

bool shows_planning(const State& state) {
  const Mode mode = state.display.mode;
  if (state.display.track_ahead_free) return false;
  return mode == Mode::FS || mode == Mode::SM || mode == Mode::AD || (mode == Mode::OS && state.toggles.speed);
}

void draw_planning(const Drawing& to) {
  if (to.display.track_ahead_free) {
    to.rect(Area::D, Colour::dark_grey, {0, 50, 162, 50}, "question");
    to.symbol(Area::D, Picture::DR02, {0, 50, 162, 50});
    Item border = to.item(Kind::border, Area::D, Colour::medium_grey, {0, 50, 162, 50});
    border.border = Border::field;
    to.add(border);
    to.rect(Area::D, Colour::medium_grey, {162, 50, 82, 50}, "answer");
    Item words = to.text_item(Area::D, "Yes", Colour::black, 12, Align::centre, 0);
    words.at = {162, 50, 82, 50};
    to.add(words);
    Item yes = to.item(Kind::button, Area::D, Colour::black, {162, 50, 82, 50});
    yes.name.append("Yes");
    yes.border = Border::field;
    yes.pressed = looks_pressed(to.state, {ActionKind::track_ahead_free, 0}, to.now);
    to.add(yes);
    return;
  }
  if (!shows_planning(to.state)) return;
  const std::int32_t range = kRanges[to.state.zoom % kRanges.size()];
  const Ahead ahead{double(range), planning_end(to.display.planning, range)};
  draw_profile(to, ahead);
  draw_scale(to, range);
  draw_marker(to, ahead);
  draw_orders(to, ahead);
  for (const port::PlannedGradient& element : to.display.planning.gradients) draw_gradient(to, ahead, element);
  draw_changes(to, ahead);
  to.symbol(Area::D9, to.state.zoom == 0 ? Picture::NA05 : Picture::NA03);
  to.symbol(Area::D12, to.state.zoom + 1u >= kRanges.size() ? Picture::NA06 : Picture::NA04);
}

}  // namespace evc::dmi
