#include "track/services.h"

namespace evc::track {
namespace {

/// The condition of a text on the mode. Trackside of a version up to 2.1 knows AD as FS (6.6.2.2.4 to 6.6.2.2.6).
bool holds_in(Mode condition, Mode mode) { return condition == mode || (condition == Mode::FS && mode == Mode::AD); }

/// What conditions of texts are compared with.
struct Moment {
  Place est_front{};
  Duration now{};
  Mode mode = Mode::NP;
  Level level = Level::L0;
  std::uint8_t NID_NTC = 0;
};

bool level_is(Level level, std::uint8_t NID_NTC, const Moment& s) {
  return level == s.level && (level != Level::NTC || NID_NTC == s.NID_NTC);
}

/// All parts in use, or one of them; with no part in use: fulfilled at once for the start, never for the end.
struct Parts {
  bool all = false;
  unsigned used = 0, true_now = 0;
  void part(bool in_use, bool holds) {
    if (!in_use) return;
    ++used;
    if (holds) ++true_now;
  }
  bool fulfilled() const { return used > 0 && (all ? true_now == used : true_now > 0); }
};

bool starts(const Text& t, const Moment& s) {
  Parts parts{t.all_parts};
  parts.part(t.start_at.has_value(), t.start_at && s.est_front >= *t.start_at);
  parts.part(t.start_mode.has_value(), t.start_mode && holds_in(*t.start_mode, s.mode));
  parts.part(t.start_level.has_value(), t.start_level && level_is(*t.start_level, t.start_NTC, s));
  return parts.used == 0 || parts.fulfilled();
}

/// The end by a mode or level is the transition from it (3.12.3.4.3), before the start too.
void note_transitions(Text& t, const Moment& s) {
  const bool in_mode = t.end_mode && holds_in(*t.end_mode, s.mode);
  const bool in_level = t.end_level && level_is(*t.end_level, t.end_NTC, s);
  t.end_mode_left = t.end_mode_left || (t.in_end_mode && !in_mode);
  t.end_level_left = t.end_level_left || (t.in_end_level && !in_level);
  t.in_end_mode = in_mode;
  t.in_end_level = in_level;
}

/// Each part of the end is latched separately (3.12.3.4.3.1.2 of 4.0.0).
bool ends(Text& t, const Moment& s) {
  t.end_place_passed = t.end_place_passed || (t.end_at && s.est_front >= *t.end_at);
  t.end_time_over = t.end_time_over || (t.T_TEXTDISPLAY && s.now - t.shown_since >= *t.T_TEXTDISPLAY);
  return at_end(t);
}

}  // namespace

bool at_end(const Text& t) {
  Parts parts{t.all_parts};
  parts.part(t.end_at.has_value(), t.end_place_passed);
  parts.part(t.T_TEXTDISPLAY.has_value(), t.end_time_over);
  parts.part(t.end_mode.has_value(), t.end_mode_left);
  parts.part(t.end_level.has_value(), t.end_level_left);
  return parts.fulfilled();
}

TextDisplay show_texts(Description& d, const Here& here, Mode mode, Level level, std::uint8_t NID_NTC,
                       TextAcknowledgement acknowledgement, TextReports& reports) {
  const Moment s{here.est_front, here.now, mode, level, NID_NTC};
  TextDisplay display;
  for (Text& t : d.texts) {
    note_transitions(t, s);
    if (t.state == Text::State::waiting && starts(t, s)) {
      t.shown_since = s.now;
      // What has ended already is not shown, to be acknowledged or not (3.12.3.4.4).
      t.state = ends(t, s) ? Text::State::ended : Text::State::shown;
    }
    if (t.state != Text::State::shown) continue;
    const bool confirm = t.Q_TEXTCONFIRM != 0;
    if (confirm && acknowledgement.id == t.id && !t.acknowledged) {
      t.acknowledged = true;
      if (t.report)
        (void)reports.push_back({t.NID_TEXTMESSAGE, t.NID_C, t.NID_RBC});  // at most one per stored text: it fits
    }
    const bool end = ends(t, s);
    const bool waits = confirm && !t.acknowledged;
    const bool with_end = t.ack_and_end && !acknowledgement.always_ends;
    const bool over = confirm ? t.acknowledged && (end || !with_end) : end;
    if (over) {
      t.state = Text::State::ended;
      continue;
    }
    (void)display.shown.push_back(t.id);  // at most one per stored text
    if (!waits) continue;
    (void)display.to_acknowledge.push_back(t.id);
    // Beyond its end the text stays until it is acknowledged, with the brake that it orders (3.12.3.4.7).
    display.service_brake = display.service_brake || (end && t.Q_TEXTCONFIRM == 2);
    display.emergency_brake = display.emergency_brake || (end && t.Q_TEXTCONFIRM == 3);
  }
  return display;
}

}  // namespace evc::track
