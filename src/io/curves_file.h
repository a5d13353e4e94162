#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/train_file.h"
#include "io/workbook_inputs.h"
#include "openevc/curves.h"

namespace evc::io {

/// A permitted braking distance as packet 52 gives it (3.11.11).
struct PbdQuery {
  Distance D_PBD{};
  double G_PBDSR = 0.0;  // per mille, downhill negative
  bool service_brake = false;
};
/// A level crossing that is not protected, without a stop in rear of it (3.13.9.3.5.11, 5.16.3).
struct LxQuery {
  Place D_LX{};
  Speed V_LX{};
};

/// What is asked about one target: an `evc-curves/1` document.
struct CurvesInput {
  std::string name;        // of the case: the key `name`, else the file's name
  std::string train_name;  // of the train
  sdm::Inputs inputs;
  sdm::TargetKind target = sdm::TargetKind::EOA_SvL;
  Place target_location{};  // distances count from here: EOA, LOA or start of the restriction
  Acceleration A_est{};
  Speed V_ura{};
  /// The train's place, where `state` gives one (4.0.0's reduced build-up times depend on it).
  std::optional<sdm::Motion> motion;
  std::vector<double> speeds_kmh;
  std::vector<double> positions_m;
  std::vector<PbdQuery> PBD;
  std::vector<LxQuery> LX;
  /// Constants of the workbook model, where the document gives them (`--model workbook`).
  std::optional<WorkbookInputs> workbook;
};

/// Reads `evc-curves/1`. Absent keys take the defaults of A.3.1, A.3.2 and the standard train; unknown
/// keys are errors; train data and national values out of range are refused with the clause. `train`
/// and `national_values` may be names of files, relative to `file`.
Result<CurvesInput> read_curves(std::string_view text, const std::string& file);

/// The target that the document asks about, among those that follow from it; null when nothing is supervised.
const sdm::Target* target_of(const CurvesInput& input, const sdm::Derived& derived);

}  // namespace evc::io
