#include "kernel/report/dialogue.h"

#include "kernel/state.h"

namespace evc::kernel {
namespace {

namespace start = procedures::start_of_mission;
namespace trip = procedures::train_trip;
namespace data_change = procedures::train_data_change;

/// The step of a procedure whose first step is `first`.
template <class Step>
constexpr Dialogue at(Dialogue first, Step first_step, Step step) {
  return static_cast<Dialogue>(terms::index(first) + terms::index(step) - terms::index(first_step));
}
static_assert(at(Dialogue::start_S0, start::Step::S0, start::Step::S25) == Dialogue::start_S25);
static_assert(at(Dialogue::trip_S050, trip::Step::S050, trip::Step::S170) == Dialogue::trip_S170);
static_assert(at(Dialogue::train_data_S2, data_change::Step::S2, data_change::Step::S6) == Dialogue::train_data_S6);

/// The acknowledgement asked for at the start of an area of a mode profile.
struct OfMode {
  Ack ack;
  Mode mode;
  Dialogue ahead, entered;
};
constexpr std::array<OfMode, 3> kOfModes{{{Ack::OS, Mode::OS, Dialogue::OS_ahead, Dialogue::OS_entered},
                                          {Ack::LS, Mode::LS, Dialogue::LS_ahead, Dialogue::LS_entered},
                                          {Ack::SH, Mode::SH, Dialogue::SH_ahead, Dialogue::SH_entered}}};

/// The one acknowledgement among those asked for that belongs to a step.
std::optional<Ack> one_of(Set<Ack> asked, std::initializer_list<Ack> candidates) {
  for (const Ack ack : candidates)
    if (asked.has(ack)) return ack;
  return std::nullopt;
}

std::optional<Ack> acknowledgement_of(Dialogue step, Set<Ack> asked) {
  switch (step) {
    case Dialogue::start_S22:
      return one_of(asked, {Ack::SN});
    case Dialogue::start_S23:
      return one_of(asked, {Ack::UN});
    case Dialogue::start_S24:
    case Dialogue::trip_S160:
      return one_of(asked, {Ack::SR});
    case Dialogue::start_S25:
    case Dialogue::trip_S170:
      return one_of(asked, {Ack::OS, Ack::LS, Ack::SH});
    case Dialogue::trip_S060:
      return one_of(asked, {Ack::trip});
    case Dialogue::train_data_S3:
    case Dialogue::train_data_S5:
      return one_of(asked, {Ack::brake});
    default:
      return std::nullopt;
  }
}

std::optional<Dialogue> step_of(const State& s) {
  if (s.manoeuvre.request.waits_for_answer) return Dialogue::manoeuvre_S050;
  if (s.mode == Mode::TR || s.mode == Mode::PT) {
    if (s.train_trip.step == trip::Step::S010) return std::nullopt;
    const bool alone = s.train_trip.step == trip::Step::S120 && !s.radio.supervising.session.established();
    return at(Dialogue::trip_S050, trip::Step::S050, alone ? trip::Step::S121 : s.train_trip.step);  // 5.11.4.2
  }
  if (s.shunting.waits_for_answer) return Dialogue::shunting_S050;
  if (s.mode == Mode::SB) return at(Dialogue::start_S0, start::Step::S0, s.start_of_mission.step);
  if (const data_change::Step step = s.train_data_change.procedure.step; step >= data_change::Step::S2)
    return at(Dialogue::train_data_S2, data_change::Step::S2, step);
  return std::nullopt;
}

}  // namespace

std::optional<ShownDialogue> dialogue_of(const State& s, bool desk_open, Set<Ack> asked) {
  if (!desk_open) return std::nullopt;
  if (const auto step = step_of(s)) return ShownDialogue{*step, acknowledgement_of(*step, asked)};
  for (const OfMode& row : kOfModes)
    if (asked.has(row.ack)) return ShownDialogue{s.mode == row.mode ? row.entered : row.ahead, row.ack};
  if (asked.has(Ack::RV)) return ShownDialogue{Dialogue::reversing, Ack::RV};
  if (asked.has(Ack::level)) return ShownDialogue{Dialogue::level_transition, Ack::level};
  return std::nullopt;
}

}  // namespace evc::kernel
