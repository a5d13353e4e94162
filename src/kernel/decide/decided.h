#pragma once
#include <cstdint>

#include "base/inplace_vector.h"
#include "brakes/brakes.h"
#include "procedures/effects.h"
#include "track/services.h"

namespace evc::kernel {

/// The results of the procedures, the mode transition and the texts for the driver, the brakes and the radio in this
/// cycle.
struct Decided {
  track::Here here;             ///< the train, after start of mission set the status of its position
  procedures::Effects effects;  ///< of all procedures
  brakes::CauseSet asked;
  bool mode_changed = false;
  bool mission_ended = false;             ///< by the change of mode (5.5.2)
  bool basis_renewed = false;             ///< State::basis differs from that of the cycle before
  bool start_selected = false;            ///< an MA is requested for it (3.8.2.3 a)
  bool reversing_possible = false;        ///< shown to the driver (5.13)
  bool track_ahead_free_granted = false;  ///< message 149 is due
  track::TextDisplay texts;               ///< shown now
  bool status_acknowledged = false;       ///< the text of the unit that asks for it
  track::TextReports texts_to_report;     ///< acknowledged: messages 158 are due
};

}  // namespace evc::kernel
