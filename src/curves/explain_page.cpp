#include "curves/explain_page.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace evc::curves {
namespace {

constexpr int kSymbol = 18, kValue = 86;

/// Further lines of a formula are below the text of the first one.
void append_lines(std::vector<std::string>& lines, const std::string& text) {
  for (std::size_t from = 0; from != std::string::npos;) {
    const std::size_t end = text.find('\n', from);
    lines.push_back((from == 0 ? "= " : "  ") + text.substr(from, end - from));
    from = end == std::string::npos ? end : end + 1;
  }
}

}  // namespace

void ExplainPage::step(const std::string& symbol, const std::string& formula, const std::string& with, double value,
                       const std::string& unit, const std::string& clause) {
  std::vector<std::string> lines;
  append_lines(lines, formula);
  if (!with.empty()) append_lines(lines, with);
  lines.front() = fmt::format("{:<{}}", symbol, kSymbol) + lines.front();
  for (std::size_t i = 1; i < lines.size(); ++i) lines[i] = std::string(kSymbol, ' ') + lines[i];
  // The value of a long formula is on a line of its own.
  if (lines.back().size() > kValue) lines.emplace_back();
  const std::string shown = unit == "m/s2" ? n5(value) : n4(value);
  lines.back() = fmt::format("{:<{}}= {:>11} {:<5} [{}]", lines.back(), kValue, shown, unit, clause);
  for (const std::string& text : lines) line(text);
}

std::string n4(double v) { return fmt::format("{:.4f}", v + 0.0); }
std::string n5(double v) { return fmt::format("{:.5f}", v + 0.0); }
std::string short_number(double v) { return fmt::format("{:.10g}", v + 0.0); }
std::string plus_n5(double v) { return (v < 0.0 ? " - " : " + ") + n5(std::abs(v)); }

std::string range_of_step(const char* symbol, double from, double upto) {
  if (upto > 1e6) return from > 0.0 ? fmt::format("{:.6g} < {}", from, symbol) : fmt::format("any {}", symbol);
  return fmt::format("{:.6g} {} {} <= {:.6g}", from, from > 0.0 ? "<" : "<=", symbol, upto);
}

}  // namespace evc::curves
