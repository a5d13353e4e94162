#include "curves/command.h"

#include <fmt/format.h>

#include <algorithm>

#include "curves/compare.h"
#include "curves/explain.h"
#include "curves/overrides.h"
#include "curves/plot.h"
#include "curves/result.h"
#include "curves/workbook.h"
#include "io/data_files.h"
#include "io/file.h"

namespace evc::curves {
namespace {

using io::complain;

constexpr const char* kShippedInput = "curves/passenger_eoa.json";
constexpr const char* kShippedWorkbook = "curves/workbook.json";

Format format_of(const std::string& name) {
  return name == "csv" ? Format::csv : name == "table" ? Format::table : Format::json;
}

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The query in a file, with members of it replaced.
io::Result<Approached> load(const std::string& file, const std::vector<std::string>& replaced) {
  const auto text = io::read_text(file);
  if (!text) return tl::unexpected(text.error());
  std::vector<Override> overrides;
  for (const std::string& one : replaced) {
    auto read = read_override(one);
    if (!read) return tl::unexpected(read.error());
    overrides.push_back(*std::move(read));
  }
  const auto document = overridden(*text, file, overrides);
  if (!document) return tl::unexpected(document.error());
  auto input = io::curves_of(*document, file);
  if (!input) return tl::unexpected(input.error());
  return Approached(std::move(*input));
}

/// Checks whether outputs would overwrite an input or each other; 0 when not.
int check_outputs(std::initializer_list<std::string> inputs, const std::string& output, const std::string& plot) {
  for (const std::string& input : inputs)
    for (const std::string& file : {output, plot})
      if (const auto apart = io::not_the_input(input, file); !apart) return complain(apart.error());
  if (!plot.empty() && output != "-" && io::same_file(output, plot))
    return complain({"--plot", "", plot, "another file than that of -o"});
  return 0;
}

/// Writes the result; with only a plot, standard output stays empty.
int deliver(const std::string& output, const std::string& text, const std::string& plot_file, const std::string& plot) {
  if (!plot_file.empty())
    if (const auto written = io::write_whole(plot_file, plot); !written) return complain(written.error());
  if (plot_file.empty() || output != "-")
    if (const auto written = io::write_whole(output, text); !written) return complain(written.error());
  return 0;
}

int wrong_plot(const std::string& file, const char* expected) {
  return complain({"--plot", "", file, std::string("a file name that ends in ") + expected});
}

}  // namespace

int show(const Options& o) {
  const bool workbook = o.model == "workbook";
  if (workbook && o.explain_kmh >= 0.0) return complain({"--explain", "", "--model workbook", "--model srs"});
  if (const int wrong = check_outputs({o.input}, o.output, o.plot); wrong != 0) return wrong;
  const auto approached =
      load(!o.input.empty() ? o.input : io::data_file(workbook ? kShippedWorkbook : kShippedInput), o.replaced);
  if (!approached) return complain(approached.error());
  const bool svg = ends_with(o.plot, ".svg");
  if (!o.plot.empty() && !svg && (workbook || !ends_with(o.plot, ".html")))
    return wrong_plot(o.plot, workbook ? ".svg" : ".svg or .html");
  if (workbook) {
    const Workbook sheet = workbook_of(*approached);
    return deliver(o.output, workbook_text(sheet, format_of(o.format)), o.plot,
                   o.plot.empty() ? "" : workbook_svg(sheet, *approached));
  }
  std::string plot;
  if (!o.plot.empty()) plot = svg ? curves_svg(*approached) : curves_html(*approached);
  if (o.explain_kmh >= 0.0) {
    // The page of --explain is requested separately: a plot does not replace it.
    if (!plot.empty())
      if (const auto written = io::write_whole(o.plot, plot); !written) return complain(written.error());
    return deliver(o.output, explain_text(*approached, o.explain_kmh), "", "");
  }
  return deliver(o.output, curves_text(curves_result(*approached), format_of(o.format)), o.plot, plot);
}

int compare(const CompareOptions& o) {
  if (const int wrong = check_outputs({o.a, o.b}, o.output, o.plot); wrong != 0) return wrong;
  const auto a = load(o.a, o.replaced);
  if (!a) return complain(a.error());
  const auto b = load(o.b, o.replaced);
  if (!b) return complain(b.error());
  const bool svg = ends_with(o.plot, ".svg");
  if (!o.plot.empty() && !svg && !ends_with(o.plot, ".html")) return wrong_plot(o.plot, ".svg or .html");
  const Comparison comparison = compare_curves(*a, *b);
  std::string plot;
  if (!o.plot.empty())
    plot = svg ? comparison_svg(compare_curves(*a, *b, drawn_speeds(comparison))) : comparison_html(*a, *b);
  // CSV has no field for warnings, and a plot alone prints nothing.
  if (o.format == "csv" || (!o.plot.empty() && o.output == "-"))
    for (const std::string& warning : comparison.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return deliver(o.output, comparison_text(comparison, format_of(o.format)), o.plot, plot);
}

}  // namespace evc::curves
