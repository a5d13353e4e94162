#pragma once
#include <string>

#include "base/units.h"

namespace evc::curves {

/// A page of steps, as written to check a number by hand: symbol = formula = formula with its values = value, unit and
/// paragraph.
class ExplainPage {
 public:
  void heading(const std::string& text) { out_ += "\n" + std::to_string(++heading_) + "  " + text + "\n"; }
  void line(const std::string& text) { out_ += "   " + text + "\n"; }
  /// `with`: the formula with values; empty where the value is given. Line breaks in both continue on the next line.
  void step(const std::string& symbol, const std::string& formula, const std::string& with, double value,
            const std::string& unit, const std::string& clause);
  std::string text() && { return std::move(out_); }

 private:
  std::string out_;
  int heading_ = 0;
};

/// Four decimals: places, speeds, times, factors.
std::string n4(double v);
/// Five decimals: decelerations in m/s2.
std::string n5(double v);
/// The shortest form: for given values.
std::string short_number(double v);
/// " + 0.04809" or " - 0.04809".
std::string plus_n5(double v);
/// The range of a step above `from` up to and including `upto`, in km/h or m: "100 < V <= 120".
std::string range_of_step(const char* symbol, double from, double upto);

}  // namespace evc::curves
