#include "rules.h"

#include <algorithm>

namespace evc::exploration {
namespace {

constexpr Distance kPlace{1.0};         // two places that are the same: relocation, rounding of telegrams
constexpr Distance kFrontToBack{20.0};  // front end to the min safe antenna: L_antenna, location accuracy, a cycle
constexpr Distance kFreeRun{2.0};       // D_NVROLL
constexpr Speed kRounding{0.01};
constexpr Duration kCycle{0.1};
constexpr int kQuiet = 20;  // cycles in which an input has been answered, also by the radio link

bool any(Mode mode, std::initializer_list<Mode> of) { return std::find(of.begin(), of.end(), mode) != of.end(); }
/// 4.5.2: an authority is supervised.
bool supervises(Mode mode) { return any(mode, {Mode::FS, Mode::LS, Mode::OS, Mode::AD}); }
/// 4.10: those in which emergency stops are kept.
bool keeps_stops(Mode mode) {
  return any(mode, {Mode::FS, Mode::LS, Mode::OS, Mode::SR, Mode::UN, Mode::SN, Mode::TR, Mode::PT, Mode::AD});
}
bool has(const port::Outputs& now, What what) {
  return std::any_of(now.events.begin(), now.events.end(), [&](const port::Event& e) { return e.what == what; });
}
bool shows(const port::Outputs& now, Symbol symbol) {
  return std::find(now.symbols.begin(), now.symbols.end(), symbol) != now.symbols.end();
}
std::uint32_t signals_of(const port::Inputs& in) {
  const port::TrainSignals& t = in.train;
  std::uint32_t bits = static_cast<std::uint32_t>(t.direction_controller);
  for (const bool b : {t.powered, t.isolated, t.desk_open, t.sleeping, t.non_leading, t.passive_shunting,
                       t.antenna_alarm, t.consist.has_value(), in.safety_fault, in.automatic_operation.requests_AD,
                       in.automatic_operation.active, in.national_system.available != 0})
    bits = bits << 1 | (b ? 1u : 0u);
  return bits;
}
bool overridden(const port::Outputs& now) { return shows(now, Symbol::MO03); }

/// One cycle against what was known before it.
class Cycle {
 public:
  Cycle(Known& known, const port::Inputs& in, const port::Outputs& now, Applied& applied)
      : k_(known), in_(in), now_(now), applied_(applied) {}

  std::vector<std::string> look() {
    stops();
    authority();
    limits();
    movement();
    brakes_and_trip();
    requests();
    radio();
    k_.mode = now_.mode;
    return std::move(faults_);
  }

 private:
  void apply(Rule rule, bool holds, const std::string& what) {
    ++applied_[terms::index(rule)];
    if (!holds) faults_.push_back(std::string(name(rule)) + ": " + name(now_.mode) + " " + what);
  }

  void stops() {
    for (const port::Event& e : now_.events) {
      if (e.what == What::emergency_stop_unconditional) {
        apply(Rule::stop_trips, now_.mode == Mode::TR, "with an unconditional emergency stop");
        k_.stops.push_back(e.id);
      }
      if (e.what == What::emergency_stop_accepted) {
        k_.stops.push_back(e.id);
        if (k_.telling && k_.telling->stop && (!k_.stop || *k_.telling->stop < *k_.stop)) k_.stop = k_.telling->stop;
      }
      if (e.what == What::emergency_stop_revoked) std::erase(k_.stops, e.id);
    }
    if (!keeps_stops(now_.mode)) k_.stops.clear();
    if (k_.stops.empty()) k_.stop.reset();
    if (k_.stops.empty()) return;
    // In level 1 a group gives an authority all the same: 4.8.3 [5] is for that of an RBC.
    const bool fresh = has(now_, What::authority_accepted);
    const bool by_group = fresh && now_.level == Level::L1;
    if (by_group) k_.stop.reset();
    apply(Rule::stop_pending, !fresh || by_group, "accepts an authority while a stop is pending");
    if (k_.stop && now_.EOA) apply(Rule::stop_location, *now_.EOA <= *k_.stop + kPlace, "has an EOA beyond the stop");
  }

  void authority() {
    const bool supervised = supervises(now_.mode);
    if (supervised || now_.mode != Mode::SM)
      apply(Rule::authority_of_mode, supervised == now_.EOA.has_value(),
            supervised ? "without an authority" : "with an authority");
    const bool fresh = has(now_, What::authority_accepted);
    if (fresh) {
      k_.area = k_.telling ? k_.telling->area : std::nullopt;
      if (k_.area) k_.begin = k_.telling->begin;
    }
    if (supervised && now_.EOA && k_.EOA && !fresh && k_.mode == now_.mode)
      apply(Rule::growth, *now_.EOA <= *k_.EOA + kPlace, "has a longer authority without a new one");
    k_.EOA = now_.EOA;
    if (!supervised || !now_.EOA) {
      k_.area.reset();
      return;
    }
    // A.3.5.1: what was entered stays so.
    if (k_.area == now_.mode && now_.max_safe_front >= k_.begin) k_.area.reset();
    if (k_.area && k_.area != now_.mode && now_.max_safe_front < k_.begin)
      apply(Rule::area_ahead, *now_.EOA <= k_.begin + kPlace,
            std::string("has an EOA beyond the begin of ") + name(*k_.area));
    const Distance margin = kFrontToBack + now_.v * kCycle;
    if (!overridden(now_))
      apply(Rule::passed_end, now_.min_safe_front <= *now_.EOA + margin, "goes on beyond its authority");
    if (now_.est_front >= *now_.EOA + kPlace && now_.V_P)
      apply(Rule::standing_at_end, *now_.V_P <= now_.V_release.value_or(Speed{}) + kRounding,
            "permits a speed beyond the EOA");
  }

  void limits() {
    // V_P and the SBI limit may be held where they are shown (3.13.10.4.8), the warning limit is not: no order of
    // those.
    const auto in_order = [this](const std::optional<Speed>& lower, const std::optional<Speed>& upper) {
      if (lower && upper) apply(Rule::order_of_limits, *lower <= *upper + kRounding, "has limits in another order");
    };
    in_order(now_.V_P, now_.V_W);
    in_order(now_.V_P, now_.V_SBI);
    in_order(now_.V_W, now_.V_EBI);
    in_order(now_.V_SBI, now_.V_EBI);
    if (now_.V_P && now_.V_MRSP)
      apply(Rule::order_of_limits, *now_.V_P <= *now_.V_MRSP + kRounding, "permits more than the MRSP");
    if (now_.V_EBI && now_.v > *now_.V_EBI + kRounding)
      apply(Rule::too_fast, now_.eb, "above the EBI limit without emergency brake");
    // In AD the SBI limits command no brake (4.4.16.1.4 of 4.0.0).
    if (now_.V_SBI && now_.mode != Mode::AD && now_.v > *now_.V_SBI + kRounding)
      apply(Rule::too_fast, now_.eb || now_.sb, "above the SBI limit without a brake");
    if (!now_.V_P) return;
    // The default national values, and V_MAMODE and V_REVERSE of these worlds.
    double km_h = 0.0;
    switch (now_.mode) {
      case Mode::SR:
      case Mode::SM:
        km_h = 40.0;
        break;
      case Mode::SH:
      case Mode::OS:
      case Mode::LS:
      case Mode::RV:
        km_h = 30.0;
        break;
      case Mode::UN:
        km_h = 100.0;
        break;
      default:
        return;
    }
    apply(Rule::ceiling, *now_.V_P <= Speed{km_h / 3.6} + kRounding, "permits more than its speed");
  }

  /// Whether the movement is one that a protection of the mode allows for a short way only (4.5.2).
  bool forbidden() const {
    using port::DirectionController;
    const DirectionController controller = in_.train.direction_controller;
    const bool backward = in_.odometry.V_est < Speed{};
    const bool against =
        controller == DirectionController::neutral || backward == (controller == DirectionController::forward);
    switch (now_.mode) {
      case Mode::SB:
        return true;
      case Mode::FS:
      case Mode::LS:
      case Mode::OS:
      case Mode::AD:
      case Mode::SR:
        return against || backward;
      case Mode::SH:
      case Mode::UN:
        return against;
      case Mode::RV:
      case Mode::PT:
        return against || !backward;
      default:
        return false;
    }
  }

  void movement() {
    const Speed V = in_.odometry.V_est;
    const Distance run = (V < Speed{} ? -V : V) * kCycle;
    const bool turned = (V < Speed{}) != k_.backward;
    k_.backward = V < Speed{};
    // In SB the distance counts from one place, whichever way the train runs (3.14.4): after a turn it comes back there
    // first.
    const bool standstill_supervised = now_.mode == Mode::SB;
    if (turned && standstill_supervised) k_.free_run = -k_.free_run;
    if (run == Distance{} || now_.mode != k_.mode || now_.eb || (turned && !standstill_supervised) || !forbidden()) {
      k_.free_run = k_.longest_run = {};
      return;
    }
    k_.free_run += run;
    if (k_.longest_run < run) k_.longest_run = run;
    // What is run in the cycle of the beginning and in this one.
    apply(Rule::runs_unbraked, k_.free_run <= kFreeRun + 2.0 * k_.longest_run, "lets the train run unbraked");
  }

  void brakes_and_trip() {
    const bool braked = now_.tco || now_.sb || now_.eb;
    apply(Rule::brake_for_a_reason, braked != now_.brake_reasons.empty() || now_.mode == Mode::IS,
          braked ? "brakes for no reason" : "does not brake for a reason");
    const bool tripped = now_.mode == Mode::TR || now_.mode == Mode::PT;
    apply(Rule::trip_reason, tripped || !now_.trip_reason, "with a reason of a trip");
    if (now_.mode == Mode::TR) {
      apply(Rule::trip_reason, now_.trip_reason.has_value(), "without its reason");
      if (k_.mode == Mode::TR) apply(Rule::trip_reason, now_.trip_reason == k_.trip_reason, "changes its reason");
    }
    k_.trip_reason = now_.trip_reason;
  }

  /// Whether the answer to a request can lead to something in the mode.
  bool asked_here(Ack ack) const {
    const Mode mode = now_.mode;
    const bool starts = any(mode, {Mode::SB, Mode::PT, Mode::SM});
    const bool runs = supervises(mode);
    switch (ack) {
      case Ack::OS:
      case Ack::LS:
      case Ack::SH:
        return starts || runs || any(mode, {Mode::SR, Mode::UN, Mode::SN, Mode::SH});
      case Ack::SR:
      case Ack::UN:
      case Ack::SN:
        return mode != Mode::TR && mode != Mode::RV && mode != Mode::SH && mode != Mode::NL && mode != Mode::SF;
      case Ack::RV:
        return runs;
      case Ack::trip:
        return mode == Mode::TR;
      default:
        return !any(mode, {Mode::NP, Mode::SF, Mode::IS, Mode::SL, Mode::PS});
    }
  }

  void requests() {
    const bool nothing_new = quiet();
    for (unsigned i = 0; i < static_cast<unsigned>(Ack::count); ++i) {
      const auto ack = static_cast<Ack>(i);
      if (now_.requests.has(ack))
        apply(Rule::asked_in_mode, asked_here(ack), "asks to acknowledge " + std::string(kAckRows[i].name));
      if (nothing_new && k_.requests.has(ack))
        apply(Rule::asked_until_answered, now_.requests.has(ack),
              "asks no more to acknowledge " + std::string(kAckRows[i].name));
    }
    k_.requests = now_.requests;
  }

  /// Nothing came from outside for a while, and the train stood.
  bool quiet() {
    const port::DriverActions& d = in_.driver;
    const bool driver = d.selected != 0 || d.acknowledged != 0 || d.driver_id || d.level || d.train_running_number ||
                        d.train_data != nullptr || d.rbc_contact || in_.external_train_data.data != nullptr;
    const bool trackside = k_.telling || !in_.radio_messages.empty() || !in_.balise_telegrams.empty() ||
                           in_.radio_link != RadioLink::unchanged;
    const std::uint32_t signals = signals_of(in_);
    const bool moves = in_.odometry.V_est != Speed{} || now_.mode != k_.mode || now_.level != k_.level;
    k_.quiet = driver || trackside || moves || signals != k_.signals ? 0 : k_.quiet + 1;
    k_.signals = signals;
    k_.level = now_.level;
    return k_.quiet > kQuiet;
  }

  void radio() {
    if (now_.radio_out.empty()) return;
    apply(Rule::silent_without_radio, !now_.sessions.empty() || !now_.infill_sessions.empty(),
          "sends without a session");
  }

  Known& k_;
  const port::Inputs& in_;
  const port::Outputs& now_;
  Applied& applied_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> look(Known& known, const port::Inputs& in, const port::Outputs& now, Applied& applied) {
  return Cycle(known, in, now, applied).look();
}

}  // namespace evc::exploration
