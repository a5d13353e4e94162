#include "screen/screen_json.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

// The kinds and their fields are explained in docs/dmi.md. Where no comment says otherwise x and y are relative to the
// area; `abs` and `centre` are absolute.
namespace evc::screen {
namespace {

using dmi::Item;
using dmi::Kind;
using dmi::Rect;

/// A millionth is enough, and the same everywhere.
double rounded(double value) {
  if (!std::isfinite(value) || std::abs(value) > 1e9) return 0.0;
  return std::nearbyint(value * 1e6) / 1e6 + 0.0;
}

OrderedJson list_of(const Rect& r) { return {r.x, r.y, r.w, r.h}; }

std::string utf8(std::string_view text) { return std::string(text); }

const char* name_of(dmi::Align align) {
  return align == dmi::Align::left ? "left" : align == dmi::Align::centre ? "centre" : "right";
}
const char* name_of(dmi::ButtonType type) {
  switch (type) {
    case dmi::ButtonType::up:
      return "up";
    case dmi::ButtonType::down:
      return "down";
    case dmi::ButtonType::down_repeat:
      return "down, repeat";
    case dmi::ButtonType::delay:
      return "delay";
  }
  return "up";
}
const char* name_of(dmi::Border border) {
  switch (border) {
    case dmi::Border::none:
      return "none";
    case dmi::Border::area:
      return "area";
    case dmi::Border::button:
      return "button";
    case dmi::Border::field:
      return "input field";
  }
  return "none";
}
const char* name_of(dmi::FieldState state) {
  switch (state) {
    case dmi::FieldState::not_selected:
      return "not selected";
    case dmi::FieldState::selected:
      return "selected";
    case dmi::FieldState::accepted:
      return "accepted";
  }
  return "not selected";
}

/// The colour, where there is one.
void add_colour(OrderedJson& out, const char* key, dmi::Colour colour) {
  if (colour != dmi::Colour::none) out[key] = dmi::name(colour);
}

void add_name(OrderedJson& out, const Item& item) {
  if (!item.name.empty()) out["name"] = utf8(item.name.view());
}

/// `abs`, `centre`, and in area D the distances from its upper left corner.
void add_place(OrderedJson& out, const Rect& abs) {
  constexpr Rect d = dmi::rect_of(dmi::Area::D);
  out["abs"] = list_of(abs);
  out["centre"] = {abs.x + abs.w / 2.0, abs.y + abs.h / 2.0};
  if (abs.x < d.x || abs.x >= d.x + d.w || abs.y < d.y - abs.h || abs.y >= d.y + d.h) return;
  out["x_rel_D"] = abs.x - d.x;
  out["top_y_rel_D"] = abs.y - d.y;
  out["bottom_y_rel_D"] = abs.y + abs.h - d.y;
  out["centre_y_rel_D"] = rounded(abs.y + abs.h / 2.0 - d.y);
}

/// The lowest row of the bar of a speed change, on which its place is (015560 8.3.6): 18 of PL21, 4 of the others.
void add_bar(OrderedJson& out, const Item& item, const Rect& abs) {
  constexpr int bar_above = 4, bar_below = 18;
  const Picture p = *item.picture;
  const int d = dmi::rect_of(dmi::Area::D).y;
  if (p == Picture::PL21) out["bar_bottom_y_rel_D"] = abs.y + bar_below - d;
  if (p == Picture::PL22 || p == Picture::PL23 || p == Picture::PL37) out["bar_bottom_y_rel_D"] = abs.y + bar_above - d;
}

void add_text(OrderedJson& out, const Item& item) {
  const Rect abs = dmi::absolute(item);
  out["value"] = utf8(item.text.view());
  out["align"] = name_of(item.align);
  const int height = item.height;
  const std::string_view role = item.name.view();
  out["x"] = abs.x + (item.align == dmi::Align::left ? item.indent : 0);  // absolute, as y: top of capital letters
  out["y"] = rounded(abs.y + (abs.h - height) / 2.0);
  if (item.align == dmi::Align::right) {
    const int edge = abs.x + abs.w - item.indent;
    out[role == "dwell" ? "number_right_edge" : "right_edge"] = edge;  // of "59s" without its unit
  }
  if (role == "geo") {
    out["heights"] = {{"km", height}, {"m", 10}};
  } else {
    out["height"] = height;
  }
  add_colour(out, "colour", item.colour);
  add_colour(out, "bg", item.background);
  out["bold"] = item.bold;
  if (role == "top" || role == "middle" || role == "bottom")
    out["position"] = utf8(role);
  else
    add_name(out, item);
  add_place(out, abs);
  if (item.align == dmi::Align::left && out.contains("x_rel_D"))
    out["x_rel_D"] = out["x_rel_D"].get<int>() + item.indent;
}

OrderedJson sides_of(std::uint8_t sides) {
  OrderedJson out = OrderedJson::array();
  if ((sides & dmi::kTop) != 0) out.push_back("top");
  if ((sides & dmi::kLeft) != 0) out.push_back("left");
  if ((sides & dmi::kBottom) != 0) out.push_back("bottom");
  if ((sides & dmi::kRight) != 0) out.push_back("right");
  return out;
}

void add_dial_item(OrderedJson& out, const Item& item) {
  switch (item.kind) {
    case Kind::arc:
      out["from_deg"] = rounded(item.from_deg);
      out["to_deg"] = rounded(item.to_deg);
      out["r_in"] = rounded(item.r_in);
      out["r_out"] = rounded(item.r_out);
      break;
    case Kind::pointer:
      out["deg"] = rounded(item.from_deg);
      break;
    case Kind::dial_line:
      out["speed"] = item.number;
      out["deg"] = rounded(item.from_deg);
      out["length"] = rounded(item.r_out - item.r_in);
      out["r_out"] = rounded(item.r_out);
      out["width"] = item.w;
      break;
    case Kind::dial_number:
      out["value"] = utf8(item.text.view());
      out["near_deg"] = rounded(item.from_deg);
      out["radius"] = rounded(item.r_in);
      if (item.w != 0) out["aside"] = item.w;
      out["height"] = item.height;
      break;
    case Kind::hook:
      out["edge_deg"] = rounded(item.from_deg);
      out["extends"] = "towards zero";
      out["tangential"] = item.w;
      out["radial"] = rounded(item.r_out - item.r_in);
      out["r_in"] = rounded(item.r_in);
      out["r_out"] = rounded(item.r_out);
      break;
    case Kind::disc:
      out["radius_on"] = rounded(item.r_in);
      out["deg"] = rounded(item.from_deg);
      out["diameter"] = item.w;
      break;
    default:
      break;
  }
}

/// The picture or words of a button or key.
void add_label(OrderedJson& out, const Item& item) {
  if (item.picture) {
    out["symbol"] = name(*item.picture);
  } else {
    out["label"] = utf8(item.text.view());
    out["label_height"] = item.height;
  }
  add_colour(out, "label_colour", item.colour);
  add_colour(out, "bg", item.background);
}

void add_button(OrderedJson& out, const Item& item) {
  out["id"] = utf8(item.name.view());
  add_name(out, item);
  out["type"] = name_of(item.type);
  out["enabled"] = item.enabled;
  out["pressed"] = item.pressed;
  add_label(out, item);
  out["border"] = name_of(item.pressed ? dmi::Border::none : item.border);
  add_place(out, dmi::absolute(item));
}

void add_key(OrderedJson& out, const Item& item) {
  out["n"] = item.number;
  out["enabled"] = item.enabled;
  out["pressed"] = item.pressed;
  add_label(out, item);
  out["height"] = item.height;
  out["bold"] = item.bold;
  add_place(out, dmi::absolute(item));
}

void add_field(OrderedJson& out, const Item& item) {
  out["n"] = item.number;
  out["label"] = utf8(item.name.view());
  out["value"] = utf8(item.text.view());
  out["state"] = name_of(item.state);
  add_colour(out, "bg", item.background);
  add_colour(out, "value_colour", item.colour);
  add_place(out, dmi::absolute(item));
}

void add_labelled(OrderedJson& out, const Item& item) {
  out["n"] = item.number;
  out["label"] = utf8(item.name.view());
  out["value"] = utf8(item.text.view());
  add_colour(out, "colour", item.colour);
  out["label_right"] = item.label_right;
  out["data_left"] = item.data_left;
  out["baseline_y"] = item.baseline;
}

void add_rectangle(OrderedJson& out, const Item& item) {
  out["x"] = item.at.x;
  out["y"] = item.at.y;
  out["w"] = item.at.w;
  out["h"] = item.at.h;
  if (item.name.view() == "background") {
    out["role"] = "background";
  } else {
    add_name(out, item);
  }
  if (!item.name.empty()) add_colour(out, "bg", item.colour);
  if (!item.text.empty()) {
    out["value"] = utf8(item.text.view());
    out["align"] = name_of(item.align);
  }
  add_place(out, dmi::absolute(item));
}

void add_bar_item(OrderedJson& out, const Item& item) {
  out["x"] = item.at.x;
  out["w"] = item.at.w;
  out["top_row"] = item.at.y;
  out["bottom_row"] = item.at.y + item.at.h - 1;
}

void add_symbol(OrderedJson& out, const Item& item) {
  const Rect abs = dmi::absolute(item);
  if (!item.picture) return;
  out["id"] = name(*item.picture);
  out["x"] = abs.x;  // absolute, as y
  out["y"] = abs.y;
  out["w"] = abs.w;
  out["h"] = abs.h;
  add_place(out, abs);
  add_bar(out, item, abs);
}

void add_text_symbol(OrderedJson& out, const Item& item) {
  if (item.picture) out["like"] = name(*item.picture);
  out["value"] = utf8(item.text.view());
  out["max_w"] = item.at.w;
  out["max_h"] = item.at.h;
  add_place(out, dmi::absolute(item));
}

void add_step(OrderedJson& out, const Item& item) {
  out["from_m"] = item.from_m;
  out["to_m"] = item.to_m;
  out["width"] = item.at.w;
  out["quarters"] = item.number;
  add_place(out, dmi::absolute(item));
}

void add_digits(OrderedJson& out, const Item& item) {
  OrderedJson columns = OrderedJson::array();
  for (const char c : item.text.view()) columns.push_back(c == ' ' ? std::string() : std::string(1, c));
  out["columns"] = std::move(columns);
  out["height"] = item.height;
}

OrderedJson pointer_shape(const Item& pointer) {
  constexpr dmi::PointerShape p = dmi::kPointer;
  return {{"kind", "pointer_shape"},  {"hub_radius", p.hub_radius},      {"tip_radius", p.tip_radius},
          {"tip_width", p.tip_width}, {"base_width", p.base_width},      {"taper_from", p.taper_from},
          {"taper_to", p.taper_to},   {"deg", rounded(pointer.from_deg)}};
}

OrderedJson rectangle(const std::string& name, const Rect& abs) {
  return {{"kind", "rect"}, {"name", name}, {"abs", list_of(abs)}};
}

/// The symbol of a button or key, in its middle.
void append_symbol(OrderedJson& items, const Item& item) {
  const PictureRow& row = kPictureRows[terms::index(*item.picture)];
  Item symbol = item;
  symbol.kind = Kind::symbol;
  symbol.colour = dmi::Colour::none;
  symbol.at.x = static_cast<std::int16_t>(item.at.x + (item.at.w - row.width) / 2);
  symbol.at.y = static_cast<std::int16_t>(item.at.y + (item.at.h - row.height) / 2);
  symbol.at.w = row.width;
  symbol.at.h = row.height;
  items.push_back(json_of(symbol));
}

/// The surface of a button that has one, and the text on it.
void append_filled(OrderedJson& items, const Item& item) {
  OrderedJson surface{
      {"kind", "rect"}, {"area", dmi::name(item.area)},        {"x", item.at.x}, {"y", item.at.y}, {"w", item.at.w},
      {"h", item.at.h}, {"colour", dmi::name(item.background)}};
  items.push_back(std::move(surface));
  if (item.picture) return;
  items.push_back({{"kind", "text"},
                   {"area", dmi::name(item.area)},
                   {"value", utf8(item.text.view())},
                   {"align", name_of(item.align)},
                   {"height", item.height},
                   {"colour", dmi::name(item.colour)}});
}

/// The answer of "entry complete?" is the button "Yes" and the rectangle "yes".
std::string in_small_letters(const std::string& name) { return name == "Yes" ? "yes" : name; }

/// The rectangles of an item that has others inside, or touches.
void append_parts(OrderedJson& items, const Item& item) {
  const Rect abs = dmi::absolute(item);
  const std::string number = std::to_string(item.number);
  if (item.kind == Kind::pointer) items.push_back(pointer_shape(item));
  if (item.kind == Kind::button) {
    const std::string name = utf8(item.name.view());
    OrderedJson part = rectangle(item.number > 0 ? "button " + number + " " + name : in_small_letters(name), abs);
    add_label(part, item);
    items.push_back(std::move(part));
    if (item.background != dmi::Colour::none) append_filled(items, item);
    if (item.picture) append_symbol(items, item);
  }
  if (item.kind == Kind::key) {
    items.push_back(rectangle(item.name.empty() ? "key " + number : utf8(item.name.view()), abs));
    if (item.picture) append_symbol(items, item);
  }
  if (item.kind == Kind::field) {
    const Rect data = item.data_at.w > 0 ? dmi::absolute(item.area, item.data_at) : abs;
    const bool labelled = data.x > abs.x;
    if (labelled)
      items.push_back(rectangle("label " + number, {abs.x, abs.y, static_cast<std::int16_t>(data.x - abs.x), abs.h}));
    OrderedJson part = rectangle(labelled ? "data " + number : "input", data);
    part["value"] = utf8(item.text.view());
    add_colour(part, "bg", item.background);
    items.push_back(std::move(part));
  }
}

OrderedJson button_of(const dmi::Touch& touch) {
  return {{"kind", "button"},         {"id", utf8(touch.name.view())}, {"type", name_of(touch.type)},
          {"enabled", touch.enabled}, {"touch", list_of(touch.abs)},   {"action", utf8(touch.action.view())}};
}

}  // namespace

OrderedJson json_of(const Item& item) {
  OrderedJson out{{"kind", dmi::name(item.kind)}, {"area", dmi::name(item.area)}};
  switch (item.kind) {
    case Kind::digits:
      add_digits(out, item);
      break;
    case Kind::text:
      add_text(out, item);
      return out;
    case Kind::text_symbol:
      add_text_symbol(out, item);
      break;
    case Kind::symbol:
      add_symbol(out, item);
      break;
    case Kind::rect:
      add_rectangle(out, item);
      break;
    case Kind::bar:
      add_bar_item(out, item);
      break;
    case Kind::frame:
      out["rect"] = list_of(dmi::absolute(item));
      out["width"] = item.w;
      out["flashing"] = true;
      break;
    case Kind::border:
      out["style"] = name_of(item.border);
      add_place(out, dmi::absolute(item));
      break;
    case Kind::button:
      add_button(out, item);
      return out;
    case Kind::field:
      add_field(out, item);
      return out;
    case Kind::key:
      add_key(out, item);
      return out;
    case Kind::echo:
    case Kind::view_item:
      add_labelled(out, item);
      return out;
    case Kind::pasp_step:
      add_step(out, item);
      break;
    case Kind::edge:
      out["sides"] = sides_of(item.sides);
      out["width"] = 1;
      add_place(out, dmi::absolute(item));
      break;
    case Kind::cursor:
      add_place(out, dmi::absolute(item));
      break;
    default:
      add_dial_item(out, item);
      break;
  }
  add_colour(out, "colour", item.colour);
  return out;
}

OrderedJson json_of(const dmi::SoundOrder& order) {
  OrderedJson out{{"id", dmi::name(order.sound)}};
  if (order.what == dmi::SoundDo::once)
    out["times"] = 1;
  else
    out["do"] = order.what == dmi::SoundDo::loop ? "loop" : "stop";
  return out;
}

OrderedJson items_of(const dmi::Screen& screen) {
  OrderedJson items = OrderedJson::array();
  std::vector<bool> shown(screen.touch.size(), false);
  for (const Item& item : screen.items) {
    OrderedJson out = json_of(item);
    if (item.kind == Kind::button) {
      out["window"] = utf8(screen.window.view());
      const Rect abs = dmi::absolute(item);
      for (std::size_t i = 0; i < screen.touch.size(); ++i) {
        const dmi::Touch& touch = screen.touch[i];
        const bool same = touch.name == item.name || touch.abs == abs;
        if (!same || shown[i]) continue;
        shown[i] = true;
        out["touch"] = list_of(touch.abs);
        out["action"] = utf8(touch.action.view());
        out["type"] = name_of(touch.type);
        break;
      }
    }
    const OrderedJson touched = out.contains("touch") ? out["touch"] : OrderedJson();
    const OrderedJson drawn = out.contains("abs") ? out["abs"] : OrderedJson();
    items.push_back(std::move(out));
    append_parts(items, item);
    if (item.kind == Kind::button && touched.is_array() && touched != drawn)
      items.push_back(
          {{"kind", "rect"}, {"name", in_small_letters(utf8(item.name.view())) + " touch"}, {"abs", touched}});
  }
  for (std::size_t i = 0; i < screen.touch.size(); ++i)
    if (!shown[i]) items.push_back(button_of(screen.touch[i]));
  return items;
}

OrderedJson touch_of(const dmi::Screen& screen) {
  OrderedJson out = OrderedJson::array();
  for (const dmi::Touch& touch : screen.touch)
    out.push_back({{"name", utf8(touch.name.view())},
                   {"abs", list_of(touch.abs)},
                   {"action", utf8(touch.action.view())},
                   {"enabled", touch.enabled},
                   {"type", name_of(touch.type)}});
  return out;
}

std::string screen_json(const dmi::Screen& screen) {
  const auto lines_of = [](const OrderedJson& list) {
    std::string text = "[";
    for (std::size_t i = 0; i < list.size(); ++i) text += (i == 0 ? "\n    " : ",\n    ") + list[i].dump();
    return text + (list.empty() ? "]" : "\n  ]");
  };
  OrderedJson flashing = OrderedJson::array();
  for (const dmi::Area area : screen.flashing) flashing.push_back(dmi::name(area));
  OrderedJson sounds = OrderedJson::array();
  for (const dmi::SoundOrder& order : screen.sounds)
    if (order.what != dmi::SoundDo::stop) sounds.push_back(dmi::name(order.sound));
  const OrderedJson head{{"schema", "evc-screen/1"},
                         {"t_ms", static_cast<std::int64_t>(rounded(screen.t_ms))},
                         {"window", utf8(screen.window.view())}};
  std::string text = "{\n  ";
  const std::string members = head.dump();
  text += members.substr(1, members.size() - 2) + ",\n  \"items\": " + lines_of(items_of(screen)) +
          ",\n  \"flashing\": " + flashing.dump() + ",\n  \"touch\": " + lines_of(touch_of(screen)) +
          ",\n  \"sounds\": " + sounds.dump() + "\n}\n";
  return text;
}

}  // namespace evc::screen
