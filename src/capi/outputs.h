#pragma once
#include "openevc/evc.h"
#include "openevc/openevc.h"

namespace evc::capi {

/// All members of `to` but its size.
void give_outputs(openevc_outputs& to, const kernel::Outputs& outputs) noexcept;

/// The same of the advance display; null: there is none.
void give_planning(openevc_planning& to, const kernel::Planning* planning) noexcept;

}  // namespace evc::capi
