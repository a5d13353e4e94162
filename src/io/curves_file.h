#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json.h"
#include "io/train_file.h"
#include "io/workbook_inputs.h"
#include "openevc/curves.h"

namespace evc::io {

/// A permitted braking distance as in packet 52 (3.11.11).
struct PbdQuery {
  Distance D_PBD{};
  double G_PBDSR = 0.0;  // per mille, downhill negative
  bool service_brake = false;
};
/// An unprotected level crossing without a required stop in rear of it (3.13.9.3.5.11, 5.16.3).
struct LxQuery {
  Place D_LX{};
  Speed V_LX{};
};

/// Tables that are computed on request (`query.details`).
struct CurvesDetails {
  bool ceilings = false, times = false, locations = false, arcs = false, targets = false, confidence_interval = false;
  friend constexpr bool operator==(const CurvesDetails&, const CurvesDetails&) = default;
};

/// The query about one target: an `evc-curves/1` document.
struct CurvesInput {
  std::string name;        // of the case: the key `name`, else the file's name
  std::string train_name;  // of the train
  sdm::Inputs inputs;
  sdm::TargetKind target = sdm::TargetKind::EOA_SvL;
  Place target_location{};  // reference of distances: EOA, LOA or start of the restriction
  Acceleration A_est{};
  Speed V_ura{};
  /// V_ura as a function of speed, and the state of the service brake feedback.
  sdm::Assumed assumed;
  /// The train's place, if `state` gives one (the reduced build-up times of 4.0.0 depend on it).
  std::optional<sdm::Motion> motion;
  std::vector<double> speeds_kmh;
  std::vector<double> positions_m;
  std::vector<PbdQuery> PBD;
  std::vector<LxQuery> LX;
  CurvesDetails details;
  /// Constants of the workbook model, if the document gives them (`--model workbook`).
  std::optional<WorkbookInputs> workbook;
};

/// Reads `evc-curves/1`. Absent keys have the defaults of A.3.1, A.3.2 and the standard train; unknown keys are errors;
/// train data and national values out of range are errors with the clause. `train` and `national_values` may be names
/// of files, relative to `file`.
Result<CurvesInput> read_curves(std::string_view text, const std::string& file);
/// The same from a document that is parsed already.
Result<CurvesInput> curves_of(const Json& document, const std::string& file);
/// The document with the files that `train` and `national_values` name read in place.
Result<Json> curves_document(std::string_view text, const std::string& file);

/// The target of the document among those computed; null when nothing is supervised.
const sdm::Target* target_of(const CurvesInput& input, const sdm::Derived& derived);

}  // namespace evc::io
