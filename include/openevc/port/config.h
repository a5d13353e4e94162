#pragma once
#include <array>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/units.h"
#include "openevc/port/display.h"
#include "openevc/port/outputs.h"
#include "openevc/terms/level.h"
#include "openevc/terms/srs_version.h"
#include "openevc/terms/track_condition.h"
#include "openevc/train/national_values.h"
#include "openevc/train/train_data.h"

namespace evc::port {

/// Who the unit is for the RBC.
struct Identity {
  std::uint32_t NID_ENGINE = 0;  // 24 bits, assigned to this unit alone (3.18.4.4)
  // Of the mobile terminals, NID_RADIO (7.5.1.95), for an RBC of version 2.0 or 1.Y (packet 3).
  InplaceVector<std::uint64_t, 4> telephone_numbers;
};

/// The configuration, given once at power-up.
struct Config {
  SrsVersion srs = SrsVersion::v3_6_0;
  train::TrainData train;
  train::NationalValues national_values;  // valid until packet 3 gives others (3.18.2)
  Distance L_engine{20};  // where no train data count: SH, SL, NL, PS, before their entry (4.4.6.1.4 and others)
  std::array<bool, kLevels> levels{true, true, true, true, true};  // what this unit is fitted for
  Identity identity;
  // Radio networks that the driver may choose, NID_MN; the first one is the default (3.5.6.3). None: the terminals have
  // their own default, and the driver has no choice.
  InplaceVector<std::uint32_t, 16> networks;
  std::optional<RbcAddress> contact;       // the last one known (3.18.4.3.1), to be revalidated; data kept replace it
  std::int16_t local_time_offset_min = 0;  // of the local time from UTC (3.18.5.1)
  Speed dial{400.0 / 3.6};                 // the highest speed on the dial of the display (015560 8.2.1.1)
  InplaceVector<NtcName, 16> ntc_names;    // of the national systems, for the display
  std::uint8_t terminals = 2;              // mobile terminals, 1 or 2: sessions at the same time (3.15.1.3.2)
  ByTrain by_train;                        // what the train does by itself at track conditions
};

}  // namespace evc::port
