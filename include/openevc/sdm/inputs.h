#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/step_function.h"
#include "openevc/base/units.h"
#include "openevc/sdm/deceleration.h"
#include "openevc/terms/release_speed.h"
#include "openevc/terms/srs_version.h"
#include "openevc/train/brake_model.h"
#include "openevc/train/train_data.h"

namespace evc::sdm {

inline constexpr std::size_t kMrspSteps = 128;
using Mrsp = StepFunction<Place, Speed, kMrspSteps>;

/// End of authority with its supervised location, or limit of authority: the closest ones, temporary
/// ones included (3.13.1.5). With `temporary` no release speed is supervised.
struct Authority {
  enum class Kind : std::uint8_t { none, EOA_SvL, LOA };
  Kind kind = Kind::none;
  Place EOA{};                       // EOA, or the LOA
  Place SvL{};                       // EOA_SvL only; absent SvL: the EOA
  std::optional<Place> LOA_besides;  // EOA_SvL only, 4.0.0: an LOA, with V_LOA, whatever lies nearer (3.13.1.5)
  Speed V_LOA{};
  bool temporary = false;
  ReleaseSpeedChoice release_speed = ReleaseSpeedChoice::none;
  Speed V_release{};  // with ReleaseSpeedChoice::value
  // For the release speed calculated on board (3.13.9.4.8.2).
  bool level_1_at_EOA = false;     // alpha
  Distance Q_LOCACC_reference{};   // of the reference balise group
  Place reference{};               // the reference balise group: d_EOA counts from it
  Distance confidence_interval{};  // d_maxsafefront - d_minsafefront when the curves are built
  Distance L_train_doubt{};        // 4.0.0, after a supervised manoeuvre authorisation
  Speed V_ura{};                   // when the curves are built
  friend constexpr bool operator==(const Authority&, const Authority&) = default;
};

/// Everything that curves and fixed locations depend on. The caller changes `revision` whenever another member changes.
struct Inputs {
  std::uint64_t revision = 0;
  SrsVersion srs = SrsVersion::v3_6_0;
  train::TrainData train;
  train::NationalValues national_values;
  train::FixedValues fixed;
  train::BrakeStatus brakes;
  /// Never empty when something is supervised: at least the maximum train speed. The caller selects
  /// the restrictions in it, by mode.
  Mrsp mrsp;
  std::array<bool, kMrspSteps> mrsp_due_to_TSR{};  // by step
  /// Where the stored track description begins: there begins the first element of the MRSP for pre-indication and
  /// perturbation locations (3.13.11.3, 3.13.11.9). Absent, or in rear of the first step: with the first step.
  std::optional<Place> track_description_from;
  /// Whether the decreases of the MRSP are targets (FS, LS, OS, SR, UN; not SH, RV).
  bool supervise_targets = true;
  Authority authority;
  std::optional<Place> SR_end;  // end of the SR distance (4.4.11)
  GradientProfile gradient;
  TrackConditions conditions;
  /// The speed up to which curves are traced exactly; absent: 100 km/h above train and MRSP.
  std::optional<Speed> V_top;
};

}  // namespace evc::sdm
