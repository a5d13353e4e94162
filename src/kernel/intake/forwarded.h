#pragma once
#include "kernel/intake/evaluation.h"

namespace evc::kernel {

/// Data of packet 44, given out as they are. To a national system only data of an RBC or of a balise group, not infill
/// (3.15.6.5).
void forward_data(Evaluation& evaluation, const lang::PacketView& view, modes::Verdict verdict);

}  // namespace evc::kernel
