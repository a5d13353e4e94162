#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curves/picture.h"
#include "curves/plot.h"
#include "io/number.h"
#include "io/xml.h"

// The interactive page: all values are computed here, on a grid; the page interpolates.
namespace evc::curves {

extern const char page_template[];

namespace {

constexpr std::size_t kColumns = 320;
constexpr double kRow_kmh = 1.0;
constexpr double kLimit_kmh = 1.0;

/// Two decimals are enough for a chart.
void append_rounded(std::string& out, double v) {
  if (std::isfinite(v))
    io::append_number(out, std::nearbyint(v * 100.0) / 100.0 + 0.0);
  else
    out += "null";
}

template <class Items, class Append>
void append_array(std::string& out, const char* key, const Items& items, Append append) {
  out += fmt::format("{}\"{}\":[", out.back() == '{' ? "" : ",", key);
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += ',';
    first = false;
    append(item);
  }
  out += ']';
}

void append_key(std::string& out, const char* key) {
  out += fmt::format("{}\"{}\":", out.back() == '{' ? "" : ",", key);
}

void append_curves(std::string& out, const Picture& p) {
  append_array(out, "x", p.x_m, [&](double x) { io::append_number(out, std::nearbyint(x * 1000.0) / 1000.0 + 0.0); });
  append_array(out, "curves", p.curves, [&](const PictureCurve& c) {
    std::string dash = c.stroke.dash;
    std::replace(dash.begin(), dash.end(), ' ', ',');
    out += fmt::format("{{\"key\":\"{}\",\"name\":\"{}\",\"colour\":\"{}\",\"width\":{:g},\"dash\":[{}]", c.key, c.name,
                       c.stroke.colour, c.stroke.width, dash);
    append_array(out, "v", c.v, [&](double v) { append_rounded(out, v); });
    out += '}';
  });
  const auto append_step = [&](const Picture::Step& s) {
    out += '[';
    append_rounded(out, s.from_m);
    out += ',';
    append_rounded(out, s.value);
    out += ']';
  };
  append_array(out, "gradient", p.gradient, append_step);
  append_array(out, "under", p.under_train, append_step);
  append_array(out, "zones", p.zones, [&](const Picture::Zone& z) {
    out += '[';
    append_rounded(out, z.from_m);
    out += ',';
    append_rounded(out, z.to_m);
    out += fmt::format(",{},\"{}\"]", z.row, z.name);
  });
  append_array(out, "marks", p.marks, [&](const Picture::Mark& mark) {
    out += '[';
    append_rounded(out, mark.x_m);
    out += ",\"" + mark.name + "\"]";
  });
}

/// Places of the chosen target's curves and limits by speed.
void append_limits(std::string& out, const Approached& a, const Picture& p) {
  std::vector<SpeedRow> rows;
  for (double v = 0.0; v <= p.top_kmh + kLimit_kmh; v += kLimit_kmh) rows.push_back(speed_row(a, v));
  const double target = a.input().target_location.from_origin.si;
  append_key(out, "limits");
  out += fmt::format("{{\"step\":{:g}", kLimit_kmh);
  for (const auto& c : curve_columns()) {
    const std::string name = std::string(c.name) == "FLOI" ? "SBI" : c.name;
    append_array(out, name.c_str(), rows, [&](const SpeedRow& row) {
      append_rounded(out, row.*c.value ? target - *(row.*c.value) : std::nan(""));
    });
  }
  out += '}';
}

struct State {
  int status, monitoring;
  bool tco, sb, eb;
  friend bool operator==(const State&, const State&) = default;
};

/// The first cycle of supervision with the train at this place and speed.
State state_at(const Approached& a, double x_m, double v_kmh) {
  sdm::Motion m;
  m.est_front = m.min_safe_front = m.max_safe_front = Place{{x_m}};
  if (const auto& given = a.input().motion) {
    m.max_safe_front = m.est_front + (given->max_safe_front - given->est_front);
    m.min_safe_front = m.est_front - (given->est_front - given->min_safe_front);
  }
  m.V_est = {v_kmh / kKmh};
  m.V_ura = a.V_ura_at(Speed{v_kmh / kKmh});
  m.A_est = a.input().A_est;
  m.standstill = v_kmh <= 0.0;
  sdm::Supervision fresh;
  const sdm::Result r = sdm::supervise(fresh, a.derived(), m);
  return {static_cast<int>(r.status), static_cast<int>(r.monitoring), r.tco, r.sb, r.eb};
}

void append_map(std::string& out, const Approached& a, const Picture& p) {
  const double dx = (p.to_m - p.from_m) / static_cast<double>(kColumns - 1);
  const auto rows = static_cast<std::size_t>(p.top_kmh / kRow_kmh) + 1;
  std::vector<State> states;
  append_key(out, "map");
  out += fmt::format("{{\"x0\":{},\"dx\":{},\"dv\":{:g},\"rows\":{}", p.from_m, dx, kRow_kmh, rows);
  std::vector<std::size_t> columns(kColumns);
  for (std::size_t i = 0; i < kColumns; ++i) columns[i] = i;
  append_array(out, "columns", columns, [&](std::size_t i) {
    out += '[';
    std::size_t run = 0, before = 0;
    for (std::size_t k = 0; k < rows; ++k) {
      const State s = state_at(a, p.from_m + static_cast<double>(i) * dx, static_cast<double>(k) * kRow_kmh);
      const auto found = std::find(states.begin(), states.end(), s);
      const auto index = static_cast<std::size_t>(found - states.begin());
      if (found == states.end()) states.push_back(s);
      if (k > 0 && index != before) {
        out += fmt::format("{},{},", before, run);
        run = 0;
      }
      before = index;
      ++run;
    }
    out += fmt::format("{},{}]", before, run);
  });
  append_array(out, "states", states, [&](const State& s) {
    out += fmt::format("{{\"status\":{},\"monitoring\":{},\"tco\":{},\"sb\":{},\"eb\":{}}}", s.status, s.monitoring,
                       s.tco, s.sb, s.eb);
  });
  out += '}';
}

std::string data_of(const Approached& a) {
  const Picture p = picture_of(a);
  const Scalars scalars = scalars_of(a);
  const io::CurvesInput& c = a.input();
  std::string out = "{";
  append_key(out, "name");
  io::append_string(out, c.name);
  append_key(out, "subtitle");
  io::append_string(out, fmt::format("{}, L_TRAIN {:g} m, SUBSET-026 {}, T_be {} s, T_bs {} s", c.train_name,
                                     c.inputs.train.L_TRAIN.si, name(c.inputs.srs), fixed(scalars.T_be_s, 2),
                                     fixed(scalars.T_bs_s, 2)));
  append_key(out, "top");
  append_rounded(out, p.top_kmh);
  append_key(out, "bottom");
  append_rounded(out, p.bottom_kmh);
  append_key(out, "target");
  append_rounded(out, c.target_location.from_origin.si);
  const double middle = p.from_m + 0.45 * (p.to_m - p.from_m);
  append_key(out, "train");
  out += fmt::format("{{\"x\":{},\"v\":{}}}", c.motion ? c.motion->est_front.from_origin.si : middle,
                     0.8 * c.inputs.mrsp.at(Place{{middle}}).si * kKmh);
  append_curves(out, p);
  append_limits(out, a, p);
  append_key(out, "release");
  if (p.V_release_kmh && p.start_of_RSM_m) {
    out += '[';
    append_rounded(out, *p.start_of_RSM_m);
    out += ',';
    append_rounded(out, *p.V_release_kmh);
    out += ',';
    append_rounded(out, p.end_of_RSM_m);
    out += ']';
  } else {
    out += "null";
  }
  append_map(out, a, p);
  append_array(out, "notes", a.notes(), [&](const std::string& note) { io::append_string(out, note); });
  return out + "}";
}

}  // namespace

std::string curves_html(const Approached& a) {
  const std::string data = io::json_in_script(data_of(a));
  std::string page = page_template;
  const std::string slot = "/*DATA*/null";
  page.replace(page.find(slot), slot.size(), data);
  return page;
}

}  // namespace evc::curves
