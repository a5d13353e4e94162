#include "io/output_lines.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "io/date_time.h"
#include "io/display_json.h"
#include "io/latin1.h"
#include "io/number.h"
#include "io/output_data.h"
#include "io/rbc_contact.h"
#include "texts/texts.h"

namespace evc::io {
namespace {

using kernel::Outputs;

/// The name of a term, null for `none`, the first.
template <const auto& kRows, class E>
const char* name_or_null(E value) {
  return terms::index(value) == 0 ? nullptr : terms::kNames<kRows>[terms::index(value)];
}

void append_kmh(std::string& out, Speed v) { append_micro(out, v.si * 3.6); }
void append_metres(std::string& out, OdometerPlace p) { append_micro(out, p.from_origin.si); }
/// M_VERSION as "2.1".
void append_version(std::string& out, std::uint8_t M_VERSION) {
  out += std::to_string(M_VERSION >> 4) + '.' + std::to_string(M_VERSION & 15);
}

/// One row in either format: JSON has a key before each value and `null`, CSV a comma and an empty field.
class OutputRow {
 public:
  OutputRow(std::string& out, bool json) : out_(out), json_(json) {}

  void key(const char* name) {
    if (json_) {
      out_ += first_ ? "\"" : ",\"";
      out_ += name;
      out_ += "\":";
    } else if (!first_) {
      out_ += ',';
    }
    first_ = false;
  }
  void absent() {
    if (json_) out_ += "null";
  }
  void text(const char* name, const char* value) {
    key(name);
    if (value == nullptr)
      absent();
    else if (json_)
      append_string(out_, value);
    else
      out_ += value;
  }
  void flag(const char* name, bool value) {
    key(name);
    out_ += value ? "true" : "false";
  }
  void speed(const char* name, const std::optional<Speed>& v) {
    key(name);
    if (v)
      append_kmh(out_, *v);
    else
      absent();
  }
  void place(const char* name, const std::optional<OdometerPlace>& p) {
    key(name);
    if (p)
      append_metres(out_, *p);
    else
      absent();
  }
  /// A list of strings: a JSON array, or one quoted field.
  template <class List, class Append>
  void list(const char* name, const List& items, Append append) {
    key(name);
    if (!json_ && items.empty()) return;
    out_ += json_ ? "[" : "\"";
    bool first = true;
    for (const auto& item : items) {
      if (!first) out_ += json_ ? ',' : ';';
      first = false;
      if (!json_) {
        append_field(append, item);
        continue;
      }
      std::string text;
      append(text, item);
      append_string(out_, text);
    }
    out_ += json_ ? "]" : "\"";
  }
  /// A JSON array of objects.
  template <class List, class Append>
  void objects(const char* name, const List& items, Append append) {
    key(name);
    out_ += '[';
    bool first = true;
    for (const auto& item : items) {
      if (!first) out_ += ',';
      first = false;
      append(out_, item);
    }
    out_ += ']';
  }
  void open(const char* name) {
    key(name);
    if (!json_) return;
    out_ += '{';
    first_ = true;
  }
  void close() {
    if (json_) out_ += '}';
  }
  /// An object of numbers that may be absent; in CSV a column for each.
  void number(const char* name, bool present, double value) {
    key(name);
    if (present)
      append_number(out_, value);
    else
      absent();
  }
  std::string& out() { return out_; }
  bool json() const { return json_; }

 private:
  template <class Append, class Item>
  void append_field(Append append, const Item& item) {
    std::string text;
    append(text, item);
    for (const char c : text) {
      if (c == '"') out_ += '"';
      out_ += c;
    }
  }
  std::string& out_;
  bool json_;
  bool first_ = true;
};

void append_radio_address(OutputRow& row, const char* name, const std::optional<kernel::RbcAddress>& address) {
  if (row.json()) {
    row.key(name);
    if (address)
      append_contact(row.out(), address->NID_C, address->NID_RBC, address->NID_RADIO, address->infill_unit);
    else
      row.absent();
    return;
  }
  row.number(name, address.has_value(), address ? address->NID_C : 0);
  row.number(name, address.has_value(), address ? address->NID_RBC : 0);
  row.key(name);
  if (address) append_NID_RADIO(row.out(), address->NID_RADIO);
}

/// In JSON a text, for another RBC than the supervising one and for a radio infill unit an object; in a CSV field
/// `NID_C/NID_RBC:` or `NID_C/RIU NID_RIU:` before it.
void append_radio_out(OutputRow& row, const Outputs& o) {
  const auto hex = [](std::string& out, const kernel::OutgoingMessage& m) {
    append_hex(out, {m.bytes.begin(), m.bytes.size()});
  };
  if (!row.json()) {
    row.list("radio_out", o.radio_out, [&](std::string& out, const kernel::OutgoingMessage& m) {
      if (m.to)
        out += std::to_string(m.to->NID_C) + (m.infill_unit ? "/RIU " : "/") + std::to_string(m.to->NID_RBC) + ':';
      hex(out, m);
    });
    return;
  }
  row.objects("radio_out", o.radio_out, [&](std::string& out, const kernel::OutgoingMessage& m) {
    if (m.to) {
      out += "{\"to\":{\"NID_C\":";
      append_number(out, std::int64_t{m.to->NID_C});
      out += number_key(m.infill_unit);
      append_number(out, std::int64_t{m.to->NID_RBC});
      out += "},\"message\":";
    }
    out += '"';
    hex(out, m);
    out += m.to ? "\"}" : "\"";
  });
}

void append_lrbg(OutputRow& row, const std::optional<kernel::NidLrbg>& lrbg) {
  if (row.json() && !lrbg) {
    row.text("lrbg", nullptr);
    return;
  }
  if (row.json()) row.open("lrbg");
  row.number("NID_C", lrbg.has_value(), lrbg ? lrbg->NID_C : 0);
  row.number("NID_BG", lrbg.has_value(), lrbg ? lrbg->NID_BG : 0);
  row.close();
}

/// A fixed text by its number (7.5.1.137), a plain one as UTF-8.
void append_shown_text(std::string& out, const kernel::ShownText& text) {
  if (text.Q_TEXT) {
    out += *text.Q_TEXT == 0 ? "Level crossing not protected" : *text.Q_TEXT == 1 ? "Acknowledgement" : "fixed text ";
    if (*text.Q_TEXT > 1) append_number(out, std::int64_t{*text.Q_TEXT});
    return;
  }
  append_utf8(out, {text.characters.data(), text.length});
}

/// Whether two lists are alike by what `of` takes of their elements.
template <class List, class Of>
bool alike(const List& a, const List& b, Of of) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&of](const auto& x, const auto& y) { return of(x) == of(y); });
}

void append_text(std::string& out, const char* text) { out += text; }

/// The elements of a set by their names, in the order of the enumeration.
template <class E, class Names>
void append_names(std::vector<const char*>& names, Set<E> set, const Names& all) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(E::count); ++i)
    if (set.has(static_cast<E>(i))) names.push_back(all[i]);
}

/// Acknowledgements, then entries, then Start.
std::vector<const char*> requests_of(const Outputs& o) {
  std::vector<const char*> names;
  append_names(names, o.requests, terms::kNames<kAckRows>);
  append_names(names, o.entries, terms::kNames<kEntryRows>);
  if (o.start_offered) names.push_back("start");
  return names;
}

std::vector<const char*> reasons_of(const Outputs& o) {
  std::vector<const char*> names;
  append_names(names, o.brake_reasons, terms::kNames<kCauseRows>);
  return names;
}

void append_driver(OutputRow& row, const Outputs& o) {
  if (row.json()) row.open("driver");
  row.list("requests", requests_of(o), append_text);
  row.list("texts", o.texts, append_shown_text);
  row.list("symbols", o.symbols, [](std::string& out, Symbol s) { out += name(s); });
  row.close();
}

void append_speeds(OutputRow& row, const Outputs& o) {
  row.speed("v_kmh", o.v);
  row.text("monitoring", name_or_null<kMonitoringRows>(o.monitoring));
  row.text("status", name_or_null<kStatusRows>(o.status));
  row.speed("V_P", o.V_P);
  row.speed("V_W", o.V_W);
  row.speed("V_SBI", o.V_SBI);
  row.speed("V_EBI", o.V_EBI);
  row.speed("V_MRSP", o.V_MRSP);
  row.speed("V_target", o.V_target);
  row.key("d_target_m");
  if (o.d_target)
    append_micro(row.out(), o.d_target->si);
  else
    row.absent();
  row.speed("V_release", o.V_release);
  row.place("EOA_m", o.EOA);
  row.place("SvL_m", o.SvL);
}

/// With the name of the national system, where it is known.
std::string words_of(StatusText text, const Outputs& o, const NationalSystemNames& names) {
  std::string words = name(text);
  if (!o.national_system || !names_national_system(text)) return words;
  const auto known = names.find(*o.national_system);
  if (known == names.end()) return words;
  return known->second + words.substr(std::string_view("National system").size());
}

/// Single values of the second edition; distances, times and speeds are null without a value.
void append_second_values(OutputRow& row, const Outputs& o, const NationalSystemNames& names) {
  const auto micro = [&row](const char* name, std::optional<double> value) {
    row.key(name);
    if (value)
      append_micro(row.out(), *value);
    else
      row.absent();
  };
  const auto metres = [](const std::optional<Distance>& d) { return d ? std::optional<double>(d->si) : std::nullopt; };
  row.speed("V_I", o.V_I);
  micro("tti_s", o.TTI ? std::optional<double>(o.TTI->si) : std::nullopt);
  row.speed("lssma_kmh", o.LSSMA);
  row.flag("mrdt_changed", o.MRDT_changed);
  micro("d_indication_m", metres(o.d_indication));
  row.text("memo_status", o.memo_status ? terms::kNames<kMemoStatusRows>[terms::index(*o.memo_status)] : nullptr);
  row.flag("level_valid", o.level_valid);
  const std::string reason = o.trip_reason ? words_of(*o.trip_reason, o, names) : "";
  row.text("trip_reason", o.trip_reason ? reason.c_str() : nullptr);
  micro("geo_m", metres(o.geo));
  micro("rv_left_m", metres(o.rv_left));
  std::string version;
  append_version(version, o.M_VERSION);
  row.text("version", version.c_str());
  std::string network;
  if (o.radio_register)
    network = *o.radio_register == port::kDefaultNetwork ? "default" : digits_of_NID_MN(*o.radio_register);
  row.text("radio_register", o.radio_register ? network.c_str() : nullptr);
  row.speed("set_speed_kmh", o.set_speed);
  row.text("language", std::string(o.language.view()).c_str());
}

/// The keys of `select` and `enter` that are enabled, in the order of 4.7.2.
std::vector<const char*> enabled_keys(const Outputs& o) {
  std::vector<const char*> keys;
  for (std::size_t i = 0; i < terms::index(DriverInput::count); ++i)
    if (o.enabled.has(static_cast<DriverInput>(i)))
      for (const char* key : texts::keys_of(static_cast<DriverInput>(i)))
        // 5.4.3.2 S3: the last RBC is offered where its contact is known.
        if (key != nullptr && (o.data.rbc_status != DataStatus::unknown || std::string_view(key) != "last_rbc"))
          keys.push_back(key);
  return keys;
}

/// One element of `messages`.
struct Message {
  int id;
  const char* kind;
  std::string text;
  bool important, acknowledge;
  Duration since;
};
void append_message(std::string& out, const Message& m) {
  out += "{\"id\":";
  append_number(out, static_cast<std::int64_t>(m.id));
  out += ",\"kind\":\"";
  out += m.kind;
  out += "\",\"text\":";
  append_string(out, m.text);
  out += m.important ? ",\"class\":\"important\"" : ",\"class\":\"auxiliary\"";
  out += m.acknowledge ? ",\"ack\":true" : ",\"ack\":false";
  out += ",\"since_ms\":";
  append_micro(out, m.since.si * 1000.0);
  out += '}';
}

/// The texts of the trackside, then those of the unit.
std::vector<Message> messages_of(const Outputs& o, const NationalSystemNames& names) {
  std::vector<Message> messages;
  for (const kernel::ShownText& text : o.texts) {
    messages.push_back({text.id, text.Q_TEXT ? "fixed" : "plain", {}, text.important, text.acknowledge, text.since});
    append_shown_text(messages.back().text, text);
  }
  for (const kernel::ShownStatus& s : o.status_texts)
    messages.push_back({kernel::kFirstStatusId + static_cast<int>(s.text), "status", words_of(s.text, o, names), true,
                        asks_acknowledgement(s.text), s.since});
  return messages;
}

/// A member of an object; the first one has no comma before it.
void append_member(std::string& out, const char* name, double value, bool first = false) {
  out += first ? "\"" : ",\"";
  out += name;
  out += "\":";
  append_micro(out, value);
}
void append_null(std::string& out, const char* name, bool first = false) {
  out += first ? "\"" : ",\"";
  out += name;
  out += "\":null";
}

const char* kind_name(std::optional<TrackConditionKind> kind) {
  return kind ? terms::kNames<kTrackConditionRows>[terms::index(*kind)] : "change of traction system";
}

void append_condition(std::string& out, const kernel::ShownCondition& c) {
  out += "{\"symbol\":\"";
  out += name(c.symbol);
  out += "\",\"kind\":\"";
  out += kind_name(c.kind);
  out += '"';
  append_member(out, "from_m", c.from.from_origin.si);
  append_member(out, "to_m", c.to.from_origin.si);
  out += ",\"phase\":\"";
  out += terms::kNames<kConditionPhaseRows>[terms::index(c.phase)];
  out += "\"}";
}

/// Begins an object with the distances that remain to an area or platform.
template <class Ordered>
void append_distances(std::string& out, const Ordered& o) {
  out += '{';
  if (o.to_start)
    append_member(out, "to_start_m", o.to_start->si, true);
  else
    append_null(out, "to_start_m", true);
  append_member(out, "to_end_m", o.to_end.si);
}

/// The key in `train_orders` of each kind of track condition; none where nothing is output to the train.
constexpr auto kOrderKeys = std::to_array<const char*>({
    nullptr,
    nullptr,
    nullptr,
    "pantograph",
    nullptr,
    "air_tightness",
    "regenerative_brake_inhibited",
    "eddy_current_service_brake_inhibited",
    "magnetic_shoe_brake_inhibited",
    "main_switch",
    "eddy_current_emergency_brake_inhibited",
});
static_assert(kOrderKeys.size() == kTrackConditionRows.size(), "every kind of track condition has its line");

void append_train_orders(OutputRow& row, const Outputs& o) {
  row.open("train_orders");
  for (std::size_t kind = 0; kind < kOrderKeys.size(); ++kind) {
    if (kOrderKeys[kind] == nullptr) continue;
    std::vector<kernel::OrderedArea> areas;
    for (const kernel::OrderedArea& area : o.ordered_areas)
      if (terms::index(area.kind) == kind) areas.push_back(area);
    row.objects(kOrderKeys[kind], areas, [](std::string& out, const kernel::OrderedArea& area) {
      append_distances(out, area);
      out += '}';
    });
  }
  row.key("traction_system");
  if (o.ordered_traction) {
    row.out() += '{';
    append_member(row.out(), "to_start_m", o.ordered_traction->to_start.si, true);
    append_member(row.out(), "M_VOLTAGE", o.ordered_traction->M_VOLTAGE);
    append_member(row.out(), "NID_CTRACTION", o.ordered_traction->NID_CTRACTION);
    row.out() += '}';
  } else {
    row.absent();
  }
  row.key("allowed_current_a");
  if (o.ordered_current) {
    row.out() += '{';
    append_member(row.out(), "to_start_m", o.ordered_current->to_start.si, true);
    if (o.ordered_current->amperes)
      append_member(row.out(), "current_a", *o.ordered_current->amperes);
    else
      append_null(row.out(), "current_a");
    row.out() += '}';
  } else {
    row.absent();
  }
  row.objects("station_platform", o.ordered_platforms, [](std::string& out, const kernel::OrderedPlatform& p) {
    append_distances(out, p);
    append_member(out, "M_PLATFORM", p.M_PLATFORM);
    append_member(out, "Q_PLATFORM", p.Q_PLATFORM);
    out += '}';
  });
  row.flag("remote_shunting", o.remote_shunting);
  row.text("engine_orientation",
           o.engine_orientation ? terms::kNames<kEngineOrientationRows>[terms::index(*o.engine_orientation)] : nullptr);
  row.flag("sound_horn", o.sound_horn);
  row.close();
}

void append_planned_speed(std::string& out, const kernel::PlannedSpeed& speed) {
  out += '{';
  append_member(out, "at_m", speed.at.si, true);
  append_member(out, "v_kmh", speed.V.si * 3.6);
  out += ",\"from\":[";
  std::vector<const char*> sources;
  append_names(sources, speed.sources, terms::kNames<kMrspSourceRows>);
  bool first = true;
  for (const char* source : sources) {
    if (!first) out += ',';
    first = false;
    append_string(out, source);
  }
  out += "]}";
}

void append_planned_condition(std::string& out, const kernel::PlannedCondition& c) {
  out += "{\"symbol\":\"";
  out += name(c.symbol);
  out += "\",\"kind\":\"";
  out += kind_name(c.kind);
  out += '"';
  append_member(out, "at_m", c.at.si);
  out += '}';
}

/// The advance display (3.15.10); the first Indication location is an output of every cycle.
void append_planning(OutputRow& row, const Outputs& o, const kernel::Planning& p) {
  const auto metres = [&row](const char* name, const std::optional<Distance>& d) {
    row.key(name);
    if (d)
      append_micro(row.out(), d->si);
    else
      row.absent();
  };
  row.open("planning");
  row.objects("gradient", p.gradients, [](std::string& out, const kernel::PlannedGradient& g) {
    out += '{';
    append_member(out, "from_m", g.from.si, true);
    append_member(out, "to_m", g.to.si);
    append_member(out, "permille", g.permille);
    out += '}';
  });
  row.objects("mrsp", p.speeds, append_planned_speed);
  row.objects("orders", p.conditions, append_planned_condition);
  metres("indication_m", o.d_indication);
  metres("EOA_m", p.EOA);
  metres("LOA_m", p.LOA);
  row.speed("V_LOA_kmh", p.LOA ? std::optional<Speed>(p.V_LOA) : std::nullopt);
  row.close();
}

void append_clock(OutputRow& row, const std::optional<kernel::DateTime>& clock) {
  row.key("clock");
  if (!clock) {
    row.absent();
    return;
  }
  row.out() += "{\"utc\":\"";
  append_date_time(row.out(), clock->utc);
  row.out() += "Z\",\"local\":\"";
  append_date_time(row.out(), clock->utc + 60 * std::int64_t{clock->local_offset_min});
  row.out() += "\"}";
}

void append_dialogue(OutputRow& row, const std::optional<kernel::ShownDialogue>& dialogue) {
  row.key("dialogue");
  if (!dialogue) {
    row.absent();
    return;
  }
  const DialogueRow& words = kDialogueRows[terms::index(dialogue->step)];
  std::string& out = row.out();
  out += std::string("{\"procedure\":\"") + words.procedure + "\",\"step\":\"" + words.step + "\",\"waits_for\":";
  if (dialogue->acknowledges)
    append_string(out, std::string(terms::kNames<kAckRows>[terms::index(*dialogue->acknowledges)]) + "_ack");
  else
    append_string(out, words.waits_for);
  out += '}';
}

/// What CSV has no room for.
void append_second_lists(OutputRow& row, const Outputs& o, const NationalSystemNames& names) {
  std::vector<const char*> levels;
  for (const auto& level : kLevelRows)
    if (o.levels_allowed.has(level.value)) levels.push_back(level.name);
  row.list("levels_allowed", levels, append_text);
  row.list("enabled", enabled_keys(o), append_text);
  row.objects("messages", messages_of(o, names), append_message);
  std::vector<std::pair<kernel::RbcSession, const char*>> sessions;
  for (const kernel::RbcSession& s : o.sessions)
    sessions.emplace_back(s, terms::kNames<kSessionRoleRows>[terms::index(s.role)]);
  for (const kernel::RbcSession& s : o.infill_sessions) sessions.emplace_back(s, nullptr);
  row.objects("sessions", sessions, [](std::string& out, const auto& shown) {
    const auto& [s, role] = shown;
    out += "{\"NID_C\":";
    append_number(out, std::int64_t{s.NID_C});
    out += number_key(role == nullptr);
    append_number(out, std::int64_t{s.NID_RBC});
    out += ",\"state\":\"";
    out += terms::kNames<kSessionPhaseRows>[terms::index(s.phase)];
    out += "\",\"role\":\"";
    out += role != nullptr ? role : "infill";
    out += "\"}";
  });
  row.objects("track_conditions", o.track_conditions, append_condition);
  append_train_orders(row, o);
  row.key("data");
  append_data(row.out(), o.data, o.level, o.covers);
  row.objects("forwarded", o.forwarded, [](std::string& out, const kernel::ForwardedData& data) {
    out += "{\"NID_XUSER\":";
    append_number(out, std::int64_t{data.NID_XUSER});
    out += ",\"NID_NTC\":";
    if (data.NID_NTC)
      append_number(out, std::int64_t{*data.NID_NTC});
    else
      out += "null";
    out += ",\"bits\":";
    append_number(out, std::int64_t{data.bits});
    out += ",\"data\":\"";
    append_hex(out, {data.bytes.begin(), data.bytes.size()});
    out += "\"}";
  });
  append_clock(row, o.clock);
  append_dialogue(row, o.dialogue);
  std::vector<const char*> shown;
  append_names(shown, o.shown, terms::kNames<kDriverOutputRows>);
  row.list("shown", shown, append_text);
}

/// What options ask for.
void append_optional(OutputRow& row, const Outputs& o, const kernel::Planning* planning, const kernel::Display* dmi,
                     std::span<const NamedSound> sounds) {
  if (planning != nullptr)
    append_planning(row, o, *planning);
  else
    row.text("planning", nullptr);
  row.key("dmi");
  if (dmi != nullptr)
    append_display(row.out(), *dmi, sounds);
  else
    row.absent();
}

/// The columns of a trace, and of a JSON line what is in front of the lists of the second edition.
void append_row(OutputRow& row, std::int64_t t_ms, const Outputs& o, const NationalSystemNames& names) {
  row.key("t_ms");
  append_number(row.out(), t_ms);
  row.text("mode", name(o.mode));
  row.text("level", name(o.level));
  append_lrbg(row, o.lrbg);
  row.place("est_front_m", o.est_front);
  row.place("min_safe_front_m", o.min_safe_front);
  row.place("max_safe_front_m", o.max_safe_front);
  append_speeds(row, o);
  row.flag("tco", o.tco);
  row.flag("sb", o.sb);
  row.flag("eb", o.eb);
  row.list("brake_reasons", reasons_of(o), append_text);
  append_driver(row, o);
  append_radio_out(row, o);
  append_radio_address(row, "radio_connect", o.radio_connect);
  append_radio_address(row, "radio_disconnect", o.radio_disconnect);
  row.list("events", o.events, append_event);
  append_second_values(row, o, names);
}

}  // namespace

void append_event(std::string& out, const kernel::Event& event) { out += texts::line_of(event).view(); }

void append_output(std::string& out, std::int64_t t_ms, const Outputs& outputs, const kernel::Planning* planning,
                   const NationalSystemNames& names, const kernel::Display* dmi, std::span<const NamedSound> sounds) {
  out += '{';
  OutputRow row(out, true);
  append_row(row, t_ms, outputs, names);
  append_second_lists(row, outputs, names);
  append_optional(row, outputs, planning, dmi, sounds);
  out += "}\n";
}

void append_trace(std::string& out, std::int64_t t_ms, const Outputs& outputs) {
  OutputRow row(out, false);
  append_row(row, t_ms, outputs, {});
  out += '\n';
}

std::string trace_header() {
  return "t_ms,mode,level,lrbg.NID_C,lrbg.NID_BG,est_front_m,min_safe_front_m,max_safe_front_m,v_kmh,monitoring,status,"
         "V_P,V_W,V_SBI,V_EBI,V_MRSP,V_target,d_target_m,V_release,EOA_m,SvL_m,tco,sb,eb,brake_reasons,driver.requests,"
         "driver.texts,driver.symbols,radio_out,radio_connect.NID_C,radio_connect.NID_RBC,radio_connect.NID_RADIO,"
         "radio_disconnect.NID_C,radio_disconnect.NID_RBC,radio_disconnect.NID_RADIO,events,V_I,tti_s,"
         "lssma_kmh,mrdt_changed,d_indication_m,memo_status,level_valid,trip_reason,geo_m,rv_left_m,version,"
         "radio_register,set_speed_kmh,language\n";
}

namespace {

/// Apart from the distance left in SR and the time left of a cover.
bool differ_in_data(const kernel::Outputs& before, const kernel::Outputs& after) {
  const auto statuses = [](const kernel::ShownData& d) {
    return std::tuple(d.driver_id_status, d.train_running_number_status, d.level_status, d.rbc_status, d.train_status,
                      d.SR.status, d.slippery_rail);
  };
  const auto values = [](const kernel::ShownData& d) {
    return std::tuple(d.network, d.driver_id.view(), d.train_running_number, d.rbc.NID_C, d.rbc.NID_RBC,
                      d.rbc.NID_RADIO, d.SR.V);
  };
  const auto train = [](const kernel::ShownTrainData& t) {
    return std::tuple(t.L_TRAIN, t.V_MAXTRAIN, t.brake_percentage, t.cant_deficiency_mm, t.other_categories,
                      t.axle_load, t.loading_gauge, t.airtight);
  };
  const kernel::ShownData& a = before.data;
  const kernel::ShownData& b = after.data;
  return statuses(a) != statuses(b) || values(a) != values(b) || train(a.train) != train(b.train) ||
         !alike(before.covers, after.covers, [](const auto& c) { return std::pair(c.NID_C, c.NID_VBCMK); });
}

bool differ_in_second_edition(const Outputs& a, const Outputs& b) {
  const bool values = a.dialogue == b.dialogue && a.set_speed == b.set_speed && a.language == b.language &&
                      a.LSSMA == b.LSSMA && a.MRDT_changed == b.MRDT_changed && a.memo_status == b.memo_status &&
                      a.level_valid == b.level_valid && a.trip_reason == b.trip_reason && a.M_VERSION == b.M_VERSION;
  const bool lists = a.levels_allowed == b.levels_allowed && a.enabled == b.enabled && a.shown == b.shown &&
                     alike(a.texts, b.texts, [](const auto& t) { return t.acknowledge; }) &&
                     alike(a.status_texts, b.status_texts, [](const auto& s) { return s.text; }) &&
                     std::equal(a.sessions.begin(), a.sessions.end(), b.sessions.begin(), b.sessions.end()) &&
                     std::equal(a.infill_sessions.begin(), a.infill_sessions.end(), b.infill_sessions.begin(),
                                b.infill_sessions.end());
  // Distances and places apart.
  const bool conditions =
      alike(a.track_conditions, b.track_conditions, [](const auto& c) { return std::pair(c.symbol, c.phase); }) &&
      alike(a.ordered_areas, b.ordered_areas,
            [](const auto& area) { return std::pair(area.kind, area.to_start.has_value()); }) &&
      alike(a.ordered_platforms, b.ordered_platforms, [](const auto& p) { return p.to_start.has_value(); }) &&
      a.ordered_traction.has_value() == b.ordered_traction.has_value() &&
      a.ordered_current.has_value() == b.ordered_current.has_value() && a.sound_horn == b.sound_horn &&
      a.remote_shunting == b.remote_shunting && a.engine_orientation == b.engine_orientation;
  return !values || !lists || !conditions || differ_in_data(a, b);
}

}  // namespace

bool differ_beyond_motion(const Outputs& a, const Outputs& b) {
  if (!b.radio_out.empty() || b.radio_connect || b.radio_disconnect || b.radio_register || !b.events.empty())
    return true;
  if (!a.radio_out.empty() || a.radio_connect || a.radio_disconnect || a.radio_register || !a.events.empty())
    return true;
  if (!a.forwarded.empty() || !b.forwarded.empty()) return true;
  const bool same = a.mode == b.mode && a.level == b.level && a.lrbg == b.lrbg && a.monitoring == b.monitoring &&
                    a.status == b.status && a.V_MRSP == b.V_MRSP && a.V_target == b.V_target &&
                    a.V_release == b.V_release && a.EOA == b.EOA && a.SvL == b.SvL && a.tco == b.tco && a.sb == b.sb &&
                    a.eb == b.eb && alike(a.texts, b.texts, [](const auto& t) { return t.id; });
  return !same || a.brake_reasons != b.brake_reasons || a.requests != b.requests || a.entries != b.entries ||
         a.start_offered != b.start_offered ||
         !std::equal(a.symbols.begin(), a.symbols.end(), b.symbols.begin(), b.symbols.end()) ||
         differ_in_second_edition(a, b);
}

bool differ_beyond_motion(const kernel::Planning* a, const kernel::Planning* b) {
  if (a == nullptr || b == nullptr) return a != b;
  return !alike(a->speeds, b->speeds, [](const auto& s) { return std::pair(s.V, s.sources); }) ||
         !alike(a->gradients, b->gradients, [](const auto& g) { return g.permille; }) ||
         !alike(a->conditions, b->conditions, [](const auto& c) { return c.symbol; }) ||
         a->EOA.has_value() != b->EOA.has_value() || a->LOA.has_value() != b->LOA.has_value();
}

}  // namespace evc::io
