#include "check/command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "check/rules.h"
#include "io/file.h"
#include "io/json.h"
#include "io/line_file.h"
#include "run/load.h"

namespace evc::check {
namespace {

using io::complain;

std::string text_of(const Where& where) {
  if (where.group) return fmt::format("group {}/{}", where.group->NID_C, where.group->NID_BG);
  if (where.message) return fmt::format("message {}", *where.message);
  return "track";
}

}  // namespace

io::Result<Review> review(const std::string& text, const std::string& file, const io::Train* train) {
  const auto line = io::read_line(text, file);
  if (!line) return tl::unexpected(line.error());
  Review review{line->name, {}};
  const Trackside trackside = read(*line);
  check_groups(trackside, review.findings);
  check_messages(trackside, review.findings);
  check_journey(trackside, review.findings);
  check_track(trackside, review.findings);
  check_document(trackside, io::parse_json(text, file), review.findings);
  if (train != nullptr) check_braking(trackside, *train, review.findings);
  review.findings.sort();
  return review;
}

std::string table_of(const Review& review) {
  const Findings& findings = review.findings;
  std::string text;
  for (const Finding& f : findings.all())
    text += fmt::format("{:<8} {:>9.1f} m  {:<16} {:<20} {}\n", name(f.severity), f.where.at_m, text_of(f.where),
                        f.clause, f.text);
  const auto counted = [&](Severity severity) {
    const std::size_t n = findings.count(severity);
    return fmt::format("{} {}{}", n, name(severity), n == 1 ? "" : "s");
  };
  return text + fmt::format("{}: {}, {}, {}\n", io::printable(review.line), counted(Severity::error),
                            counted(Severity::warning), counted(Severity::note));
}

std::string json_of(const Review& review) {
  const Findings& findings = review.findings;
  nlohmann::ordered_json document = {{"schema", "evc-check/1"},
                                     {"line", review.line},
                                     {"errors", findings.count(Severity::error)},
                                     {"warnings", findings.count(Severity::warning)},
                                     {"notes", findings.count(Severity::note)},
                                     {"findings", nlohmann::ordered_json::array()}};
  for (const Finding& f : findings.all()) {
    nlohmann::ordered_json finding = {{"severity", name(f.severity)}, {"at_m", f.where.at_m}};
    if (f.where.group) finding["group"] = {{"NID_C", f.where.group->NID_C}, {"NID_BG", f.where.group->NID_BG}};
    if (f.where.message) finding["message"] = *f.where.message;
    finding["clause"] = f.clause;
    finding["text"] = f.text;
    document["findings"].push_back(std::move(finding));
  }
  return document.dump(2) + "\n";
}

int check(const Options& options) {
  const std::string file = run::line_file(options.line);
  for (const std::string& input : {file, options.train})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  const auto text = io::read_text(file);
  if (!text) return complain(text.error());
  const auto train = run::load_train(options.train);
  if (!train) return complain(train.error());
  const auto reviewed = review(*text, file, options.train.empty() ? nullptr : &*train);
  if (!reviewed) return complain(reviewed.error());
  const std::string answer = options.format == "json" ? json_of(*reviewed) : table_of(*reviewed);
  if (const auto written = io::write_whole(options.output, answer); !written) return complain(written.error());
  return reviewed->findings.count(Severity::error) == 0 ? 0 : 1;
}

}  // namespace evc::check
