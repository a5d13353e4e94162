#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.h"

namespace evc::sweep {

/// What a case is: a journey, a query of curves, a stream of inputs.
enum class Kind : std::uint8_t { run, curves, replay };
/// All combinations, draws, or Sobol points.
enum class Sample : std::uint8_t { grid, random, sobol };

/// An entry of `vary`: one value of the case that is replaced.
struct Entry {
  enum class How : std::uint8_t { list, uniform, normal, count };
  std::string at;  ///< JSON pointer into the case
  How how = How::list;
  std::vector<io::Json> list;  ///< of a list and of a range, at least one
  double first = 0.0;          ///< uniform: from; normal: mean
  double second = 0.0;         ///< uniform: to; normal: standard deviation
  std::uint64_t count = 0;     ///< 1 to this
  std::size_t place = 0;       ///< index in `vary`

  /// How many values a grid takes of it; 1 for one that is drawn.
  std::uint64_t choices() const;
  bool is_drawn() const { return how == How::uniform || how == How::normal; }
};

/// `evc-sweep/1`, without the files that it names.
struct Spec {
  std::string file;  ///< its name, for errors and as the place that file names are relative to
  Kind kind = Kind::run;
  Sample sample = Sample::grid;
  std::uint64_t seed = 1;  ///< of the draws
  std::uint64_t cases = 0;
  io::Json base = io::Json::object();
  std::vector<Entry> vary;
  std::vector<std::string> measure;  ///< empty: all
  std::string text;                  ///< as one line
};

/// The most cases of a sweep, the most entries of `vary`.
inline constexpr std::uint64_t kMostCases = 1'000'000'000;
inline constexpr std::size_t kMostEntries = 64;

/// Reads it. The files of `base` are not opened: see make_work.
io::Result<Spec> read_spec(std::string_view text, const std::string& file);

}  // namespace evc::sweep
