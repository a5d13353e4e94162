#pragma once
#include "io/diagnostic.h"
#include "sweep/plan.h"
#include "sweep/queue.h"

namespace evc::sweep {

/// Who computes the cases of a sweep: threads of this process, or the ranks of a cluster.
class Computers {
 public:
  Computers() = default;
  virtual ~Computers() = default;
  Computers(const Computers&) = delete;
  Computers& operator=(const Computers&) = delete;

  /// Before anything is written or computed; an error where one of them cannot compute this plan.
  virtual io::Result<bool> prepare(const Plan& plan) = 0;
  /// All that is to be done, at least one case; 0 threads: as many as is usual. See `compute` of queue.h.
  virtual void compute(const Plan& plan, Todo& todo, unsigned threads, const Take& take) = 0;
};

/// Threads of this process, one for each processor if no number is given.
class Threads final : public Computers {
 public:
  io::Result<bool> prepare(const Plan& plan) override;
  void compute(const Plan& plan, Todo& todo, unsigned threads, const Take& take) override;
};

}  // namespace evc::sweep
