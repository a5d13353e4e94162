#include <algorithm>
#include <array>

#include "dmi/entry.h"
#include "dmi/geometry.h"
#include "dmi/labels.h"

namespace evc::dmi {
namespace {

using port::Display;

constexpr std::size_t kSteps = 5;  // of volume and brightness, 20 % each
constexpr std::size_t kFirstNtc = kLevelChoices.size();
constexpr std::size_t kAxleLoads = kAxleLoadRows.size(), kGauges = kLoadingGaugeRows.size();

Value typed(std::uint64_t number) {
  Value value;
  append_number(value.typed, static_cast<std::int64_t>(std::min<std::uint64_t>(number, 9999999999999999u)));
  return value;
}
Value chosen(std::size_t choice) {
  Value value;
  value.choice = static_cast<std::int16_t>(choice);
  return value;
}

/// The place of the n-th bit that is set, of those offered.
template <class Bits>
std::optional<std::size_t> nth_offered(Bits bits, std::size_t choice, std::size_t most) {
  for (std::size_t i = 0; i < most; ++i)
    if (((bits >> i) & 1u) != 0 && choice-- == 0) return i;
  return std::nullopt;
}
template <class Bits>
std::size_t count_offered(Bits bits, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < most; ++i) count += (bits >> i) & 1u;
  return count;
}
template <class Bits>
Value choice_among(Bits bits, std::size_t place) {
  if (((bits >> place) & 1u) == 0) return {};
  return chosen(count_offered(bits, place));
}

/// The loading gauges in the order of their keys (015560 Table 42), other than that of their codes.
constexpr std::array<LoadingGauge, kGauges> kGaugeKeys{LoadingGauge::G1, LoadingGauge::GA, LoadingGauge::GB,
                                                       LoadingGauge::GC, LoadingGauge::none};
bool is_offered(const Display& display, LoadingGauge gauge) {
  return ((display.config.loading_gauges >> terms::index(gauge)) & 1u) != 0;
}
std::optional<LoadingGauge> gauge_of(const Display& display, std::size_t choice) {
  for (const LoadingGauge gauge : kGaugeKeys)
    if (is_offered(display, gauge) && choice-- == 0) return gauge;
  return std::nullopt;
}
Value choice_of(const Display& display, LoadingGauge stored) {
  std::size_t choice = 0;
  for (const LoadingGauge gauge : kGaugeKeys) {
    if (!is_offered(display, gauge)) continue;
    if (gauge == stored) return chosen(choice);
    ++choice;
  }
  return {};
}

constexpr auto kCategories = static_cast<std::size_t>(TrainCategory::count);

std::uint16_t international(TrainCategoryBrake brake) {
  return brake == TrainCategoryBrake::passenger   ? train::kPassenger
         : brake == TrainCategoryBrake::freight_P ? train::kFreightP
                                                  : train::kFreightG;
}
Value category_of(const Display& display) {
  const port::ShownTrainData& train = display.data.stored.train;
  for (const TrainCategoryRow& row : kTrainCategoryRows)
    if (row.cant_deficiency_mm == train.cant_deficiency_mm && (train.other_categories & international(row.brake)) != 0)
      return choice_among(display.config.categories.bits(), terms::index(row.value));
  return {};
}

/// The national systems of the keyboard: those with a name, and those offered without one.
InplaceVector<std::uint8_t, 32> systems_of(const Display& display) {
  InplaceVector<std::uint8_t, 32> systems;
  const auto put = [&](std::uint8_t nid_ntc) {
    if (std::find(systems.begin(), systems.end(), nid_ntc) == systems.end() && !systems.push_back(nid_ntc)) return;
  };
  for (const port::NtcName& named : display.config.ntc_names) put(named.nid_ntc);
  for (const std::uint8_t nid_ntc : display.data.ntcs) put(nid_ntc);
  return systems;
}

Value stored_level(const Display& display) {
  if (display.data.stored.level_status == DataStatus::unknown) return {};
  if (display.level == Level::NTC) {
    const auto systems = systems_of(display);
    for (std::size_t i = 0; i < systems.size(); ++i)
      if (systems[i] == display.nid_ntc) return chosen(kFirstNtc + i);
    return {};
  }
  for (std::size_t i = 0; i < kLevelChoices.size(); ++i)
    if (kLevelChoices[i] == display.level) return chosen(i);
  return {};
}

Value stored_train(const Display& display, FieldId id) {
  if (display.data.stored.train_status == DataStatus::unknown) return {};
  const port::ShownTrainData& train = display.data.stored.train;
  switch (id) {
    case FieldId::train_type:
      return display.data.train_type ? chosen(*display.data.train_type) : Value{};
    case FieldId::category:
      return category_of(display);
    case FieldId::length:
      return typed(static_cast<std::uint64_t>(whole(train.L_TRAIN.si, 0, 99999)));
    case FieldId::brake_percentage:
      return train.brake_percentage ? typed(static_cast<std::uint64_t>(whole(*train.brake_percentage, 0, 999)))
                                    : Value{};
    case FieldId::maximum_speed:
      return typed(static_cast<std::uint64_t>(whole_kmh(train.V_MAXTRAIN)));
    case FieldId::axle_load:
      return choice_among(display.config.axle_loads, static_cast<std::size_t>(train.axle_load) % kAxleLoads);
    case FieldId::airtight:
      return chosen(train.airtight ? 1 : 0);
    case FieldId::gauge:
      return choice_of(display, train.loading_gauge);
    default:
      return {};
  }
}

Value stored_radio(const Display& display, FieldId id) {
  const port::ShownData& stored = display.data.stored;
  switch (id) {
    case FieldId::rbc_id:
      if (stored.rbc_status == DataStatus::unknown) return {};
      return typed((std::uint64_t{stored.rbc.NID_C} << 14) | (stored.rbc.NID_RBC & 0x3FFFu));
    case FieldId::rbc_phone: {
      Value value;
      if (stored.rbc_status != DataStatus::unknown) value.typed = from_bcd(stored.rbc.NID_RADIO, 16);
      return value;
    }
    case FieldId::network:
      for (std::size_t i = 0; stored.network && i < display.data.networks.size(); ++i)
        if (display.data.networks[i] == *stored.network) return chosen(i);
      return {};
    case FieldId::radio_type:
      return chosen(static_cast<std::size_t>(display.data.radio));
    default:
      return {};
  }
}

Value stored_sr(const Display& display, FieldId id) {
  const port::ShownSR& sr = display.data.stored.SR;
  if (sr.status == DataStatus::unknown) return {};
  if (id == FieldId::sr_speed) return typed(static_cast<std::uint64_t>(whole_kmh(sr.V)));
  // A distance that is infinite or longer than can be entered: the longest one (015560 11.7.6 S3).
  const double most = display.data.D_sr_most ? display.data.D_sr_most->si : display.config.D_sr.most;
  return typed(static_cast<std::uint64_t>(whole(sr.D && sr.D->si < most ? sr.D->si : most, 0, 999999)));
}

Words network_label(std::uint32_t network) {
  Words words;
  if (network == port::kDefaultNetwork) {
    words.append("Default");
    return words;
  }
  words.append(from_bcd(network, 6).view());
  return words;
}

Words level_label(const Display& display, std::size_t choice) {
  constexpr std::array<std::string_view, 4> kNames{"Level 1", "Level 2", "Level 3", "Level 0"};
  if (choice < kNames.size()) return Words{kNames[choice]};
  const auto systems = systems_of(display);
  return choice - kFirstNtc < systems.size() ? ntc_label(display, systems[choice - kFirstNtc]) : Words{};
}

Words train_label(const Display& display, FieldId id, std::size_t choice) {
  if (id == FieldId::train_type) {
    Words words;
    if (choice < display.config.train_types.size())
      append_latin(words, until_zero(display.config.train_types[choice].name));
    return words;
  }
  if (id == FieldId::category) {
    const auto place = nth_offered(display.config.categories.bits(), choice, kCategories);
    return place ? Words{name(static_cast<TrainCategory>(*place))} : Words{};
  }
  if (id == FieldId::axle_load) {
    const auto place = nth_offered(display.config.axle_loads, choice, kAxleLoads);
    return place ? Words{terms::kNames<kAxleLoadRows>[*place]} : Words{};
  }
  const auto gauge = gauge_of(display, choice);
  if (!gauge) return {};
  return Words{*gauge == LoadingGauge::none ? "Out of GC" : terms::kNames<kLoadingGaugeRows>[terms::index(*gauge)]};
}

Words two(std::string_view first, std::string_view second, std::size_t choice) {
  return Words{choice == 0 ? first : choice == 1 ? second : std::string_view{}};
}

}  // namespace

std::uint64_t to_bcd(std::string_view digits, int places) {
  std::uint64_t bcd = 0;
  for (int i = 0; i < places; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const bool digit = place < digits.size() && digits[place] >= '0' && digits[place] <= '9';
    bcd = (bcd << 4) | (digit ? static_cast<std::uint64_t>(digits[place] - '0') : 0xFu);
  }
  return bcd;
}

Text<16> from_bcd(std::uint64_t bcd, int places) {
  Text<16> text;
  for (int i = places; i-- > 0;) {
    const auto digit = (bcd >> (4 * i)) & 0xFu;
    if (digit > 9) break;
    text.append(static_cast<char>('0' + digit));
  }
  return text;
}

std::optional<std::uint64_t> typed_number(const Value& value) {
  if (value.typed.empty()) return std::nullopt;
  std::uint64_t number = 0;
  for (const char c : value.typed.view()) {
    if (c < '0' || c > '9') return std::nullopt;
    number = number * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return number;
}

Value stored_value(const State& state, FieldId id) {
  const Display& display = state.display;
  const port::ShownData& stored = display.data.stored;
  Value value;
  switch (id) {
    case FieldId::driver_id:
      if (stored.driver_id_status != DataStatus::unknown && stored.driver_id.valid())
        value.typed.append(stored.driver_id.view());
      return value;
    case FieldId::train_running_number:
      if (stored.train_running_number_status != DataStatus::unknown)
        value.typed = from_bcd(stored.train_running_number, 8);
      return value;
    case FieldId::level:
      return stored_level(display);
    case FieldId::language:
      for (std::size_t i = 0; i < display.config.languages.size(); ++i)
        if (display.config.languages[i] == display.language) return chosen(i);
      return value;
    case FieldId::volume:
      return chosen(static_cast<std::size_t>(state.volume / 20 - (state.volume >= 20 ? 1 : 0)));
    case FieldId::brightness:
      return chosen(static_cast<std::size_t>(state.brightness / 20 - (state.brightness >= 20 ? 1 : 0)));
    case FieldId::ato:
      return chosen(display.ato.on ? 1 : 0);
    case FieldId::adhesion:
      return chosen(display.slippery_rail ? 1 : 0);
    case FieldId::sr_speed:
    case FieldId::sr_distance:
      return stored_sr(display, id);
    case FieldId::rbc_id:
    case FieldId::rbc_phone:
    case FieldId::network:
    case FieldId::radio_type:
      return stored_radio(display, id);
    case FieldId::validation:
      return chosen(1);
    default:
      return stored_train(display, id);
  }
}

std::size_t choices_of(const State& state, FieldId id) {
  const Display& display = state.display;
  switch (id) {
    case FieldId::level:
      return kFirstNtc + systems_of(display).size();
    case FieldId::language:
      return display.config.languages.size();
    case FieldId::volume:
    case FieldId::brightness:
      return kSteps;
    case FieldId::network:
      return display.data.networks.size();
    case FieldId::radio_type:
      return 3;
    case FieldId::train_type:
      return display.config.train_types.size();
    case FieldId::category:
      return count_offered(display.config.categories.bits(), kCategories);
    case FieldId::axle_load:
      return count_offered(display.config.axle_loads, kAxleLoads);
    case FieldId::gauge:
      return count_offered(display.config.loading_gauges, kGauges);
    default:
      return 2;
  }
}

Words choice_label(const State& state, FieldId id, std::size_t choice) {
  const Display& display = state.display;
  switch (id) {
    case FieldId::level:
      return level_label(display, choice);
    case FieldId::language:
      return choice < display.config.languages.size() ? Words{language_name(display.config.languages[choice])}
                                                      : Words{};
    case FieldId::volume:
    case FieldId::brightness: {
      Words words = number_words(static_cast<std::int64_t>(20 * (choice + 1)));
      words.append(" %");
      return words;
    }
    case FieldId::ato:
      return two("Stand-by", "On", choice);
    case FieldId::adhesion:
      return two("Non slippery rail", "Slippery rail", choice);
    case FieldId::network:
      return choice < display.data.networks.size() ? network_label(display.data.networks[choice]) : Words{};
    case FieldId::radio_type:
      return choice == 2 ? Words{"GSM-R"} : two("FRMCS", "FRMCS+GSM-R", choice);
    case FieldId::one_radio_system:
    case FieldId::airtight:
    case FieldId::validation:
      return two("No", "Yes", choice);
    default:
      return train_label(display, id, choice);
  }
}

bool choice_enabled(const State& state, FieldId id, std::size_t choice) {
  if (choice >= choices_of(state, id)) return false;
  if (id != FieldId::level) return true;
  if (choice < kFirstNtc) {
    const Level level = kLevelChoices[choice];
    if (level == Level::L3 && state.display.config.srs == SrsVersion::v4_0_0) return false;
    return ((state.display.data.levels >> static_cast<unsigned>(level)) & 1u) != 0;
  }
  const auto systems = systems_of(state.display);
  const auto& offered = state.display.data.ntcs;
  return std::find(offered.begin(), offered.end(), systems[choice - kFirstNtc]) != offered.end();
}

std::optional<std::uint8_t> system_of_choice(const Display& display, std::size_t choice) {
  const auto systems = systems_of(display);
  if (choice < kFirstNtc || choice - kFirstNtc >= systems.size()) return std::nullopt;
  return systems[choice - kFirstNtc];
}

port::ShownTrainData entered_train_data(const State& state, const Entry& entry) {
  const port::DisplayConfig& config = state.display.config;
  port::ShownTrainData train = state.display.data.stored.train;
  if (const Value* type = value_of(entry, FieldId::train_type)) {
    if (type->choice >= 0 && static_cast<std::size_t>(type->choice) < config.train_types.size())
      return config.train_types[static_cast<std::size_t>(type->choice)].data;
    return train;
  }
  const auto number = [&](FieldId id) -> std::optional<double> {
    const Value* value = value_of(entry, id);
    const auto typed_in = value != nullptr ? typed_number(*value) : std::nullopt;
    if (!typed_in) return std::nullopt;
    return static_cast<double>(*typed_in);
  };
  const auto choice = [&](FieldId id, auto bits, std::size_t most) -> std::optional<std::size_t> {
    const Value* value = value_of(entry, id);
    if (value == nullptr || value->choice < 0) return std::nullopt;
    return nth_offered(bits, static_cast<std::size_t>(value->choice), most);
  };
  if (const auto length = number(FieldId::length)) train.L_TRAIN = Distance{*length};
  if (const auto percentage = number(FieldId::brake_percentage)) train.brake_percentage = *percentage;
  if (const auto speed = number(FieldId::maximum_speed)) train.V_MAXTRAIN = Speed{*speed / kKmh};
  if (const auto place = choice(FieldId::category, config.categories.bits(), kCategories)) {
    train.cant_deficiency_mm = kTrainCategoryRows[*place].cant_deficiency_mm;
    train.other_categories = international(kTrainCategoryRows[*place].brake);
  }
  if (const auto place = choice(FieldId::axle_load, config.axle_loads, kAxleLoads))
    train.axle_load = static_cast<AxleLoad>(*place);
  if (const Value* value = value_of(entry, FieldId::gauge); value != nullptr && value->choice >= 0)
    if (const auto gauge = gauge_of(state.display, static_cast<std::size_t>(value->choice)))
      train.loading_gauge = *gauge;
  if (const Value* airtight = value_of(entry, FieldId::airtight)) train.airtight = airtight->choice == 1;
  return train;
}

}  // namespace evc::dmi
