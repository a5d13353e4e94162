#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sweep/cases.h"
#include "sweep/spec.h"
#include "sweep/work.h"

namespace evc::sweep {

/// A row of the table: a case with its values and what it gave.
struct Row {
  std::uint64_t number = 0;
  std::vector<Value> values;  ///< one for each entry of `vary`
  Outcome outcome;
};

/// A spec with its files read: everything that whoever computes cases needs. A row depends on the plan and the number
/// alone: threads, processes and computers that have the same plan compute the same rows.
class Plan {
 public:
  /// From the text of a spec. Before anything is computed everything that can be wrong with it is found.
  static io::Result<std::unique_ptr<const Plan>> make(std::string_view text, const std::string& file);
  explicit Plan(Spec spec) : spec_(std::move(spec)), cases_(spec_) {}
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  const Spec& spec() const { return spec_; }
  const std::vector<std::string>& measures() const { return work_->measures(); }
  /// SHA-256 of the spec and of the contents of its files, in hexadecimal digits.
  const std::string& identity() const { return identity_; }

  std::vector<io::Json> values(std::uint64_t number) const { return cases_.values(number); }
  /// Memory for one thread.
  std::unique_ptr<Scratch> scratch() const { return work_->scratch(); }
  /// The case with this number, below spec().cases. Any thread may call it, each with a scratch of its own.
  Row compute(std::uint64_t number, Scratch& scratch) const;
  /// Computes it again, with its files in a folder that exists.
  io::Result<bool> record(std::uint64_t number, const std::string& folder) const;

 private:
  Spec spec_;
  Cases cases_;
  std::unique_ptr<const Work> work_;
  std::string identity_;
};

}  // namespace evc::sweep
