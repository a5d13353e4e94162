#include "io/output_lines.h"

#include <cstring>

#include "io/number.h"

namespace evc::io {
namespace {

using kernel::Outputs;

constexpr const char* kMonitoring[] = {nullptr, "CSM", "TSM", "RSM"};
constexpr const char* kStatus[] = {nullptr, "Normal", "Indication", "Overspeed", "Warning", "Intervention"};

void append_kmh(std::string& out, Speed v) { append_micro(out, v.si * 3.6); }
void append_metres(std::string& out, OdometerPlace p) { append_micro(out, p.from_origin.si); }

/// One shape for both formats: JSON has a key before each value and `null`, CSV a comma and nothing.
class Row {
 public:
  Row(std::string& out, bool json) : out_(out), json_(json) {}

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

void append_radio_address(Row& row, const char* name, const std::optional<kernel::RbcAddress>& address) {
  if (row.json()) {
    row.key(name);
    if (!address) {
      row.absent();
      return;
    }
    row.out() += "{\"NID_C\":";
    append_number(row.out(), static_cast<std::int64_t>(address->NID_C));
    row.out() += ",\"NID_RBC\":";
    append_number(row.out(), static_cast<std::int64_t>(address->NID_RBC));
    row.out() += ",\"NID_RADIO\":\"";
  } else {
    row.number(name, address.has_value(), address ? address->NID_C : 0);
    row.number(name, address.has_value(), address ? address->NID_RBC : 0);
    row.key(name);
    if (!address) return;
  }
  std::uint8_t bytes[8];
  for (unsigned i = 0; i < 8; ++i) bytes[i] = static_cast<std::uint8_t>((address->NID_RADIO >> (56 - 8 * i)) & 0xffu);
  append_hex(row.out(), bytes);
  if (row.json()) row.out() += "\"}";
}

void append_lrbg(Row& row, const std::optional<kernel::NidLrbg>& lrbg) {
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
  for (std::size_t i = 0; i < text.length; ++i) {
    const auto c = static_cast<unsigned char>(text.characters[i]);
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else {
      out += static_cast<char>(0xC0 | (c >> 6));
      out += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
}

bool same_shown(const InplaceVector<kernel::ShownText, 6>& a, const InplaceVector<kernel::ShownText, 6>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].id != b[i].id) return false;
  return true;
}

void append_driver(Row& row, const Outputs& o) {
  const auto text = [](std::string& out, const char* s) { out += s; };
  if (row.json()) row.open("driver");
  row.list("requests", o.driver_requests, text);
  row.list("texts", o.texts, append_shown_text);
  row.list("symbols", o.symbols, text);
  row.close();
}

void append_speeds(Row& row, const Outputs& o) {
  row.speed("v_kmh", o.v);
  row.text("monitoring", kMonitoring[static_cast<std::size_t>(o.monitoring)]);
  row.text("status", kStatus[static_cast<std::size_t>(o.status)]);
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

void append_row(Row row, std::int64_t t_ms, const Outputs& o) {
  row.key("t_ms");
  append_number(row.out(), t_ms);
  row.text("mode", modes::name(o.mode));
  row.text("level", modes::name(o.level));
  append_lrbg(row, o.lrbg);
  row.place("est_front_m", o.est_front);
  row.place("min_safe_front_m", o.min_safe_front);
  row.place("max_safe_front_m", o.max_safe_front);
  append_speeds(row, o);
  row.flag("tco", o.tco);
  row.flag("sb", o.sb);
  row.flag("eb", o.eb);
  row.list("brake_reasons", o.brake_reasons, [](std::string& out, const char* s) { out += s; });
  append_driver(row, o);
  row.list("radio_out", o.radio_out, [](std::string& out, const kernel::OutgoingMessage& m) {
    append_hex(out, {m.bytes.begin(), m.bytes.size()});
  });
  append_radio_address(row, "radio_connect", o.radio_connect);
  append_radio_address(row, "radio_disconnect", o.radio_disconnect);
  row.list("events", o.events, append_event);
}

template <class T, std::size_t N>
bool same_texts(const InplaceVector<T, N>& a, const InplaceVector<T, N>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::strcmp(a[i], b[i]) != 0) return false;
  return true;
}

}  // namespace

void append_event(std::string& out, const kernel::Event& e) {
  out += e.subject;
  const auto word = [&out](const char* text) {
    if (!out.empty()) out += ' ';
    out += text;
  };
  if (e.id >= 0) {
    word("");
    append_number(out, e.id);
  }
  if (e.from != nullptr && e.to != nullptr) {
    word(e.from);
    out += "->";
    out += e.to;
  }
  if (e.what != nullptr) word(e.what);
  if (e.clause != nullptr) {
    word("[");
    out += e.clause;
    out += ']';
  } else if (e.number >= 0) {
    word("[");
    append_number(out, static_cast<std::int64_t>(e.number));
    out += ']';
  }
}

void append_output(std::string& out, std::int64_t t_ms, const Outputs& outputs) {
  out += '{';
  append_row(Row(out, true), t_ms, outputs);
  out += "}\n";
}

void append_trace(std::string& out, std::int64_t t_ms, const Outputs& outputs) {
  append_row(Row(out, false), t_ms, outputs);
  out += '\n';
}

std::string trace_header() {
  return "t_ms,mode,level,lrbg.NID_C,lrbg.NID_BG,est_front_m,min_safe_front_m,max_safe_front_m,v_kmh,monitoring,status,"
         "V_P,V_W,V_SBI,V_EBI,V_MRSP,V_target,d_target_m,V_release,EOA_m,SvL_m,tco,sb,eb,brake_reasons,driver.requests,"
         "driver.texts,driver.symbols,radio_out,radio_connect.NID_C,radio_connect.NID_RBC,radio_connect.NID_RADIO,"
         "radio_disconnect.NID_C,radio_disconnect.NID_RBC,radio_disconnect.NID_RADIO,events\n";
}

bool differ_beyond_motion(const Outputs& a, const Outputs& b) {
  if (!b.radio_out.empty() || b.radio_connect || b.radio_disconnect || !b.events.empty()) return true;
  if (!a.radio_out.empty() || a.radio_connect || a.radio_disconnect || !a.events.empty()) return true;
  const bool same = a.mode == b.mode && a.level == b.level && a.lrbg == b.lrbg && a.monitoring == b.monitoring &&
                    a.status == b.status && a.V_MRSP == b.V_MRSP && a.V_target == b.V_target &&
                    a.V_release == b.V_release && a.EOA == b.EOA && a.SvL == b.SvL && a.tco == b.tco && a.sb == b.sb &&
                    a.eb == b.eb && same_shown(a.texts, b.texts);
  return !same || !same_texts(a.brake_reasons, b.brake_reasons) || !same_texts(a.driver_requests, b.driver_requests) ||
         !same_texts(a.symbols, b.symbols);
}

}  // namespace evc::io
