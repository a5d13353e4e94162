#include "sweep/plan.h"

#include <utility>

#include "run/sha256.h"

namespace evc::sweep {

io::Result<std::unique_ptr<const Plan>> Plan::make(std::string_view text, const std::string& file) {
  auto spec = read_spec(text, file);
  if (!spec) return tl::unexpected(spec.error());
  auto plan = std::make_unique<Plan>(*std::move(spec));
  auto work = make_work(plan->spec_);
  if (!work) return tl::unexpected(work.error());
  plan->work_ = *std::move(work);
  plan->identity_ = run::sha256(plan->spec_.text + '\n' + plan->work_->documents());
  return plan;
}

Row Plan::compute(std::uint64_t number, Scratch& scratch) const {
  Row row;
  row.number = number;
  const std::vector<io::Json> values = cases_.values(number);
  row.values.reserve(values.size());
  for (const io::Json& value : values) row.values.push_back(value_of(value));
  row.outcome = work_->compute(values, scratch);
  return row;
}

io::Result<bool> Plan::record(std::uint64_t number, const std::string& folder) const {
  return work_->record(cases_.values(number), folder);
}

}  // namespace evc::sweep
