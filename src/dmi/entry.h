#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "dmi/state.h"

// Data entry (chapter 10): fields, keyboards, checks.
namespace evc::dmi {

enum class Keyboard : std::uint8_t { numeric, alphanumeric, yes_no, dedicated };
Keyboard keyboard_of(FieldId);
/// The most characters of a typed value.
std::uint8_t most_characters(FieldId);

inline constexpr std::size_t kFieldsPerPage = 4;

/// Whether the driver enters the field with this train and these radio systems, and the data view shows it.
bool is_entered(const port::Display&, FieldId);
/// Whether train data are entered by a train type: the layout that was used last, where it can be switched
/// (015560 11.3.9.6, 11.3.9.7.1).
bool uses_train_types(const State&);
/// Begins the process of a window: its fields with what is stored.
void begin_entry(State&, WindowId);
/// The fields that stand on the page that is shown: [first, last).
struct Shown {
  std::size_t first = 0, last = 0;
};
Shown shown_fields(const State&);
Field* selected_field(State&);
const Field* selected_field(const State&);

/// A key as it is labelled now.
struct Key {
  Words label;
  std::optional<Picture> picture;
  bool enabled = false;
  bool bold = false;
  ButtonType type = ButtonType::down;
  std::int16_t choice = -1;  ///< with a dedicated keyboard
};
Key key_at(const State&, int number);
void press_key(State&, int number, Duration now);
/// Whether the same key would change the last character (015560 10.3.2.5): the cursor waits below it.
bool tap_runs(const Entry&, Duration now);
/// Closes a multi-tap whose time is over.
void end_tap(State&, Duration now);

/// Selects the field, or enters the value of the selected one. True when a window with one field is complete.
bool touch_field(State&, std::size_t place);
bool enter_enabled(const State&);
/// An operational limit is to be overruled: a delay button.
bool enter_is_delayed(const State&);
bool can_turn_page(const State&, bool forward);
bool complete_enabled(const State&);
bool complete_is_delayed(const State&);
/// Yes of "entry complete?": whether the checks across fields let it pass.
bool check_across(State&);

/// The number of choices of a dedicated keyboard, and their labels.
std::size_t choices_of(const State&, FieldId);
Words choice_label(const State&, FieldId, std::size_t choice);
/// The first choices of the level window (015560 11.3.2); the national systems follow.
inline constexpr std::array<Level, 4> kLevelChoices{Level::L1, Level::L2, Level::L3, Level::L0};
/// NID_NTC of a choice of the level window; none where it is another level.
std::optional<std::uint8_t> system_of_choice(const port::Display&, std::size_t choice);
bool choice_enabled(const State&, FieldId, std::size_t choice);

/// A value as the driver reads it, with its blanks (015560 5.1.5).
Words shown_value(const State&, const Field&);
/// As `shown_value`, or what the last check found, and its colour.
struct Echo {
  Words words;
  Colour colour{};
};
Echo echo_of(const State&, const Field&);

/// The number that was typed; none: not only digits, or none.
std::optional<std::uint64_t> typed_number(const Value&);
/// The value of a field of the process; null: not in it.
const Value* value_of(const Entry&, FieldId);
/// What is stored of a field, as the window proposes it (015560 10.6).
Value stored_value(const State&, FieldId);
/// Left aligned decimal digits, filled with F to `places`.
std::uint64_t to_bcd(std::string_view digits, int places);
Text<16> from_bcd(std::uint64_t bcd, int places);

/// Train data of the fields of the process; what is not among them stays as stored.
port::ShownTrainData entered_train_data(const State&, const Entry&);

}  // namespace evc::dmi
