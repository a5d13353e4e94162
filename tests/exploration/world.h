#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "../scenarios/brake_rules.h"
#include "../through_step/reference.h"
#include "kernel/evc.h"
#include "kernel/state.h"
#include "rules.h"
#include "sim/cycle_inputs.h"

// A unit with a driver, a train and a trackside that do what they are ordered, allowed or not.
namespace evc::exploration {

using through_step::BitList;
using through_step::Codes;

/// What is checked in every cycle, and what was seen.
class Watch {
 public:
  /// The cells of the mode table of `srs`, from tests/reference.
  explicit Watch(SrsVersion srs);
  /// Notes a fault if the change is in no cell, if a brake is missing in TR, SF or NP (4.4.13.1.2, 4.4.5.1.2,
  /// 4.4.4.1.2), if one is commanded in IS, or if the driver is asked something with the desk closed. The runner adds
  /// brake commands that do not keep to their rules (3.14.1, 4.12).
  void look(Mode before, const port::Outputs& now, const port::TrainSignals& train);
  const std::vector<std::string>& modes() const { return modes_; }

  std::map<std::pair<std::string, std::string>, std::uint64_t> cells;  ///< of the table: from, to -> times seen
  std::map<std::string, std::uint64_t> cycles;                         ///< mode -> cycles in it
  Applied applied{};                                                   ///< of each rule of rules.h
  std::vector<std::string> faults;                                     ///< of the last `look`s, without the way to it

 private:
  std::vector<std::string> modes_;
};

/// What is known between two cycles. A copy goes on independently.
struct World {
  kernel::State state;
  sim::CycleInputs in;
  port::Outputs out;
  unsigned groups = 0;                       ///< passed; the next one has NID_BG 100 + groups
  std::map<unsigned, std::uint32_t> sent{};  ///< NID_MESSAGE -> T_TRAIN of the last one of the unit
  bool failed = false;                       ///< SF is or may be entered (4.4.5; after SL, NL and PS later)
  bool calling = false;                      ///< a connection was asked for and is not answered
  brake_rules::Memory brakes{};
  Known known{};
  std::map<unsigned, double> groups_at{};  ///< NID_BG -> counter of the first balise
};

/// What a group or message has that the rules of rules.h need: distances from the group, or from the LRBG.
struct Ahead {
  std::optional<Mode> area = {};
  double D_MAMODE = 0.0;
  std::optional<double> D_EMERGENCYSTOP = {};
};

/// Runs worlds. Its `Derived` is computed again for each (SRS: none; a restored State is used with an empty one).
class Runner {
 public:
  Runner(SrsVersion srs, Watch& watch);
  /// A unit with power, its desk closed.
  std::unique_ptr<World> power_up();
  /// Goes on with this world until the next call.
  void go_on_with(World& world);

  World& world() { return *world_; }
  /// The signals of driver and train; those of the driver are given for one cycle.
  port::Inputs& inputs() { return world_->in.levels; }
  void cycle();
  void run(int cycles);
  /// A group of two balises under the antenna, the packets in the first one. A train that stands is moved over it.
  void pass(const BitList& packets, bool spoiled = false, const Ahead& ahead = {});
  /// A message of the RBC that was called last, as version 2.1 has it, or 2.3 if only that does. `codes` beside T_TRAIN
  /// and NID_LRBG.
  void receive(unsigned NID_MESSAGE, Codes codes = {}, const BitList& packets = {}, const Ahead& ahead = {});
  /// The T_TRAIN of the last message of the unit with this number, or 0.
  std::uint64_t asked(unsigned NID_MESSAGE) const;

  void enter_train_data();
  bool prints_events = false;  ///< as they come
  const kernel::Config& config() const { return config_; }

 private:
  void advance();
  /// From now on this comes from trackside, from a balise at this counter.
  void tell(const Ahead& ahead, double group_at);
  kernel::Config config_;
  Watch& watch_;
  std::unique_ptr<kernel::Derived> derived_;
  World* world_ = nullptr;
};

/// A packet to the train, with its usual values beside `codes`.
void put(BitList& to, unsigned NID_PACKET, const Codes& codes = {});

}  // namespace evc::exploration
