#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/diagnostic.h"
#include "sweep/cases.h"
#include "sweep/spec.h"

namespace evc::sweep {

/// What a case gave: a value for each measure, or why it could not be computed.
struct Outcome {
  std::vector<Value> measures;  ///< as many as there are names, also of a case that failed
  std::string error;            ///< empty: it was computed
};

/// Memory that a thread uses again from case to case. What is in it has no effect on a result.
struct Scratch {
  Scratch() = default;
  virtual ~Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

/// The kind of a sweep with its files read: from the values of a case to its outcome. Const and without state, so that
/// any number of threads may use one.
class Work {
 public:
  Work() = default;
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// The names of the measures, in the order of the columns.
  const std::vector<std::string>& measures() const { return measures_; }
  /// The files of the sweep as they were read, for a hash: the same name may lead to another file later.
  virtual std::string documents() const = 0;
  /// Memory for one thread.
  virtual std::unique_ptr<Scratch> scratch() const { return std::make_unique<Scratch>(); }
  /// The case with these values, one for each entry of the spec. The scratch is one of this work.
  virtual Outcome compute(const std::vector<io::Json>& values, Scratch& scratch) const = 0;
  /// Computes it again and leaves its files in a folder, which exists.
  virtual io::Result<bool> record(const std::vector<io::Json>& values, const std::string& folder) const = 0;

 protected:
  std::vector<std::string> measures_;
};

/// Reads the files that the spec names and checks everything that does not depend on the case: an error names the place
/// in the spec or in the file. The work refers to the spec.
io::Result<std::unique_ptr<Work>> make_work(const Spec& spec);

}  // namespace evc::sweep
