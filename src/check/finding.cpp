#include "check/finding.h"

#include <algorithm>
#include <utility>

#include "texts/texts.h"

namespace evc::check {

const char* name(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      break;
  }
  return "note";
}

void Findings::add(Severity severity, const Where& where, Clause clause, std::string text) {
  findings_.push_back({severity, where, texts::text_of(clause), std::move(text)});
}
void Findings::add(Severity severity, const Where& where, const char* document, std::string text) {
  findings_.push_back({severity, where, document, std::move(text)});
}

void Findings::sort() {
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const Finding& a, const Finding& b) { return a.where.at_m < b.where.at_m; });
}

std::size_t Findings::count(Severity severity) const {
  return static_cast<std::size_t>(
      std::count_if(findings_.begin(), findings_.end(), [&](const Finding& f) { return f.severity == severity; }));
}

std::string group_text(GroupId id) { return std::to_string(id.NID_C) + "/" + std::to_string(id.NID_BG); }

}  // namespace evc::check
