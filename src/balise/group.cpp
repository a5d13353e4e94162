#include "balise/group.h"

namespace evc::balise {

void note(Outcome& outcome, const Event& event) {
  if (stronger(event.reaction, outcome.reaction)) outcome.reaction = event.reaction;
  if (event.reaction == Reaction::service_brake) outcome.shorten_at_standstill = true;
  if (event.what == Happened::wrong_direction) outcome.wrong_direction = true;
  if (!outcome.events.push_back(event)) outcome.events.back().what = Happened::capacity;
}

const char* name_of(Finding finding) {
  switch (finding) {
    case Finding::none:
      return "none";
    case Finding::balise_missed:
      return "balise missed";
    case Finding::balise_not_decoded:
      return "balise not decoded";
    case Finding::invalid_value:
      return "invalid value";
    case Finding::counters_differ:
      return "message counters differ";
    case Finding::not_announced:
      return "not announced";
    case Finding::outside_window:
      return "outside its window";
    case Finding::wrong_direction:
      return "wrong direction";
    case Finding::not_repositioning:
      return "no repositioning group";
  }
  return "";
}

const char* name_of(Happened what) {
  switch (what) {
    case Happened::group_accepted:
      return "accepted";
    case Happened::linking_ok:
      return "ok";
    case Happened::linking_error_early:
      return "found before its window";
    case Happened::linking_error_missed:
      return "not found in its window";
    case Happened::linking_error_later:
      return "a later group found in its window";
    case Happened::wrong_direction:
      return "crossed in the wrong direction";
    case Happened::double_linking_error:
      return "second group in a row not found";
    case Happened::double_repositioning:
      return "second repositioning group";
    case Happened::message_error:
      return "message inconsistent";
    case Happened::group_ignored:
      return "ignored";
    case Happened::telegram_covered:
      return "covered";
    case Happened::telegram_version_old:
      return "version too old";
    case Happened::telegram_version_new:
      return "version too new";
    case Happened::telegram_against_movement:
      return "read against the permitted movement";
    case Happened::telegram_not_decoded:
      return "telegram not decoded";
    case Happened::capacity:
      return "capacity exceeded";
  }
  return "";
}

}  // namespace evc::balise
