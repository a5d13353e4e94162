#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "explain/brought.h"
#include "kernel/examine.h"
#include "sim/cycle_inputs.h"
#include "terms/mrsp_source.h"

// The memory of an explanation: what happened in the journey up to now, and where it came from.
namespace evc::explain {

/// An event, and the telegram or message it came with.
struct Note {
  std::int64_t t_ms = 0;
  port::Event event;
  std::string source;  ///< "group 100", "message 3 (Movement authority)"; nothing: of no input from the track
  std::string detail;  ///< what the event does not say: which balise of a group was not read
  // Of an event of a cycle in which the end of the authority changed:
  std::string ended, became;  ///< before and after it; nothing: without one
  bool nearer = false;        ///< the end or what is supervised behind it came nearer
};

/// What driver, train interface or bearer did; not what the unit refused in the same cycle.
struct Act {
  enum class Kind : std::uint8_t {
    select,
    acknowledge,
    SR_speed,
    SR_distance,
    window,
    desk,
    power,
    isolation,
    sleeping,
    non_leading,
    passive_shunting,
    controller,
    antenna,
    external_data,
    national_system,
    fault,
    session
  };
  std::int64_t t_ms = 0;
  Kind kind{};
  std::string text;        ///< "driver acknowledges OS"
  std::uint8_t about = 0;  ///< the Select that is selected, the Ack that is given, the Window, the national order
};

/// Of the radio: lost or refused.
inline constexpr std::uint8_t kNotConnected = 1;
/// The orders of a national system.
inline constexpr std::uint8_t kNationalService = 0, kNationalEmergency = 1, kNationalTrip = 2;

/// A message of an RBC.
struct Contact {
  std::int64_t t_ms = 0;
  std::uint8_t NID_MESSAGE = 0;
};

/// The last radio hole that was left (3.16.3.4.1.3).
struct RadioHole {
  std::int64_t from_ms = 0, to_ms = 0;
  std::optional<NoteIndex> packet;  ///< that announced it
  std::string place;                ///< "from 332.0 m to 532.0 m"
  std::optional<Contact> last;      ///< the last message of the supervising RBC before its end
};

/// The national values that the last set replaced.
struct ReplacedValues {
  std::int64_t t_ms = 0;  ///< when
  train::NationalValues values;
};

/// A group that linking announced last, with its place as of then.
struct Announced {
  Note note;
  balise::Link link;
  std::string place;
};

/// The telegrams of a group that was read last: bit n for N_PIG n.
struct GroupRead {
  std::int64_t t_ms = 0;
  unsigned total = 0, read = 0;
  std::int64_t began_ms = 0;
};

/// A cycle with the memory of the unit before and after it.
struct Moment {
  std::int64_t t_ms = 0;
  kernel::State before, deciding, after;  ///< `deciding`: with the inputs of the cycle, in the mode before it
  kernel::Derived::Curves curves;
  procedures::Facts facts;
  kernel::Outputs outputs;
  port::Odometry odometry;
  port::TrainSignals train;
  bool safety_fault = false;  ///< reported from outside
};

/// A brake command by one cause: its first cycle, and the first one without it.
struct Braking {
  std::unique_ptr<Moment> onset;
  std::optional<std::int64_t> until;
  std::optional<std::int64_t> failed;  ///< the service brake was not applied, or is not any more (3.14.1.2)
  std::unique_ptr<Moment> beyond_EBI;  ///< after an emergency brake in place of the service brake
};

class Journal {
 public:
  /// A cycle that was answered. `before` is the state before it.
  void take(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
            const kernel::Derived& derived, const kernel::Examined& seen, const kernel::Outputs& outputs);
  /// Keeps the last cycle as `now`.
  void stop_here(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
                 const kernel::Derived& derived, const kernel::Examined& seen, const kernel::Outputs& outputs);

  const std::vector<Note>& notes() const { return notes_; }
  /// The cycle in which the mode was entered; null: at power-up.
  const Moment* mode_entry() const { return entry_.get(); }
  const std::map<Cause, Braking>& brakings() const { return brakings_; }
  const Moment& now() const { return *now_; }

  /// The last note of a kind, not after `t_ms`; with `id` of that id. Null: none.
  const Note* last(What what, std::int64_t t_ms, std::optional<std::int32_t> id = {}) const;
  /// The same of an act; with `about` of that Select or Ack.
  const Act* last(Act::Kind kind, std::int64_t t_ms, std::optional<std::uint8_t> about = {}) const;
  /// The last packet accepted with that number, as of X = 2. Null: none.
  const Note* last_packet(std::int32_t NID_PACKET) const;
  const Brought& brought() const { return brought_; }
  /// Null: none.
  const Note* note(std::optional<NoteIndex> index) const { return index ? &notes_[*index] : nullptr; }
  /// The note with which a text came, by its identity on board.
  const Note* of_text(std::uint8_t id) const;
  /// Of a group, by NID_BG; null: never announced.
  const Announced* announced(std::int32_t NID_BG) const;
  /// The last message of an RBC that was not rejected; null: none.
  const Contact* last_of(const radio::Rbc& rbc) const;
  const std::optional<RadioHole>& radio_hole() const { return radio_hole_; }
  /// Whether the national values were the default ones when the journey began.
  bool starts_with_defaults() const { return starts_with_defaults_; }
  const std::optional<ReplacedValues>& replaced_values() const { return replaced_values_; }

 private:
  void take_notes(const sim::CycleInputs& cycle, const kernel::Outputs& outputs);
  void take_acts(const sim::CycleInputs& cycle);
  void take_driver(const sim::CycleInputs& cycle, const kernel::Outputs& outputs);
  void take_groups(const sim::CycleInputs& cycle);
  std::string error_words(std::int32_t NID_BG) const;
  void take_links(const kernel::State& deciding);
  void take_end(const kernel::State& before, const kernel::State& after);
  void take_contact(const sim::CycleInputs& cycle, const radio::Session& before, const radio::Session& after);
  void take_track(const track::Description& now);
  void take_radio_hole(std::int64_t t_ms, const kernel::State& before, const kernel::State& after);
  void take_values(std::int64_t t_ms, const kernel::State& before, const kernel::State& after);
  void take_texts(const kernel::State& before, const kernel::State& after);
  void take_brakes(const Moment& moment);
  bool brakes_change(const kernel::State& after, const kernel::Outputs& outputs) const;

  std::vector<Note> notes_;
  std::vector<Act> acts_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, Contact> contacts_;  ///< by NID_C and NID_RBC
  std::unique_ptr<Moment> entry_, now_;
  std::map<Cause, Braking> brakings_;
  std::map<std::int32_t, Announced> announced_;    ///< by NID_BG
  std::map<std::int32_t, GroupRead> groups_read_;  ///< by NID_BG
  std::map<std::int32_t, NoteIndex> packets_;      ///< the last one of each NID_PACKET
  Brought brought_;
  std::optional<RadioHole> radio_hole_;
  std::int64_t in_radio_hole_since_ = 0;
  std::optional<ReplacedValues> replaced_values_;
  std::map<std::uint8_t, Note> texts_;
  Set<Cause> braked_;
  port::TrainSignals train_;
  Set<port::Window> windows_;
  port::NationalSystem national_system_;
  bool fault_ = false;
  bool first_ = true;
  bool starts_with_defaults_ = false;
};

}  // namespace evc::explain
