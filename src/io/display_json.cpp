#include "io/display_json.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "io/display_names.h"
#include "io/latin1.h"
#include "io/number.h"
#include "io/output_data.h"
#include "io/rbc_contact.h"
#include "io/train_file.h"
#include "texts/texts.h"

namespace evc::io {
namespace {

/// Objects and lists, with the commas between.
class Writer {
 public:
  explicit Writer(std::string& out) : out_(out) {}

  void open(const char* key = nullptr) { begin(key, '{'); }
  void close() { end('}'); }
  void open_list(const char* key = nullptr) { begin(key, '['); }
  void close_list() { end(']'); }

  void key(const char* name) {
    comma();
    if (name == nullptr) return;
    out_ += '"';
    out_ += name;
    out_ += "\":";
  }
  void number(const char* name, double value) {
    key(name);
    append_micro(out_, value);
  }
  void whole(const char* name, std::int64_t value) {
    key(name);
    append_number(out_, value);
  }
  void flag(const char* name, bool value) {
    key(name);
    out_ += value ? "true" : "false";
  }
  void text(const char* name, std::string_view value) {
    key(name);
    append_string(out_, value);
  }
  /// Of ISO 8859-1.
  void latin1(const char* name, std::string_view value) {
    std::string utf8;
    append_utf8(utf8, value);
    text(name, utf8);
  }
  template <class E>
  void term(const char* name, std::span<const char* const> names, E value) {
    text(name, names[terms::index(value)]);
  }
  void null(const char* name) {
    key(name);
    out_ += "null";
  }
  void metres(const char* name, const std::optional<Distance>& d) { d ? number(name, d->si) : null(name); }
  void kmh(const char* name, const std::optional<Speed>& v) { v ? number(name, v->si * 3.6) : null(name); }
  void seconds(const char* name, const std::optional<Duration>& t) { t ? number(name, t->si) : null(name); }
  template <class T>
  void optional(const char* name, const std::optional<T>& value) {
    value ? whole(name, static_cast<std::int64_t>(*value)) : null(name);
  }
  /// The elements of a set by their names.
  template <class E, class Name>
  void set(const char* name, Set<E> elements, Name name_of) {
    open_list(name);
    for (std::size_t i = 0; i < terms::index(E::count); ++i)
      if (elements.has(static_cast<E>(i))) text(nullptr, name_of(static_cast<E>(i)));
    close_list();
  }
  /// Numbers of a set of bits by their names.
  void bits(const char* name, unsigned bits, std::span<const char* const> names) {
    open_list(name);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (((bits >> i) & 1u) != 0) text(nullptr, names[i]);
    close_list();
  }
  /// `write(element)` writes one value without a key.
  template <class List, class Write>
  void list(const char* name, const List& elements, Write write) {
    open_list(name);
    for (const auto& element : elements) write(element);
    close_list();
  }
  std::string& out() { return out_; }

 private:
  void comma() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  void begin(const char* name, char bracket) {
    key(name);
    out_ += bracket;
    first_ = true;
  }
  void end(char bracket) {
    out_ += bracket;
    first_ = false;
  }

  std::string& out_;
  bool first_ = true;
};

/// Up to the first zero.
template <std::size_t N>
std::string_view until_zero(const std::array<char, N>& characters) {
  const std::string_view all(characters.data(), N);
  return all.substr(0, all.find('\0'));
}

std::string_view category_name(TrainCategory category) { return name(category); }

void append_range(Writer& w, const char* key, const port::EntryRange& r) {
  const auto& [least, most, step, operational_least, operational_most] = r;
  w.open(key);
  w.number("least", least);
  w.number("most", most);
  w.number("step", step);
  operational_least ? w.number("operational_least", *operational_least) : w.null("operational_least");
  operational_most ? w.number("operational_most", *operational_most) : w.null("operational_most");
  w.close();
}

void append_train_types(Writer& w, const port::DisplayConfig& c) {
  w.list("train_types", c.train_types, [&w](const port::TrainType& type) {
    w.open();
    w.latin1("name", until_zero(type.name));
    w.key("data");
    append_train_data(w.out(), type.data);
    w.close();
  });
}

void append_config(Writer& w, const port::DisplayConfig& config) {
  const auto& [srs, dial, ntc_names, languages, train_data_entry, train_types, categories, axle_loads, loading_gauges,
               L_TRAIN, brake_percentage, asks_brake_percentage, V_MAXTRAIN, V_sr, D_sr, cross_checks, gsmr_fitted,
               frmcs_fitted, T_dispTTI] = config;
  w.open("config");
  w.text("srs", name(srs));
  w.whole("dial_kmh", names::kDials[terms::index(dial)]);
  w.list("ntc_names", ntc_names, [&w](const port::NtcName& ntc) {
    w.open();
    w.whole("nid_ntc", ntc.nid_ntc);
    w.latin1("name", until_zero(ntc.characters));
    w.close();
  });
  w.list("languages", languages, [&w](const Language& language) { w.text(nullptr, language.view()); });
  w.term("train_data_entry", names::kEntryNames, train_data_entry);
  static_cast<void>(train_types);
  append_train_types(w, config);
  w.set("categories", categories, category_name);
  w.bits("axle_loads", axle_loads, terms::kNames<kAxleLoadRows>);
  w.bits("loading_gauges", loading_gauges, terms::kNames<kLoadingGaugeRows>);
  append_range(w, "length_m", L_TRAIN);
  append_range(w, "brake_percentage", brake_percentage);
  w.flag("asks_brake_percentage", asks_brake_percentage);
  append_range(w, "max_speed_kmh", V_MAXTRAIN);
  append_range(w, "V_sr_kmh", V_sr);
  append_range(w, "D_sr_m", D_sr);
  w.list("cross_checks", cross_checks, [&w](const port::CrossCheck& check) {
    w.open();
    w.set("categories", check.categories, category_name);
    w.kmh("most_kmh", check.V_most);
    w.flag("operational", check.operational);
    w.close();
  });
  w.flag("gsmr_fitted", gsmr_fitted);
  w.flag("frmcs_fitted", frmcs_fitted);
  w.number("T_dispTTI_s", T_dispTTI.si);
  w.close();
}

void append_level(Writer& w, const char* key, Level level, std::uint8_t nid_ntc) {
  w.open(key);
  w.text("level", name(level));
  level == Level::NTC ? w.whole("nid_ntc", nid_ntc) : w.null("nid_ntc");
  w.close();
}

/// Areas A and B.
void append_speeds(Writer& w, const port::Display& d) {
  w.kmh("v_kmh", d.v);
  w.text("monitoring", terms::kNames<kMonitoringRows>[terms::index(d.monitoring)]);
  w.text("status", terms::kNames<kStatusRows>[terms::index(d.status)]);
  w.kmh("V_P", d.V_P);
  w.kmh("V_SBI", d.V_SBI);
  w.kmh("V_target", d.V_target);
  w.kmh("V_release", d.V_release);
  w.flag("target_information", d.target_information);
  w.whole("mrdt", d.MRDT);
  w.metres("d_target_m", d.d_target);
  w.seconds("tti_s", d.TTI);
  w.kmh("lssma_kmh", d.LSSMA);
  w.kmh("set_speed_kmh", d.set_speed);
}

void append_symbols(Writer& w, const port::Display& d) {
  w.flag("slippery_rail", d.slippery_rail);
  d.sm ? w.term("sm", names::kSmNames, *d.sm) : w.null("sm");
  w.flag("override_active", d.override_active);
  w.flag("reversing_permitted", d.reversing_permitted);
  w.flag("bmm_inhibited", d.bmm_inhibited);
  w.flag("brake", d.brake);
  w.flag("brake_for_missing_ack", d.brake_for_missing_ack);
  if (d.announced_level)
    append_level(w, "announced_level", d.announced_level->level, d.announced_level->nid_ntc);
  else
    w.null("announced_level");
  w.term("radio", names::kRadioNames, d.radio);
  w.metres("geo_m", d.geo);
  w.list("conditions", d.conditions, [&w](const port::DisplayedCondition& c) {
    w.open();
    w.whole("id", c.id);
    w.text("symbol", name(c.picture));
    w.text("phase", terms::kNames<kConditionPhaseRows>[terms::index(c.phase)]);
    w.close();
  });
  if (d.tunnel) {
    w.open("tunnel");
    w.flag("inside", d.tunnel->inside);
    w.metres("distance_m", d.tunnel->distance);
    w.close();
  } else {
    w.null("tunnel");
  }
  w.flag("track_ahead_free", d.track_ahead_free);
}

void append_planning(Writer& w, const port::Display& d) {
  const auto& [speeds, gradients, conditions, EOA, LOA, V_LOA] = d.planning;
  w.open("planning");
  w.list("gradient", gradients, [&w](const port::PlannedGradient& g) {
    w.open();
    w.metres("from_m", g.from);
    w.metres("to_m", g.to);
    w.whole("permille", g.permille);
    w.close();
  });
  w.list("mrsp", speeds, [&w](const port::PlannedSpeed& speed) {
    w.open();
    w.metres("at_m", speed.at);
    w.kmh("v_kmh", speed.V);
    w.set("from", speed.sources,
          [](MrspSource source) { return terms::kNames<kMrspSourceRows>[terms::index(source)]; });
    w.close();
  });
  static_cast<void>(conditions);  // they are the orders
  w.list("orders", d.orders, [&w](const port::PlannedOrder& order) {
    w.open();
    w.text("symbol", name(order.picture));
    w.metres("at_m", order.at);
    w.close();
  });
  w.metres("indication_m", d.indication_marker);
  w.metres("indication_target_m", d.indication_target);
  w.metres("EOA_m", EOA);
  w.metres("LOA_m", LOA);
  w.kmh("V_LOA_kmh", LOA ? std::optional<Speed>(V_LOA) : std::nullopt);
  w.close();
}

void append_displayed_text(Writer& w, const port::DisplayedText& t) {
  w.open();
  w.whole("id", t.id);
  w.term("kind", names::kTextKindNames, t.kind);
  w.text("class", t.important ? "important" : "auxiliary");
  w.flag("ack", t.acknowledge);
  w.number("since_ms", t.since.si * 1000.0);
  w.optional("minute_of_day", t.minute_of_day);
  switch (t.kind) {
    case port::TextKind::fixed:
      w.whole("q_text", t.Q_TEXT);
      break;
    case port::TextKind::status:
      w.text("status", name(t.status));
      names_national_system(t.status) ? w.whole("nid_ntc", t.nid_ntc) : w.null("nid_ntc");
      break;
    case port::TextKind::plain:
    case port::TextKind::national:
      w.latin1("text", {t.characters.data(), t.length});
      break;
  }
  w.close();
}

void append_acks(Writer& w, const port::Display& d) {
  w.list("acks", d.acks, [&w](const port::AskedAck& asked) {
    w.open();
    w.text("what", terms::kNames<kAckRows>[terms::index(asked.what)]);
    asked.what == Ack::text ? w.whole("id", asked.id) : w.null("id");
    w.number("since_ms", asked.since.si * 1000.0);
    w.close();
  });
}

void append_displayed_data(Writer& w, const port::Display& d) {
  const auto& [stored, train_type, levels, ntcs, networks, covers, M_VERSION, radio, gsmr_registered, frmcs_registered,
               asks_one_radio_system, D_sr_most] = d.data;
  w.open("data");
  w.key("stored");
  append_data(w.out(), stored, d.level, covers);
  w.optional("train_type", train_type);
  w.bits("levels", levels, terms::kNames<kLevelRows>);
  w.list("ntcs", ntcs, [&w](std::uint8_t nid_ntc) { w.whole(nullptr, nid_ntc); });
  w.list("networks", networks, [&w](std::uint32_t NID_MN) { w.text(nullptr, digits_of_NID_MN(NID_MN)); });
  w.text("version", std::to_string(M_VERSION >> 4) + '.' + std::to_string(M_VERSION & 15));
  w.term("radio", names::kNetworkTypeNames, radio);
  w.flag("gsmr_registered", gsmr_registered);
  w.flag("frmcs_registered", frmcs_registered);
  w.flag("asks_one_radio_system", asks_one_radio_system);
  w.metres("D_sr_most_m", D_sr_most);
  w.close();
}

void append_ato(Writer& w, const port::DisplayedAto& ato) {
  const auto& [on, status, stop, dwell_s, hold, doors, skip, coasting_advice, warning_sound, advice_speed, name_length,
               name, arrival, stopping_points, advice_change] = ato;
  w.open("ato");
  w.flag("on", on);
  w.term("status", names::kAtoStatusNames, status);
  w.term("stop", names::kAtoStopNames, stop);
  w.optional("dwell_s", dwell_s);
  w.flag("hold", hold);
  w.term("doors", names::kAtoDoorsNames, doors);
  w.term("skip", names::kAtoSkipNames, skip);
  w.flag("coasting_advice", coasting_advice);
  w.flag("warning_sound", warning_sound);
  w.kmh("advice_speed_kmh", advice_speed);
  w.latin1("name", {name.data(), name_length});
  w.optional("arrival_second_of_day", arrival);
  w.list("stopping_points_m", stopping_points, [&w](Distance at) { w.metres(nullptr, at); });
  w.metres("advice_change_m", advice_change);
  w.close();
}

void append_step(Writer& w, const std::optional<Dialogue>& step) {
  if (!step) return w.null("step");
  const DialogueRow& row = kDialogueRows[terms::index(*step)];
  w.open("step");
  w.text("procedure", row.procedure);
  w.text("step", row.step);
  w.close();
}

/// All members by name where they are few: a new one that is not named does not compile. For port::Display itself the
/// test changes each member.
void append_members(Writer& w, const port::Display& d) {
  w.text("schema", "evc-dmi/1");
  append_config(w, d.config);
  w.number("now_ms", d.now.si * 1000.0);
  w.optional("second_of_day", d.second_of_day);
  w.text("mode", name(d.mode));
  w.flag("level_valid", d.level_valid);
  append_level(w, "level", d.level, d.nid_ntc);
  w.flag("standstill", d.standstill);
  w.text("language", d.language.view());
  append_speeds(w, d);
  append_symbols(w, d);
  append_planning(w, d);
  w.list("texts", d.texts, [&w](const port::DisplayedText& text) { append_displayed_text(w, text); });
  append_acks(w, d);
  append_displayed_data(w, d);
  w.set("buttons", d.buttons, [](Button button) { return name(button); });
  w.set("enabled", d.enabled, [](DriverInput input) { return name(input); });
  append_step(w, d.step);
  w.flag("start_of_mission", d.start_of_mission);
  w.term("waiting", names::kWaitingNames, d.waiting);
  append_ato(w, d.ato);
}

/// There is one, wherever it is.
constexpr void forget(std::optional<Distance>& d) {
  if (d) d = Distance{};
}
constexpr void forget(std::optional<Speed>& v) {
  if (v) v = Speed{};
}

void forget_planning(port::Display& d) {
  for (auto& gradient : d.planning.gradients) gradient.from = gradient.to = {};
  for (auto& speed : d.planning.speeds) speed.at = {};
  for (auto& order : d.orders) order.at = {};
  forget(d.planning.EOA);
  forget(d.planning.LOA);
  forget(d.indication_marker);
  forget(d.indication_target);
}

}  // namespace

void append_display(std::string& out, const port::Display& display, std::span<const NamedSound> sounds) {
  Writer w(out);
  w.open();
  append_members(w, display);
  w.list("sounds", sounds, [&w](const NamedSound& sound) {
    w.open();
    w.text("id", sound.id);
    sound.what != nullptr ? w.text("do", sound.what) : w.whole("times", 1);
    w.close();
  });
  w.close();
}

std::string motionless(const port::Display& display) {
  const auto d = std::make_unique<port::Display>(display);
  d->now = {};
  d->second_of_day.reset();
  d->v = {};
  forget(d->V_P);
  forget(d->V_SBI);
  forget(d->d_target);
  if (d->TTI) d->TTI = Duration{};
  forget(d->geo);
  if (d->tunnel) d->tunnel->distance = {};
  forget_planning(*d);
  forget(d->data.stored.SR.D);
  for (auto& cover : d->data.covers) cover.left = {};
  forget(d->ato.advice_change);
  for (auto& point : d->ato.stopping_points) point = {};
  d->ato.dwell_s.reset();
  std::string text;
  append_display(text, *d);
  return text;
}

}  // namespace evc::io
