#include "run/report.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/number.h"
#include "io/xml.h"
#include "run/rounded.h"

namespace evc::run {

extern const char report_template[];

namespace {

constexpr double kTolerance_kmh = 0.15;  // maximum change of a curve by thinning
constexpr double kTolerance_m = 1.0;
constexpr std::size_t kLongestGap = 100;  // cycles

constexpr double Sample::*kCurves[] = {&Sample::v,   &Sample::mrsp, &Sample::p,      &Sample::w,
                                       &Sample::sbi, &Sample::ebi,  &Sample::target, &Sample::release};

bool same_state(const Sample& a, const Sample& b) {
  if (a.mode != b.mode || a.level != b.level || a.monitoring != b.monitoring || a.status != b.status ||
      a.brakes != b.brakes)
    return false;
  if (std::isnan(a.d_target) != std::isnan(b.d_target)) return false;
  return std::all_of(std::begin(kCurves), std::end(kCurves),
                     [&](auto curve) { return std::isnan(a.*curve) == std::isnan(b.*curve); });
}

/// Whether every sample between `first` and `last` is on the straight lines between them.
bool straight(const std::vector<Sample>& s, std::size_t first, std::size_t last) {
  const Sample& a = s[first];
  const Sample& b = s[last];
  const double n = static_cast<double>(last - first);
  for (std::size_t i = first + 1; i < last; ++i) {
    const double share = static_cast<double>(i - first) / n;
    if (std::abs(a.x_m + share * (b.x_m - a.x_m) - s[i].x_m) > kTolerance_m) return false;
    for (const auto curve : kCurves) {
      if (std::isnan(a.*curve)) continue;
      if (!(std::abs(a.*curve + share * (b.*curve - a.*curve) - s[i].*curve) <= kTolerance_kmh)) return false;
    }
  }
  return true;
}

/// The samples that a chart needs: every change of state with the sample before it, and as few points of the curves as
/// the tolerance allows.
std::vector<std::size_t> thinned(const std::vector<Sample>& s) {
  std::vector<std::size_t> kept;
  if (s.empty()) return kept;
  kept.push_back(0);
  for (std::size_t i = 1; i < s.size(); ++i) {
    const std::size_t from = kept.back();
    const bool changed = !same_state(s[i - 1], s[i]);
    if (changed) {
      if (from != i - 1) kept.push_back(i - 1);
      kept.push_back(i);
    } else if (i - from > kLongestGap || !straight(s, from, i)) {
      if (from != i - 1) kept.push_back(i - 1);
    }
  }
  if (kept.back() != s.size() - 1) kept.push_back(s.size() - 1);
  return kept;
}

/// A chart can show one decimal.
void append_tenths(std::string& out, double v) {
  if (std::isnan(v))
    out += "null";
  else
    io::append_number(out, tenth(v));
}

template <class Items, class Append>
void append_list(std::string& out, const char* key, const Items& items, Append append) {
  out += out.back() == '{' ? "\"" : ",\"";
  out += key;
  out += "\":[";
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += ',';
    first = false;
    append(item);
  }
  out += ']';
}

void append_samples(std::string& out, const std::vector<Sample>& samples) {
  const auto kept = thinned(samples);
  const auto column = [&](const char* key, double Sample::*field) {
    append_list(out, key, kept, [&](std::size_t i) { append_tenths(out, samples[i].*field); });
  };
  column("t", &Sample::t_s);
  column("x", &Sample::x_m);
  column("v", &Sample::v);
  column("mrsp", &Sample::mrsp);
  column("p", &Sample::p);
  column("w", &Sample::w);
  column("sbi", &Sample::sbi);
  column("ebi", &Sample::ebi);
  column("vt", &Sample::target);
  column("dt", &Sample::d_target);
  column("vr", &Sample::release);
  const auto codes = [&](const char* key, std::uint8_t Sample::*field) {
    append_list(out, key, kept, [&](std::size_t i) { io::append_number(out, std::int64_t{samples[i].*field}); });
  };
  codes("mode", &Sample::mode);
  codes("level", &Sample::level);
  codes("mon", &Sample::monitoring);
  codes("status", &Sample::status);
  codes("brakes", &Sample::brakes);
}

void append_line(std::string& out, const sim::Line& line, const sim::World& world) {
  append_list(out, "gradient", line.gradient, [&](const sim::GradientSegment& g) {
    out += '[';
    append_tenths(out, g.start_m);
    out += ',';
    append_tenths(out, g.end_m);
    out += ',';
    append_tenths(out, g.permille);
    out += ']';
  });
  append_list(out, "groups", world.passings(), [&](const sim::Passing& p) {
    out += '[';
    append_tenths(out, p.position_m);
    out += ',';
    io::append_number(out, std::int64_t{p.NID_C});
    out += ',';
    io::append_number(out, std::int64_t{p.NID_BG});
    out += ']';
  });
  append_list(out, "radio", world.radio().deliveries(), [&](const sim::Delivery& d) {
    out += '[';
    append_tenths(out, static_cast<double>(d.t_ms) / 1000.0);
    out += ',';
    append_tenths(out, d.front_m);
    out += ',';
    io::append_number(out, std::int64_t{d.NID_MESSAGE});
    out += ',';
    io::append_number(out, std::int64_t{d.seq});
    out += ']';
  });
}

template <class Enum>
void append_names(std::string& out, const char* key, std::size_t count) {
  std::vector<std::size_t> codes(count);
  for (std::size_t i = 0; i < count; ++i) codes[i] = i;
  append_list(out, key, codes, [&](std::size_t i) { io::append_string(out, name(static_cast<Enum>(i))); });
}

std::string data_of(const Journey& journey, const sim::World& world, const sim::Line& line,
                    const std::string& train_name, const std::string& driver_name, const std::string& summary) {
  std::string out = "{";
  append_names<Mode>(out, "modes", kModes);
  append_names<Level>(out, "levels", kLevels);
  out += ",\"line\":";
  io::append_string(out, line.name);
  out += ",\"train\":";
  io::append_string(out, train_name);
  out += ",\"driver\":";
  io::append_string(out, driver_name);
  append_samples(out, journey.samples());
  append_line(out, line, world);
  append_list(out, "events", journey.events(), [&](const JourneyEvent& e) {
    out += '[';
    append_tenths(out, e.t_s);
    out += ',';
    append_tenths(out, e.x_m);
    out += ',';
    io::append_string(out, e.text);
    out += ']';
  });
  return out + ",\"summary\":" + summary + "}";
}

}  // namespace

std::string report_page(const Journey& journey, const sim::World& world, const sim::Line& line,
                        const std::string& train_name, const std::string& driver_name, const std::string& summary,
                        const DisplayLists& displays) {
  std::string page = report_template;
  const auto put = [&page](std::string_view place, const std::string& text) {
    page.replace(page.find(place), place.size(), text);
  };
  put("/*DATA*/null", io::json_in_script(data_of(journey, world, line, train_name, driver_name, summary)));
  put("/*DISPLAY*/null", displays.json(kLargestReport - std::min(kLargestReport, page.size())));
  return page;
}

}  // namespace evc::run
