#include "matrix/command.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "io/file.h"
#include "io/number.h"
#include "matrix/drive.h"
#include "matrix/matrix.h"
#include "run/load.h"
#include "terms/level.h"
#include "terms/mode.h"

namespace evc::matrix {
namespace {

using io::complain;
using nlohmann::ordered_json;

/// A speed in km/h. A division by 3.6 of whole km/h is undone exactly.
double kmh(Speed v) {
  const double rounded = std::nearbyint(v.si * 3.6 * 1e6) / 1e6;
  return rounded / 3.6 <= v.si ? rounded : std::floor(v.si * 3.6 * 1e6) / 1e6;
}
/// For the table: rounded down, so that it shows no higher value than the rows have.
double down(double value, double steps) { return std::floor(value * steps + 1e-9) / steps; }

ordered_json optional_kmh(const std::optional<Speed>& v) { return v ? ordered_json(kmh(*v)) : ordered_json(nullptr); }

/// The cells of a row in the order of the columns; null where nothing is stored.
ordered_json cells(const Matrix& m, const Row& row) {
  ordered_json c;
  c["d_m"] = std::nearbyint((row.from - m.front).si * 1e6) / 1e6 + 0.0;
  c["LRBG"] =
      row.group ? ordered_json(fmt::format("{}/{}", row.group->NID_C, row.group->NID_BG)) : ordered_json(nullptr);
  c["SSP"] = optional_kmh(row.SSP);
  c["QF"] = row.QF ? ordered_json(*row.QF ? 1 : 0) : ordered_json(nullptr);
  c["Grd"] = row.Grd;
  c["ASP"] = optional_kmh(row.ASP);
  c["V_LOA"] = optional_kmh(row.V_LOA);
  c["TSR"] = optional_kmh(row.TSR);
  c["Adh"] = row.Adh ? 1 : 0;
  for (std::size_t k = 0; k < kSteps; ++k) c[fmt::format("Aeb{}", k)] = row.Aeb[k].si;
  c["MRSP"] = kmh(row.MRSP);
  for (std::size_t k = 0; k < kSteps; ++k) c[fmt::format("Asafe{}", k)] = row.Asafe[k].si;
  return c;
}

/// The names of the columns, also where there is no row.
ordered_json columns() { return cells(Matrix{}, Row{}); }

std::string plain(const ordered_json& cell) {
  return cell.is_null() ? std::string() : cell.is_string() ? cell.get<std::string>() : cell.dump();
}

std::string csv_of(const Matrix& m) {
  std::string text;
  const ordered_json names = columns();
  for (const auto& [name, cell] : names.items()) text += (text.empty() ? "" : ",") + name;
  text += '\n';
  for (const Row& row : m.rows) {
    std::string line;
    const ordered_json values = cells(m, row);
    for (const auto& [name, cell] : values.items()) line += (name == "d_m" ? "" : ",") + plain(cell);
    text += line + '\n';
  }
  return text;
}

std::string cell_of_table(const std::string& name, const ordered_json& cell) {
  if (cell.is_null()) return "-";
  if (name.rfind('A', 0) == 0 && name != "ASP" && name != "Adh")
    return fmt::format("{:.3f}", down(cell.get<double>(), 1e3));
  if (name == "Grd") return fmt::format("{:g}", down(cell.get<double>(), 1e2));
  if (cell.is_number_float()) return fmt::format("{:g}", down(cell.get<double>(), 10.0));
  return plain(cell);
}

struct Head {
  std::string line, train;
  double at_m;
  Mode mode;
  Level level;
  std::string lrbg;
};

/// The speed steps of Aeb and Asafe: "0 to 80, 120, 160 km/h and above".
std::string steps_of(const Matrix& m) {
  std::string text = "0";
  for (const auto& limit : m.steps)
    if (limit) text += fmt::format(", {:g}", down(kmh(*limit), 10.0));
  return text;
}

std::string table_of(const Matrix& m, const Head& head) {
  std::string text =
      fmt::format("line          {}\ntrain         {}\n", io::printable(head.line), io::printable(head.train));
  text += fmt::format("front end     {:g} m, mode {}, level {}, LRBG {}\n", head.at_m, name(head.mode),
                      name(head.level), head.lrbg.empty() ? "none" : head.lrbg);
  text += m.target ? fmt::format("target        EOA or LOA in {:.1f} m{}\n", (*m.target - m.front).si,
                                 m.cut ? ", beyond the last row" : "")
                   : std::string("target        none\n");
  text += fmt::format("quantum       {:g} m, {} rows; speed steps of Aeb and Asafe from {} km/h\n", m.quantum.si,
                      m.rows.size(), steps_of(m));
  const auto width = [](const std::string& name) { return name == "LRBG" ? 12 : name == "d_m" ? 8 : 7; };
  const ordered_json names = columns();
  for (const auto& [name, cell] : names.items()) text += fmt::format("{:>{}}", name, width(name));
  text += '\n';
  for (const Row& row : m.rows) {
    const ordered_json values = cells(m, row);
    for (const auto& [name, cell] : values.items())
      text += fmt::format("{:>{}}", cell_of_table(name, cell), width(name));
    text += '\n';
  }
  return text;
}

std::string json_of(const Matrix& m, const Head& head) {
  ordered_json document = {{"schema", "evc-track/1"}, {"line", head.line},       {"train", head.train},
                           {"at_m", head.at_m},       {"mode", name(head.mode)}, {"level", name(head.level)}};
  document["LRBG"] = head.lrbg.empty() ? ordered_json(nullptr) : ordered_json(head.lrbg);
  document["target_m"] = m.target ? ordered_json((*m.target - m.front).si) : ordered_json(nullptr);
  document["cut"] = m.cut;
  document["quantum_m"] = m.quantum.si;
  document["steps_kmh"] = ordered_json::array();
  for (const auto& limit : m.steps)
    if (limit) document["steps_kmh"].push_back(kmh(*limit));
  document["rows"] = ordered_json::array();
  for (const Row& row : m.rows) document["rows"].push_back(cells(m, row));
  return document.dump(1) + "\n";
}

std::optional<Distance> quantum_of(const std::string& given) {
  if (given == "auto") return {};
  return Distance{given == "50" ? 50.0 : given == "5" ? 5.0 : 0.5};
}

}  // namespace

int track(const Options& options) {
  const std::string file = run::line_file(options.line);
  for (const std::string& input : {file, options.train})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  const auto line = run::load_line(file);
  if (!line) return complain(line.error());
  const auto train = run::load_train(options.train);
  if (!train) return complain(train.error());
  const auto run = std::make_unique<DrivenTrain>(*line, *train);
  if (options.at_m < run->world.start_m() || options.at_m > run->world.end_m())
    return complain({"--at", "", fmt::format("{:g}", options.at_m),
                     fmt::format("a place on the line, {:g} to {:g} m", run->world.start_m(), run->world.end_m())});
  if (!run->drive_to(options.at_m)) {
    (void)complain({file, "", fmt::format("a run that ends at {:.1f} m", run->world.front_m()),
                    fmt::format("one to {:g} m", options.at_m)});
    return 1;
  }
  const Matrix m = matrix_of(run->state, run->derived, quantum_of(options.quantum));
  Head head{line->name, train->name, options.at_m, run->outputs.mode, run->outputs.level, {}};
  if (run->outputs.lrbg) head.lrbg = fmt::format("{}/{}", run->outputs.lrbg->NID_C, run->outputs.lrbg->NID_BG);
  const std::string text = options.format == "csv"    ? csv_of(m)
                           : options.format == "json" ? json_of(m, head)
                                                      : table_of(m, head);
  const auto written = io::write_whole(options.output, text);
  return written ? 0 : complain(written.error());
}

}  // namespace evc::matrix
