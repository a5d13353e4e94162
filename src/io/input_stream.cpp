#include "io/input_stream.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "io/date_time.h"
#include "io/input_object.h"
#include "io/rbc_contact.h"
#include "texts/texts.h"

namespace evc::io {
namespace {

using sim::CycleInputs;

/// A gap in a stream is filled with cycles; a longer one is an error.
constexpr std::int64_t kLongestGapMs = 24LL * 3600 * 1000;
constexpr double kFarMetres = 1e9;

/// Texts by the digits of NID_NTC.
NationalSystemNames read_ntc_names(const JsonPlace& place) {
  NationalSystemNames names;
  if (!place.is_object()) place.fail("an object");
  for (const auto& member : place.value().items()) {
    const std::string& key = member.key();
    const bool digits = !key.empty() && key.size() <= 3 && key.find_first_not_of("0123456789") == std::string::npos;
    const int NID_NTC = digits ? std::stoi(key) : 256;
    if (NID_NTC > 255) place[key.c_str()].fail("a NID_NTC, 0 to 255, as its name");
    names[static_cast<std::uint8_t>(NID_NTC)] = place[key.c_str()].string();
  }
  if (names.size() > decltype(kernel::Config::ntc_names)::capacity()) place.fail("at most 16 names");
  return names;
}

/// Names of track conditions, as in `track_conditions` of the outputs, and of the change of traction system; each once.
ByTrain read_by_train(const JsonPlace& place) {
  constexpr const char* kTraction = "change of traction system";
  ByTrain by_train;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::string& name = place[i].string();
    bool known = name == kTraction;
    by_train.traction_system = by_train.traction_system || known;
    for (std::size_t before = 0; before < i; ++before)
      if (place[before].string() == name) place[i].fail("each name once");
    std::string expected;
    for (const auto& row : kTrackConditionRows) {
      if (!may_be_by_train(row.value)) continue;
      expected += std::string("\"") + row.name + "\", ";
      if (name != row.name) continue;
      by_train.conditions[terms::index(row.value)] = known = true;
    }
    if (!known) place[i].fail("one of " + expected + '"' + kTraction + '"');
  }
  return by_train;
}

/// The ranges of the speed dial (015560 8.2.1.1).
Speed read_dial(const JsonPlace& place) {
  const std::int64_t kmh = place.integer(140, 400);
  if (kmh != 140 && kmh != 180 && kmh != 250 && kmh != 400) place.fail("140, 180, 250 or 400");
  return Speed{static_cast<double>(kmh) / 3.6};
}

Configuration read_configuration(const JsonPlace& place) {
  if (const auto p = place.find("schema"); p && !use_of(p->string()).empty())
    p->fail(quoted_kind(p->string()), "a configuration");
  place.know_only({"schema", "cycle_ms", "srs", "train", "levels", "national_values", "engine_length_m", "NID_ENGINE",
                   "telephone_numbers", "terminals", "cabs", "rbc", "local_time_offset_min", "networks",
                   "cold_movement_detection", "dial_kmh", "ntc_names", "by_train"});
  Configuration c;
  if (const auto p = place.find("cycle_ms")) c.cycle_ms = p->integer(1, 10000);
  if (const auto p = place.find("srs")) c.srs = read_srs_version(*p);
  if (const auto p = place.find("train")) c.train = read_train(*p);
  if (const auto p = place.find("national_values")) c.national_values = read_national_values(*p);
  if (const auto p = place.find("engine_length_m")) c.L_engine = {p->number(1.0, 1000.0)};
  if (const auto p = place.find("NID_ENGINE"))
    c.identity.NID_ENGINE = static_cast<std::uint32_t>(p->integer(0, 0xFFFFFF));
  if (const auto p = place.find("telephone_numbers"))
    for (std::size_t i = 0; i < p->size(); ++i)
      if (!c.identity.telephone_numbers.push_back(read_NID_RADIO((*p)[i]))) p->fail("at most 4 telephone numbers");
  if (const auto p = place.find("terminals")) c.terminals = static_cast<std::uint8_t>(p->integer(1, 2));
  if (const auto p = place.find("cabs")) c.cabs = static_cast<int>(p->integer(1, 2));
  if (const auto p = place.find("cold_movement_detection")) c.cold_movement_detection = p->boolean();
  if (const auto p = place.find("networks"))
    for (std::size_t i = 0; i < p->size(); ++i)
      if (!c.networks.push_back(read_NID_MN((*p)[i]))) p->fail("at most 16 networks");
  if (const auto p = place.find("ntc_names")) c.ntc_names = read_ntc_names(*p);
  if (const auto p = place.find("by_train")) c.by_train = read_by_train(*p);
  if (const auto p = place.find("dial_kmh")) c.dial = read_dial(*p);
  if (const auto p = place.find("rbc")) c.contact = read_address(*p);
  if (const auto p = place.find("local_time_offset_min"))
    c.local_time_offset_min = static_cast<std::int16_t>(p->integer(-1440, 1440));
  if (const auto p = place.find("levels")) {
    c.levels.fill(false);
    for (std::size_t i = 0; i < p->size(); ++i) c.levels[terms::index((*p)[i].term<kLevelRows>())] = true;
  }
  c.document = place.value().dump();
  return c;
}

/// `at_ms`, not after the line's own time.
std::optional<Duration> read_time(const JsonPlace& place, std::int64_t t_ms) {
  const auto p = place.find("at_ms");
  if (!p) return std::nullopt;
  const double at_ms = p->number(0.0, 1e15);
  if (at_ms > static_cast<double>(t_ms)) p->fail("a time not after t_ms, " + std::to_string(t_ms));
  return Duration{at_ms / 1000.0};
}

void read_odometer(CycleInputs& cycle, std::int64_t t_ms, const JsonPlace& place) {
  place.know_only(
      {"at_ms", "nominal_m", "min_m", "max_m", "speed_mps", "speed_min_mps", "speed_max_mps", "accel_mps2"});
  kernel::Odometry o;
  const auto metres = [&](const char* key) { return OdometerPlace{{place[key].number(-kFarMetres, kFarMetres)}}; };
  const auto speed = [&](const char* key) { return Speed{place[key].number(-300.0, 300.0)}; };
  o.nominal = metres("nominal_m");
  o.min = metres("min_m");
  o.max = metres("max_m");
  o.V_est = speed("speed_mps");
  o.V_min = place.find("speed_min_mps") ? speed("speed_min_mps") : o.V_est;
  o.V_max = place.find("speed_max_mps") ? speed("speed_max_mps") : o.V_est;
  if (const auto p = place.find("accel_mps2")) o.A_est = {p->number(-50.0, 50.0)};
  o.measured = read_time(place, t_ms).value_or(Duration{static_cast<double>(t_ms) / 1000.0});
  if (o.min > o.nominal || o.nominal > o.max) place.fail("min_m <= nominal_m <= max_m");
  if (o.V_min > o.V_est || o.V_est > o.V_max) place.fail("speed_min_mps <= speed_mps <= speed_max_mps");
  cycle.levels.odometry = o;
}

/// User bits of a telegram: 830 and 210 (SUBSET-036) are padded to whole bytes in the text.
std::size_t user_bits(const JsonPlace& place, std::size_t digits) {
  const auto bits = static_cast<std::int64_t>(4 * digits);
  if (const auto p = place.find("bits")) return static_cast<std::size_t>(p->integer(1, bits));
  return bits == 832 ? 830u : bits == 216 ? 210u : static_cast<std::size_t>(bits);
}

void read_passage(CycleInputs& cycle, std::int64_t t_ms, const JsonPlace& place, CycleInputs::Telegram t) {
  t.passed = read_time(place, t_ms);
  if (t.passed && place.find("at_m")) place["at_m"].fail("either at_m or at_ms");
  if (!t.passed) t.at = {{place["at_m"].number(-kFarMetres, kFarMetres)}};
  cycle.balises.push_back(std::move(t));
}

void read_balise(CycleInputs& cycle, std::int64_t t_ms, const JsonPlace& place) {
  place.know_only({"telegram", "at_m", "at_ms", "bits"});
  CycleInputs::Telegram t;
  const JsonPlace hex = place["telegram"];
  t.bits.bytes = hex.hex();
  t.bits.size = user_bits(place, hex.string().size());
  if (t.bits.size > 830) hex.fail(std::to_string(t.bits.size) + " bits", "at most 830");
  t.bits.bytes.resize((t.bits.size + 7) / 8);
  read_passage(cycle, t_ms, place, std::move(t));
}

/// A telegram without bits.
void read_balise_failed(CycleInputs& cycle, std::int64_t t_ms, const JsonPlace& place) {
  place.know_only({"at_m", "at_ms"});
  read_passage(cycle, t_ms, place, {});
}

sim::Bits read_message(const JsonPlace& hex) {
  sim::Bits bits;
  bits.bytes = hex.hex();
  bits.size = 8 * bits.bytes.size();
  if (hex.string().size() % 2 != 0) hex.fail("an even number of hexadecimal digits");
  // L_MESSAGE has ten bits (7.5.1.50).
  if (bits.bytes.size() > 1023) hex.fail(std::to_string(bits.bytes.size()) + " bytes", "at most 1023");
  return bits;
}

void read_loop(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"message"});
  cycle.loops.push_back(read_message(place["message"]));
}

/// The report of the bearer: each of RadioLink except `unchanged`.
RadioLink read_session(const JsonPlace& place) {
  const std::span<const char* const> names(terms::kNames<kRadioLinkRows>);
  return static_cast<RadioLink>(1 + place.one_of(names.subspan(1)));
}

/// The RBC or radio infill unit of a message or report; absent: the one called last.
std::optional<kernel::RbcIdentity> read_identity(const JsonPlace& place, bool infill_unit) {
  const auto to = place.find("to");
  if (!to) return std::nullopt;
  const char* const number = infill_unit ? "NID_RIU" : "NID_RBC";
  to->know_only({"NID_C", number});
  return kernel::RbcIdentity{static_cast<std::uint16_t>((*to)["NID_C"].integer(0, 1023)),
                             static_cast<std::uint16_t>((*to)[number].integer(0, 16383))};
}

void read_radio(InputStream::Radio& radio, const JsonPlace& place, bool infill_unit) {
  const std::optional<kernel::RbcIdentity> with = read_identity(place, infill_unit);
  if (const auto p = place.find("message"))
    radio.emplace_back(CycleInputs::RadioMessage{read_message(*p), with, infill_unit});
  if (const auto p = place.find("session"))
    radio.emplace_back(InputStream::Report{read_session(*p), with, infill_unit});
}
void read_radio(CycleInputs& cycle, InputStream::Radio& radio, const JsonPlace& place) {
  place.know_only({"message", "session", "to", "network"});
  if (const auto p = place.find("network"))
    cycle.levels.train.radio_registered = p->one_of({"not registered", "registered"}) == 1;
  read_radio(radio, place, false);
}
void read_radio_infill(InputStream::Radio& radio, const JsonPlace& place) {
  place.know_only({"message", "session", "to"});
  read_radio(radio, place, true);
}

/// Decimal digits as BCD, left aligned, padded with F (7.5.1.92 NID_OPERATIONAL).
std::uint32_t packed_digits(const JsonPlace& place) {
  std::string digits;
  if (place.is_string())
    digits = place.string();
  else
    digits = std::to_string(place.integer(0, 99999999));
  if (digits.empty() || digits.size() > 8 || digits.find_first_not_of("0123456789") != std::string::npos)
    place.fail("1 to 8 decimal digits");
  std::uint32_t packed = 0;
  for (std::size_t i = 0; i < 8; ++i)
    packed = packed << 4 | (i < digits.size() ? static_cast<std::uint32_t>(digits[i] - '0') : 15u);
  return packed;
}

/// 1 to 16 letters and digits, or a number.
DriverId read_driver_id(const JsonPlace& place) {
  const std::string text = place.is_string() ? place.string() : std::to_string(place.integer(0, 99999999));
  const DriverId id(text);
  if (text.size() > DriverId::kMost || id.view().size() != text.size() || !id.valid())
    place.fail("1 to 16 letters and digits");
  return id;
}

/// Two letters: "en".
Language read_language(const JsonPlace& place) {
  const std::string& text = place.string();
  Language language;
  if (text.size() == language.letters.size()) language.letters = {text[0], text[1]};
  if (text != language.view() || !language.valid()) place.fail("two letters of ISO 639-1, as en");
  return language;
}

/// A virtual balise cover; one to be removed needs no period.
kernel::DriverActions::Cover read_vbc(const JsonPlace& place) {
  place.know_only({"NID_C", "NID_VBCMK", "T_VBC"});
  kernel::DriverActions::Cover cover{};
  cover.NID_C = static_cast<std::uint16_t>(place["NID_C"].integer(0, 1023));
  cover.NID_VBCMK = static_cast<std::uint8_t>(place["NID_VBCMK"].integer(0, 63));
  if (const auto p = place.find("T_VBC")) cover.T_VBC = static_cast<std::uint8_t>(p->integer(0, 255));
  return cover;
}

void read_enter(CycleInputs& cycle, std::optional<Train>& entered, const JsonPlace& place) {
  place.know_only({"driver_id", "level", "nid_ntc", "train_data", "train_running_number", "rbc", "V_sr_kmh", "D_sr_m",
                   "vbc", "network", "set_speed_kmh", "language"});
  auto& driver = cycle.levels.driver;
  if (const auto p = place.find("driver_id")) driver.driver_id = read_driver_id(*p);
  if (const auto p = place.find("level")) driver.level = p->term<kLevelRows>();
  if (const auto p = place.find("nid_ntc")) driver.nid_ntc = static_cast<std::uint8_t>(p->integer(0, 255));
  if (const auto p = place.find("train_running_number")) driver.train_running_number = packed_digits(*p);
  if (const auto p = place.find("rbc")) {
    const kernel::RbcAddress rbc = read_address(*p);
    driver.rbc_contact = kernel::DriverActions::RbcContact{rbc.NID_C, rbc.NID_RBC, rbc.NID_RADIO};
  }
  if (const auto p = place.find("network")) driver.network = read_NID_MN(*p);
  if (const auto p = place.find("vbc")) driver.cover = read_vbc(*p);
  if (const auto p = place.find("V_sr_kmh")) driver.V_sr = Speed{p->number(0.0, 600.0) / 3.6};
  if (const auto p = place.find("D_sr_m")) driver.D_sr = Distance{p->number(0.0, 327670.0)};
  if (const auto p = place.find("language")) driver.language = read_language(*p);
  if (const auto p = place.find("set_speed_kmh")) driver.set_speed = Speed{p->number(0.0, 600.0) / 3.6};
  if (const auto p = place.find("train_data")) {
    entered = read_entered_train(*p);
    cycle.train_data = entered->data;
  }
}

/// The button that opens train data again after they were valid is that of the first time.
std::uint32_t read_selection(const JsonPlace& place) {
  if (place.value() == "new_train_data") return 1u << terms::index(kernel::Select::train_data);
  return 1u << place.one_of(texts::kSelectNames);
}

/// One name or an array of names, each a bit.
void read_selections(std::uint32_t& selected, const JsonPlace& place) {
  if (place.is_array()) {
    for (std::size_t i = 0; i < place.size(); ++i) read_selections(selected, place[i]);
    return;
  }
  selected = kernel::with_selection(selected, read_selection(place));
}

/// An entry window that opens or closes.
void read_window(Set<kernel::Window>& windows, const JsonPlace& place) {
  place.know_only({"opened", "closed"});
  const auto of = [](const JsonPlace& name) { return static_cast<kernel::Window>(name.one_of(texts::kWindowNames)); };
  if (const auto p = place.find("closed")) windows.remove(of(*p));
  if (const auto p = place.find("opened")) windows.add(of(*p));
}

/// Names of requests, and `{ "id" }`: the text of that id.
void read_acknowledgement(kernel::DriverActions& driver, const JsonPlace& place) {
  if (place.is_array()) {
    for (std::size_t i = 0; i < place.size(); ++i) read_acknowledgement(driver, place[i]);
    return;
  }
  const auto bit = [](Ack ack) { return 1u << static_cast<unsigned>(ack); };
  if (!place.is_object()) {
    driver.acknowledged |= bit(place.term<kAckRows>());
    return;
  }
  place.know_only({"id"});
  if (driver.acknowledged_text != 0) place.fail("one text in a cycle");
  driver.acknowledged_text = static_cast<std::uint16_t>(place["id"].integer(1, kernel::kLastStatusId));
  driver.acknowledged |= bit(Ack::text);
}

void read_driver(CycleInputs& cycle, std::optional<Train>& entered, const JsonPlace& place) {
  place.know_only({"select", "ack", "enter", "window"});
  auto& driver = cycle.levels.driver;
  if (const auto p = place.find("select")) read_selections(driver.selected, *p);
  if (const auto p = place.find("ack")) read_acknowledgement(driver, *p);
  if (const auto p = place.find("enter")) read_enter(cycle, entered, *p);
  if (const auto p = place.find("window")) read_window(cycle.levels.windows, *p);
}

/// Train data of another source than the driver (5.17).
void read_external_train_data(CycleInputs& cycle, const JsonPlace& place) {
  const auto data = place.find("data");
  const auto validation = place.find("data_validation");
  if (validation && !data) validation->fail("data, which it belongs to");
  if (!data) return;
  cycle.external_train_data = read_entered_train(*data).data;
  cycle.levels.external_train_data.driver_validates = !validation || validation->boolean();
}

/// Of an external source (3.6.5.2); without its length the train data count alone.
void read_integrity(kernel::TrainSignals& t, const JsonPlace& place) {
  const auto length = place.find("train_length_m");
  if (const auto p = place.find("integrity")) {
    t.integrity = p->term<kTrainIntegrityRows>();
    t.length_confirmed.reset();
  } else if (length) {
    length->fail("integrity, which it belongs to");
  }
  if (length && !length->is_null()) t.length_confirmed = {length->number(0.0, 4095.0)};
}

/// One end of the shunting consist: nominal, least, greatest length.
ConsistEnd read_consist_end(const JsonPlace& lengths) {
  if (lengths.size() != 3) lengths.fail("[nominal, min, max]");
  const ConsistEnd end{
      {lengths[0].number(0.0, 4095.0)}, {lengths[1].number(0.0, 4095.0)}, {lengths[2].number(0.0, 4095.0)}};
  if (!is_possible(end)) lengths.fail("min <= nominal <= max");
  return end;
}

/// 4.0.0: from the front end of the engine on the side of the active cab to each end of the shunting consist; null: it
/// is not available any more.
std::optional<ConsistLength> read_consist_length(const JsonPlace& place) {
  if (place.is_null()) return std::nullopt;
  place.know_only({"front_m", "rear_m"});
  return ConsistLength{read_consist_end(place["front_m"]), read_consist_end(place["rear_m"])};
}

/// The desk that is open: `cab` names it, `desk_open` alone speaks of cab A.
void read_desk(kernel::TrainSignals& t, const JsonPlace& place) {
  if (const auto p = place.find("desk_open")) {
    t.desk_open = p->boolean();
    if (t.desk_open) t.cab = kernel::Cab::A;
  }
  const auto cab = place.find("cab");
  if (!cab) return;
  t.desk_open = !cab->is_null();
  if (t.desk_open) t.cab = static_cast<kernel::Cab>(cab->one_of(texts::kCabNames));
}

void read_signals(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"powered",
                   "isolated",
                   "desk_open",
                   "cab",
                   "sleeping",
                   "non_leading",
                   "passive_shunting",
                   "direction_controller",
                   "brake_pressure_kpa",
                   "service_brake_feedback",
                   "regenerative_brake_active",
                   "eddy_current_brake_active",
                   "magnetic_shoe_brake_active",
                   "ep_brake_active",
                   "additional_brake_active",
                   "antenna_alarm",
                   "radio_registered",
                   "data",
                   "data_validation",
                   "integrity",
                   "train_length_m",
                   "safe_consist_length",
                   "traction_system",
                   "main_switch"});  // the last two are not used (CAVEATS)
  auto& t = cycle.levels.train;
  const auto flag = [&](bool& signal, const char* key) {
    if (const auto p = place.find(key)) signal = p->boolean();
  };
  flag(t.powered, "powered");
  if (place.find("powered")) cycle.levels.moved.reset();
  flag(t.isolated, "isolated");
  read_desk(t, place);
  flag(t.sleeping, "sleeping");
  flag(t.non_leading, "non_leading");
  flag(t.passive_shunting, "passive_shunting");
  flag(t.service_brake_feedback, "service_brake_feedback");
  flag(t.regenerative_brake_active, "regenerative_brake_active");
  flag(t.eddy_current_brake_active, "eddy_current_brake_active");
  flag(t.magnetic_shoe_brake_active, "magnetic_shoe_brake_active");
  flag(t.ep_brake_active, "ep_brake_active");
  flag(t.additional_brake_active, "additional_brake_active");
  flag(t.antenna_alarm, "antenna_alarm");
  flag(t.radio_registered, "radio_registered");
  read_external_train_data(cycle, place);
  read_integrity(t, place);
  if (const auto p = place.find("safe_consist_length")) t.consist = read_consist_length(*p);
  if (const auto p = place.find("direction_controller"))
    t.direction_controller = static_cast<kernel::DirectionController>(p->one_of(texts::kDirectionNames));
  if (const auto p = place.find("brake_pressure_kpa")) {
    t.brake_pressure_kpa.reset();
    if (!p->is_null()) t.brake_pressure_kpa = p->number(0.0, 2000.0);
  }
}

/// Of a key that is left out instead of saying false.
void require_true(const JsonPlace& place) {
  if (place.value() != true) place.fail("true");
}

/// Power off, or on with what cold movement detection says (3.15.8).
void read_power(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"off", "on", "moved"});
  const auto off = place.find("off");
  const auto on = place.find("on");
  if (off && on) place.fail("either off or on");
  const JsonPlace what = off ? *off : place["on"];
  require_true(what);
  const auto moved = place.find("moved");
  if (moved && off) moved->fail("on, which it belongs to");
  cycle.levels.train.powered = !off;
  cycle.levels.moved.reset();
  if (moved && !moved->is_null()) cycle.levels.moved = moved->boolean();
}

void read_national_system(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"available", "trip_active", "service_brake", "emergency_brake"});
  auto& national = cycle.levels.national_system;
  if (const auto p = place.find("available")) {
    national.available = 0;
    for (std::size_t i = 0; i < p->size(); ++i) national.available |= std::uint64_t{1} << (*p)[i].integer(0, 63);
  }
  if (const auto p = place.find("trip_active")) national.trip_active = p->boolean();
  if (const auto p = place.find("service_brake")) national.service_brake = p->boolean();
  if (const auto p = place.find("emergency_brake")) national.emergency_brake = p->boolean();
}

void read_automatic_operation(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"requests_AD", "selector"});
  constexpr std::array<const char*, 2> selectors{"stand_by", "active"};
  auto& operation = cycle.levels.automatic_operation;
  if (const auto p = place.find("requests_AD")) operation.requests_AD = p->boolean();
  if (const auto p = place.find("selector")) operation.active = p->one_of(selectors) == 1;
}

void read_fault(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"safety"});
  if (const auto p = place.find("safety")) cycle.levels.safety_fault = p->boolean();
}

void read_clock(CycleInputs& cycle, const JsonPlace& place) {
  place.know_only({"utc"});
  cycle.levels.utc = read_utc(place["utc"]);
}

void read_object(CycleInputs& cycle, std::int64_t t_ms, InputStream::Radio& radio, std::optional<Train>& entered,
                 const JsonPlace& place) {
  place.know_only({"t_ms", "config", "odometer", "balise", "balise_failed", "loop", "radio", "radio_in_fill", "driver",
                   "train", "power", "national_system", "ato", "fault", "clock", "end"});
  if (const auto p = place.find("config")) p->fail("config on the first line only");
  if (const auto p = place.find("odometer")) read_odometer(cycle, t_ms, *p);
  if (const auto p = place.find("balise")) read_balise(cycle, t_ms, *p);
  if (const auto p = place.find("balise_failed")) read_balise_failed(cycle, t_ms, *p);
  if (const auto p = place.find("loop")) read_loop(cycle, *p);
  if (const auto p = place.find("radio")) read_radio(cycle, radio, *p);
  if (const auto p = place.find("radio_in_fill")) read_radio_infill(radio, *p);
  if (const auto p = place.find("driver")) read_driver(cycle, entered, *p);
  if (const auto p = place.find("train")) read_signals(cycle, *p);
  if (const auto p = place.find("power")) read_power(cycle, *p);
  if (const auto p = place.find("national_system")) read_national_system(cycle, *p);
  if (const auto p = place.find("ato")) read_automatic_operation(cycle, *p);
  if (const auto p = place.find("fault")) read_fault(cycle, *p);
  if (const auto p = place.find("clock")) read_clock(cycle, *p);
  if (const auto p = place.find("end")) require_true(*p);
}

}  // namespace

void read_inputs(const JsonPlace& object, std::int64_t t_ms, const Configuration& configuration,
                 InputStream::Radio& radio, std::optional<Train>& entered, sim::CycleInputs& cycle) {
  read_object(cycle, t_ms, radio, entered, object);
  if (configuration.cabs == 1 && cycle.levels.train.cab == kernel::Cab::B)
    object["train"]["cab"].fail("A: the engine has one cab");
  if (!configuration.cold_movement_detection) cycle.levels.moved.reset();
}

void deliver_radio(sim::CycleInputs& cycle, InputStream::Radio& radio) {
  for (; !radio.empty(); radio.pop_front()) {
    if (auto* message = std::get_if<CycleInputs::RadioMessage>(&radio.front())) {
      cycle.radio.push_back(std::move(*message));
      continue;
    }
    if (cycle.levels.radio_link != RadioLink::unchanged) return;
    const InputStream::Report& report = std::get<InputStream::Report>(radio.front());
    cycle.levels.radio_link = report.link;
    cycle.levels.radio_link_with = report.with;
    cycle.levels.radio_link_of_infill_unit = report.infill_unit;
  }
}

Result<Configuration> read_configuration(std::string_view text, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(text, file);
    return read_configuration(JsonPlace(document, file));
  });
}

void InputStream::begin(std::optional<Configuration> given) {
  read_ahead();
  if (pending_ && pending_->object.contains("config")) {
    const JsonPlace place(pending_->object, file_, place_of_line());
    configuration_ = read_configuration(place["config"]);
    pending_->object.erase("config");
    if (pending_->object.empty()) read_ahead();
  }
  if (given) configuration_ = *std::move(given);
}

Result<InputStream> InputStream::open(std::string file, NextLine next_line, std::optional<Configuration> given) {
  return guarded([&] {
    InputStream stream(std::move(file), std::move(next_line));
    stream.begin(std::move(given));
    return stream;
  });
}

Result<InputStream> InputStream::open_by_clock(std::string file, NextLine next_line, ByClock by_clock) {
  return guarded([&] {
    InputStream stream(std::move(file), std::move(next_line));
    stream.by_clock_ = std::move(by_clock);
    stream.begin({});
    stream.configuration_.cycle_ms = stream.by_clock_->cycle_ms.value_or(stream.configuration_.cycle_ms);
    return stream;
  });
}

std::int64_t InputStream::time_of(const JsonPlace& line) const {
  if (by_clock_) return by_clock_->arrived_ms();
  const auto t = line.find("t_ms");
  // `config` has no time: it may be on a line without `t_ms`.
  if (!t && line.find("config")) return 0;
  const JsonPlace time = line["t_ms"];
  const std::int64_t t_ms = time.integer(0, INT64_MAX / 4);
  if (t_ms < last_ms_) time.fail("a time not before " + std::to_string(last_ms_));
  if (t_ms <= ended_ms_) time.fail("a time after " + std::to_string(ended_ms_) + ", which was ended");
  if (t_ms - last_ms_ > kLongestGapMs) time.fail("a time within 24 h of " + std::to_string(last_ms_));
  return t_ms;
}

void InputStream::read_ahead() {
  pending_.reset();
  std::string text;
  while (next_line_(text)) {
    ++line_;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.find_first_not_of(" \t") == std::string::npos) continue;
    Pending read{parse_json(text, file_, place_of_line()), 0};
    const JsonPlace place(read.object, file_, place_of_line());
    read.t_ms = time_of(place);
    last_ms_ = std::max(last_ms_, read.t_ms);
    if (!by_clock_ && place.find("end")) ended_ms_ = read.t_ms;
    pending_ = std::move(read);
    return;
  }
}

void InputStream::consume(sim::CycleInputs& cycle) {
  const JsonPlace object(pending_->object, file_, place_of_line());
  read_inputs(object, pending_->t_ms, configuration_, radio_, entered_, cycle);
}

Result<bool> InputStream::next(sim::CycleInputs& cycle) {
  return guarded([&] {
    if (cycle_ended_ || (by_clock_ && !pending_)) read_ahead();
    cycle_ended_ = false;
    if (!by_clock_ && empty()) return false;
    cycle.clear();
    cycle.t_ms = next_cycle_ms_;
    bool consumed = by_clock_ || !radio_.empty();
    while (pending_ && pending_->t_ms <= cycle.t_ms) {
      consume(cycle);
      // `end` alone is no input: after the last cycle that it completes there is none.
      consumed = consumed || pending_->object.size() > 2 || ended_ms_ != pending_->t_ms;
      // The next line may come later than the outputs are wanted.
      cycle_ended_ = ended_ms_ == cycle.t_ms;
      if (cycle_ended_) {
        pending_.reset();
        break;
      }
      read_ahead();
    }
    if (!consumed && !cycle_ended_ && empty()) return false;
    deliver_radio(cycle, radio_);
    next_cycle_ms_ += configuration_.cycle_ms;
    return true;
  });
}

InputStream::NextLine lines_of(std::string text) {
  auto rest = std::make_shared<std::pair<std::string, std::size_t>>(std::move(text), 0);
  return [rest](std::string& line) {
    auto& [all, at] = *rest;
    if (at >= all.size()) return false;
    const std::size_t end = std::min(all.find('\n', at), all.size());
    line.assign(all, at, end - at);
    at = end + 1;
    return true;
  };
}

}  // namespace evc::io
