#pragma once
#include "kernel/intake/evaluation.h"

// Message 9, the request to shorten the movement authority (3.8.6).
namespace evc::kernel {

/// Decodes the authority that the message proposes, for take_shortening too. Whether SSP and gradient cover the
/// authority that the message proposes (4.8.3 [4]).
bool proposal_is_described(Evaluation& e);
/// Granted only when the authority is described and the train would not have to brake for it (3.8.6.2).
Clause take_shortening(Evaluation& e, const lang::MessageToTrainView& view);

/// Whether the train is in rear of the Indication limits of the proposed authority (3.8.6.2). Without side effects:
/// only `curves` is written.
bool can_stop_before(const State& state, Derived::Curves& curves, const TrainSignals& train, const track::Here& here,
                     const track::AuthorityContents& proposal);

}  // namespace evc::kernel
