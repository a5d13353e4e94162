#include "io/display_reader.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "io/display_names.h"
#include "io/latin1.h"
#include "io/train_file.h"
#include "terms/dialogue.h"

namespace evc::io {
namespace {

/// A value of the record. What is missing or of another kind sets the fault, once for all, and reads as nothing.
class Value {
 public:
  Value(const Json* json, bool& fault) : json_(json), fault_(fault) {}

  Value operator[](const char* key) const {
    if (json_ == nullptr || !json_->is_object()) return nothing();
    const auto found = json_->find(key);
    return found == json_->end() ? nothing() : Value(&*found, fault_);
  }
  bool null() const { return json_ != nullptr && json_->is_null(); }
  double number() const {
    if (json_ != nullptr && json_->is_number()) return json_->get<double>();
    fault_ = true;
    return 0.0;
  }
  template <class T>
  T whole() const {
    const double n = number();
    if (n >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
        n <= static_cast<double>(std::numeric_limits<T>::max()))
      return static_cast<T>(n);
    fault_ = true;
    return T{};
  }
  bool flag() const {
    if (json_ != nullptr && json_->is_boolean()) return json_->get<bool>();
    fault_ = true;
    return false;
  }
  std::string text() const {
    const auto* const found = json_ == nullptr ? nullptr : json_->get_ptr<const std::string*>();
    if (found != nullptr) return *found;
    fault_ = true;
    return {};
  }
  /// The place of this text in `names`.
  std::size_t one_of(std::span<const char* const> names) const {
    const auto found = std::find(names.begin(), names.end(), text());
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    fault_ = true;
    return 0;
  }
  /// The term with this name in a table of src/terms.
  template <const auto& kRows>
  auto term() const {
    return kRows[one_of(std::span<const char* const>(terms::kNames<kRows>))].value;
  }
  template <class E>
  E named(std::span<const char* const> names) const {
    return static_cast<E>(one_of(names));
  }

  Distance metres() const { return Distance{number()}; }
  Speed kmh() const { return Speed{number() / 3.6}; }
  Duration seconds() const { return Duration{number()}; }
  Duration ms() const { return Duration{number() / 1000.0}; }
  std::optional<Distance> some_metres() const { return null() ? std::nullopt : std::optional(metres()); }
  std::optional<Speed> some_kmh() const { return null() ? std::nullopt : std::optional(kmh()); }
  template <class T>
  std::optional<T> some_whole() const {
    return null() ? std::nullopt : std::optional(whole<T>());
  }
  /// A text in ISO 8859-1, its bytes into `to`: how many. A longer one is a fault.
  template <std::size_t N>
  std::uint8_t latin1(std::array<char, N>& to) const {
    const std::string bytes = latin1_of(text());
    if (bytes.size() > N) fault_ = true;
    const std::size_t size = std::min(bytes.size(), N);
    std::copy_n(bytes.begin(), size, to.begin());
    return static_cast<std::uint8_t>(size);
  }
  /// `read(value)` gives an element; more than fit are a fault.
  template <class T, std::size_t N, class Read>
  void list(InplaceVector<T, N>& to, Read read) const {
    each([&](const Value& value) {
      if (!to.push_back(read(value))) fault_ = true;
    });
  }
  template <class Take>
  void each(Take take) const {
    if (json_ == nullptr || !json_->is_array()) {
      fault_ = true;
      return;
    }
    for (const Json& item : *json_) take(Value(&item, fault_));
  }
  /// Bits by the names of their numbers.
  std::uint64_t bits(std::span<const char* const> names) const {
    std::uint64_t all = 0;
    each([&](const Value& value) { all |= std::uint64_t{1} << value.one_of(names); });
    return all;
  }
  template <class E>
  Set<E> set(std::span<const char* const> names) const {
    return Set<E>::of_bits(bits(names));
  }
  void fail() const { fault_ = true; }

 private:
  Value nothing() const {
    fault_ = true;
    return {nullptr, fault_};
  }

  const Json* json_;
  bool& fault_;
};

/// Decimal digits, packed four bits each into `places` of them from the left, the rest F.
std::uint32_t packed(const Value& value, unsigned places) {
  const std::string digits = value.text();
  if (digits.size() > places || digits.find_first_not_of("0123456789") != std::string::npos) value.fail();
  std::uint32_t number = 0;
  for (unsigned i = 0; i < places; ++i)
    number = number << 4 | (i < digits.size() ? static_cast<std::uint32_t>(digits[i] - '0') & 15u : 15u);
  return number;
}

/// NID_RADIO (7.5.1.95): 16 hexadecimal digits.
std::uint64_t radio_number(const Value& value) {
  const std::string digits = value.text();
  if (digits.size() != 16) value.fail();
  std::uint64_t number = 0;
  for (const char c : digits) {
    const bool decimal = c >= '0' && c <= '9';
    const char letter = static_cast<char>(c | 0x20);
    if (!decimal && (letter < 'a' || letter > 'f')) value.fail();
    number = number << 4 | (static_cast<unsigned>(decimal ? c - '0' : letter - 'a' + 10) & 15u);
  }
  return number;
}

Language language_of(const Value& value) {
  Language language;
  if (value.latin1(language.letters) != language.letters.size() || !language.valid()) value.fail();
  return language;
}

port::ShownTrainData train_data_of(const Value& value) {
  port::ShownTrainData train;
  train.L_TRAIN = value["length_m"].metres();
  train.V_MAXTRAIN = value["max_speed_kmh"].kmh();
  if (const Value percentage = value["brake_percentage"]; !percentage.null())
    train.brake_percentage = percentage.number();
  const Value category = value["category"];
  train.cant_deficiency_mm = category["cant_deficiency_mm"].whole<std::uint16_t>();
  train.other_categories = static_cast<std::uint16_t>(category["other"].bits(kOtherCategoryNames));
  train.axle_load = category["axle_load"].term<kAxleLoadRows>();
  train.loading_gauge = category["loading_gauge"].term<kLoadingGaugeRows>();
  train.airtight = category["airtight"].flag();
  return train;
}

port::EntryRange range_of(const Value& value) {
  const auto some = [](const Value& number) { return number.null() ? std::nullopt : std::optional(number.number()); };
  return {value["least"].number(), value["most"].number(), value["step"].number(), some(value["operational_least"]),
          some(value["operational_most"])};
}

port::Dial dial_of(const Value& value) {
  const auto found = std::find(names::kDials.begin(), names::kDials.end(), value.whole<int>());
  if (found == names::kDials.end()) value.fail();
  return found == names::kDials.end() ? port::Dial::to_400 : static_cast<port::Dial>(found - names::kDials.begin());
}

void read_config(const Value& value, port::DisplayConfig& c) {
  c.srs = value["srs"].term<kSrsVersionRows>();
  c.dial = dial_of(value["dial_kmh"]);
  value["ntc_names"].list(c.ntc_names, [](const Value& ntc) {
    port::NtcName name;
    name.nid_ntc = ntc["nid_ntc"].whole<std::uint8_t>();
    ntc["name"].latin1(name.characters);
    return name;
  });
  value["languages"].list(c.languages, language_of);
  c.train_data_entry = value["train_data_entry"].named<port::TrainDataEntry>(names::kEntryNames);
  value["train_types"].list(c.train_types, [](const Value& given) {
    port::TrainType type;
    given["name"].latin1(type.name);
    type.data = train_data_of(given["data"]);
    return type;
  });
  c.categories = value["categories"].set<TrainCategory>(terms::kNames<kTrainCategoryRows>);
  c.axle_loads = static_cast<std::uint16_t>(value["axle_loads"].bits(terms::kNames<kAxleLoadRows>));
  c.loading_gauges = static_cast<std::uint8_t>(value["loading_gauges"].bits(terms::kNames<kLoadingGaugeRows>));
  c.L_TRAIN = range_of(value["length_m"]);
  c.brake_percentage = range_of(value["brake_percentage"]);
  c.asks_brake_percentage = value["asks_brake_percentage"].flag();
  c.V_MAXTRAIN = range_of(value["max_speed_kmh"]);
  c.V_sr = range_of(value["V_sr_kmh"]);
  c.D_sr = range_of(value["D_sr_m"]);
  value["cross_checks"].list(c.cross_checks, [](const Value& check) {
    return port::CrossCheck{check["categories"].set<TrainCategory>(terms::kNames<kTrainCategoryRows>),
                            check["most_kmh"].kmh(), check["operational"].flag()};
  });
  c.gsmr_fitted = value["gsmr_fitted"].flag();
  c.frmcs_fitted = value["frmcs_fitted"].flag();
  c.T_dispTTI = value["T_dispTTI_s"].seconds();
}

/// A level, and with level NTC the national system.
template <class Place>
void read_shown_level(const Value& value, Place& place) {
  place.level = value["level"].term<kLevelRows>();
  if (place.level == Level::NTC) place.nid_ntc = value["nid_ntc"].whole<std::uint8_t>();
}

/// Areas A and B.
void read_speeds(const Value& value, port::Display& d) {
  d.v = value["v_kmh"].kmh();
  d.monitoring = value["monitoring"].term<kMonitoringRows>();
  d.status = value["status"].term<kStatusRows>();
  d.V_P = value["V_P"].some_kmh();
  d.V_SBI = value["V_SBI"].some_kmh();
  d.V_target = value["V_target"].some_kmh();
  d.V_release = value["V_release"].some_kmh();
  d.target_information = value["target_information"].flag();
  d.MRDT = value["mrdt"].whole<std::uint8_t>();
  d.d_target = value["d_target_m"].some_metres();
  if (const Value TTI = value["tti_s"]; !TTI.null()) d.TTI = TTI.seconds();
  d.LSSMA = value["lssma_kmh"].some_kmh();
  d.set_speed = value["set_speed_kmh"].some_kmh();
}

void read_symbols(const Value& value, port::Display& d) {
  d.slippery_rail = value["slippery_rail"].flag();
  if (const Value sm = value["sm"]; !sm.null()) d.sm = sm.named<port::SmDirection>(names::kSmNames);
  d.override_active = value["override_active"].flag();
  d.reversing_permitted = value["reversing_permitted"].flag();
  d.bmm_inhibited = value["bmm_inhibited"].flag();
  d.brake = value["brake"].flag();
  d.brake_for_missing_ack = value["brake_for_missing_ack"].flag();
  if (const Value level = value["announced_level"]; !level.null()) read_shown_level(level, d.announced_level.emplace());
  d.radio = value["radio"].named<RadioIndication>(names::kRadioNames);
  d.geo = value["geo_m"].some_metres();
  value["conditions"].list(d.conditions, [](const Value& c) {
    return port::DisplayedCondition{c["id"].whole<std::uint16_t>(), c["symbol"].term<kPictureRows>(),
                                    c["phase"].term<kConditionPhaseRows>()};
  });
  if (const Value tunnel = value["tunnel"]; !tunnel.null())
    d.tunnel = {tunnel["inside"].flag(), tunnel["distance_m"].metres()};
  d.track_ahead_free = value["track_ahead_free"].flag();
}

void read_planning(const Value& value, port::Display& d) {
  value["gradient"].list(d.planning.gradients, [](const Value& g) {
    port::PlannedGradient gradient;
    gradient.from = g["from_m"].metres();
    gradient.to = g["to_m"].metres();
    gradient.permille = g["permille"].whole<decltype(gradient.permille)>();
    return gradient;
  });
  value["mrsp"].list(d.planning.speeds, [](const Value& s) {
    port::PlannedSpeed speed;
    speed.at = s["at_m"].metres();
    speed.V = s["v_kmh"].kmh();
    speed.sources = s["from"].set<MrspSource>(terms::kNames<kMrspSourceRows>);
    return speed;
  });
  value["orders"].list(d.orders, [](const Value& order) {
    return port::PlannedOrder{order["symbol"].term<kPictureRows>(), order["at_m"].metres()};
  });
  d.indication_marker = value["indication_m"].some_metres();
  d.indication_target = value["indication_target_m"].some_metres();
  d.planning.EOA = value["EOA_m"].some_metres();
  d.planning.LOA = value["LOA_m"].some_metres();
  if (d.planning.LOA) d.planning.V_LOA = value["V_LOA_kmh"].kmh();
}

port::DisplayedText text_of(const Value& value) {
  port::DisplayedText text;
  text.id = value["id"].whole<std::uint16_t>();
  text.kind = value["kind"].named<port::TextKind>(names::kTextKindNames);
  text.important = value["class"].text() == "important";
  text.acknowledge = value["ack"].flag();
  text.since = value["since_ms"].ms();
  text.minute_of_day = value["minute_of_day"].some_whole<std::uint16_t>();
  switch (text.kind) {
    case port::TextKind::fixed:
      text.Q_TEXT = value["q_text"].whole<std::uint8_t>();
      break;
    case port::TextKind::status:
      text.status = value["status"].term<kStatusTextRows>();
      text.nid_ntc = value["nid_ntc"].some_whole<std::uint8_t>().value_or(0);
      break;
    case port::TextKind::plain:
    case port::TextKind::national:
      text.length = value["text"].latin1(text.characters);
      break;
  }
  return text;
}

port::AskedAck ack_of(const Value& value) {
  return {value["what"].term<kAckRows>(), value["id"].some_whole<std::uint16_t>().value_or(0), value["since_ms"].ms()};
}

/// A datum of the data view: its status, and `read(value)` where it is known.
template <class Read>
DataStatus read_datum(const Value& datum, Read read) {
  const DataStatus status = datum["status"].term<kDataStatusRows>();
  if (status != DataStatus::unknown) read(datum["value"]);
  return status;
}

void read_stored(const Value& value, port::DisplayedData& data) {
  port::ShownData& d = data.stored;
  d.driver_id_status = read_datum(value["driver_id"], [&](const Value& id) { id.latin1(d.driver_id.characters); });
  d.train_running_number_status = read_datum(value["train_running_number"],
                                             [&](const Value& number) { d.train_running_number = packed(number, 8); });
  d.level_status = read_datum(value["level"], [](const Value&) {});
  d.rbc_status = read_datum(value["rbc"], [&](const Value& rbc) {
    d.rbc.NID_C = rbc["NID_C"].whole<std::uint16_t>();
    d.rbc.NID_RBC = rbc["NID_RBC"].whole<std::uint16_t>();
    d.rbc.NID_RADIO = radio_number(rbc["NID_RADIO"]);
  });
  d.train_status = read_datum(value["train_data"], [&](const Value& train) { d.train = train_data_of(train); });
  d.SR.status = read_datum(value["sr"], [&](const Value& SR) {
    d.SR.V = SR["V_sr_kmh"].kmh();
    d.SR.D = SR["D_sr_m"].some_metres();
  });
  value["vbc"]["value"].list(data.covers, [](const Value& cover) {
    return port::ShownCover{cover["NID_C"].whole<std::uint16_t>(), cover["NID_VBCMK"].whole<std::uint8_t>(),
                            cover["left_s"].seconds()};
  });
  d.slippery_rail = value["adhesion"]["value"].text() == "slippery rail";
  read_datum(value["network"], [&](const Value& network) { d.network = packed(network, 6); });
}

/// "2.1": four bits each.
std::uint8_t version_of(const Value& value) {
  const std::string text = value.text();
  const auto part = [&](const std::string& digits) {
    if (digits.empty() || digits.size() > 2 || digits.find_first_not_of("0123456789") != std::string::npos) {
      value.fail();
      return 0;
    }
    return (digits.size() == 2 ? 10 * (digits[0] - '0') : 0) + (digits.back() - '0');
  };
  const std::size_t point = std::min(text.find('.'), text.size());
  const int X = part(text.substr(0, point)), Y = part(point < text.size() ? text.substr(point + 1) : "");
  if (X > 15 || Y > 15) value.fail();
  return static_cast<std::uint8_t>((X << 4 | (Y & 15)) & 255);
}

void read_data(const Value& value, port::DisplayedData& data) {
  read_stored(value["stored"], data);
  data.train_type = value["train_type"].some_whole<std::uint8_t>();
  data.levels = static_cast<std::uint8_t>(value["levels"].bits(terms::kNames<kLevelRows>));
  value["ntcs"].list(data.ntcs, [](const Value& nid_ntc) { return nid_ntc.whole<std::uint8_t>(); });
  value["networks"].list(data.networks, [](const Value& network) { return packed(network, 6); });
  data.M_VERSION = version_of(value["version"]);
  data.radio = value["radio"].named<port::RadioNetworkType>(names::kNetworkTypeNames);
  data.gsmr_registered = value["gsmr_registered"].flag();
  data.frmcs_registered = value["frmcs_registered"].flag();
  data.asks_one_radio_system = value["asks_one_radio_system"].flag();
  data.D_sr_most = value["D_sr_most_m"].some_metres();
}

void read_ato(const Value& value, port::DisplayedAto& ato) {
  ato.on = value["on"].flag();
  ato.status = value["status"].named<port::AtoStatus>(names::kAtoStatusNames);
  ato.stop = value["stop"].named<port::AtoStop>(names::kAtoStopNames);
  ato.dwell_s = value["dwell_s"].some_whole<std::uint16_t>();
  ato.hold = value["hold"].flag();
  ato.doors = value["doors"].named<port::AtoDoors>(names::kAtoDoorsNames);
  ato.skip = value["skip"].named<port::AtoSkip>(names::kAtoSkipNames);
  ato.coasting_advice = value["coasting_advice"].flag();
  ato.warning_sound = value["warning_sound"].flag();
  ato.advice_speed = value["advice_speed_kmh"].some_kmh();
  ato.name_length = value["name"].latin1(ato.name);
  ato.arrival_second_of_day = value["arrival_second_of_day"].some_whole<std::uint32_t>();
  value["stopping_points_m"].list(ato.stopping_points, [](const Value& at) { return at.metres(); });
  ato.advice_change = value["advice_change_m"].some_metres();
}

std::optional<Dialogue> step_of(const Value& value) {
  if (value.null()) return std::nullopt;
  const std::string procedure = value["procedure"].text(), step = value["step"].text();
  for (const DialogueRow& row : kDialogueRows)
    if (procedure == row.procedure && step == row.step) return row.value;
  value.fail();
  return std::nullopt;
}

void read_members(const Value& value, port::Display& d) {
  if (value["schema"].text() != "evc-dmi/1") value.fail();
  read_config(value["config"], d.config);
  d.now = value["now_ms"].ms();
  d.second_of_day = value["second_of_day"].some_whole<std::uint32_t>();
  d.mode = value["mode"].term<kModeRows>();
  d.level_valid = value["level_valid"].flag();
  read_shown_level(value["level"], d);
  d.standstill = value["standstill"].flag();
  d.language = language_of(value["language"]);
  read_speeds(value, d);
  read_symbols(value, d);
  read_planning(value["planning"], d);
  value["texts"].list(d.texts, text_of);
  value["acks"].list(d.acks, ack_of);
  read_data(value["data"], d.data);
  d.buttons = value["buttons"].set<Button>(terms::kNames<kButtonRows>);
  d.enabled = value["enabled"].set<DriverInput>(terms::kNames<kDriverInputRows>);
  d.step = step_of(value["step"]);
  d.start_of_mission = value["start_of_mission"].flag();
  d.waiting = value["waiting"].named<port::Waiting>(names::kWaitingNames);
  read_ato(value["ato"], d.ato);
}

}  // namespace

bool read_display(std::string_view text, port::Display& display) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return false;
  display = port::Display{};
  bool fault = false;
  read_members(Value(&json, fault), display);
  return !fault;
}

}  // namespace evc::io
