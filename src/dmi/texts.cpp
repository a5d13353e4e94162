#include <array>

#include "dmi/acks.h"
#include "dmi/drawing.h"
#include "dmi/labels.h"

namespace evc::dmi {
namespace {

constexpr std::uint8_t kTextHeight = 12, kTimeHeight = 10;
constexpr double kTextFrom = 3 + 36 + 10;  // indent, time, gap (015560 8.2.3.4.6)
constexpr double kTextRoom = 234.0 - kTextFrom - 3.0;
constexpr std::size_t kLines = 5;

/// A whole text in UTF-8.
struct Content {
  std::array<char, 600> characters{};
  std::size_t size = 0;
  void append(std::string_view text) {
    for (const char c : text)
      if (size < characters.size()) characters[size++] = c;
  }
  std::string_view view() const { return {characters.data(), size}; }
};

void append_name(Content& content, const port::Display& display, std::uint8_t nid_ntc) {
  const Words label = ntc_label(display, nid_ntc);
  content.append(label.view());
}

Content content_of(const port::Display& display, const port::DisplayedText& text) {
  Content content;
  switch (text.kind) {
    case port::TextKind::fixed:
      content.append(fixed_text(text.Q_TEXT));
      return content;
    case port::TextKind::status: {
      if (text.status >= StatusText::count) return content;
      // Since 4.0.0 each radio system has its own text (015560 Table 68); FRMCS is none of this on-board.
      if (text.status == StatusText::network_registration_failed && is_400(display)) {
        content.append("GSM-R network registration failed");
        return content;
      }
      const Words named{name(text.status)};
      const std::string_view words = named.view();
      constexpr std::string_view kNational = "National system";
      if (names_national_system(text.status) && part_of(words, 0, kNational.size()) == kNational) {
        append_name(content, display, text.nid_ntc);
        content.append(part_of(words, kNational.size()));
      } else {
        content.append(words);
      }
      return content;
    }
    default:
      break;
  }
  for (std::size_t i = 0; i < text.length && i < text.characters.size(); ++i) {
    Text<2> character;
    append_latin(character, text.characters[i]);
    content.append(character.view());
  }
  return content;
}

struct TextLine {
  const port::DisplayedText* text;
  bool first;
  std::string_view words;
};

/// Calls `f` with each line of the text.
template <class F>
void each_line(const port::Display& display, const port::DisplayedText& text, F f) {
  const Content content = content_of(display, text);
  std::string_view rest = content.view();
  bool first = true;
  do {
    const std::size_t length = line_length(rest, kTextHeight, text.important, kTextRoom);
    f(TextLine{&text, first, part_of(rest, 0, length)});
    rest.remove_prefix(length);
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    first = false;
  } while (!rest.empty());
}

/// Whether `a` is above `b`: group 1 first, then the newer one.
bool above(const port::DisplayedText& a, const port::DisplayedText& b) {
  if (a.important != b.important) return a.important;
  return a.since > b.since;
}

bool waits_for_answer(const State& state, const port::DisplayedText& text) {
  if (!text.acknowledge) return false;
  for (const Answered& answered : state.answered)
    if (answered.ack.what == Ack::text && answered.ack.id == text.id) return false;
  return true;
}

using Order = InplaceVector<std::uint8_t, 32>;
/// The places of the texts that are shown, downwards.
Order order_of(const State& state) {
  Order order;
  if (text_ack_waits(state)) return order;
  const auto& texts = state.display.texts;
  for (std::size_t i = texts.size(); i-- > 0;) {
    if (waits_for_answer(state, texts[i])) continue;
    std::size_t place = 0;
    while (place < order.size() && !above(texts[i], texts[order[place]])) ++place;
    if (!order.insert(place, static_cast<std::uint8_t>(i))) break;  // as many as texts
  }
  return order;
}

std::size_t lines_of(const State& state) {
  std::size_t lines = 0;
  for (const std::uint8_t place : order_of(state))
    each_line(state.display, state.display.texts[place], [&](const TextLine&) { ++lines; });
  return lines;
}

void draw_line(const Drawing& to, const TextLine& line, std::size_t row) {
  const auto area = static_cast<Area>(static_cast<std::size_t>(Area::E5) + row);
  if (line.first && line.text->minute_of_day) {
    Words time;
    append_number(time, *line.text->minute_of_day / 60 % 24, 2);
    time.append(':');
    append_number(time, *line.text->minute_of_day % 60, 2);
    Item item = to.text_item(area, time, Colour::white, kTimeHeight, Align::left, 3);
    item.at = {0, 0, 39, 20};
    item.bold = line.text->important;
    to.add(item);
  }
  Item item = to.text_item(area, Words{line.words}, Colour::white, kTextHeight, Align::left, 0);
  item.at = {static_cast<std::int16_t>(kTextFrom), 0, static_cast<std::int16_t>(234 - kTextFrom), 20};
  item.bold = line.text->important;
  to.add(item);
}

/// The text whose acknowledgement is on offer.
port::DisplayedText asked_text(const port::Display& display, const port::AskedAck& ack) {
  for (const port::DisplayedText& text : display.texts) {
    const bool changed_data = text.kind == port::TextKind::status && text.status == StatusText::train_data_changed;
    if (ack.what == Ack::text ? text.id == ack.id || (ack.id == 0 && text.acknowledge) : changed_data) return text;
  }
  port::DisplayedText text;
  text.important = true;
  text.kind = ack.what == Ack::train_data ? port::TextKind::status : port::TextKind::fixed;
  text.status = StatusText::train_data_changed;
  text.Q_TEXT = 1;
  return text;
}

}  // namespace

bool can_scroll(const State& state, bool up) {
  if (state.offered && for_text(state.offered->ack.what)) return false;
  if (up) return state.scroll > 0;
  return state.scroll + kLines < lines_of(state);
}

void draw_texts(const Drawing& to) {
  const State& state = to.state;
  std::size_t row = 0;
  if (state.offered && for_text(state.offered->ack.what)) {
    const port::DisplayedText text = asked_text(state.display, state.offered->ack);
    each_line(state.display, text, [&](const TextLine& line) {
      if (row < kLines) draw_line(to, line, row);
      ++row;
    });
  } else {
    std::size_t skipped = 0;
    for (const std::uint8_t place : order_of(state))
      each_line(state.display, state.display.texts[place], [&](const TextLine& line) {
        if (skipped++ < state.scroll || row >= kLines) return;
        draw_line(to, line, row++);
      });
  }
  to.symbol(Area::E10, can_scroll(state, true) ? Picture::NA13 : Picture::NA15);
  to.symbol(Area::E11, can_scroll(state, false) ? Picture::NA14 : Picture::NA16);
}

}  // namespace evc::dmi
