#include "kernel/cab.h"

#include <utility>

#include "track/withdraw.h"

namespace evc::kernel {
namespace {

/// What entry of SB or PS kept, and refers to places ahead of the other cab: the train does not run there.
void delete_what_was_ahead(State& s) {
  procedures::level_transition::turn(s.level_transition);
  s.pending_national_values.reset();
  s.buffer.clear();
  s.staff_responsible = {};
  balise::abandon(s.balise);
  balise::clear(s.balise.linking);
  if (s.reports.parameters) s.reports.parameters->at.clear();
  s.reports.rear_border.reset();
  s.reports.front_border.reset();
  track::turn(s.track);
}

/// The confirmed length begins at the min safe rear end of the former orientation (3.6.5.2.4), not of that of now.
void forget_confirmed_length(position::IntegrityStatus& status) {
  if (status.integrity != position::Integrity::lost) status = {};
}

/// The announcement of a loop stays (4.10): its messages count for the other direction now (3.6.3.1.1 c), in which
/// another signal is ahead.
void turn(AnnouncedLoop& loop) {
  loop.signal.reset();
  loop.signal_passed = false;
  loop.orientation = opposite(loop.orientation);
  std::swap(loop.from, loop.to);
  for (std::optional<Place>* end : {&loop.from, &loop.to})
    if (*end) *end = Place{-(*end)->from_origin};
}

}  // namespace

void turn_train(State& s) {
  delete_what_was_ahead(s);
  position::turn(s.position);
  forget_confirmed_length(s.integrity);
  s.handover = {};
  if (s.loop) turn(*s.loop);
  protection::turn(s.guards);
  ++s.revision;
}

bool skips_closing(const State& s, const TrainSignals& train) {
  return s.desk_was_open && train.desk_open && train.cab != s.cab;
}

void see_from_other_cab(State& s, Cab cab) {
  s.cab = cab;
  position::change_cab(s.position, s.L_engine);
  ++s.revision;
}

void follow_cab(State& s, const TrainSignals& train, Log log) {
  if (train.desk_open && train.cab != s.cab) {
    delete_what_was_ahead(s);
    see_from_other_cab(s, train.cab);
    forget_confirmed_length(s.integrity);
    s.handover = {};  // its order is deleted (4.10), and the border lies behind; each RBC ends its own session
    if (s.loop) turn(*s.loop);
    protection::turn(s.guards);
    log.note({.what = What::cab_changed, .clause = "5.12.2.5"_srs});
  }
  s.desk_was_open = train.desk_open;
}

}  // namespace evc::kernel
