#include "explain/modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/file.h"
#include "modes/srs_4_6_2.h"
#include "modes/srs_4_6_2_v400.h"

namespace evc::explain {
namespace {

/// A cell of either table.
struct Transition {
  std::size_t to = 0, from = 0;
  int priority = 0;
  std::vector<int> numbers;
};
struct Table {
  std::string title;
  std::vector<std::string> modes;
  std::vector<Transition> cells;
};

/// The modes of a table in the order of its columns.
std::size_t column_of(const std::vector<Mode>& columns, Mode mode) {
  return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), mode) - columns.begin());
}

template <std::size_t N>
Table table_of(const std::array<modes::Cell<Mode>, N>& cells, const std::vector<Mode>& columns, const char* editions) {
  Table table;
  table.title = fmt::format("transitions between modes, SUBSET-026-4 4.6.2 of {}", editions);
  for (const Mode mode : columns) table.modes.emplace_back(name(mode));
  for (const modes::Cell<Mode>& cell : cells) {
    Transition t{column_of(columns, cell.to), column_of(columns, cell.from), cell.priority, {}};
    for (const std::uint8_t n : cell.when)
      if (n != 0) t.numbers.push_back(n);
    table.cells.push_back(std::move(t));
  }
  return table;
}

const Transition* cell_of(const Table& table, std::size_t to, std::size_t from) {
  for (const Transition& t : table.cells)
    if (t.to == to && t.from == from) return &t;
  return nullptr;
}

/// As on the page of the standard: a row for each mode entered, a column for each mode left; the numbers of a cell
/// below each other, its priority last.
std::string matrix_of(const Table& table) {
  std::string text =
      table.title + "\ninto a mode (row) from another (column): any of the conditions, then the priority\n\n   ";
  for (const std::string& mode : table.modes) text += fmt::format("{:>4}", mode);
  text += "\n";
  for (std::size_t to = 0; to < table.modes.size(); ++to) {
    std::size_t height = 1;
    for (const Transition& t : table.cells)
      if (t.to == to) height = std::max(height, t.numbers.size() + 1);
    for (std::size_t line = 0; line < height; ++line) {
      std::string row = fmt::format("{:<3}", line == 0 ? table.modes[to] : "");
      for (std::size_t from = 0; from < table.modes.size(); ++from) {
        const Transition* t = cell_of(table, to, from);
        row += t == nullptr                ? fmt::format("{:>4}", from == to && line == 0 ? "." : "")
               : line < t->numbers.size()  ? fmt::format("{:>4}", t->numbers[line])
               : line == t->numbers.size() ? fmt::format("{:>4}", fmt::format("p{}", t->priority))
                                           : "    ";
      }
      text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    text += "\n";
  }
  return text;
}

/// The conditions of the cells into the modes for which `entered` holds, each once.
template <class Entered>
std::vector<int> numbers_of(const Table& table, Entered entered) {
  std::vector<int> numbers;
  for (const Transition& t : table.cells)
    if (entered(t.to)) numbers.insert(numbers.end(), t.numbers.begin(), t.numbers.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Those of the table.
std::string conditions_of(const Table& table) {
  std::string text = "conditions, 4.6.3\n";
  for (const int n : numbers_of(table, [](std::size_t) { return true; }))
    text += fmt::format("{:>4}  {}\n", n, modes::meaning(n));
  return text;
}

// --- The graph

constexpr double kSize = 1400.0, kRadius = 590.0, kNode = 24.0;
struct Point {
  double x, y;
};
/// A label or a node: its middle and half its width and height.
struct Box {
  Point at;
  double width, height;
};
double overlap(const Box& a, const Box& b) {
  const double x = a.width + b.width - std::abs(a.at.x - b.at.x), y = a.height + b.height - std::abs(a.at.y - b.at.y);
  return x > 0.0 && y > 0.0 ? x * y : 0.0;
}
/// Numbers in font size 10, with some room around them.
Box label_box(Point at, const std::string& text) { return {at, 3.0 * static_cast<double>(text.size()) + 2.0, 6.0}; }

Point place_of(std::size_t mode, std::size_t count) {
  const double angle =
      2.0 * 3.14159265358979 * static_cast<double>(mode) / static_cast<double>(count) - 1.5707963267949;
  return {kSize / 2 + kRadius * std::cos(angle), kSize / 2 + kRadius * std::sin(angle)};
}

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return text;
}

/// Modes that are entered from nearly every other one by one condition: a note instead of arrows.
bool from_everywhere(const std::string& mode) { return mode == "NP" || mode == "SF" || mode == "IS"; }

/// A curve that bends towards the middle; the two directions of a pair apart.
struct Curve {
  Point start, bend, end;
  Point at(double s) const {
    return {(1 - s) * (1 - s) * start.x + 2 * s * (1 - s) * bend.x + s * s * end.x,
            (1 - s) * (1 - s) * start.y + 2 * s * (1 - s) * bend.y + s * s * end.y};
  }
};
Curve curve_of(const Table& table, const Transition& t) {
  const Point a = place_of(t.from, table.modes.size()), b = place_of(t.to, table.modes.size());
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const Point bend{(a.x + b.x) / 2 * 0.75 + kSize / 2 * 0.25 - dy / length * 22,
                   (a.y + b.y) / 2 * 0.75 + kSize / 2 * 0.25 + dx / length * 22};
  const auto towards = [](Point from, Point to, double d) {
    const double l = std::hypot(to.x - from.x, to.y - from.y);
    return Point{from.x + (to.x - from.x) / l * d, from.y + (to.y - from.y) / l * d};
  };
  return {towards(a, bend, kNode), bend, towards(b, bend, kNode + 5)};
}

/// A place on the curve for the numbers, as close to the mode left as the labels and modes in `taken` permit.
Point label_place(const Curve& curve, const std::string& text, const std::vector<Box>& taken) {
  Point best = curve.at(0.28);
  double least = -1.0;
  for (int step = 0; step <= 35; ++step) {
    const double s = 0.15 + 0.02 * step;
    double sum = 0.0;
    for (const Box& box : taken) sum += overlap(label_box(curve.at(s), text), box);
    if (least >= 0.0 && sum >= least) continue;
    best = curve.at(s);
    least = sum;
    if (sum <= 0.0) break;
  }
  return best;
}

int hue_of(const Table& table, const Transition& t) { return static_cast<int>(t.to * 360 / table.modes.size()); }

std::string arrow(const Table& table, const Transition& t, const Curve& c) {
  return fmt::format(
      "<g><title>{} to {}: [{}], priority {}</title><path d=\"M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}\" "
      "stroke=\"hsl({},70%,40%)\" marker-end=\"url(#arrow)\"/></g>\n",
      table.modes[t.from], table.modes[t.to], joined(t.numbers), t.priority, c.start.x, c.start.y, c.bend.x, c.bend.y,
      c.end.x, c.end.y, hue_of(table, t));
}

/// The arrows, and above them their labels, apart from each other: the longest ones are placed first.
std::string arrows_of(const Table& table) {
  std::vector<const Transition*> drawn;
  for (const Transition& t : table.cells)
    if (!from_everywhere(table.modes[t.to])) drawn.push_back(&t);
  std::stable_sort(drawn.begin(), drawn.end(), [](const Transition* a, const Transition* b) {
    return joined(a->numbers).size() > joined(b->numbers).size();
  });
  std::vector<Box> taken;
  for (std::size_t i = 0; i < table.modes.size(); ++i) taken.push_back({place_of(i, table.modes.size()), kNode, kNode});
  std::string arrows, labels;
  for (const Transition* t : drawn) {
    const Curve curve = curve_of(table, *t);
    const Point at = label_place(curve, joined(t->numbers), taken);
    taken.push_back(label_box(at, joined(t->numbers)));
    arrows += arrow(table, *t, curve);
    labels += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" fill=\"hsl({},70%,30%)\">{}</text>\n", at.x,
                          at.y + 3.5, hue_of(table, *t), joined(t->numbers));
  }
  return arrows +
         "</g>\n<g font-size=\"10\" text-anchor=\"middle\" paint-order=\"stroke\" stroke=\"white\" "
         "stroke-width=\"3\">\n" +
         labels;
}

/// Names the transitions without an arrow.
std::string not_drawn(const Table& table) {
  std::string text;
  for (std::size_t mode = 0; mode < table.modes.size(); ++mode)
    if (from_everywhere(table.modes[mode]))
      text += fmt::format("{}{} by [{}]", text.empty() ? "Not drawn: into " : ", ", table.modes[mode],
                          joined(numbers_of(table, [mode](std::size_t to) { return to == mode; })));
  return text + ".";
}

std::string graph_of(const Table& table) {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {0:g}\" font-family=\"sans-serif\">\n"
      "<title>{1}</title>\n<rect width=\"{0:g}\" height=\"{0:g}\" fill=\"white\"/>\n"
      "<defs><marker id=\"arrow\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" "
      "orient=\"auto\">"
      "<path d=\"M0 0L8 4L0 8z\" fill=\"#555\"/></marker></defs>\n"
      "<text x=\"20\" y=\"30\" font-size=\"18\">{1}</text>\n"
      "<text x=\"20\" y=\"54\" font-size=\"13\">An arrow has the colour of the mode entered; the numbers are its "
      "conditions of 4.6.3.</text>\n"
      "<text x=\"20\" y=\"{2:g}\" font-size=\"13\">{3}</text>\n"
      "<g fill=\"none\" stroke-width=\"1.2\">\n",
      kSize, table.title, kSize - 20, not_drawn(table));
  text += arrows_of(table) + "</g>\n<g font-size=\"16\" font-weight=\"bold\" text-anchor=\"middle\">\n";
  for (std::size_t i = 0; i < table.modes.size(); ++i) {
    const Point at = place_of(i, table.modes.size());
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"white\" stroke=\"hsl({},70%,40%)\" "
        "stroke-width=\"3\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        at.x, at.y, kNode, i * 360 / table.modes.size(), at.x, at.y + 6, table.modes[i]);
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace

int describe_modes(const ModesOptions& options) {
  const std::vector<Mode> of_4(modes::v400::kColumns.begin(), modes::v400::kColumns.end());
  const std::vector<Mode> of_3(modes::kColumns.begin(), modes::kColumns.end());
  const Table table = options.srs == "4.0.0" ? table_of(modes::v400::srs_4_6_2, of_4, "4.0.0")
                                             : table_of(modes::srs_4_6_2, of_3, "3.3.0 to 3.6.0");
  const auto written =
      io::write_whole(options.output, options.svg ? graph_of(table) : matrix_of(table) + conditions_of(table));
  return written ? 0 : io::complain(written.error());
}

}  // namespace evc::explain
