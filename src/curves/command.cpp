#include "curves/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "curves/compare.h"
#include "curves/explain.h"
#include "curves/overrides.h"
#include "curves/plot.h"
#include "curves/result.h"
#include "curves/workbook.h"
#include "curves/xlsx.h"
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

/// A name of the case as it is computed: a file says "150 %" of a train whose percentage was set to another one.
std::string with_replaced(const std::string& name, const std::vector<std::string>& replaced) {
  constexpr std::size_t kLongest = 60;  // of a place with its value
  std::string text = name;
  bool first = true;
  for (std::size_t i = 0; i < replaced.size(); ++i) {
    const std::string& one = replaced[i];
    const std::string place = one.substr(0, one.find('=') + 1);
    if (place == "name=" || place == "/name=") continue;  // it is in the name
    const auto later = replaced.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    if (std::any_of(later, replaced.end(), [&](const std::string& other) { return other.starts_with(place); }))
      continue;
    text += (first ? ", with " : ", ") + io::printable(one, kLongest);
    first = false;
  }
  return text;
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
  input->name = with_replaced(input->name, replaced);
  return Approached(std::move(*input));
}

/// Checks whether outputs would overwrite an input or each other; 0 when not.
int check_outputs(const std::vector<std::string>& inputs, const std::string& output, const std::string& plot) {
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

/// The kinds of picture, by the end of the file's name.
constexpr std::string_view kPictures[] = {".svg", ".png", ".pdf"};
bool is_picture(const std::string& file) {
  return std::any_of(std::begin(kPictures), std::end(kPictures), [&](auto end) { return file.ends_with(end); });
}
bool is_page(const std::string& file) { return file.ends_with(".html"); }
bool is_xlsx(const std::string& file) { return file.ends_with(".xlsx"); }

/// The drawing in the format that the name asks for.
std::string picture_for(const std::string& file, const Drawing& drawing) {
  if (file.ends_with(".png")) return png_of(drawing);
  return file.ends_with(".pdf") ? pdf_of(drawing) : svg_of(drawing);
}

Theme theme_of(const std::string& name) { return name == "print" ? Theme::print : Theme::screen; }

/// With `-o` a name of a chart, that is the chart, and nothing is written to standard output.
void take_chart_of_output(std::string& output, std::string& plot) {
  if (plot.empty() && (is_picture(output) || is_page(output))) {
    plot = output;
    output = "-";
  }
}

/// 0 when the chart's name is one of a picture or, with `page`, of a page.
int check_plot(const std::string& file, bool page) {
  if (file.empty() || is_picture(file) || (page && is_page(file))) return 0;
  return complain({"--plot", "", file,
                   std::string("a file name that ends in .svg, .png") + (page ? ", .pdf or .html" : " or .pdf")});
}

int show_workbook(const Options& o, const Approached& approached) {
  const Workbook sheet = workbook_of(approached);
  std::string plot;
  if (!o.plot.empty()) plot = picture_for(o.plot, workbook_drawing(sheet, approached, theme_of(o.theme)));
  return deliver(o.output, is_xlsx(o.output) ? xlsx_of({table_of(sheet)}) : workbook_text(sheet, format_of(o.format)),
                 o.plot, plot);
}

}  // namespace

int show(const Options& options) {
  Options o = options;
  const bool workbook = o.model == "workbook";
  if (workbook && o.explain_kmh >= 0.0) return complain({"--explain", "", "--model workbook", "--model srs"});
  if (o.explain_kmh >= 0.0 && (is_xlsx(o.output) || is_picture(o.output) || is_page(o.output)))
    return complain({"--explain", "", "-o " + o.output, "a file of text"});
  take_chart_of_output(o.output, o.plot);
  if (const int wrong = check_outputs({o.input}, o.output, o.plot); wrong != 0) return wrong;
  const auto approached =
      load(!o.input.empty() ? o.input : io::data_file(workbook ? kShippedWorkbook : kShippedInput), o.replaced);
  if (!approached) return complain(approached.error());
  if (const int wrong = check_plot(o.plot, !workbook); wrong != 0) return wrong;
  if (workbook) return show_workbook(o, *approached);
  std::string plot;
  if (!o.plot.empty())
    plot = is_page(o.plot) ? curves_html(*approached)
                           : picture_for(o.plot, curves_drawing(*approached, theme_of(o.theme)));
  if (o.explain_kmh >= 0.0) {
    // The page of --explain is requested separately: a plot does not replace it.
    if (!plot.empty())
      if (const auto written = io::write_whole(o.plot, plot); !written) return complain(written.error());
    return deliver(o.output, explain_text(*approached, o.explain_kmh), "", "");
  }
  if (!o.plot.empty() && o.output == "-") return deliver("-", "", o.plot, plot);
  const CurvesResult result = curves_result(*approached);
  return deliver(o.output, is_xlsx(o.output) ? xlsx_of(tables_of(result)) : curves_text(result, format_of(o.format)),
                 o.plot, plot);
}

int compare(const CompareOptions& options) {
  CompareOptions o = options;
  take_chart_of_output(o.output, o.plot);
  std::vector<std::string> files{o.a, o.b};
  files.insert(files.end(), o.more.begin(), o.more.end());
  if (const int wrong = check_outputs(files, o.output, o.plot); wrong != 0) return wrong;
  std::vector<Approached> inputs;
  for (const std::string& file : files) {
    auto input = load(file, o.replaced);
    if (!input) return complain(input.error());
    inputs.push_back(*std::move(input));
  }
  if (const int wrong = check_plot(o.plot, true); wrong != 0) return wrong;
  const std::vector<Comparison> all = compare_all(inputs);
  std::string plot;
  if (!o.plot.empty())
    plot = is_page(o.plot)
               ? comparison_html(inputs[0], std::span(inputs).subspan(1))
               : picture_for(o.plot, comparison_drawing(compare_all(inputs, drawn_speeds(all[0])), theme_of(o.theme)));
  // CSV has no field for warnings, and a plot alone prints nothing.
  if (o.format == "csv" || (!o.plot.empty() && o.output == "-"))
    for (const Comparison& c : all)
      for (const std::string& warning : c.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return deliver(o.output, is_xlsx(o.output) ? xlsx_of(tables_of(all)) : comparisons_text(all, format_of(o.format)),
                 o.plot, plot);
}

}  // namespace evc::curves
