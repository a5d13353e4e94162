#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "dmi/screen.h"
#include "openevc/base/inplace_vector.h"
#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/port/display.h"
#include "openevc/port/inputs.h"

// The memory of the driver-machine interface: what the driver opened, typed and toggled, and the on-board's last state.
namespace evc::dmi {

/// The windows of 015560 chapters 8 and 11.
enum class WindowId : std::uint8_t {
  default_,
  main,
  override_,
  data_view,
  special,
  settings,
  radio_data,
  driver_id,
  train_running_number,
  level,
  language,
  volume,
  brightness,
  system_version,
  set_vbc,
  remove_vbc,
  ato,
  adhesion,
  sr_data,
  rbc_data,
  network_id,
  radio_type,
  one_radio_system,
  train_data,
  validate_train_data,
  validate_set_vbc,
  validate_remove_vbc,
  count
};

/// The data that windows enter.
enum class FieldId : std::uint8_t {
  driver_id,
  train_running_number,
  level,
  language,
  volume,
  brightness,
  vbc_to_set,
  vbc_to_remove,
  ato,
  adhesion,
  sr_speed,
  sr_distance,
  rbc_id,
  rbc_phone,
  network,
  radio_type,
  one_radio_system,
  train_type,
  category,
  length,
  brake_percentage,
  maximum_speed,
  axle_load,
  airtight,
  gauge,
  validation,
  count
};

/// A value: typed characters, or a choice of a dedicated keyboard.
struct Value {
  Text<16> typed;
  std::int16_t choice = -1;
  constexpr bool given() const { return choice >= 0 || !typed.empty(); }
  friend constexpr bool operator==(const Value&, const Value&) = default;
};

/// What a check of 015560 10.3.4 found.
enum class Check : std::uint8_t {
  passed,
  technical_range,    ///< "++++" red
  operational_range,  ///< "++++" yellow: the driver may insist
  technical_cross,    ///< "????" red
  operational_cross   ///< "????" yellow
};

/// An input field.
struct Field {
  FieldId id{};
  Value value;            ///< as it is shown: the data value, or that of the keys pressed
  bool typed = false;     ///< a key was pressed since it was selected
  bool accepted = false;  ///< in this process
  /// The data value while keys are pressed, which the echo text goes on showing (015560 10.3.1.19 to 10.3.1.21), and
  /// whether it was accepted.
  Value kept = {};
  bool kept_accepted = false;
  Check check = Check::passed;
};

/// The data entry process that runs (015560 10.6).
struct Entry {
  InplaceVector<Field, 8> fields;
  std::uint8_t selected = 0;
  std::uint8_t choices_from = 0;  ///< the first choice on the keyboard: key "More"
  std::uint8_t tap_key = 0;       ///< the key of a multi-tap that runs; 0: none
  std::uint8_t tap_count = 0;
  Duration tap_at{};
  Check cross = Check::passed;  ///< of the last Yes
  std::uint8_t failed = 0;      ///< place of the rule in DisplayConfig::cross_checks that `cross` is about
  std::uint8_t overruled = 0;   ///< bit n: the driver has insisted on values against rule n
};

enum class ActionKind : std::uint8_t {
  none,
  open,    ///< argument: WindowId
  button,  ///< argument: Button
  close,
  next,
  previous,
  key,           ///< argument: 1 to 12
  field,         ///< argument: place in Entry::fields: selects it, or accepts the one that is selected
  complete,      ///< Yes of "entry complete?"
  switch_entry,  ///< between train types and train data
  ack,
  toggle_speed,
  toggle_tunnel,
  toggle_geo,
  zoom_in,
  zoom_out,
  scroll_up,
  scroll_down,
  track_ahead_free,
  ato_engage,
  ato_disengage,
  skip_stop
};

struct Action {
  ActionKind kind = ActionKind::none;
  std::uint8_t argument = 0;
  friend constexpr bool operator==(const Action&, const Action&) = default;
};

/// A place that reacts to touch.
struct Target {
  Rect abs;
  Action action;
  ButtonType type = ButtonType::up;
  bool enabled = true;
};
using Targets = InplaceVector<Target, 64>;

/// The button that is held (015560 5.3.2.6): only one at a time.
struct Pressed {
  bool held = false;
  Target target;
  bool inside = true;
  Duration since{};           ///< since it was touched, or slid into again
  bool started_over = false;  ///< a delay button that was left in between
  std::uint16_t repeats = 0;
  std::optional<port::AskedAck> ack = {};  ///< with an acknowledgement: what is acknowledged
};

/// The acknowledgement on offer (015560 5.4).
struct Offered {
  port::AskedAck ack;
  Duration since{};
};

/// An acknowledgement that the driver gave and the on-board has not taken yet.
struct Answered {
  port::AskedAck ack;
  Duration at{};
};

/// What the driver did, for the on-board; complete for a cycle.
struct Commands {
  port::DriverActions actions;  ///< its `train_data` is null: see below
  Set<port::Window> windows;    ///< open now
  std::optional<port::ShownTrainData>
      train_data;                               ///< entered and validated: `with_entered` makes the train's data of it
  std::optional<std::uint8_t> train_type;       ///< with fixed entry: place in DisplayConfig::train_types
  std::optional<port::RadioNetworkType> radio;  // 4.0.0
  std::optional<bool> one_radio_system, ato_on, skip_stop;
  InplaceVector<SoundOrder, 16> sounds;  ///< that started or stopped since the last `take`
};

/// An answer of the on-board that a window waits for with the hour glass.
struct Awaited {
  bool on = false, seen = false;
  Duration since{};
  WindowId then = WindowId::default_;
  bool needs_mode = false;  ///< `then` only when the mode is no longer `mode`
  Mode mode = Mode::SB;
};

/// What distinguishes a text from others.
struct TextKey {
  std::uint16_t id = 0;
  port::TextKind kind{};
  Duration since{};
  friend constexpr bool operator==(const TextKey&, const TextKey&) = default;
};

struct Toggles {
  bool speed = false, tunnel = false, geo = false;
};

struct State {
  port::Display display;
  bool shown_once = false;
  bool main_reached =
      false;  ///< the start-up dialogue has led to the Main window, which it is not left for (11.7.2 S10)
  WindowId window = WindowId::default_;
  std::uint8_t page = 0;
  bool from_driver_id = false;  ///< settings or train running number, opened in the window Driver ID
  Entry entry;
  Entry validated;                 ///< the entry that a validation window asks about
  bool fixed_train_entry = false;  ///< switchable entry: the layout used last
  /// Since level 2 was entered from level 0 or NTC, as long as the train may trip for it (015560 11.7.3 D5).
  std::optional<Duration> trip_awaited_since;
  Awaited awaited;
  Duration waiting_since{};  ///< of Display::waiting
  Toggles toggles;
  std::uint8_t zoom = 2;                      ///< place in kRanges
  std::uint16_t scroll = 0;                   ///< lines
  InplaceVector<TextKey, 32> unheard;         ///< important texts that were not displayed yet
  std::array<std::uint16_t, 3> slots{};       ///< ids of the conditions in B3 to B5, 0: free
  std::uint8_t volume = 60, brightness = 60;  ///< percent
  std::optional<Offered> offered;
  InplaceVector<Answered, 32> answered;
  Duration next_offer{};  ///< not before
  bool brake_acknowledged = false;
  Pressed pressed;
  bool warning_sounds = false;  ///< S2 is on
  Commands commands;
};
static_assert(std::is_trivially_copyable_v<State>);

}  // namespace evc::dmi
