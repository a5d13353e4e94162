#include "texts/texts.h"

#include <charconv>

#include "terms/edition_gap.h"

namespace evc::texts {
namespace {

// clang-format off
constexpr auto kEvents = std::to_array<EventText>({
    {What::events_lost, "events", Takes::nothing, "lost: too many in one cycle"},
    {What::odometry_not_sound, "odometry", Takes::nothing, "not sound"},

    // Balise groups.
    {What::group_accepted, "group", Takes::id, "accepted"},
    {What::group_too_many_packets, "BG", Takes::id, "refused: too many packets"},
    {What::linking_ok, "linking BG", Takes::id, "ok"},
    {What::linking_error_early, "BG", Takes::id, "found before its window"},
    {What::linking_error_missed, "BG", Takes::id, "not found in its window"},
    {What::linking_error_later, "BG", Takes::id, "a later group found in its window"},
    {What::group_wrong_direction, "BG", Takes::id, "crossed in the wrong direction"},
    {What::double_linking_error, "BG", Takes::id, "second group in a row not found"},
    {What::double_repositioning, "BG", Takes::id, "second repositioning group"},
    {What::group_inconsistent, "BG", Takes::id, "message inconsistent"},
    {What::group_ignored, "BG", Takes::id, "ignored"},
    {What::telegram_covered, "BG", Takes::id, "covered"},
    {What::telegram_version_old, "BG", Takes::id, "version too old"},
    {What::telegram_version_new, "BG", Takes::id, "version too new"},
    {What::telegram_against_movement, "BG", Takes::id, "read against the permitted movement"},
    {What::telegram_not_decoded, "BG", Takes::id, "telegram not decoded"},
    {What::group_capacity, "BG", Takes::id, "capacity exceeded"},
    {What::linking_capacity, "linking", Takes::nothing, "too many groups: farthest left out"},
    {What::cover_capacity, "virtual balise cover", Takes::nothing, "no room: not set"},

    // Messages.
    {What::message_accepted, "message", Takes::id, "accepted"},
    {What::message_buffered, "message", Takes::id, "buffered"},
    {What::message_refused, "message", Takes::id, "refused"},
    {What::message_refused_no_room, "message", Takes::id, "refused [capacity]"},
    {What::message_rejected, "message", Takes::id, "rejected"},
    {What::message_unknown, "message", Takes::id, "unknown"},
    {What::message_not_sent, "message", Takes::nothing, "not sent: too many in one cycle"},
    {What::loop_accepted, "loop", Takes::id, "accepted"},
    {What::loop_refused, "loop", Takes::id, "refused"},
    {What::loop_left, "loop", Takes::id, "left: not accepted any more"},
    {What::packet_accepted, "packet", Takes::id, "accepted"},
    {What::packet_buffered, "packet", Takes::id, "buffered"},
    {What::packet_refused, "packet", Takes::id, "refused"},
    {What::packet_refused_no_room, "packet", Takes::id, "refused [capacity]"},
    {What::buffer_full, "transition buffer", Takes::nothing, "full: the oldest set is deleted"},
    {What::packet_kept, "packet", Takes::id, "kept"},
    {What::packet_contact_stored, "packet", Takes::id, "contact stored"},
    {What::packet_not_used, "packet", Takes::id, "not used"},
    {What::packet_other_direction, "packet", Takes::id, "ignored: for the other direction"},
    {What::packet_superseded, "packet", Takes::id, "ignored: another takes its place"},
    {What::packet_no_room, "packet", Takes::id, "no room"},
    {What::packet_shortened, "packet", Takes::id, "shortened"},
    {What::infill_refused, "infill", Takes::id, "refused"},

    // Movement authority and track description.
    {What::authority_accepted, "MA", Takes::nothing, "accepted"},
    {What::authority_refused, "MA", Takes::nothing, "refused"},
    {What::authority_timer_elapsed, "MA", Takes::nothing, "timer elapsed"},
    {What::shortening_granted, "MA shortening", Takes::nothing, "granted"},
    {What::shortening_rejected, "MA shortening", Takes::nothing, "rejected"},
    {What::trip_ordered, "trip", Takes::nothing, "ordered by balise group"},
    {What::track_description_shortened, "track description", Takes::nothing, "shortened to the train"},
    {What::track_description_ended, "track description", Takes::nothing, "ended: the rest is missing"},
    {What::emergency_stop_accepted, "emergency stop", Takes::id, "accepted"},
    {What::emergency_stop_place_passed, "emergency stop", Takes::id, "refused: place passed"},
    {What::emergency_stop_other_direction, "emergency stop", Takes::id, "refused: other direction"},
    {What::emergency_stop_unconditional, "emergency stop", Takes::id, "unconditional"},
    {What::emergency_stop_revoked, "emergency stop", Takes::id, "revoked"},
    {What::level_crossing_speed, "level crossing", Takes::id, "speed instead of stop"},
    {What::targets_lost, "supervision", Takes::nothing, "too many targets: kept on the safe side"},
    {What::no_deceleration, "supervision", Takes::nothing, "no deceleration before a target"},
    {What::service_brake_failed, "service brake", Takes::nothing, "not applied: emergency brake"},

    // Session, national values, system version.
    {What::session_ordered, "session", Takes::nothing, "ordered"},
    {What::session_termination_ordered, "session", Takes::nothing, "termination ordered"},
    {What::network_missing, "session", Takes::nothing, "not set up: no terminal is registered"},
    {What::session_established, "session", Takes::nothing, "established"},
    {What::session_lost, "session", Takes::nothing, "lost"},
    {What::rbc_handover_ordered, "RBC handover", Takes::id, "ordered"},
    {What::rbc_handed_over, "RBC handover", Takes::id, "supervises"},
    {What::national_values_in_force, "national values", Takes::nothing, "in force"},
    {What::national_values_default, "national values", Takes::nothing, "defaults"},
    {What::version_operated, "system version", Takes::version, "operated"},

    // Modes, levels, procedures.
    {What::mode_changed, "mode", Takes::modes, nullptr},
    {What::level_changed, "level", Takes::levels, nullptr},
    {What::level_changed_by_driver, "level", Takes::levels, "by driver"},
    {What::override_active, "override", Takes::nothing, "active"},
    {What::override_ended, "override", Takes::nothing, "ended"},

    // The driver.
    {What::selection_not_enabled, "driver", Takes::select, nullptr, ": not enabled"},
    {What::entry_not_enabled, "driver", Takes::entered, nullptr, ": not enabled"},
    {What::entry_out_of_range, "driver", Takes::entered, nullptr, ": out of range"},
    {What::acknowledgement_not_enabled, "driver acknowledgement of", Takes::ack, nullptr, ": not enabled"},
    {What::train_data_valid, "train data", Takes::nothing, "valid"},
    {What::train_data_refused, "train data", Takes::fault, nullptr},
    {What::SR_data_out_of_range, "SR speed and distance", Takes::nothing, "refused: out of range"},
    {What::train_data_changed_by_source, "train data", Takes::nothing, "changed by an external source"},
    {What::train_data_to_be_validated, "train data", Takes::nothing, "to be validated"},
    {What::cover_set, "virtual balise cover", Takes::id, "set by driver"},
    {What::cover_removed, "virtual balise cover", Takes::id, "removed by driver"},

    {What::cab_changed, "cab", Takes::nothing, "changed"},
    {What::train_turned, "train orientation", Takes::nothing, "changed"},
    {What::consist_changed, "safe consist length", Takes::nothing, "changed"},
    {What::consist_lost, "safe consist length", Takes::nothing, "no longer available"},
    {What::odometer_out_of_tolerance, "odometer at BG", Takes::id, "out of tolerance: more than 5 m + 5 %"},
    {What::mode_not_of_level, "mode", Takes::nothing, "not possible in the level"},
    {What::edition_incomplete, "SRS 4.0.0 without", Takes::gap, nullptr},
    {What::received_without_power, "telegram or message", Takes::nothing, "not received: no power"},
});
// clang-format on

static_assert(
    [] {
      for (std::size_t i = 0; i < kEvents.size(); ++i)
        if (static_cast<std::size_t>(kEvents[i].what) != i) return false;
      return kEvents.size() == static_cast<std::size_t>(What::count);
    }(),
    "one row for each, in order");

constexpr std::array<const char*, static_cast<std::size_t>(port::Select::count)> kSelectWords{
    "start",
    "override",
    "shunting",
    "exit of shunting",
    "non leading",
    "maintain shunting",
    "train data",
    "slippery rail",
    "adhesion",
    "isolation",
    "track ahead free",
    "main window",
    "train integrity",
    "last RBC",
    "short number",
    "virtual balise cover set",
    "virtual balise cover removed",
    "radio network",
    "toggle",
    "automatic driving",
    "end of automatic driving",
    "supervised manoeuvre",
    "supervised manoeuvre again",
    "exit of supervised manoeuvre",
    "inhibition of the antenna alarm",
    "end of the inhibition of the antenna alarm"};
static_assert(kSelectWords.back() != nullptr, "one for each");
constexpr std::array<const char*, static_cast<std::size_t>(port::Entered::count)> kEnteredWords{
    "driver identity",       "train running number", "train data",    "RBC contact", "level",
    "SR speed and distance", "virtual balise cover", "radio network", "set speed",   "language"};

void add_change(ShortText& line, const char* from, const char* to) {
  line.add(" ");
  line.add(from);
  line.add("->");
  line.add(to);
}

/// What the numbers of an event mean.
void add_numbers(ShortText& line, const port::Event& e, Takes takes) {
  const auto word = [&line](const char* text) {
    line.add(" ");
    line.add(text);
  };
  switch (takes) {
    case Takes::nothing:
      return;
    case Takes::id:
      line.add(" ");
      return line.add(std::int64_t{e.id});
    case Takes::modes:
      return add_change(line, name(static_cast<Mode>(e.from)), name(static_cast<Mode>(e.to)));
    case Takes::levels:
      return add_change(line, name(static_cast<Level>(e.from)), name(static_cast<Level>(e.to)));
    case Takes::select:
      return word(words_of(static_cast<port::Select>(e.id)));
    case Takes::entered:
      return word(words_of(static_cast<port::Entered>(e.id)));
    case Takes::ack:
      return word(kAckRows[static_cast<std::size_t>(e.id)].name);
    case Takes::version:  // M_VERSION
      line.add(" ");
      line.add(std::int64_t{e.id >> 4});
      line.add(".");
      return line.add(std::int64_t{e.id & 15});
    case Takes::fault:
      return word(name(static_cast<train::Fault>(e.id)));
    case Takes::gap:
      return word(kEditionGapRows[terms::index(static_cast<EditionGap>(e.id))].name);
  }
}

void add_clause(ShortText& line, Clause clause) {
  line.add(kSrsClauses[clause.place_in_register()]);
  if (clause.infill()) line.add(" infill");
  if (const char bullet = clause.bullet(); bullet != '\0') {
    line.add(" ");
    line.add({&bullet, 1});
  }
  if (clause.exception() == 0) return;
  line.add(" [");
  line.add(std::int64_t{clause.exception()});
  line.add("]");
}

}  // namespace

void ShortText::add(std::string_view text) noexcept {
  const std::size_t room = kMost - size_;
  const std::size_t n = text.size() < room ? text.size() : room;
  text.copy(characters_.data() + size_, n);
  size_ += n;
}

void ShortText::add(std::int64_t number) noexcept {
  char digits[24];
  const auto end = std::to_chars(digits, digits + sizeof digits, number);
  add({digits, static_cast<std::size_t>(end.ptr - digits)});
}

const EventText& text_of(What what) { return kEvents[static_cast<std::size_t>(what)]; }

ShortText line_of(const port::Event& event) noexcept {
  const EventText& row = text_of(event.what);
  ShortText line;
  line.add(row.subject);
  add_numbers(line, event, row.takes);
  if (row.text != nullptr) {
    line.add(" ");
    line.add(row.text);
  }
  if (row.takes != Takes::modes && !event.clause) return line;
  line.add(" [");
  if (row.takes == Takes::modes)
    line.add(std::int64_t{event.id});
  else
    add_clause(line, event.clause);
  if (row.takes != Takes::modes && row.after_clause != nullptr) line.add(row.after_clause);
  line.add("]");
  return line;
}

std::string text_of(Clause clause) {
  ShortText text;
  if (clause) add_clause(text, clause);
  return std::string(text.view());
}

const char* words_of(port::Select select) { return kSelectWords[static_cast<std::size_t>(select)]; }
const char* words_of(port::Entered entered) { return kEnteredWords[static_cast<std::size_t>(entered)]; }

}  // namespace evc::texts
