#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/state.h"
#include "procedures/observe.h"
#include "sim/cycle_inputs.h"
#include "terms/mrsp_source.h"

// The memory of an explanation: what happened in the journey up to now, and where it came from.
namespace evc::explain {

/// An event, and the telegram or message it came with.
struct Note {
  std::int64_t t_ms = 0;
  port::Event event;
  std::string source;  ///< "group 100", "message 3 (Movement authority)"; nothing: of no input from the track
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
  std::uint8_t about = 0;  ///< the Select that is selected, the Ack that is given
};

/// A message of an RBC.
struct Contact {
  std::int64_t t_ms = 0;
  std::uint8_t NID_MESSAGE = 0;
};

/// A cycle with the memory of the unit before and after it.
struct Moment {
  std::int64_t t_ms = 0;
  kernel::State before, after;
  kernel::Derived::Curves curves;
  procedures::Facts facts;
  kernel::Outputs outputs;
  port::TrainSignals train;
  Set<port::Window> windows;
};

/// A brake command by one cause: its first cycle, and the first one without it.
struct Braking {
  std::unique_ptr<Moment> onset;
  std::optional<std::int64_t> until;
};

class Journal {
 public:
  /// A cycle that was answered. `before` is the state before it.
  void take(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
            const kernel::Derived& derived, const procedures::Facts& facts, const kernel::Outputs& outputs);
  /// Keeps the last cycle as `now`.
  void stop_here(const sim::CycleInputs& cycle, const kernel::State& before, const kernel::State& after,
                 const kernel::Derived& derived, const procedures::Facts& facts, const kernel::Outputs& outputs);

  const std::vector<Note>& notes() const { return notes_; }
  /// The cycle in which the mode was entered; null: at power-up.
  const Moment* mode_entry() const { return entry_.get(); }
  const std::map<Cause, Braking>& brakings() const { return brakings_; }
  const Moment& now() const { return *now_; }

  /// The last note of a kind, not after `t_ms`; with `id` of that id. Null: none.
  const Note* last(What what, std::int64_t t_ms, std::optional<std::int32_t> id = {}) const;
  /// The same of an act; with `about` of that Select or Ack.
  const Act* last(Act::Kind kind, std::int64_t t_ms, std::optional<std::uint8_t> about = {}) const;
  /// The note with which a TSR came, by NID_TSR and V_TSR.
  const Note* of_tsr(std::uint8_t NID_TSR, std::uint8_t V_TSR) const;
  /// The note with which a text came, by its identity on board.
  const Note* of_text(std::uint8_t id) const;
  /// The last message of an RBC that was not rejected; null: none.
  const Contact* last_of(const radio::Rbc& rbc) const;

 private:
  void take_notes(const sim::CycleInputs& cycle, const kernel::Outputs& outputs);
  void take_acts(const sim::CycleInputs& cycle);
  void take_driver(const sim::CycleInputs& cycle, const kernel::Outputs& outputs);
  void take_contact(const sim::CycleInputs& cycle, const radio::Session& before, const radio::Session& after);
  void take_restrictions(const kernel::State& before, const kernel::State& after);
  void take_texts(const kernel::State& before, const kernel::State& after);
  void take_brakes(const Moment& moment);

  std::vector<Note> notes_;
  std::vector<Act> acts_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, Contact> contacts_;  ///< by NID_C and NID_RBC
  std::unique_ptr<Moment> entry_, now_;
  std::map<Cause, Braking> brakings_;
  std::map<std::pair<std::uint8_t, std::uint8_t>, Note> restrictions_;
  std::map<std::uint8_t, Note> texts_;
  Set<Cause> braked_;
  port::TrainSignals train_;
  Set<port::Window> windows_;
  port::NationalSystem national_system_;
  bool fault_ = false;
  bool first_ = true;
};

}  // namespace evc::explain
