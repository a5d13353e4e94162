// Any record of the display, also one that no on-board would give, and any touches: the driver-machine interface shows
// every cycle, its display list is drawn, and the same calls give the same screen.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "dmi/dmi.h"
#include "paint/svg.h"

namespace {

using namespace evc;

/// Reads the fuzzer's bytes; zeros when they are used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool left() const { return at_ < size_; }
  std::uint8_t next() { return at_ < size_ ? data_[at_++] : std::uint8_t{0}; }
  bool flag() { return (next() & 1u) != 0; }
  /// Sixteen bits, most of them near what a display shows; some are no number, or huge.
  double number() {
    const std::uint8_t kind = next();
    if (kind == 255) return 0.0 / kZero;
    if (kind == 254) return 1e300;
    if (kind == 253) return -1e300;
    const double value = kind * 256.0 + next();
    return (kind & 0x80) != 0 ? -value / 8.0 : value / 8.0;
  }
  template <class E>
  E any() {
    return static_cast<E>(next());
  }

 private:
  static inline volatile double kZero = 0.0;
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

template <class T>
void sometimes(Bytes& bytes, std::optional<T>& field) {
  field.reset();
  if (bytes.flag()) field = T{bytes.number()};
}

void check(bool holds) {
  if (!holds) std::abort();
}

/// Adds elements made by `make` until the bytes say no.
template <class List, class Make>
void fill(Bytes& bytes, List& list, Make make) {
  list.clear();
  while (bytes.left() && (bytes.next() & 3u) != 0)
    if (!list.push_back(make())) return;
}

void set_train(Bytes& bytes, port::Display& d) {
  d.mode = bytes.any<Mode>();
  d.level = bytes.any<Level>();
  d.level_valid = bytes.flag();
  d.standstill = bytes.flag();
  d.v = {bytes.number()};
  d.monitoring = bytes.any<Monitoring>();
  d.status = bytes.any<Status>();
  sometimes(bytes, d.V_P);
  sometimes(bytes, d.V_SBI);
  sometimes(bytes, d.V_target);
  sometimes(bytes, d.V_release);
  sometimes(bytes, d.d_target);
  sometimes(bytes, d.TTI);
  sometimes(bytes, d.LSSMA);
  sometimes(bytes, d.set_speed);
  sometimes(bytes, d.geo);
  d.target_information = bytes.flag();
  d.MRDT = bytes.next();
  d.config.dial = bytes.any<port::Dial>();
  d.config.srs = bytes.flag() ? SrsVersion::v4_0_0 : SrsVersion::v3_6_0;
  d.radio = bytes.any<RadioIndication>();
  d.brake = bytes.flag();
  d.track_ahead_free = bytes.flag();
}

void set_lists(Bytes& bytes, port::Display& d) {
  fill(bytes, d.planning.speeds, [&] { return port::PlannedSpeed{{bytes.number()}, {bytes.number()}, {}}; });
  fill(bytes, d.planning.gradients, [&] {
    return port::PlannedGradient{
        {bytes.number()}, {bytes.number()}, static_cast<std::int16_t>(bytes.number() < 0 ? -9 : 9)};
  });
  fill(bytes, d.orders, [&] { return port::PlannedOrder{bytes.any<Picture>(), {bytes.number()}}; });
  fill(bytes, d.conditions, [&] {
    return port::DisplayedCondition{bytes.next(), bytes.any<Picture>(), bytes.any<ConditionPhase>()};
  });
  fill(bytes, d.acks, [&] { return port::AskedAck{bytes.any<Ack>(), bytes.next(), {bytes.number()}}; });
  fill(bytes, d.texts, [&] {
    port::DisplayedText text;
    text.id = bytes.next();
    text.kind = bytes.any<port::TextKind>();
    text.important = bytes.flag();
    text.acknowledge = bytes.flag();
    text.status = bytes.any<StatusText>();
    text.length = bytes.next();
    for (std::size_t i = 0; i < 16; ++i) text.characters[i] = static_cast<char>(bytes.next());
    return text;
  });
}

void set_dialogue(Bytes& bytes, port::Display& d) {
  d.buttons = Set<Button>::of_bits(bytes.flag() ? ~std::uint64_t{0} : bytes.next());
  d.start_of_mission = bytes.flag();
  d.step.reset();
  if (bytes.flag()) d.step = bytes.any<Dialogue>();
  d.waiting = bytes.any<port::Waiting>();
  d.ato.on = bytes.flag();
  d.ato.status = bytes.any<port::AtoStatus>();
  d.ato.doors = bytes.any<port::AtoDoors>();
  d.ato.skip = bytes.any<port::AtoSkip>();
  d.ato.stop = bytes.any<port::AtoStop>();
  d.data.radio = bytes.any<port::RadioNetworkType>();
  d.data.levels = bytes.next();
}

/// FNV-1a: which of the costly checks an input takes.
std::uint64_t hash_of(const std::uint8_t* data, std::size_t size) {
  std::uint64_t hash = 14695981039346656037ull;
  for (std::size_t i = 0; i < size; ++i) hash = (hash ^ data[i]) * 1099511628211ull;
  return hash;
}

/// The objects are large: made once, and set to their first values for an input.
struct Objects {
  dmi::State state;
  port::Display display;
  dmi::Screen screen, again;
};

/// What the driver did is enabled by the record that the display has (015560 11.2, 5.4).
void check_commands(const dmi::Commands& commands, const port::Display& display) {
  const port::DriverActions& done = commands.actions;
  check((done.selected >> static_cast<unsigned>(port::Select::count)) == 0 && !done.has(port::Select::isolate));
  check(!done.has(port::Select::start) || display.buttons.has(Button::start));
  check(!done.has(port::Select::override_) || display.buttons.has(Button::eoa));
  check(!done.has(port::Select::shunting) || display.buttons.has(Button::shunting));
  check(!done.has(port::Select::track_ahead_free) || display.track_ahead_free);
  for (unsigned n = 0; n < static_cast<unsigned>(Ack::count); ++n) {
    bool asked = !done.has(static_cast<Ack>(n));
    for (const port::AskedAck& ack : display.acks) asked = asked || ack.what == static_cast<Ack>(n);
    check(asked);
  }
}

/// Whether a number of the picture is none. The words of the labels may be any.
bool names_no_number(const std::string& svg) {
  const std::string label = "aria-label=\"";
  for (std::size_t from = 0; from < svg.size();) {
    const std::size_t begin = std::min(svg.find(label, from), svg.size());
    const std::string_view drawn = std::string_view(svg).substr(from, begin - from);
    if (drawn.find("nan") != std::string_view::npos || drawn.find("inf") != std::string_view::npos) return true;
    if (begin == svg.size()) return false;
    const std::size_t end = svg.find('"', begin + label.size());
    if (end == std::string::npos) return true;
    from = end + 1;
  }
  return false;
}

/// The same state gives the same screen, which a painter can draw: its places are numbers.
void check_screen(Objects& o, Duration now, bool twice, bool paint) {
  dmi::draw(o.state, now, o.screen);
  check(!o.screen.items.full() && !o.screen.touch.full());
  if (twice) {
    dmi::draw(o.state, now, o.again);
    check(o.again.items.size() == o.screen.items.size() && o.again.touch.size() == o.screen.touch.size());
  }
  if (!paint) return;
  const std::string svg = paint::svg_of(o.screen);
  check(!names_no_number(svg));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto objects = std::make_unique<Objects>();
  Objects& o = *objects;
  o.state = dmi::State{};
  o.display = port::Display{};
  Bytes bytes(data, size);
  const std::uint64_t hash = hash_of(data, size);
  double t = 0.0;
  for (int step = 0; step < 100 && bytes.left(); ++step) {
    t += bytes.next() / 64.0;
    const dmi::Cell at{bytes.next() * 4 - 100, bytes.next() * 2};
    const std::uint8_t kind = bytes.next() & 7u;
    switch (kind) {
      case 0:
        set_train(bytes, o.display);
        break;
      case 1:
        set_lists(bytes, o.display);
        break;
      case 2:
        set_dialogue(bytes, o.display);
        break;
      case 3:
        dmi::slide(o.state, at, {t});
        break;
      case 4:
        dmi::release(o.state, {t});
        break;
      case 5:
        break;
      default:
        (void)dmi::press(o.state, at, {t});
        if (kind == 7) dmi::release(o.state, {t});
        break;
    }
    if (kind >= 3) check_commands(dmi::take(o.state), o.state.display);
    // A cycle of the on-board; between two of them there may be several touches.
    if (kind != 5 && kind != 3) {
      o.display.now = {t};
      dmi::show(o.state, o.display);
    }
    if (((hash >> (step & 31)) & 7u) == 0) check_screen(o, {t}, (hash & 0xF0000u) == 0, false);
  }
  check_screen(o, {t}, (hash & 0xF00000u) == 0, (hash & 0x3F000000u) == 0);
  return 0;
}
