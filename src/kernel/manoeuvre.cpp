#include "kernel/manoeuvre.h"

#include "kernel/cab.h"
#include "kernel/here.h"

namespace evc::kernel {
namespace {

position::Ahead ahead_of(const ConsistEnd& end) { return {end.nominal, end.min, end.max}; }

/// 3.18.3.2.4: the sum of the longest.
void measure_train(Manoeuvre& manoeuvre) {
  if (manoeuvre.consist) manoeuvre.train.L_TRAIN = manoeuvre.consist->front.max + manoeuvre.consist->rear.max;
}

/// With X = 1, and under an RBC up to 2.2, the ends of the train in SB are those of the engine (6.6.2.1.2, 6.6.2.2.3,
/// 6.6.4.1.1, 6.6.4.2.1).
bool ends_of_engine(const State& s) {
  const radio::Session& session = s.radio.supervising.session;
  return s.operated_X == 1 || (session.established() && !radio::knows_manoeuvres(session));
}

ConsistOfTrain in_train_orientation(const ConsistLength& consist, bool opposite) {
  return opposite ? ConsistOfTrain{consist.rear, consist.front} : ConsistOfTrain{consist.front, consist.rear};
}

/// 3.6.1.7: from the min safe front end to the min safe rear end.
Distance length(const ConsistOfTrain& consist) { return consist.ahead.min + consist.behind.max; }

}  // namespace

std::optional<ConsistOfTrain> consist_of_train(const State& s) {
  const bool standing_by = s.mode == Mode::SB && !valid(s.data.train_data_status) && !ends_of_engine(s);
  if (!s.manoeuvre.consist || !(s.manoeuvre.active || standing_by)) return std::nullopt;
  return in_train_orientation(*s.manoeuvre.consist, s.manoeuvre.opposite);
}

std::optional<Distance> length_to_confirm(const State& s) {
  if (valid(s.data.train_data_status) && !s.manoeuvre.active) return s.train.L_TRAIN;
  if (!s.manoeuvre.available || !s.manoeuvre.consist) return std::nullopt;
  if (!s.manoeuvre.active && ends_of_engine(s)) return std::nullopt;
  return length(in_train_orientation(*s.manoeuvre.consist, s.manoeuvre.opposite));
}

bool reports_loss_of_consist(const State& s) {
  return s.manoeuvre.captured && (s.mode != Mode::SB || length_to_confirm(s).has_value());
}

void place_front_end(State& s) {
  const auto consist = consist_of_train(s);
  s.position.ahead = consist ? ahead_of(consist->ahead) : position::Ahead{};
  measure_train(s.manoeuvre);
}

position::Ahead ahead_in_request(const State& s) {
  if (s.manoeuvre.active || !s.manoeuvre.consist) return s.position.ahead;
  return ahead_of(s.manoeuvre.consist->front);
}

bool consist_in_front(const State& s) {
  return s.manoeuvre.available && s.manoeuvre.consist && s.manoeuvre.consist->front.max > Distance{};
}

bool informs_of_consist(const State& s) {
  return s.radio.supervising.session.established() && s.level.level == Level::L2 &&
         (s.mode == Mode::SB || s.manoeuvre.informs);
}

const train::TrainData& supervised_train(const State& s) { return s.manoeuvre.active ? s.manoeuvre.train : s.train; }

ManoeuvreBefore begin_manoeuvre(State& s, bool opposite, track::SpeedCode V_SM) {
  const ManoeuvreBefore before{s.manoeuvre.active, s.manoeuvre.opposite, s.manoeuvre.V_SM};
  s.manoeuvre.active = true;
  s.manoeuvre.V_SM = V_SM;
  if (opposite) {
    turn_train(s);
    s.manoeuvre.opposite = !s.manoeuvre.opposite;
  }
  place_front_end(s);
  ++s.revision;
  return before;
}

void restore_manoeuvre(State& s, const ManoeuvreBefore& before) {
  if (before.opposite != s.manoeuvre.opposite) turn_train(s);
  s.manoeuvre.active = before.active;
  s.manoeuvre.opposite = before.opposite;
  s.manoeuvre.V_SM = before.V_SM;
  place_front_end(s);
  ++s.revision;
}

bool end_manoeuvre(State& s) {
  const bool turns = s.manoeuvre.opposite;
  if (turns) turn_train(s);
  s.manoeuvre.active = s.manoeuvre.opposite = s.manoeuvre.authority = s.manoeuvre.informs = false;
  if (!s.manoeuvre.available) s.manoeuvre.consist.reset();
  place_front_end(s);
  ++s.revision;
  return turns;
}

}  // namespace evc::kernel
