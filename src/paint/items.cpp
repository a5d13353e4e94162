#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "paint/drawing.h"
#include "paint/font.h"
#include "paint/symbols.h"

// The shapes of each kind of item of the display list. Clauses are those of ERA_ERTMS_015560 4.0.0.
namespace evc::paint {
namespace {

using dmi::Colour;
using dmi::Item;
using dmi::Kind;
using dmi::Rect;
using Shapes = std::vector<Shape>;

constexpr double kDefaultHeight = 12.0;  // 015560 5.1.2
constexpr double kMargin = 3.0;          // between a text and the border beside it, the indent of 5.1.2
constexpr Point kDial{dmi::kDialX, dmi::kDialY};

void fill(Shapes& shapes, double x, double y, double w, double h, Colour colour) {
  if (colour == Colour::none || w <= 0.0 || h <= 0.0) return;
  Shape shape{{}, colour, 0.0};
  shape.path.rectangle(x, y, w, h);
  shapes.push_back(std::move(shape));
}
void fill(Shapes& shapes, const Rect& r, Colour colour) { fill(shapes, r.x, r.y, r.w, r.h, colour); }

double height_of(const Item& item) { return item.height != 0 ? item.height : kDefaultHeight; }

void write(Shapes& shapes, std::string_view text, Point left, double height, Colour colour, bool bold) {
  if (text.empty()) return;
  Shape shape{{}, colour, 0.0};
  add_text(shape.path, text, left, height, bold);
  if (!shape.path.steps().empty()) shapes.push_back(std::move(shape));
}

/// The style of a text in its rectangle, in which it is vertically centred.
struct Style {
  double height = kDefaultHeight;
  Colour colour = Colour::grey;
  bool bold = false;
  dmi::Align align = dmi::Align::left;
  double indent = 0.0;
};
void write_in(Shapes& shapes, const Rect& box, std::string_view text, Style style) {
  double width = width_of(text, style.height, style.bold);
  // The time fills G13: a text in the middle that is wider than its box is less high, so that it stays inside.
  const double room = box.w - 2.0 * std::min(kMargin, 0.05 * box.w);  // the number in D5 has less
  if (style.align == dmi::Align::centre && width > room && room > 0.0) {
    style.height *= room / width;
    width = room;
  }
  double left = box.x + style.indent;
  if (style.align == dmi::Align::right) left = box.x + box.w - style.indent - width;
  if (style.align == dmi::Align::centre) left = box.x + (box.w - width) / 2.0;
  write(shapes, text, {left, box.y + (box.h + style.height) / 2.0}, style.height, style.colour, style.bold);
}

/// The lines of a text: where it has line ends, and between words or at a hyphen or plus where it is wider than
/// `width`.
std::vector<std::string_view> lines_of(std::string_view text, double width, double height, bool bold) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size());
    std::size_t next = std::min(end + 1, text.size());
    while (width_of(text.substr(0, end), height, bold) > width) {
      // A hyphen stays on its line: "Over-ride". So does a plus: "FRMCS+GSM-R".
      const std::size_t place = text.substr(0, end - 1).find_last_of(" -+");
      if (place == std::string_view::npos || place == 0) break;
      next = place + 1;
      end = text[place] == ' ' ? place : next;
    }
    lines.push_back(text.substr(0, end));
    text.remove_prefix(next);
  }
  return lines;
}

/// Lines one below the other, two heights apart (015560 5.1.2), as a whole vertically centred; closer where they do not
/// fit. The indent is that of one side: eight digits fit into the data part of a field (10.3.2.6).
void write_lines_in(Shapes& shapes, const Rect& box, std::string_view text, const Style& style) {
  // A text in the middle keeps its distance from the two lines of a button's border.
  const double others = style.align == dmi::Align::centre ? kMargin + 2.0 : kMargin;
  const auto lines = lines_of(text, box.w - std::max(style.indent, others) - others, style.height, style.bold);
  if (lines.empty()) return;
  const auto count = static_cast<double>(lines.size());
  const double spacing = std::min(2.0 * style.height, box.h / count);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double middle = (static_cast<double>(i) - (count - 1.0) / 2.0) * spacing;
    const double width = width_of(lines[i], style.height, style.bold);
    double left = box.x + style.indent;
    if (style.align == dmi::Align::right) left = box.x + box.w - style.indent - width;
    if (style.align == dmi::Align::centre) left = box.x + (box.w - width) / 2.0;
    write(shapes, lines[i], {left, box.y + box.h / 2.0 + middle + style.height / 2.0}, style.height, style.colour,
          style.bold);
  }
}

/// One line on each side of a rectangle, `inset` cells inside (015560 5.1.1).
void line_round(Shapes& shapes, const Rect& r, int inset, Colour left_and_top, Colour right_and_bottom) {
  const double x = r.x + inset, y = r.y + inset, w = r.w - 2 * inset, h = r.h - 2 * inset;
  if (w <= 0 || h <= 0) return;
  fill(shapes, x, y + h - 1, w, 1, right_and_bottom);
  fill(shapes, x + w - 1, y, 1, h, right_and_bottom);
  fill(shapes, x, y, w, 1, left_and_top);
  fill(shapes, x, y, 1, h, left_and_top);
}

void border(Shapes& shapes, const Rect& r, dmi::Border style) {
  switch (style) {
    case dmi::Border::none:
      return;
    case dmi::Border::area:
      return line_round(shapes, r, 0, Colour::black, Colour::shadow);
    case dmi::Border::button:
      line_round(shapes, r, 0, Colour::black, Colour::shadow);
      return line_round(shapes, r, 1, Colour::shadow, Colour::black);
    case dmi::Border::field:
      return line_round(shapes, r, 0, Colour::medium_grey, Colour::medium_grey);
  }
}

void add_symbol(Shapes& shapes, Picture picture, const Rect& box) {
  if (picture >= Picture::count) return;
  const PictureRow& size = kPictureRows[terms::index(picture)];
  const Point at{box.x + (box.w - size.width) / 2.0, box.y + (box.h - size.height) / 2.0};
  for (Shape& shape : shapes_of(picture, at)) shapes.push_back(std::move(shape));
}

void arc(Shapes& shapes, const Item& item) {
  Shape shape{{}, item.colour, 0.0};
  shape.path.arc(kDial, item.r_out, item.from_deg, item.to_deg, Path::Kind::move);
  shape.path.arc(kDial, item.r_in, item.to_deg, item.from_deg);
  shape.path.close();
  shapes.push_back(std::move(shape));
}

/// A place at a radius of the dial, `across` cells clockwise of the line at the angle.
Point beside(double deg, double radius, double across) {
  const Point on = on_circle(kDial, radius, deg);
  const Point along = on_circle({}, across, deg + 90.0);
  return {on.x + along.x, on.y + along.y};
}

void polygon(Shapes& shapes, std::initializer_list<Point> corners, Colour colour) {
  Shape shape{{}, colour, 0.0};
  for (const Point& corner : corners)
    shape.path.steps().empty() ? shape.path.move_to(corner) : shape.path.line_to(corner);
  shape.path.close();
  shapes.push_back(std::move(shape));
}

void pointer(Shapes& shapes, const Item& item) {
  constexpr dmi::PointerShape p = dmi::kPointer;
  const double deg = item.from_deg, wide = p.base_width / 2.0, narrow = p.tip_width / 2.0;
  polygon(shapes,
          {beside(deg, 0, -wide), beside(deg, p.taper_from, -wide), beside(deg, p.taper_to, -narrow),
           beside(deg, p.tip_radius, -narrow), beside(deg, p.tip_radius, narrow), beside(deg, p.taper_to, narrow),
           beside(deg, p.taper_from, wide), beside(deg, 0, wide)},
          item.colour);
  Shape hub{{}, item.colour, 0.0};
  hub.path.circle(kDial, p.hub_radius);
  shapes.push_back(std::move(hub));
}

/// Each digit on the right of its third of B1 (015560 8.2.1.3).
void digits(Shapes& shapes, const Item& item) {
  const Rect b1 = dmi::rect_of(dmi::Area::B1);
  const double height = height_of(item);
  const std::string_view text = item.text.view();
  for (std::size_t i = 0; i < std::min<std::size_t>(text.size(), 3); ++i) {
    const std::string_view digit = text.substr(i, 1);
    const double right = b1.x + b1.w * (static_cast<double>(i) + 1.0) / 3.0;
    write(shapes, digit, {right - width_of(digit, height, item.bold), b1.y + (b1.h + height) / 2.0}, height,
          item.colour, item.bold);
  }
}

void dial_line(Shapes& shapes, const Item& item) {
  Shape shape{{}, item.colour, static_cast<double>(std::max<std::int16_t>(item.w, 1))};
  shape.path.move_to(on_circle(kDial, item.r_in, item.from_deg));
  shape.path.line_to(on_circle(kDial, item.r_out, item.from_deg));
  shapes.push_back(std::move(shape));
}

void dial_number(Shapes& shapes, const Item& item) {
  Point centre = on_circle(kDial, item.r_in, item.from_deg);
  centre.x += item.w;
  const double height = height_of(item);
  write(shapes, item.text.view(),
        {centre.x - width_of(item.text.view(), height, item.bold) / 2.0, centre.y + height / 2.0}, height, item.colour,
        item.bold);
}

void hook(Shapes& shapes, const Item& item) {
  const double deg = item.from_deg, back = -item.w;
  polygon(shapes,
          {beside(deg, item.r_in, 0), beside(deg, item.r_out, 0), beside(deg, item.r_out, back),
           beside(deg, item.r_in, back)},
          item.colour);
}

void disc(Shapes& shapes, const Item& item) {
  Shape shape{{}, item.colour, 0.0};
  shape.path.circle(on_circle(kDial, item.r_in, item.from_deg), item.w / 2.0);
  shapes.push_back(std::move(shape));
}

/// An abbreviation instead of the letters NTC of its symbol, at most 48 x 19 (015560 8.2.3.2).
void text_symbol(Shapes& shapes, const Item& item) {
  constexpr double arrow = 20.0;  // width of the arrow of LE08 and LE09
  Rect box = dmi::absolute(item);
  const bool announced = item.picture == Picture::LE08 || item.picture == Picture::LE09;
  if (announced) {
    const PictureRow& size = kPictureRows[terms::index(*item.picture)];
    const Point at{box.x + (box.w - size.width) / 2.0, box.y + (box.h - size.height) / 2.0};
    shapes.push_back(shapes_of(*item.picture, at).front());
    box.x = static_cast<std::int16_t>(at.x + arrow);
    box.w = static_cast<std::int16_t>(size.width - arrow);
  }
  const double room = std::min<double>(box.w, 48.0);
  const double width = width_of(item.text.view(), height_of(item), item.bold);
  const double height = width > room ? height_of(item) * room / width : height_of(item);
  write_in(shapes, box, item.text.view(), {height, item.colour, item.bold, dmi::Align::centre, 0.0});
}

void frame(Shapes& shapes, const Item& item) {
  const Rect r = dmi::absolute(item);
  const int lines = std::max<int>(item.w, 1);
  for (int i = 0; i < lines; ++i) line_round(shapes, r, i, item.colour, item.colour);
}

/// The sides of a button or key and in its middle a picture or words.
void button(Shapes& shapes, const Item& item) {
  const Rect r = dmi::absolute(item);
  fill(shapes, r, item.background);
  border(shapes, r, item.pressed ? dmi::Border::none : item.border);
  if (item.picture) return add_symbol(shapes, *item.picture, r);
  write_lines_in(shapes, r, item.text.view(), {height_of(item), item.colour, item.bold, dmi::Align::centre, 0.0});
}

/// A digit is larger than the letters behind it (015560 5.1.2).
void key(Shapes& shapes, const Item& item) {
  const std::string_view text = item.text.view();
  const bool digit_and_letters = text.size() > 2 && text[0] >= '0' && text[0] <= '9' && text[1] == ' ';
  if (!digit_and_letters || item.picture) return button(shapes, item);
  constexpr double letters = 10.0;
  const Rect r = dmi::absolute(item);
  fill(shapes, r, item.background);
  border(shapes, r, item.pressed ? dmi::Border::none : item.border);
  const double digit_width = width_of(text.substr(0, 2), height_of(item), item.bold);
  const double width = digit_width + width_of(text.substr(2), letters, item.bold);
  const Point left{r.x + (r.w - width) / 2.0, r.y + (r.h + height_of(item)) / 2.0};
  write(shapes, text.substr(0, 1), left, height_of(item), item.colour, item.bold);
  write(shapes, text.substr(2), {left.x + digit_width, left.y}, letters, item.colour, item.bold);
}

/// Label and data part of an input field, each with its own border (10.3.1).
void field(Shapes& shapes, const Item& item) {
  constexpr double indent = 10.0;
  const Rect whole = dmi::absolute(item);
  const Rect data = item.data_at.w > 0 ? dmi::absolute(item.area, item.data_at) : whole;
  if (data.x > whole.x) {
    const Rect label{whole.x, whole.y, static_cast<std::int16_t>(data.x - whole.x), whole.h};
    fill(shapes, label, Colour::dark_grey);
    border(shapes, label, dmi::Border::field);
    write_lines_in(shapes, label, item.name.view(), {kDefaultHeight, Colour::grey, false, dmi::Align::right, indent});
  }
  fill(shapes, data, item.background);
  border(shapes, data, dmi::Border::field);
  write_lines_in(shapes, data, item.text.view(), {height_of(item), item.colour, item.bold, dmi::Align::left, indent});
}

/// Echo texts and items of a view: the label ends and the value begins at a column.
void labelled(Shapes& shapes, const Item& item) {
  const double height = height_of(item);
  const std::string_view label = item.name.view();
  write(shapes, label, {item.label_right - width_of(label, height, false), static_cast<double>(item.baseline)}, height,
        Colour::grey, false);
  const Colour colour = item.colour == Colour::none ? Colour::grey : item.colour;
  write(shapes, item.text.view(), {static_cast<double>(item.data_left), static_cast<double>(item.baseline)}, height,
        colour, item.bold);
}

void edge(Shapes& shapes, const Item& item) {
  const Rect r = dmi::absolute(item);
  if ((item.sides & dmi::kTop) != 0) fill(shapes, r.x, r.y, r.w, 1, item.colour);
  if ((item.sides & dmi::kLeft) != 0) fill(shapes, r.x, r.y, 1, r.h, item.colour);
  if ((item.sides & dmi::kBottom) != 0) fill(shapes, r.x, r.y + r.h - 1, r.w, 1, item.colour);
  if ((item.sides & dmi::kRight) != 0) fill(shapes, r.x + r.w - 1, r.y, 1, r.h, item.colour);
}

/// The geographical position: its metres are less high than its kilometres (015560 8.4.4.9).
void geo(Shapes& shapes, const Item& item, const Rect& r) {
  constexpr double metres_height = 10.0;
  const std::string_view text = item.text.view();
  const std::size_t split = std::min(text.find(' ') + 1, text.size());
  const std::string_view km = text.substr(0, split), m = text.substr(split);
  const double km_width = width_of(km, height_of(item), item.bold);
  const double width = km_width + width_of(m, metres_height, item.bold);
  const Point left{r.x + (r.w - width) / 2.0, r.y + (r.h + height_of(item)) / 2.0};
  write(shapes, km, left, height_of(item), item.colour, item.bold);
  write(shapes, m, {left.x + km_width, left.y}, metres_height, item.colour, item.bold);
}

void text(Shapes& shapes, const Item& item) {
  const Rect r = dmi::absolute(item);
  fill(shapes, r, item.background);
  if (item.name.view() == "geo") return geo(shapes, item, r);
  if (item.name.view() == "dwell" && !item.text.empty()) {
    // The number ends at the indent, its unit follows (015560 8.5.5.4).
    const std::string_view unit = item.text.view().substr(item.text.length - 1U);
    return write_in(shapes, r, item.text.view(),
                    {height_of(item), item.colour, item.bold, item.align,
                     item.indent - width_of(unit, height_of(item), item.bold)});
  }
  write_in(shapes, r, item.text.view(),
           {height_of(item), item.colour, item.bold, item.align, static_cast<double>(item.indent)});
}

void add(Shapes& shapes, const Item& item) {
  switch (item.kind) {
    case Kind::arc:
      return arc(shapes, item);
    case Kind::pointer:
      return pointer(shapes, item);
    case Kind::digits:
      return digits(shapes, item);
    case Kind::dial_line:
      return dial_line(shapes, item);
    case Kind::dial_number:
      return dial_number(shapes, item);
    case Kind::hook:
      return hook(shapes, item);
    case Kind::disc:
      return disc(shapes, item);
    case Kind::text:
      return text(shapes, item);
    case Kind::text_symbol:
      return text_symbol(shapes, item);
    case Kind::symbol:
      if (item.picture) add_symbol(shapes, *item.picture, dmi::absolute(item));
      return;
    case Kind::rect:
    case Kind::bar:
    case Kind::pasp_step:
    case Kind::cursor:
      return fill(shapes, dmi::absolute(item), item.colour);
    case Kind::frame:
      return frame(shapes, item);
    case Kind::border:
      return border(shapes, dmi::absolute(item), item.border);
    case Kind::button:
      return button(shapes, item);
    case Kind::field:
      return field(shapes, item);
    case Kind::key:
      return key(shapes, item);
    case Kind::echo:
    case Kind::view_item:
      return labelled(shapes, item);
    case Kind::edge:
      return edge(shapes, item);
  }
}

std::string words_of(const Item& item) {
  std::string words = readable(item.name.view());
  const auto append = [&](const std::string& more) {
    if (more.empty()) return;
    if (!words.empty()) words += ' ';
    words += more;
  };
  if (item.picture && *item.picture < Picture::count) append(name(*item.picture));
  if (item.kind != Kind::button || words.empty()) append(readable(item.text.view()));
  return words;
}

}  // namespace

std::vector<Shape> shapes_of(const Item& item) {
  Shapes shapes;
  add(shapes, item);
  return shapes;
}

Shape background() {
  constexpr Rect size = dmi::rect_of(dmi::Area::screen);
  Shape shape{{}, Colour::dark_blue, 0.0};  // 015560 5.2.1.3
  shape.path.rectangle(0.0, 0.0, size.w, size.h);
  return shape;
}

Drawing draw(const dmi::Screen& screen) {
  Drawing drawing;
  drawing.reserve(screen.items.size());
  for (const Item& item : screen.items) {
    Group group;
    group.shapes = shapes_of(item);
    if (group.shapes.empty()) continue;
    group.label = words_of(item);
    drawing.push_back(std::move(group));
  }
  return drawing;
}

}  // namespace evc::paint
