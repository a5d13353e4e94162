#pragma once
#include <memory>

#include "sweep/work.h"

// The work of each kind; these throw ReadError. See make_work.
namespace evc::sweep {

std::unique_ptr<Work> make_run_work(const Spec& spec);
std::unique_ptr<Work> make_curves_work(const Spec& spec);
std::unique_ptr<Work> make_replay_work(const Spec& spec);

}  // namespace evc::sweep
