// Any record of the display, also one that no on-board would give, and any touches: the driver-machine interface shows
// every cycle, its display list is drawn, and the same calls give the same screen.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

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

/// A screen with what a painter needs: places that are numbers.
void check_screen(const dmi::State& state, Duration now, dmi::Screen& screen, bool paint) {
  dmi::draw(state, now, screen);
  const dmi::Screen first = screen;
  dmi::draw(state, now, screen);
  check(first.items.size() == screen.items.size() && first.touch.size() == screen.touch.size());
  if (!paint) return;
  const std::string svg = paint::svg_of(screen);
  check(svg.find("nan") == std::string::npos && svg.find("inf") == std::string::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const auto state = std::make_unique<dmi::State>();
  const auto display = std::make_unique<port::Display>();
  const auto screen = std::make_unique<dmi::Screen>();
  double t = 0.0;
  for (int step = 0; step < 100 && bytes.left(); ++step) {
    t += bytes.next() / 64.0;
    const dmi::Cell at{bytes.next() * 4 - 100, bytes.next() * 2};
    switch (bytes.next() & 7u) {
      case 0:
        set_train(bytes, *display);
        break;
      case 1:
        set_lists(bytes, *display);
        break;
      case 2:
        set_dialogue(bytes, *display);
        break;
      case 3:
        dmi::slide(*state, at, {t});
        break;
      case 4:
        dmi::release(*state, {t});
        break;
      case 5:
        (void)dmi::take(*state);
        break;
      default:
        (void)dmi::press(*state, at, {t});
        dmi::release(*state, {t});
        break;
    }
    display->now = {t};
    dmi::show(*state, *display);
    check_screen(*state, {t}, *screen, (step & 15) == 0);
  }
  return 0;
}
