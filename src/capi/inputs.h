#pragma once
#include <optional>

#include "capi/guard.h"
#include "openevc/evc.h"
#include "openevc/openevc.h"

namespace evc::capi {

/// The inputs of one cycle and what they refer to. The bytes from trackside remain the caller's.
struct Cycle {
  Cycle() = default;
  Cycle(const Cycle&) = delete;
  Cycle& operator=(const Cycle&) = delete;

  kernel::Inputs inputs;
  InplaceVector<kernel::BaliseTelegram, OPENEVC_RECEIVED> telegrams;
  InplaceVector<kernel::LoopMessage, OPENEVC_RECEIVED> loops;
  InplaceVector<kernel::RadioMessage, OPENEVC_RECEIVED> radio;
  std::optional<train::TrainData> train, external_train;
};

/// Anything but OPENEVC_OK: the reason is written to `why`. Throws std::bad_alloc, and only where the inputs have a
/// text of train data.
openevc_result take_inputs(Cycle& cycle, const openevc_inputs* inputs, Why why);

}  // namespace evc::capi
