#pragma once
#include "kernel/intake/message.h"
#include "kernel/intake/reception.h"
#include "lang/telegram.h"

// Safe consist length from the train, and the answers of the RBC to a request for a supervised manoeuvre (4.0.0).
namespace evc::kernel {

/// The safe consist length of an external source in this cycle (3.18.3.2, 3.18.3.10, 4.4.21.1.12).
void receive_consist_length(Reception& r);

/// An authorisation for a supervised manoeuvre (message 4) before its contents are evaluated: in the other direction
/// the train turns first (4.4.21.1.7).
struct ManoeuvreAuthorisation {
  bool opposite = false;
  track::SpeedCode V_SM = 0;
  Clause refused;  ///< none of it is used
};
ManoeuvreAuthorisation judge_manoeuvre(const Reception& r, const Information& information,
                                       const lang::MessageToTrainView& view);

/// Whether an answer names the request that waits for one (4.8.4 [14]). In SM it need not: the RBC may authorise more
/// than was asked for.
bool answers_manoeuvre_request(const State& state, std::uint32_t T_TRAIN_REF);

}  // namespace evc::kernel
