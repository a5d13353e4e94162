#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "position/integrity.h"
#include "position/position.h"

// Position reports: packets 0 and 1 (3.6.5, 7.4.3.1-2) as raw codes, and when to send one.
namespace evc::position {

/// NID_LRBG and NID_PRVLRBG "unknown".
inline constexpr std::uint32_t kUnknownGroup = 16777215;
/// D_LRBG and L_DOUBT* "unknown".
inline constexpr std::uint16_t kUnknownLength = 32767;

/// The codes of packet 0, or of packet 1 when NID_PRVLRBG is present (3.4.2.3.3.1). M_MODE, M_LEVEL and
/// NID_NTC are the caller's.
struct Report {
  std::uint8_t Q_SCALE = 1;
  std::uint32_t NID_LRBG = kUnknownGroup;
  std::optional<std::uint32_t> NID_PRVLRBG;  // present: packet 1
  std::uint16_t D_LRBG = kUnknownLength;
  std::uint8_t Q_DIRLRBG = 2;
  std::uint8_t Q_DLRBG = 2;
  std::uint16_t L_DOUBTOVER = kUnknownLength;
  std::uint16_t L_DOUBTUNDER = kUnknownLength;
  std::uint8_t Q_LENGTH = 0;
  std::optional<std::uint16_t> L_TRAININT;  // with Q_LENGTH 1 or 2
  std::uint8_t V_TRAIN = 0;
  std::uint8_t Q_DIRTRAIN = 2;
};

/// The report of the current position. D_LRBG is rounded to the nearest step of the finest scale that fits; the
/// rounding is added to the doubts, which are rounded up: the reported interval contains the supervised one. V_TRAIN
/// is rounded up, and L_TRAININT, which counts from the rounded place (7.5.1.57).
/// `ahead`: of the engine, the front end that is reported.
Report report(const State& state, const IntegrityStatus& integrity, const Ahead& ahead);
inline Report report(const State& state, const IntegrityStatus& integrity) {
  return report(state, integrity, state.ahead);
}
/// The report was sent: its LRBG (and its PRVLRBG) may be used by the RBC (3.6.2.2.2 c, 3.4.2.3.3.7).
void note_reported(State& state, const Report& sent);

/// Packet 58: position report parameters, in SI; places in the track frame.
struct ReportParameters {
  std::optional<Duration> T_CYCLOC;  // absent: no cycle in time
  std::optional<Distance> D_CYCLOC;  // absent: no cycle in distance
  std::uint8_t M_LOC = 2;            // 0 now, 1 every LRBG-compliant group, 2 not at groups
  struct At {
    Place place;
    bool front = false;  // Q_LGTLOC 1: max safe front end, 0: min safe rear end
  };
  InplaceVector<At, 32> at;
};

/// Events of the cycle that the position itself does not show (3.6.5.1.4). The caller does not set a bit where the mode
/// does not report it (4.5.2).
struct ReportEvents {
  bool mode_change = false;          // b
  bool integrity_confirmed = false;  // c
  bool integrity_lost = false;       // d
  bool level_change = false;         // g
  bool session_established = false;  // h
  bool new_lrbg = false;             // j, and M_LOC 1
  bool error_to_report = false;      // l
  bool parameters_active = true;     // the mode reports by parameters
  bool groups_active = true;         // j, without parameters
  bool standstill_active = true;     // a
  bool leaving_active = false;       // i
  bool borders_active = true;        // e, f, k
};

/// Why a report is due: one bit per reason, 0: none.
enum class Due : std::uint16_t {
  none = 0,
  standstill = 1 << 0,
  event = 1 << 1,
  border = 1 << 2,
  lrbg = 1 << 3,
  now = 1 << 4,
  cycle = 1 << 5,
  place = 1 << 6
};

struct ReportState {
  std::optional<ReportParameters> parameters;
  Duration sent_at{};          // time of the last cyclic report
  OdometerPlace sent_counter;  // counter at the last cyclic report
  bool now_pending = false;    // M_LOC 0
  bool stood = false;
  std::optional<Place> rear_border;   // RBC/RBC or level border for the min safe rear end (e, f)
  std::optional<Place> front_border;  // RBC/RBC border for the max safe front end (k)
};

/// New parameters replace the old ones (3.6.5.1.7); `time` and counter cycles restart.
void set_parameters(ReportState& reports, const State& state, const ReportParameters& parameters);
/// On entering level 1 or NP (4.9.1.3).
void clear_parameters(ReportState& reports);
/// Whether a report is due in this cycle, as bits of `Due`. A reason is returned once.
std::uint16_t due(ReportState& reports, const State& state, const ReportEvents& events, Distance L_TRAIN);

}  // namespace evc::position
