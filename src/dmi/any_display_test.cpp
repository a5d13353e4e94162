#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/entry.h"
#include "dmi/test_display.h"
#include "dmi/windows.h"

// For every display of the on-board and every place of a touch: no trap, nothing outside the screen's lists.
namespace evc::dmi {
namespace {

using port::Display;

/// Displays whose parts do not go together.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  bool one_in(int n) { return below(n) == 0; }
  double number(double most) {
    switch (below(12)) {
      case 0:
        return std::numeric_limits<double>::quiet_NaN();
      case 1:
        return std::numeric_limits<double>::infinity();
      case 2:
        return -most;
      case 3:
        return 1e300;
      default:
        return std::uniform_real_distribution<double>(0.0, most)(random_);
    }
  }
  template <class Q>
  std::optional<Q> maybe(double most) {
    if (one_in(3)) return std::nullopt;
    return Q{number(most)};
  }
  Display display(double now) {
    Display d;
    d.now = Duration{now};
    d.mode = static_cast<Mode>(below(19));
    d.level = static_cast<Level>(below(5));
    d.level_valid = one_in(2);
    d.nid_ntc = static_cast<std::uint8_t>(below(256));
    config(d);
    speeds(d);
    planning(d);
    symbols(d);
    texts(d, now);
    data(d);
    return d;
  }

 private:
  void config(Display& d) {
    d.config.srs = static_cast<SrsVersion>(below(3));
    d.config.dial = static_cast<port::Dial>(below(4));
    d.config.train_data_entry = static_cast<port::TrainDataEntry>(below(3));
    d.config.T_dispTTI = Duration{number(14)};
    d.config.asks_brake_percentage = !one_in(3);
    d.config.axle_loads = static_cast<std::uint16_t>(below(65536));
    d.config.categories = Set<TrainCategory>::of_bits(static_cast<std::uint64_t>(below(1 << 18)));
    d.config.L_TRAIN = {number(1000), number(5000), number(10), number(100), number(1000)};
    for (int i = below(17); i > 0; --i) {
      port::NtcName name{.nid_ntc = static_cast<std::uint8_t>(below(256))};
      for (char& c : name.characters) c = static_cast<char>(below(256));
      if (!d.config.ntc_names.push_back(name)) ADD_FAILURE();
    }
    for (int i = below(13); i > 0; --i)
      if (!d.config.languages.push_back(Language{{static_cast<char>(below(256)), 'n'}}) ||
          !d.config.train_types.push_back({}))
        ADD_FAILURE();
    for (int i = below(9); i > 0; --i)
      if (!d.config.cross_checks.push_back({d.config.categories, Speed{number(100)}, one_in(2)})) ADD_FAILURE();
  }
  void speeds(Display& d) {
    d.v = Speed{number(150)};
    d.monitoring = static_cast<Monitoring>(below(4));
    d.status = static_cast<Status>(below(6));
    d.V_P = maybe<Speed>(150), d.V_SBI = maybe<Speed>(150), d.V_target = maybe<Speed>(150),
    d.V_release = maybe<Speed>(20);
    d.target_information = one_in(2);
    d.d_target = maybe<Distance>(100000), d.TTI = maybe<Duration>(20), d.LSSMA = maybe<Speed>(150),
    d.set_speed = maybe<Speed>(150);
    d.MRDT = static_cast<std::uint8_t>(below(3));
  }
  void planning(Display& d) {
    for (int i = below(129); i > 0; --i)
      if (!d.planning.speeds.push_back({Distance{number(40000)}, Speed{number(120)}, {}})) ADD_FAILURE();
    for (int i = below(97); i > 0; --i)
      if (!d.planning.gradients.push_back(
              {Distance{number(40000)}, Distance{number(40000)}, static_cast<std::int16_t>(below(510) - 255)}))
        ADD_FAILURE();
    for (int i = below(98); i > 0; --i)
      if (!d.orders.push_back({static_cast<Picture>(below(256)), Distance{number(40000)}})) ADD_FAILURE();
    d.planning.EOA = maybe<Distance>(40000), d.planning.LOA = maybe<Distance>(40000);
    d.indication_marker = maybe<Distance>(40000), d.indication_target = maybe<Distance>(40000);
    d.track_ahead_free = one_in(4);
  }
  void symbols(Display& d) {
    d.standstill = one_in(2);
    d.brake = one_in(2), d.override_active = one_in(2), d.slippery_rail = one_in(2), d.reversing_permitted = one_in(2);
    if (one_in(2)) d.sm = static_cast<port::SmDirection>(below(2));
    if (one_in(2)) d.announced_level = port::AnnouncedLevel{static_cast<Level>(below(8)), 7};
    d.geo = maybe<Distance>(1e9);
    if (one_in(2)) d.second_of_day = static_cast<std::uint32_t>(below(1 << 30));
    for (int i = below(51); i > 0; --i)
      if (!d.conditions.push_back({static_cast<std::uint16_t>(below(60)), static_cast<Picture>(below(256)), {}}))
        ADD_FAILURE();
    if (one_in(2)) d.tunnel = port::TunnelStoppingArea{one_in(2), Distance{number(1e6)}};
    d.ato.on = one_in(2);
    d.ato.status = static_cast<port::AtoStatus>(below(6)), d.ato.stop = static_cast<port::AtoStop>(below(4));
    d.ato.doors = static_cast<port::AtoDoors>(below(8)), d.ato.skip = static_cast<port::AtoSkip>(below(4));
    d.ato.name_length = static_cast<std::uint8_t>(below(256));
    if (one_in(2)) d.ato.dwell_s = static_cast<std::uint16_t>(below(65536));
    d.ato.advice_speed = maybe<Speed>(100), d.ato.advice_change = maybe<Distance>(5000);
  }
  void texts(Display& d, double now) {
    for (int i = below(33); i > 0; --i) {
      port::DisplayedText text{.id = static_cast<std::uint16_t>(below(20)),
                               .kind = static_cast<port::TextKind>(below(4))};
      text.important = one_in(2), text.acknowledge = one_in(3), text.since = Duration{now - below(3)};
      text.status = static_cast<StatusText>(below(256)), text.Q_TEXT = static_cast<std::uint8_t>(below(256));
      text.length = static_cast<std::uint8_t>(below(256));
      for (char& c : text.characters) c = static_cast<char>(below(256));
      if (one_in(2)) text.minute_of_day = static_cast<std::uint16_t>(below(65536));
      if (!d.texts.push_back(text)) ADD_FAILURE();
    }
    for (int i = one_in(3) ? below(33) : 0; i > 0; --i)
      if (!d.acks.push_back(
              {static_cast<Ack>(below(12)), static_cast<std::uint16_t>(below(20)), Duration{now - below(5)}}))
        ADD_FAILURE();
  }
  void data(Display& d) {
    d.buttons = one_in(4) ? Set<Button>::of_bits(random_()) : test::all_buttons();
    d.start_of_mission = one_in(5);
    if (one_in(3)) d.step = static_cast<Dialogue>(below(40));
    if (one_in(4)) d.waiting = static_cast<port::Waiting>(below(10));
    port::ShownData& s = d.data.stored;
    for (DataStatus* status : {&s.driver_id_status, &s.train_running_number_status, &s.level_status, &s.rbc_status,
                               &s.train_status, &s.SR.status})
      *status = static_cast<DataStatus>(below(3));
    s.train_running_number = static_cast<std::uint32_t>(random_());
    s.rbc.NID_C = static_cast<std::uint16_t>(below(65536)), s.rbc.NID_RBC = static_cast<std::uint16_t>(below(65536));
    s.rbc.NID_RADIO = random_();
    s.train.L_TRAIN = Distance{number(5000)}, s.train.V_MAXTRAIN = Speed{number(100)},
    s.train.brake_percentage = number(300);
    s.SR.V = Speed{number(100)}, s.SR.D = maybe<Distance>(1e6);
    for (char& c : s.driver_id.characters) c = static_cast<char>(below(256));
    d.data.levels = static_cast<std::uint8_t>(below(256));
    for (int i = below(17); i > 0; --i)
      if (!d.data.ntcs.push_back(static_cast<std::uint8_t>(below(256))) ||
          !d.data.networks.push_back(static_cast<std::uint32_t>(random_())) ||
          !d.data.covers.push_back({static_cast<std::uint16_t>(below(65536)), static_cast<std::uint8_t>(below(256)),
                                    Duration{number(1e7)}, static_cast<std::uint8_t>(below(256))}))
        ADD_FAILURE();
    d.data.asks_one_radio_system = one_in(6);
    d.data.M_VERSION = static_cast<std::uint8_t>(below(256));
    if (one_in(2)) d.data.train_type = static_cast<std::uint8_t>(below(256));
  }
  std::mt19937_64 random_;
};

bool on_screen(const Rect& r) {
  return r.x >= 0 && r.y >= 0 && r.w > 0 && r.h > 0 && r.x + r.w <= 640 && r.y + r.h <= 480;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t size = c < 0x80 ? 1 : c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : c >= 0xC2 ? 2 : 0;
    if (size == 0 || i + size > text.size()) return false;
    for (std::size_t k = 1; k < size; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
    i += size;
  }
  return true;
}

void check_screen(const Screen& screen) {
  EXPECT_LT(screen.items.size(), Screen{}.items.capacity());
  EXPECT_LT(screen.touch.size(), Screen{}.touch.capacity());
  for (const Touch& touch : screen.touch) {
    EXPECT_TRUE(on_screen(touch.abs)) << touch.name.view();
    EXPECT_FALSE(touch.name.empty());
  }
  for (const Item& item : screen.items) {
    ASSERT_TRUE(is_utf8(item.text.view()) && is_utf8(item.name.view())) << name(item.kind) << " " << item.text.view();
    ASSERT_TRUE(std::isfinite(item.from_deg) && item.from_deg >= -149.0 && item.from_deg <= 144.0);
    const Rect abs = absolute(item);
    ASSERT_TRUE(abs.x >= -20 && abs.y >= -20 && abs.x + abs.w <= 660 && abs.y + abs.h <= 500)
        << name(item.kind) << " in " << name(item.area);
  }
}

TEST(AnyDisplay, AreasTileTheScreen) {
  std::vector<int> covered(640 * 480, 0);
  const auto cover = [&](Area first, Area last) {
    for (int a = static_cast<int>(first); a <= static_cast<int>(last); ++a) {
      const Rect r = rect_of(static_cast<Area>(a));
      for (int y = r.y; y < r.y + r.h; ++y)
        for (int x = r.x; x < r.x + r.w; ++x) ++covered[static_cast<std::size_t>(y * 640 + x)];
    }
  };
  cover(Area::Z, Area::Y), cover(Area::A1, Area::A4), cover(Area::B, Area::B), cover(Area::C1, Area::C9),
      cover(Area::D1, Area::D14);
  cover(Area::E1, Area::E11), cover(Area::F1, Area::F9), cover(Area::G1, Area::G13);
  for (std::size_t i = 0; i < covered.size(); ++i) ASSERT_EQ(covered[i], 1) << i % 640 << "," << i / 640;
}

TEST(AnyDisplay, EveryPlaceOfEveryWindowCanBeTouched) {
  Chance chance(1);
  for (int w = 0; w < static_cast<int>(WindowId::count); ++w)
    for (int round = 0; round < 2; ++round) {
      State ready;
      Display display = chance.display(100.0);
      display.acks.clear();
      display.waiting = port::Waiting::nothing;
      show(ready, display);
      open_window(ready, static_cast<WindowId>(w));
      check_screen(test::drawn(ready));
      for (int y = 3; y < 480; y += 24)
        for (int x = 3; x < 640; x += 24) {
          State state = ready;
          double seconds = 0.1;
          press(state, {x, y}, Duration{101.0});
          slide(state, {x + 1, y}, Duration{101.0 + seconds});
          seconds = state.pressed.target.type == ButtonType::delay ? 2.5 : seconds;
          release(state, Duration{101.0 + seconds});
          ASSERT_LT(state.window, WindowId::count);
          if (x % 96 == 3 && y % 96 == 3) check_screen(test::drawn(state));
        }
    }
}

TEST(AnyDisplay, RandomSessions) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Chance chance(seed);
    State state;
    double now = 100.0;
    Display display = chance.display(now);
    for (int cycle = 0; cycle < 300; ++cycle) {
      now += 0.2;
      if (chance.one_in(10)) display = chance.display(now);
      display.now = Duration{now};
      show(state, display);
      if (chance.one_in(20))
        display.acks.clear(), display.start_of_mission = false, display.waiting = port::Waiting::nothing;
      const Targets places = targets(state);
      Cell cell{chance.below(700) - 30, chance.below(540) - 30};
      if (!places.empty() && !chance.one_in(4))
        cell = test::middle(places[static_cast<std::size_t>(chance.below(static_cast<int>(places.size())))].abs);
      if (chance.one_in(2)) press(state, cell, Duration{now + 0.05});
      if (chance.one_in(4)) slide(state, {cell.x + chance.below(60), cell.y}, Duration{now + 0.08});
      if (!chance.one_in(4)) release(state, Duration{now + 0.1 + (chance.one_in(3) ? 2.1 : 0.0)});
      const Commands commands = take(state);
      EXPECT_EQ(commands.actions.selected >> static_cast<unsigned>(port::Select::count), 0u);
      if (cycle % 10 == 0) check_screen(test::drawn(state, Duration{now + 0.1}));
      ASSERT_LT(state.window, WindowId::count);
    }
  }
}

/// The buttons of the menus that send a selection (Tables 33 to 37).
struct Sender {
  port::Select select;
  Button button;
};
constexpr auto kSenders = std::to_array<Sender>({
    {port::Select::start, Button::start},
    {port::Select::override_, Button::eoa},
    {port::Select::shunting, Button::shunting},
    {port::Select::exit_shunting, Button::exit_shunting},
    {port::Select::non_leading, Button::non_leading},
    {port::Select::maintain_shunting, Button::maintain_shunting},
    {port::Select::train_data, Button::train_data},
    {port::Select::integrity_confirmed, Button::train_integrity},
    {port::Select::last_rbc, Button::contact_last_rbc},
    {port::Select::short_number, Button::use_short_number},
    {port::Select::radio_network, Button::gsmr_network_id},
    {port::Select::sm, Button::initiate_sm},
    {port::Select::continue_sm, Button::continue_sm},
    {port::Select::exit_sm, Button::exit_sm},
    {port::Select::bmm_inhibit, Button::bmm_inhibit},
    {port::Select::bmm_revoke, Button::bmm_revoke},
});

/// What the display may send: what `before`, the state at the last touch, enables.
void check_enabled(const Commands& commands, const State& before) {
  const Display& display = before.display;
  const port::DriverActions& done = commands.actions;
  for (const Sender& sender : kSenders)
    EXPECT_TRUE(!done.has(sender.select) || display.buttons.has(sender.button)) << name(sender.button);
  EXPECT_TRUE(!done.has(port::Select::track_ahead_free) || display.track_ahead_free);
  const bool may_toggle = display.mode == Mode::OS || display.mode == Mode::SR || display.mode == Mode::SH;
  EXPECT_TRUE(!done.has(port::Select::toggle) || may_toggle);
  EXPECT_FALSE(done.has(port::Select::isolate)) << "a device of its own";
  for (unsigned what = 0; what < static_cast<unsigned>(Ack::count); ++what) {
    bool asked = false;
    for (const port::AskedAck& ack : display.acks) asked = asked || ack.what == static_cast<Ack>(what);
    EXPECT_TRUE(asked || !done.has(static_cast<Ack>(what))) << what;
  }
  // The windows of Table 48 close with their button (11.7.1.7); in the start-up dialogue they are opened by it.
  const auto entered = [&](bool given, Button button) {
    EXPECT_TRUE(!given || display.start_of_mission || display.buttons.has(button)) << name(button);
  };
  entered(done.driver_id.has_value(), Button::driver_id);
  entered(done.level.has_value(), Button::level);
  entered(done.train_running_number.has_value(), Button::train_running_number);
  entered(commands.train_data.has_value(), Button::train_data);
  entered(done.rbc_contact.has_value(), Button::enter_rbc_data);
  entered(done.network.has_value(), Button::gsmr_network_id);
  entered(done.V_sr.has_value(), Button::sr_speed_distance);
  entered(done.language.has_value(), Button::language);
}

// Presses anywhere, any number, in any order: only what is enabled acts, and only at the place that was touched.
TEST(AnyDisplay, NothingThatIsNotEnabledActs) {
  std::size_t acted = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Chance chance(1000 + seed);
    State state;
    double now = 100.0;
    Display display = chance.display(now);
    for (int touch = 0; touch < 400; ++touch) {
      now += 0.3;
      if (chance.one_in(25)) display = chance.display(now);
      if (chance.one_in(6)) display.buttons = Set<Button>::of_bits(~std::uint64_t{0} >> chance.below(40));
      if (chance.one_in(8)) display.acks.clear(), display.waiting = port::Waiting::nothing;
      display.now = Duration{now};
      show(state, display);
      (void)take(state);
      const Targets places = targets(state);
      Cell cell{chance.below(640), chance.below(480)};
      if (!places.empty() && !chance.one_in(5))
        cell = test::middle(places[static_cast<std::size_t>(chance.below(static_cast<int>(places.size())))].abs);
      const Target* top = nullptr;
      for (const Target& place : places)
        if (top == nullptr && inside(place.abs, cell.x, cell.y)) top = &place;
      const State before = state;
      const bool hit = press(state, cell, Duration{now + 0.01});
      ASSERT_EQ(hit, !before.pressed.held && top != nullptr && top->enabled) << seed << " " << touch;
      if (!hit && !before.pressed.held) {
        const Commands commands = take(state);
        EXPECT_EQ(commands.actions.selected, 0u);
        EXPECT_EQ(commands.actions.acknowledged, 0u);
        EXPECT_TRUE(commands.sounds.empty());
        EXPECT_EQ(state.window, before.window);
      }
      if (chance.one_in(6)) slide(state, {chance.below(640), chance.below(480)}, Duration{now + 0.02});
      if (!chance.one_in(10)) {
        if (chance.one_in(3)) now += 2.5;
        release(state, Duration{now + 0.05});
      }
      const Commands commands = take(state);
      acted += commands.actions.selected != 0 || commands.actions.acknowledged != 0 ? 1u : 0u;
      check_enabled(commands, before);
      if (::testing::Test::HasFailure()) FAIL() << "seed " << seed << ", touch " << touch;
    }
  }
  EXPECT_GT(acted, 500u);
}

// Beside each other they would be read as one: of every dial, 120 and 140 of that up to 250 km/h are the nearest.
TEST(AnyDisplay, NumbersOfTheDialStandApart) {
  for (const port::Dial dial : {port::Dial::to_140, port::Dial::to_180, port::Dial::to_250, port::Dial::to_400}) {
    port::Display display = test::neutral();
    display.config.dial = dial;
    State state;
    show(state, display);
    const Screen screen = test::drawn(state);
    double right = -1000.0, low = 0.0;
    int numbers = 0;
    for (const Item& item : screen.items) {
      if (item.kind != Kind::dial_number) continue;
      const double angle = item.from_deg * 3.14159265358979 / 180.0;
      const double x = item.r_in * std::sin(angle) + item.w, y = -item.r_in * std::cos(angle);
      const double half = width_of(item.text.view(), 16, false) / 2.0;
      const bool beside = std::abs(y - low) < 8.0;
      EXPECT_TRUE(!beside || x - half > right + 0.5) << item.text.view();
      EXPECT_LE(std::abs(static_cast<double>(item.w)), 4.0);
      right = x + half;
      low = y;
      ++numbers;
    }
    EXPECT_GE(numbers, 7);
  }
}

TEST(AnyDisplay, SpeedsBeyondTheDialStandAtItsEnd) {
  State state;
  Display display = test::neutral(Mode::FS);
  display.v = Speed{200.0};
  display.monitoring = Monitoring::CSM;
  display.V_P = Speed{190.0};
  show(state, display);
  const Screen screen = test::drawn(state);
  for (const Item& item : screen.items) {
    if (item.kind == Kind::pointer) {
      EXPECT_EQ(item.from_deg, 144.0);
    }
    if (item.kind == Kind::digits) {
      EXPECT_EQ(item.text.view(), "720");
    }
  }
}

TEST(AnyDisplay, LogarithmIsRight) {
  for (double x = 1e-9; x < 1e12; x *= 1.37)
    EXPECT_NEAR(natural_logarithm(x), std::log(x), 1e-12 * std::max(1.0, std::abs(std::log(x))));
}

}  // namespace
}  // namespace evc::dmi
