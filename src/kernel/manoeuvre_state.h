#pragma once
#include <optional>

#include "procedures/supervised_manoeuvre.h"
#include "terms/consist_length.h"
#include "track/speed_restrictions.h"
#include "train/train_data.h"

namespace evc::kernel {

/// Safe consist length and supervised manoeuvre of 4.0.0 (3.18.3.2, 4.4.21).
struct Manoeuvre {
  /// As stored: in a mission it stays when its source has it no longer (3.18.3.2.5).
  std::optional<ConsistLength> consist;
  bool available = false;     ///< from its source, now
  bool captured = false;      ///< the source has given it once: it is captured from the train (3.6.5.2.5 [4])
  bool active = false;        ///< from the first authorisation to the end of the mission, or NL (3.6.1.5.1)
  bool opposite = false;      ///< the train orientation is not that of the active cab
  bool authority = false;     ///< the stored authority is of a supervised manoeuvre authorisation
  bool informs = false;       ///< from the first request on: the RBC is informed of changes (3.18.3.10)
  track::SpeedCode V_SM = 0;  ///< of the last authorisation
  train::TrainData train;     ///< the default train data (3.18.3.9), of the length of the consist
  procedures::supervised_manoeuvre::State request;
};

}  // namespace evc::kernel
