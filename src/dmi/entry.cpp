#include "dmi/entry.h"

#include <algorithm>

#include "dmi/acks.h"
#include "dmi/windows.h"
#include "dmi/words.h"

namespace evc::dmi {
namespace {

struct FieldRow {
  WindowId window;
  FieldId field;
};
constexpr auto kFieldRows = std::to_array<FieldRow>({
    FieldRow{WindowId::driver_id, FieldId::driver_id},
    FieldRow{WindowId::train_running_number, FieldId::train_running_number},
    FieldRow{WindowId::level, FieldId::level},
    FieldRow{WindowId::language, FieldId::language},
    FieldRow{WindowId::volume, FieldId::volume},
    FieldRow{WindowId::brightness, FieldId::brightness},
    FieldRow{WindowId::set_vbc, FieldId::vbc_to_set},
    FieldRow{WindowId::remove_vbc, FieldId::vbc_to_remove},
    FieldRow{WindowId::ato, FieldId::ato},
    FieldRow{WindowId::adhesion, FieldId::adhesion},
    FieldRow{WindowId::sr_data, FieldId::sr_speed},
    FieldRow{WindowId::sr_data, FieldId::sr_distance},
    FieldRow{WindowId::rbc_data, FieldId::rbc_id},
    FieldRow{WindowId::rbc_data, FieldId::rbc_phone},
    FieldRow{WindowId::network_id, FieldId::network},
    FieldRow{WindowId::radio_type, FieldId::radio_type},
    FieldRow{WindowId::one_radio_system, FieldId::one_radio_system},
    FieldRow{WindowId::train_data, FieldId::category},
    FieldRow{WindowId::train_data, FieldId::length},
    FieldRow{WindowId::train_data, FieldId::brake_percentage},
    FieldRow{WindowId::train_data, FieldId::maximum_speed},
    FieldRow{WindowId::train_data, FieldId::axle_load},
    FieldRow{WindowId::train_data, FieldId::airtight},
    FieldRow{WindowId::train_data, FieldId::gauge},
    FieldRow{WindowId::validate_train_data, FieldId::validation},
    FieldRow{WindowId::validate_set_vbc, FieldId::validation},
    FieldRow{WindowId::validate_remove_vbc, FieldId::validation},
});

constexpr Duration kTapTime{2.0};  // of a multi-tap (015560 10.3.2.5)
constexpr int kDeleteKey = 10, kZeroKey = 11, kLastKey = 12, kNoKey = 7, kYesKey = 8;
constexpr std::array<std::string_view, 9> kLetters{"1",    "2abc",  "3def", "4ghi", "5jkl",
                                                   "6mno", "7pqrs", "8tuv", "9wxyz"};

const port::EntryRange* range_of(const State& state, FieldId id) {
  const port::DisplayConfig& config = state.display.config;
  switch (id) {
    case FieldId::length:
      return &config.L_TRAIN;
    case FieldId::brake_percentage:
      return &config.brake_percentage;
    case FieldId::maximum_speed:
      return &config.V_MAXTRAIN;
    case FieldId::sr_speed:
      return &config.V_sr;
    case FieldId::sr_distance:
      return &config.D_sr;
    default:
      return nullptr;
  }
}

/// The check of a value at Enter (015560 10.3.4.2, 10.3.4.3, 10.3.4.5).
Check check_range(const State& state, const Field& field) {
  const auto number = typed_number(field.value);
  // Three codes have 24 bits: country and RBC (015560 11.3.5.3.1); validity period, country and identity of a virtual
  // balise cover (11.3.12.5), of which the code to remove it does not need the period (11.3.13.5).
  if (field.id == FieldId::rbc_id || field.id == FieldId::vbc_to_set || field.id == FieldId::vbc_to_remove)
    return number && *number < (1u << 24) ? Check::passed : Check::technical_range;
  const port::EntryRange* range = range_of(state, field.id);
  if (range == nullptr) return Check::passed;
  if (!number) return Check::technical_range;
  const auto value = static_cast<double>(*number);
  if (value < range->least || value > range->most) return Check::technical_range;
  if (range->step >= 1.0 && *number % static_cast<std::uint64_t>(std::min(range->step, 1e6)) != 0)
    return Check::technical_range;
  const bool low = range->operational_least && value < *range->operational_least;
  const bool high = range->operational_most && value > *range->operational_most;
  return low || high ? Check::operational_range : Check::passed;
}

/// The choice of a key of a dedicated keyboard; below 0: none.
int choice_of_key(const State& state, FieldId id, int number) {
  if (keyboard_of(id) == Keyboard::yes_no) return number == kNoKey ? 0 : number == kYesKey ? 1 : -1;
  const std::size_t count = choices_of(state, id);
  if (count <= static_cast<std::size_t>(kLastKey)) return number - 1;
  if (number == kLastKey) return -1;
  return state.entry.choices_from + number - 1;
}

/// Whether a check at Enter has rejected the value.
bool rejected(const Field& field) {
  return field.check == Check::technical_range || field.check == Check::operational_range;
}

/// The first key since the field was selected, or since a check rejected the value, replaces what is shown
/// (015560 10.3.1.19).
bool replaces(const Field& field) { return !field.typed || rejected(field); }

/// The echo texts of fields that a rule across them has rejected show their values again.
void end_cross_check(Entry& entry) {
  entry.cross = Check::passed;
  for (Field& field : entry.fields)
    if (field.check == Check::technical_cross || field.check == Check::operational_cross) field.check = Check::passed;
}

/// Before a key changes what is shown: the data value is kept until it is replaced or deleted. One that a check has
/// rejected is not.
void keep(Field& field) {
  if (rejected(field)) {
    field.kept = Value{};
  } else if (!field.typed) {
    field.kept = field.value;
    field.kept_accepted = field.accepted;
  }
}

void changed(State& state, Field& field) {
  field.typed = true;
  field.accepted = false;
  field.check = Check::passed;
  state.entry.overruled = 0;
  end_cross_check(state.entry);
}

void type_character(Field& field, char c) {
  if (replaces(field)) field.value.typed.clear();
  if (field.value.typed.length < most_characters(field.id)) field.value.typed.append(c);
}

/// A key with letters: pressed again in time it changes the last character (015560 10.3.2.5).
void tap(State& state, Field& field, int number, Duration now) {
  Entry& entry = state.entry;
  const std::string_view letters = kLetters[static_cast<std::size_t>(number - 1) % kLetters.size()];
  const bool again = entry.tap_key == number && tap_runs(entry, now) && field.typed && !field.value.typed.empty();
  if (again) {
    entry.tap_count = static_cast<std::uint8_t>((entry.tap_count + 1u) % letters.size());
    field.value.typed.characters[field.value.typed.length - 1u] = letters[entry.tap_count];
  } else {
    entry.tap_count = 0;
    type_character(field, letters[0]);
  }
  entry.tap_key = static_cast<std::uint8_t>(number);
  entry.tap_at = now;
}

void select(State& state, std::size_t place) {
  Entry& entry = state.entry;
  entry.selected = static_cast<std::uint8_t>(place);
  entry.choices_from = 0;
  entry.tap_key = 0;
  state.page = static_cast<std::uint8_t>(place / kFieldsPerPage);
}

/// A check of train data across fields (015560 10.3.4.4, 10.3.4.6): whether the train is too fast for its category.
bool fails(const port::CrossCheck& check, const port::ShownTrainData& train, std::optional<std::size_t> category) {
  if (!category || !check.categories.has(static_cast<TrainCategory>(*category))) return false;
  return train.V_MAXTRAIN > check.V_most;
}

}  // namespace

Keyboard keyboard_of(FieldId id) {
  switch (id) {
    case FieldId::driver_id:
      return Keyboard::alphanumeric;
    case FieldId::airtight:
    case FieldId::one_radio_system:
    case FieldId::validation:
      return Keyboard::yes_no;
    case FieldId::train_running_number:
    case FieldId::vbc_to_set:
    case FieldId::vbc_to_remove:
    case FieldId::sr_speed:
    case FieldId::sr_distance:
    case FieldId::rbc_id:
    case FieldId::rbc_phone:
    case FieldId::length:
    case FieldId::brake_percentage:
    case FieldId::maximum_speed:
      return Keyboard::numeric;
    default:
      return Keyboard::dedicated;
  }
}

std::uint8_t most_characters(FieldId id) {
  switch (id) {
    case FieldId::driver_id:
    case FieldId::rbc_phone:
      return 16;
    case FieldId::train_running_number:
    case FieldId::vbc_to_set:
    case FieldId::vbc_to_remove:
    case FieldId::rbc_id:
      return 8;
    case FieldId::sr_distance:
      return 6;
    case FieldId::length:
      return 4;
    case FieldId::brake_percentage:
    case FieldId::maximum_speed:
    case FieldId::sr_speed:
      return 3;
    default:
      return 0;
  }
}

bool is_entered(const port::Display& display, FieldId id) {
  switch (id) {
    case FieldId::rbc_phone:  // where GSM-R is used (015560 11.3.5.4)
      return display.data.radio != port::RadioNetworkType::frmcs && display.config.gsmr_fitted;
    case FieldId::brake_percentage:
      return display.config.asks_brake_percentage;
    default:
      return true;
  }
}

bool uses_train_types(const State& state) {
  const port::TrainDataEntry kind = state.display.config.train_data_entry;
  return kind == port::TrainDataEntry::fixed || (kind == port::TrainDataEntry::switchable && state.fixed_train_entry);
}

void begin_entry(State& state, WindowId window) {
  state.entry = Entry{};
  const bool types = window == WindowId::train_data && uses_train_types(state);
  for (const FieldRow& row : kFieldRows) {
    if (row.window != window || types || !is_entered(state.display, row.field)) continue;
    if (!state.entry.fields.push_back({.id = row.field, .value = stored_value(state, row.field)})) return;
  }
  if (types &&
      !state.entry.fields.push_back({.id = FieldId::train_type, .value = stored_value(state, FieldId::train_type)}))
    return;
}

Shown shown_fields(const State& state) {
  const std::size_t count = state.entry.fields.size();
  const std::size_t first = std::min<std::size_t>(count, kFieldsPerPage * state.page);
  return {first, std::min(count, first + kFieldsPerPage)};
}

Field* selected_field(State& state) {
  return state.entry.selected < state.entry.fields.size() ? &state.entry.fields[state.entry.selected] : nullptr;
}
const Field* selected_field(const State& state) {
  return state.entry.selected < state.entry.fields.size() ? &state.entry.fields[state.entry.selected] : nullptr;
}
const Value* value_of(const Entry& entry, FieldId id) {
  for (const Field& field : entry.fields)
    if (field.id == id) return &field.value;
  return nullptr;
}

Key key_at(const State& state, int number) {
  Key key;
  const Field* field = selected_field(state);
  if (field == nullptr) return key;
  const Keyboard keyboard = keyboard_of(field->id);
  if (keyboard == Keyboard::dedicated || keyboard == Keyboard::yes_no) {
    if (keyboard == Keyboard::dedicated && number == kLastKey &&
        choices_of(state, field->id) > static_cast<std::size_t>(kLastKey)) {
      key.picture = Picture::NA23;
      key.enabled = true;
      key.type = ButtonType::up;  // as every button that turns pages, other than keys (015560 5.3.2.7.4)
      return key;
    }
    key.choice = static_cast<std::int16_t>(choice_of_key(state, field->id, number));
    if (key.choice < 0 || static_cast<std::size_t>(key.choice) >= choices_of(state, field->id)) return key;
    key.label = choice_label(state, field->id, static_cast<std::size_t>(key.choice));
    key.enabled = choice_enabled(state, field->id, static_cast<std::size_t>(key.choice));
    // The key of level 3 exists up to 3.6.0 (015560 11.3.2.5).
    if (field->id == FieldId::level && key.choice == 2 && !key.enabled &&
        state.display.config.srs == SrsVersion::v4_0_0)
      key.label.clear();
    return key;
  }
  key.enabled = number != kLastKey;
  if (number == kDeleteKey) key.type = ButtonType::down_repeat;
  key.bold = number == kLastKey;
  if (number == kDeleteKey) {
    key.picture = Picture::NA21;
  } else if (number == kZeroKey) {
    key.label.append('0');
  } else if (number == kLastKey) {
    key.label.append('.');
  } else if (number >= 1 && number <= 9) {
    const std::string_view letters = kLetters[static_cast<std::size_t>(number - 1)];
    key.label.append(part_of(letters, 0, 1));
    if (keyboard == Keyboard::alphanumeric && letters.size() > 1) {
      key.label.append(' ');
      key.label.append(part_of(letters, 1));
      key.type = ButtonType::down_repeat;  // held it goes on to the next character (015560 10.3.2.5 b)
    }
  }
  return key;
}

void press_key(State& state, int number, Duration now) {
  Field* field = selected_field(state);
  const Key key = key_at(state, number);
  if (field == nullptr || !key.enabled) return;
  const Keyboard keyboard = keyboard_of(field->id);
  if (keyboard == Keyboard::dedicated || keyboard == Keyboard::yes_no) {
    if (key.choice >= 0) {
      keep(*field);
      field->value = Value{};
      field->value.choice = key.choice;
      return changed(state, *field);
    }
    const std::size_t next = state.entry.choices_from + 11u;
    state.entry.choices_from = static_cast<std::uint8_t>(next < choices_of(state, field->id) ? next : 0);
    return;
  }
  keep(*field);
  field->value.choice = -1;
  if (number == kDeleteKey) {
    if (!field->value.typed.empty()) --field->value.typed.length;
    state.entry.tap_key = 0;
  } else if (number == kZeroKey || keyboard == Keyboard::numeric) {
    type_character(*field, static_cast<char>('0' + (number == kZeroKey ? 0 : number)));
    state.entry.tap_key = 0;
  } else {
    tap(state, *field, number, now);
  }
  changed(state, *field);
}

bool tap_runs(const Entry& entry, Duration now) { return entry.tap_key != 0 && now - entry.tap_at < kTapTime; }

void end_tap(State& state, Duration now) {
  if (!tap_runs(state.entry, now)) state.entry.tap_key = 0;
}

bool enter_enabled(const State& state) {
  const Field* field = selected_field(state);
  return field != nullptr && field->check != Check::technical_range && field->value.given();
}

bool enter_is_delayed(const State& state) {
  const Field* field = selected_field(state);
  return field != nullptr && field->check == Check::operational_range;
}

bool touch_field(State& state, std::size_t place) {
  Entry& entry = state.entry;
  if (place >= entry.fields.size()) return false;
  Field& current = entry.fields[entry.selected % entry.fields.size()];
  if (place != entry.selected) {
    // A new value that was not accepted is erased, and the old one is deleted (015560 10.3.1.20).
    if (current.typed && !current.accepted) current.value = Value{};
    if (rejected(current)) current.check = Check::passed;
    current.typed = false;
    select(state, place);
    entry.fields[place].typed = false;
    return false;
  }
  if (!enter_enabled(state)) return false;
  const bool insisted = current.check == Check::operational_range;
  const Check found = check_range(state, current);
  if (found == Check::technical_range || (found == Check::operational_range && !insisted)) {
    current.check = found;
    return false;
  }
  if (current.check == Check::operational_range) current.check = Check::passed;
  // A value accepted anew may be checked across again (015560 10.3.4.4.4).
  if (entry.cross == Check::technical_cross) end_cross_check(entry);
  current.accepted = true;
  current.typed = false;
  if (entry.fields.size() == 1 && !is_full(state.window)) return true;
  if (layout_of(state.window) == Layout::validation) return true;
  const std::size_t next = (place + 1) % entry.fields.size();
  if (next == place) return false;
  select(state, next);
  entry.fields[next].typed = false;
  return false;
}

bool can_turn_page(const State& state, bool forward) {
  if (is_entry(state.window)) {
    const Field* field = selected_field(state);
    if (field != nullptr && rejected(*field)) return false;
  }
  return forward ? state.page + 1u < pages_of(state) : state.page > 0;
}

bool complete_enabled(const State& state) {
  if (state.entry.fields.empty() || state.entry.cross == Check::technical_cross) return false;
  for (const Field& field : state.entry.fields) {
    const bool held = field.value.given() && !(field.typed && !field.accepted);
    if (!held || rejected(field)) return false;
  }
  return true;
}

bool complete_is_delayed(const State& state) { return state.entry.cross == Check::operational_cross; }

bool check_across(State& state) {
  if (state.window != WindowId::train_data) return true;
  Entry& entry = state.entry;
  // The driver insists: this rule is overruled, the others are not (015560 10.3.4.6.5).
  if (entry.cross == Check::operational_cross) entry.overruled |= static_cast<std::uint8_t>(1u << entry.failed);
  end_cross_check(entry);
  const port::ShownTrainData train = entered_train_data(state, state.entry);
  std::optional<std::size_t> category;
  for (const TrainCategoryRow& row : kTrainCategoryRows) {
    const std::uint16_t other = row.brake == TrainCategoryBrake::passenger   ? train::kPassenger
                                : row.brake == TrainCategoryBrake::freight_P ? train::kFreightP
                                                                             : train::kFreightG;
    if (!category && row.cant_deficiency_mm == train.cant_deficiency_mm && (train.other_categories & other) != 0)
      category = terms::index(row.value);
  }
  const auto& rules = state.display.config.cross_checks;
  for (const bool operational : {false, true}) {
    for (std::size_t i = 0; i < rules.size(); ++i) {
      if (rules[i].operational != operational || !fails(rules[i], train, category)) continue;
      if (operational && ((entry.overruled >> i) & 1u) != 0) continue;
      entry.cross = operational ? Check::operational_cross : Check::technical_cross;
      entry.failed = static_cast<std::uint8_t>(i);
      for (Field& field : entry.fields)
        if (field.id == FieldId::category || field.id == FieldId::maximum_speed || field.id == FieldId::train_type)
          field.check = entry.cross;
      return false;
    }
  }
  return true;
}

Words shown_value(const State& state, const Field& field) {
  if (field.value.choice >= 0) return choice_label(state, field.id, static_cast<std::size_t>(field.value.choice));
  const std::string_view typed = field.value.typed.view();
  Words words;
  // More than five characters of a line: two groups with a blank; a line has eight (015560 5.1.5.2).
  for (std::size_t line = 0; line < typed.size(); line += 8) {
    const std::string_view part = part_of(typed, line, 8);
    if (line > 0) words.append('\n');
    const std::size_t first = part.size() > 5 ? (part.size() + 1) / 2 : part.size();
    words.append(part_of(part, 0, first));
    if (first < part.size()) {
      words.append(' ');
      words.append(part_of(part, first));
    }
  }
  return words;
}

Echo echo_of(const State& state, const Field& field) {
  switch (field.check) {
    case Check::technical_range:
      return {"++++", Colour::red};
    case Check::operational_range:
      return {"++++", Colour::yellow};
    case Check::technical_cross:
      return {"????", Colour::red};
    case Check::operational_cross:
      return {"????", Colour::yellow};
    case Check::passed:
      break;
  }
  if (!field.typed) return {shown_value(state, field), field.accepted ? Colour::white : Colour::grey};
  Field data = field;
  data.value = field.kept;
  return {shown_value(state, data), field.kept_accepted ? Colour::white : Colour::grey};
}

}  // namespace evc::dmi
