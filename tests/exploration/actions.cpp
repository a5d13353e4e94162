#include "actions.h"

#include <tuple>

namespace evc::exploration {
namespace {

constexpr int kAnswered = 3;  // cycles after an input

using Act = std::function<void(Runner&)>;

Act select(port::Select what) {
  return [what](Runner& r) {
    r.inputs().driver.selected = 1u << static_cast<unsigned>(what);
    r.run(kAnswered);
  };
}
/// A change of the signals that last.
Act with(std::function<void(port::Inputs&)> change, int cycles = kAnswered) {
  return [change, cycles](Runner& r) {
    change(r.inputs());
    r.run(cycles);
  };
}
Act moves(double m_s, int cycles) {
  return with([m_s](port::Inputs& in) { in.odometry.V_est = in.odometry.V_min = in.odometry.V_max = Speed{m_s}; },
              cycles);
}
Act level(Level level) {
  return [level](Runner& r) {
    r.inputs().driver.level = level;
    r.inputs().driver.nid_ntc = level == Level::NTC ? 1 : 0;
    r.run(kAnswered);
  };
}
Act contact() {
  return [](Runner& r) {
    r.inputs().driver.rbc_contact = {.NID_C = 1, .NID_RBC = 1, .NID_RADIO = 0x1234FFFFFFFFFFFF};
    r.run(kAnswered);
  };
}
void acknowledge(Runner& r, bool all) {
  const std::uint64_t asked = r.world().out.requests.bits();
  r.inputs().driver.acknowledged = static_cast<std::uint32_t>(all ? asked : asked & (~asked + 1));
  r.run(kAnswered);
}
void connected_with(Runner& r, std::uint64_t M_VERSION) {
  if (r.world().calling) {
    r.inputs().radio_link = RadioLink::connected;
    r.world().calling = false;
  }
  r.run(kAnswered);
  r.receive(32, {{"M_VERSION", M_VERSION}});
}
void connected(Runner& r) { connected_with(r, 33); }
/// An RBC of version 2.3 acknowledges the session too (3.5.3.7.4 of 4.0.0).
void connected_2_3(Runner& r) {
  connected_with(r, 35);
  r.receive(38);
}
Act link(RadioLink what) {
  return [what](Runner& r) {
    r.inputs().radio_link = what;
    r.world().calling = false;
    r.run(kAnswered);
  };
}
/// Up to 3 m beyond the EOA, whether braked or not, and stops there.
void runs_to_end(Runner& r) {
  constexpr double kBeyond = 3.0;
  constexpr int kCycles = 800;
  const auto left = [&r] {
    const port::Outputs& out = r.world().out;
    return out.EOA ? (*out.EOA - out.est_front).si + kBeyond : 0.0;
  };
  for (int i = 0; i < kCycles && left() > 0.0; ++i) moves(left() > 100.0 ? 40.0 : 5.0, 1)(r);
  moves(0.0, 5)(r);
}
void enter_driver_id(Runner& r) {
  r.inputs().driver.driver_id = DriverId("1234");
  r.run(kAnswered);
}
void enter_train_running_number(Runner& r) {
  r.inputs().driver.train_running_number = 0x4711FFFF;
  r.run(kAnswered);
}
void enter_train_data(Runner& r) {
  r.enter_train_data();
  r.run(kAnswered);
}

BitList one(unsigned NID_PACKET, const Codes& codes) {
  BitList p;
  put(p, NID_PACKET, codes);
  return p;
}
BitList end_of_session() { return one(42, {{"Q_RBC", 0}, {"NID_RADIO", ~std::uint64_t{0}}}); }

/// Authority of `metres` with gradient and speeds, in a message (15) or from a group (12).
BitList authority(unsigned NID_PACKET, std::uint64_t metres) {
  BitList p;
  put(p, NID_PACKET, {{"L_ENDSECTION", metres}});
  put(p, 21);
  put(p, 27);
  return p;
}
/// A change to level 1 here, with the authority for it.
BitList level_1_with(BitList authority) {
  BitList p;
  put(p, 41, {{"D_LEVELTR", 32767}, {"M_LEVELTR", 2}, {"L_ACKLEVELTR", 0}});
  through_step::append(p, authority);
  return p;
}
BitList with_mode(unsigned NID_PACKET, std::uint64_t M_MAMODE, std::uint64_t D_MAMODE,
                  std::uint64_t L_ACKMAMODE = 300) {
  BitList p = authority(NID_PACKET, 2000);
  put(p, 80,
      {{"M_MAMODE", M_MAMODE},
       {"D_MAMODE", D_MAMODE},
       {"V_MAMODE", 6},
       {"L_MAMODE", 500},
       {"L_ACKMAMODE", L_ACKMAMODE},
       {"Q_MAMODE", 1}});
  return p;
}
BitList reversing() {
  BitList p = one(138, {{"D_STARTREVERSE", 0}, {"L_REVERSEAREA", 500}});
  put(p, 139, {{"D_REVERSE", 1000}, {"V_REVERSE", 6}});
  return p;
}
Act group(std::function<BitList()> packets, Ahead ahead = {}) {
  return [packets, ahead](Runner& r) { r.pass(packets(), false, ahead); };
}
Act message(unsigned NID_MESSAGE, std::function<BitList()> packets = {}, Codes codes = {}, unsigned answers = 0,
            Ahead ahead = {}) {
  return [=](Runner& r) {
    Codes all = codes;
    if (answers != 0) all["T_TRAIN_REF"] = r.asked(answers);
    r.receive(NID_MESSAGE, all, packets ? packets() : BitList{}, ahead);
  };
}
/// What a group or message has beside the packets of `with_mode`.
Ahead of(Mode area, double D_MAMODE) { return {.area = area, .D_MAMODE = D_MAMODE}; }
/// A text that has to be acknowledged, for ever.
BitList text() {
  return one(76, {{"Q_TEXTCLASS", 1},
                  {"Q_TEXTDISPLAY", 0},
                  {"D_TEXTDISPLAY", 0},
                  {"M_MODETEXTDISPLAY_START", 15},
                  {"M_LEVELTEXTDISPLAY_START", 5},
                  {"M_MODETEXTDISPLAY_END", 15},
                  {"M_LEVELTEXTDISPLAY_END", 5},
                  {"L_TEXTDISPLAY", 32767},
                  {"T_TEXTDISPLAY", 1023},
                  {"Q_TEXTCONFIRM", 1},
                  {"Q_TEXT", 1}});
}
/// Level 0 or another one 200 m ahead, announced at once.
BitList level_ahead(std::uint64_t M_LEVELTR) {
  return one(41, {{"D_LEVELTR", 200}, {"M_LEVELTR", M_LEVELTR}, {"L_ACKLEVELTR", 300}});
}
Act all_of(std::vector<Act> acts) {
  return [acts = std::move(acts)](Runner& r) {
    for (const Act& act : acts) act(r);
  };
}

void add_train(std::vector<Action>& a) {
  a.push_back({"desk opened", with([](port::Inputs& in) { in.train.desk_open = true; }, 12)});
  a.push_back({"desk closed", with([](port::Inputs& in) { in.train.desk_open = false; })});
  a.push_back({"controller backward",
               with([](port::Inputs& in) { in.train.direction_controller = port::DirectionController::backward; })});
  a.push_back({"controller neutral",
               with([](port::Inputs& in) { in.train.direction_controller = port::DirectionController::neutral; })});
  a.push_back({"controller forward",
               with([](port::Inputs& in) { in.train.direction_controller = port::DirectionController::forward; })});
  a.push_back({"sleeping", with([](port::Inputs& in) { in.train.sleeping = !in.train.sleeping; })});
  a.push_back({"non leading", with([](port::Inputs& in) { in.train.non_leading = !in.train.non_leading; })});
  a.push_back(
      {"passive shunting", with([](port::Inputs& in) { in.train.passive_shunting = !in.train.passive_shunting; })});
  a.push_back({"antenna alarm begins or ends",
               with([](port::Inputs& in) { in.train.antenna_alarm = !in.train.antenna_alarm; })});
  a.push_back({"stops", moves(0.0, 5)});
  a.push_back({"drives at 5 m/s", moves(5.0, 20)});
  a.push_back({"drives at 40 m/s", moves(40.0, 20)});
  a.push_back({"rolls back", moves(-1.0, 40)});
  a.push_back({"runs to the end of its authority", runs_to_end});
  a.push_back({"waits 5 s", with([](port::Inputs&) {}, 50)});
  a.push_back({"waits 70 s", with([](port::Inputs&) {}, 700)});
  a.push_back({"power off", with([](port::Inputs& in) { in.train.powered = false; })});
  a.push_back({"power on", with([](port::Inputs& in) {
                 in.train.powered = true;
                 in.moved = false;
               })});
  a.push_back({"isolated", with([](port::Inputs& in) { in.train.isolated = true; })});
  a.push_back({"fault", [](Runner& r) {
                 r.inputs().safety_fault = true;
                 r.cycle();
                 r.inputs().safety_fault = false;
                 r.world().failed = true;
                 r.run(kAnswered);
               }});
  a.push_back({"national system present", with([](port::Inputs& in) { in.national_system.available = 2; })});
  a.push_back({"automatic operation on or off", with([](port::Inputs& in) {
                 auto& ato = in.automatic_operation;
                 ato = {.requests_AD = !ato.requests_AD, .active = !ato.active};
               })});
  a.push_back({"train data from outside", [](Runner& r) {
                 r.world().in.external_train_data = r.config().train;
                 r.run(kAnswered);
               }});
}

void add_driver(std::vector<Action>& a) {
  using port::Select;
  for (const auto& [name, what] :
       std::initializer_list<std::pair<const char*, Select>>{{"selects start", Select::start},
                                                             {"selects override", Select::override_},
                                                             {"selects shunting", Select::shunting},
                                                             {"selects exit shunting", Select::exit_shunting},
                                                             {"selects non leading", Select::non_leading},
                                                             {"selects train data", Select::train_data},
                                                             {"selects isolation", Select::isolate},
                                                             {"selects track ahead free", Select::track_ahead_free},
                                                             {"confirms integrity", Select::integrity_confirmed},
                                                             {"disengages automatic driving", Select::ato_disengage},
                                                             {"asks for a supervised manoeuvre", Select::sm}})
    a.push_back({name, select(what)});
  a.push_back({"drives on and engages automatic driving",  // the text "Entering FS" has to have ended
               all_of({with([](port::Inputs& in) { in.automatic_operation = {.requests_AD = true, .active = true}; }),
                       moves(30.0, 150), select(Select::ato_engage)})});
  a.push_back({"enters driver ID", enter_driver_id});
  a.push_back({"enters level 0", level(Level::L0)});
  a.push_back({"enters level NTC", level(Level::NTC)});
  a.push_back({"enters level 1", level(Level::L1)});
  a.push_back({"enters level 2", level(Level::L2)});
  a.push_back({"enters RBC", contact()});
  a.push_back({"enters train data", enter_train_data});
  a.push_back({"enters train running number", enter_train_running_number});
  a.push_back({"acknowledges one", [](Runner& r) { acknowledge(r, false); }});
  a.push_back({"acknowledges all", [](Runner& r) { acknowledge(r, true); }});
  a.push_back(
      {"leaves with continue shunting",  // nothing shows that it was selected
       all_of({select(Select::maintain_shunting), with([](port::Inputs& in) { in.train.desk_open = false; })})});
  const Act data = all_of({enter_train_data, enter_train_running_number});
  a.push_back({"prepares level 0", all_of({enter_driver_id, level(Level::L0), data})});
  a.push_back({"prepares level NTC", all_of({with([](port::Inputs& in) { in.national_system.available = 2; }),
                                             enter_driver_id, level(Level::NTC), data})});
  a.push_back({"prepares level 1", all_of({enter_driver_id, level(Level::L1), data})});
  const Act level_2 =
      all_of({enter_driver_id, level(Level::L2), contact(), connected, message(41), data, message(8, {}, {}, 129)});
  a.push_back({"prepares level 2", level_2});
  a.push_back({"prepares level 2 beyond a group",
               all_of({group([] { return BitList{}; }), moves(0.0, 10), [](Runner& r) { acknowledge(r, true); },
                       level_2, select(port::Select::start)})});
}

void add_radio(std::vector<Action>& a) {
  a.push_back({"session established", connected});
  a.push_back({"radio lost", link(RadioLink::lost)});
  a.push_back({"radio refused", link(RadioLink::refused)});
  a.push_back({"train accepted", message(41)});
  a.push_back({"train rejected", message(40)});
  a.push_back({"position confirmed", message(43)});
  a.push_back({"train data acknowledged", message(8, {}, {}, 129)});
  a.push_back({"SR authorised", message(2, {}, {{"D_SR", 32767}})});
  a.push_back({"authority of the RBC", message(3, [] { return authority(15, 2000); })});
  a.push_back({"authority, on sight now", message(
                                              3, [] { return with_mode(15, 0, 0); }, {}, 0, of(Mode::OS, 0.0))});
  a.push_back(
      {"authority, limited supervision now", message(
                                                 3, [] { return with_mode(15, 2, 0); }, {}, 0, of(Mode::LS, 0.0))});
  a.push_back({"authority, shunting now", message(
                                              3, [] { return with_mode(15, 1, 0); }, {}, 0, of(Mode::SH, 0.0))});
  a.push_back({"authority, on sight ahead", message(
                                                3, [] { return with_mode(15, 0, 200); }, {}, 0, of(Mode::OS, 200.0))});
  a.push_back({"exit from trip recognised", message(6)});
  a.push_back({"emergency stop", message(16, {}, {{"NID_EM", 1}})});
  a.push_back({"emergency stop revoked", message(18, {}, {{"NID_EM", 1}})});
  a.push_back({"short authority of the RBC", message(3, [] { return authority(15, 150); })});
  a.push_back({"RBC asks to shorten the authority", message(9, [] { return authority(15, 300); })});
  a.push_back({"emergency stop ahead", message(15, {}, {{"NID_EM", 2}, {"Q_DIR", 1}, {"D_EMERGENCYSTOP", 300}}, 0,
                                               {.D_EMERGENCYSTOP = 300.0})});
  a.push_back({"authority of the RBC, emergency stop ahead",
               all_of({message(3, [] { return authority(15, 2000); }),
                       message(15, {}, {{"NID_EM", 2}, {"Q_DIR", 1}, {"D_EMERGENCYSTOP", 300}}, 0,
                               {.D_EMERGENCYSTOP = 300.0})})});
  a.push_back({"emergency stop ahead revoked", message(18, {}, {{"NID_EM", 2}})});
  a.push_back({"shunting refused", message(27, {}, {}, 130)});
  a.push_back({"shunting authorised", message(28, {}, {}, 130)});
  a.push_back({"termination acknowledged", message(39)});
  a.push_back({"stops in a reversing area of the RBC", all_of({message(24, reversing), moves(0.0, 10)})});
  a.push_back({"level 1 of the RBC", message(24, [] {
                 return one(41, {{"D_LEVELTR", 0}, {"M_LEVELTR", 2}, {"L_ACKLEVELTR", 0}});
               })});
  a.push_back({"session ends, says the RBC", message(24, end_of_session)});
}

void add_groups(std::vector<Action>& a) {
  a.push_back({"group", group([] { return BitList{}; })});
  a.push_back({"group that cannot be read", [](Runner& r) { r.pass({}, true); }});
  a.push_back({"authority of a group", group([] { return authority(12, 2000); })});
  a.push_back({"group, on sight now", group([] { return with_mode(12, 0, 0); }, of(Mode::OS, 0.0))});
  a.push_back({"group, on sight ahead", group([] { return with_mode(12, 0, 200); }, of(Mode::OS, 200.0))});
  a.push_back({"group, limited supervision now", group([] { return with_mode(12, 2, 0); }, of(Mode::LS, 0.0))});
  a.push_back({"group, shunting now", group([] { return with_mode(12, 1, 0); }, of(Mode::SH, 0.0))});
  a.push_back({"group, level 1 and authority", group([] { return level_1_with(authority(12, 2000)); })});
  a.push_back(
      {"group, level 1 and on sight", group([] { return level_1_with(with_mode(12, 0, 0)); }, of(Mode::OS, 0.0))});
  a.push_back({"group, level 1 and limited supervision",
               group([] { return level_1_with(with_mode(12, 2, 0)); }, of(Mode::LS, 0.0))});
  a.push_back(
      {"group ends shunting at the opening of the desk, desk opened",  // stored, not shown
       all_of({group([] { return one(135, {}); }), with([](port::Inputs& in) { in.train.desk_open = true; })})});
  // The window begins 13 m beyond the group: it is entered, and left again by rolling back.
  for (const auto& [name, M_MAMODE, mode] : std::initializer_list<std::tuple<const char*, std::uint64_t, Mode>>{
           {"group, on sight ahead, acknowledged in its window", 0, Mode::OS},
           {"group, limited supervision ahead, acknowledged in its window", 2, Mode::LS}})
    a.push_back({name, all_of({group([M = M_MAMODE] { return with_mode(12, M, 100, 82); }, of(mode, 100.0)),
                               moves(5.0, 20), [](Runner& r) { acknowledge(r, true); }})});
  a.push_back({"short authority of a group", group([] { return authority(12, 150); })});
  a.push_back({"text to be acknowledged", group(text)});
  a.push_back({"group, level 0 ahead", group([] { return level_ahead(0); })});
  a.push_back({"group, level 1 ahead", group([] { return level_ahead(2); })});
  a.push_back({"signal at danger", group([] { return one(12, {{"V_MAIN", 0}, {"L_ENDSECTION", 0}}); })});
  a.push_back({"danger for shunting", group([] { return one(132, {{"Q_ASPECT", 0}}); })});
  a.push_back({"stop if in SR", group([] { return one(137, {{"Q_SRSTOP", 0}}); })});
  a.push_back({"stops in a reversing area", all_of({group(reversing), moves(0.0, 10)})});  // it is shown then
  for (const auto& [name, M_LEVELTR] : std::initializer_list<std::pair<const char*, std::uint64_t>>{
           {"level 0", 0}, {"level NTC", 1}, {"level 1", 2}, {"level 2", 3}}) {
    Codes codes{{"D_LEVELTR", 32767}, {"M_LEVELTR", M_LEVELTR}, {"L_ACKLEVELTR", 0}};
    if (M_LEVELTR == 1) codes["NID_NTC"] = 1;
    a.push_back({std::string("group, ") + name + " now", group([codes] { return one(41, codes); })});
  }
  a.push_back({"group, session with the RBC", group([] {
                 return one(42, {{"Q_RBC", 1}, {"NID_RBC", 1}, {"NID_RADIO", 0x1234FFFFFFFFFFFF}});
               })});
}

/// A consist of 200 m, of which `in_front` are in front of the engine.
Act consist(double in_front) {
  const auto exactly = [](double metres) { return ConsistEnd{Distance{metres}, Distance{metres}, Distance{metres}}; };
  return with([=](port::Inputs& in) {
    in.train.consist = ConsistLength{.front = exactly(in_front), .rear = exactly(200.0 - in_front)};
  });
}
/// The reference is D_REF beyond the LRBG, so that an authority in either direction begins beyond the train.
Act authorises_manoeuvre(std::uint64_t Q_DIR, std::uint64_t D_REF) {
  const auto packets = [=] {
    BitList p;
    put(p, 15, {{"Q_DIR", Q_DIR}, {"L_ENDSECTION", 3000}});
    put(p, 21, {{"Q_DIR", Q_DIR}});
    put(p, 27, {{"Q_DIR", Q_DIR}});
    return p;
  };
  return message(4, packets, {{"D_REF", D_REF}, {"V_SM", 8}}, 131);
}

/// What only the supervised manoeuvre of 4.0.0 has, under an RBC of 2.3 (3.18.3.2 b, 4.4.21, 5.21).
void add_manoeuvre(std::vector<Action>& a) {
  const Act data = all_of({enter_train_data, enter_train_running_number});
  a.push_back({"session established with an RBC of 2.3", connected_2_3});
  a.push_back(
      {"enters a manoeuvre beyond a group, under an RBC of 2.3",
       all_of({group([] { return BitList{}; }), moves(0.0, 10), [](Runner& r) { acknowledge(r, true); },
               enter_driver_id, level(Level::L2), contact(), connected_2_3, message(41), data, message(8, {}, {}, 129),
               consist(0.0), message(7, {}, {}, 133), select(port::Select::sm), authorises_manoeuvre(1, 0)})});
  a.push_back({"consist behind the engine", consist(0.0)});
  a.push_back({"consist in front of the engine", consist(60.0)});
  a.push_back({"consist not known", with([](port::Inputs& in) { in.train.consist.reset(); })});
  a.push_back({"asks for a further manoeuvre", select(port::Select::continue_sm)});
  a.push_back({"leaves the manoeuvre", select(port::Select::exit_sm)});
  a.push_back({"SM authorised", authorises_manoeuvre(1, 0)});
  a.push_back({"SM authorised in the other direction", authorises_manoeuvre(0, 800)});
  a.push_back({"SM refused", message(5, {}, {}, 131)});
  a.push_back({"consist length acknowledged", message(7, {}, {}, 133)});
}

}  // namespace

const std::vector<Action>& actions(SrsVersion srs) {
  static const std::vector<Action> of_all = [] {
    std::vector<Action> a;
    add_train(a);
    add_driver(a);
    add_radio(a);
    add_groups(a);
    return a;
  }();
  static const std::vector<Action> of_4_0_0 = [] {
    std::vector<Action> a = of_all;
    add_manoeuvre(a);
    return a;
  }();
  return srs == SrsVersion::v4_0_0 ? of_4_0_0 : of_all;
}

namespace {

/// What the RBC says to a start: it ends a session that has to end first (5.4.3.2 S0), else it lets the train start.
void rbc_answers(Runner& r) {
  if (r.world().calling) connected(r);
  const port::Outputs& out = r.world().out;
  if (out.sessions.empty()) return;
  if (out.sessions[0].phase == SessionPhase::terminating) message(39)(r);
  if (!out.dialogue || out.sessions.empty() || out.sessions[0].phase != SessionPhase::up) return;
  switch (out.dialogue->step) {
    case Dialogue::start_S0:
      return message(24, end_of_session)(r);
    case Dialogue::start_D33:
      return message(41)(r);
    case Dialogue::start_S11:
      return message(8, {}, {}, 129)(r);
    case Dialogue::start_S21:
    case Dialogue::trip_S150:
      return message(2, {}, {{"D_SR", 32767}})(r);
    case Dialogue::trip_S120:
    case Dialogue::trip_S121:
      return message(6)(r);
    case Dialogue::trip_S130:
      return message(18, {}, {{"NID_EM", 1}})(r);
    default:
      return;
  }
}

/// What the driver enters when it is asked.
void driver_enters(Runner& r) {
  const port::Outputs& out = r.world().out;
  const Set<Level> allowed = out.levels_allowed;
  if (!out.requests.empty()) acknowledge(r, true);
  if (out.enabled.has(DriverInput::exit_shunting)) select(port::Select::exit_shunting)(r);
  if (out.entries.has(Entry::driver_id)) enter_driver_id(r);
  Level wanted = Level::L0;  // 3.18.4.2.5: a level of the table of trackside
  for (const Level l : {Level::L3, Level::L2, Level::L1, Level::NTC, Level::L0})
    if (allowed.has(l)) wanted = l;
  const bool asks = !out.level_valid || (out.level != wanted && allowed.has(wanted));
  if (out.enabled.has(DriverInput::level) && out.mode == Mode::SB && asks) level(wanted)(r);
  if (out.entries.has(Entry::rbc_contact)) contact()(r);
  if (out.entries.has(Entry::train_data)) enter_train_data(r);
  if (out.entries.has(Entry::train_running_number)) enter_train_running_number(r);
  if (out.start_offered) select(port::Select::start)(r);
}

/// The way out of NP and SF (4.6.2).
void switches_off_and_on(Runner& r) {
  r.inputs().train.powered = false;
  r.run(kAnswered);
  r.inputs().train.powered = true;
  r.inputs().moved = false;
  r.world().failed = false;
  r.run(kAnswered);
}

}  // namespace

bool goes_on(Runner& r) {
  constexpr int kDesks = 3;    // times that the desk is closed and opened
  constexpr int kTries = 150;  // seconds; the longest wait is that for the end of a session
  port::Inputs& in = r.inputs();
  moves(0.0, 10)(r);
  if (r.world().failed || r.world().out.mode == Mode::SF || r.world().out.mode == Mode::NP) switches_off_and_on(r);
  in.train.sleeping = in.train.non_leading = in.train.passive_shunting = in.train.antenna_alarm = false;
  in.train.direction_controller = port::DirectionController::forward;
  in.national_system.available = 2;
  in.train.consist.reset();  // with vehicles in front of the engine there are no train data (3.18.3.5)
  for (int desk = 0; desk < kDesks; ++desk) {
    for (const bool open : {false, true}) {
      in.train.desk_open = open;
      r.run(20);
      // A fault that was memorised in SL or NL shows itself when the mode is left (4.4.6.1.6, 4.4.15.1.5).
      if (r.world().out.mode == Mode::SF) switches_off_and_on(r);
    }
    for (int i = 0; i < kTries; ++i) {
      const port::Outputs& out = r.world().out;
      const bool runs = out.mode != Mode::SB && out.mode != Mode::TR && out.mode != Mode::PT && out.mode != Mode::SF;
      if (runs && !out.eb && !out.sb && out.requests.empty()) return true;
      rbc_answers(r);
      driver_enters(r);
      r.run(10);
    }
  }
  return false;
}

}  // namespace evc::exploration
