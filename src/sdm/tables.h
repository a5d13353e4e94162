#pragma once
#include <cstdint>
#include <span>

#include "sdm/rules.h"
#include "sdm/supervision.h"
#include "terms/srs_version.h"

// The tables of 3.13.10 in the form of the page: triggering conditions with their speed and location, the command and
// the status they trigger. A location "beyond X" means the max safe front end for limits from an EBD; in the EOA/SvL
// tables "max safe front for SvL OR estimated front for EOA"; "up to X" is its negation (AND). SBI is SBI2 for an EBD
// and SBI1 for the EOA; EBI concerns the SvL only.
namespace evc::sdm {

/// Speeds that the rows compare with. Vt: target speed, in the EOA/SvL table the release speed (0 where
/// none is supervised); M: V_MRSP; _w, _sbi, _ebi: plus the margin of that speed.
enum class Bound : std::uint8_t { none, Vt, Vt_w, Vt_sbi, Vt_ebi, M, M_w, M_sbi, M_ebi, count };
/// Limits that a front end can be beyond: I, P, W, SBI, EBI at V_est; I_M: I at V_MRSP.
enum class Limit : std::uint8_t { none, I, P, W, SBI, EBI, I_M };
enum class Command : std::uint8_t { none, TCO, SB, EB };

/// t<id>: `above` < V_est <= `upto` (V_est = above where `equal`), beyond one limit, not beyond another.
struct TriggerRow {
  std::uint8_t id;
  Bound above;
  Bound upto;
  Limit beyond;
  Limit not_beyond;
  Command command;
  Status status;
  bool equal = false;
};

// clang-format off

/// Table 5, ceiling speed monitoring.
inline constexpr TriggerRow kCSM[] = {
    {1, Bound::none,  Bound::M,    Limit::none, Limit::none, Command::none, Status::Normal},
    {2, Bound::M,     Bound::none, Limit::none, Limit::none, Command::none, Status::Overspeed},
    {3, Bound::M_w,   Bound::none, Limit::none, Limit::none, Command::none, Status::Warning},
    {4, Bound::M_sbi, Bound::none, Limit::none, Limit::none, Command::SB,   Status::Intervention},
    {5, Bound::M_ebi, Bound::none, Limit::none, Limit::none, Command::EB,   Status::Intervention},
};

/// Table 13, release speed monitoring (Vt: V_release).
inline constexpr TriggerRow kRSM[] = {
    {1, Bound::none, Bound::Vt,   Limit::none, Limit::none, Command::none, Status::Indication},
    {2, Bound::Vt,   Bound::none, Limit::none, Limit::none, Command::EB,   Status::Intervention},
};

/// Table 8 of 3.4.0: target speed monitoring, MRSP target or LOA.
inline constexpr TriggerRow kTSM_MRSP_LOA_3_4_0[] = {
    {1,  Bound::none,   Bound::Vt,    Limit::none, Limit::none, Command::none, Status::Normal},
    {2,  Bound::Vt,     Bound::M,     Limit::none, Limit::I,    Command::none, Status::Normal},
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::none, Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {5,  Bound::M,      Bound::M_w,   Limit::none, Limit::I_M,  Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::I_M,  Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt_w,   Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {8,  Bound::M_w,    Bound::M_sbi, Limit::none, Limit::I_M,  Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::I_M,  Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt_sbi, Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {11, Bound::M_sbi,  Bound::M_ebi, Limit::none, Limit::I_M,  Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::I_M,  Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt_ebi, Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {14, Bound::M_ebi,  Bound::none,  Limit::none, Limit::I_M,  Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::I_M,  Limit::none, Command::EB,   Status::Intervention},
};
/// Table 9 of 3.4.0: EOA/SvL (Vt: V_release) and end of the SR distance (Vt: 0).
inline constexpr TriggerRow kTSM_EOA_SvL_3_4_0[] = {
    {1,  Bound::none,   Bound::Vt,    Limit::none, Limit::none, Command::none, Status::Normal},
    {2,  Bound::Vt,     Bound::M,     Limit::none, Limit::I,    Command::none, Status::Normal},
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::none, Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {5,  Bound::M,      Bound::M_w,   Limit::none, Limit::I_M,  Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::I_M,  Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt,     Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {8,  Bound::M_w,    Bound::M_sbi, Limit::none, Limit::I_M,  Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::I_M,  Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt,     Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {11, Bound::M_sbi,  Bound::M_ebi, Limit::none, Limit::I_M,  Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::I_M,  Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt,     Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {14, Bound::M_ebi,  Bound::none,  Limit::none, Limit::I_M,  Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::I_M,  Limit::none, Command::EB,   Status::Intervention},
};

/// Tables 8 and 9 of 4.0.0.
inline constexpr TriggerRow kTSM_MRSP_LOA_4_0_0[] = {
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::P,    Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::none, Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt_w,   Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::none, Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt_sbi, Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::none, Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt_ebi, Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::none, Limit::none, Command::EB,   Status::Intervention},
};
inline constexpr TriggerRow kTSM_EOA_SvL_4_0_0[] = {
    {0,  Bound::Vt,     Bound::none,  Limit::I,    Limit::none, Command::none, Status::Indication, true},
    {1,  Bound::Vt,     Bound::none,  Limit::P,    Limit::none, Command::none, Status::Overspeed,  true},
    {2,  Bound::Vt,     Bound::none,  Limit::W,    Limit::none, Command::TCO,  Status::Warning,    true},
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::P,    Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::none, Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt,     Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::none, Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt,     Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::none, Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt,     Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::none, Limit::none, Command::EB,   Status::Intervention},
};

/// Tables 8 and 9 of 3.6.0, as in a public implementation: those of 4.0.0 without t0-t2, and with t6, t9, t12, t15 only
/// beyond the Indication limit.
inline constexpr TriggerRow kTSM_MRSP_LOA_3_6_0[] = {
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::P,    Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::I,    Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt_w,   Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::I,    Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt_sbi, Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::I,    Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt_ebi, Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::I,    Limit::none, Command::EB,   Status::Intervention},
};
inline constexpr TriggerRow kTSM_EOA_SvL_3_6_0[] = {
    {3,  Bound::Vt,     Bound::M,     Limit::I,    Limit::P,    Command::none, Status::Indication},
    {4,  Bound::Vt,     Bound::M,     Limit::P,    Limit::none, Command::none, Status::Overspeed},
    {6,  Bound::M,      Bound::M_w,   Limit::I,    Limit::W,    Command::none, Status::Overspeed},
    {7,  Bound::Vt,     Bound::M_w,   Limit::W,    Limit::none, Command::TCO,  Status::Warning},
    {9,  Bound::M_w,    Bound::M_sbi, Limit::I,    Limit::SBI,  Command::TCO,  Status::Warning},
    {10, Bound::Vt,     Bound::M_sbi, Limit::SBI,  Limit::none, Command::SB,   Status::Intervention},
    {12, Bound::M_sbi,  Bound::M_ebi, Limit::I,    Limit::EBI,  Command::SB,   Status::Intervention},
    {13, Bound::Vt,     Bound::M_ebi, Limit::EBI,  Limit::none, Command::EB,   Status::Intervention},
    {15, Bound::M_ebi,  Bound::none,  Limit::I,    Limit::none, Command::EB,   Status::Intervention},
};

/// Tables 6, 10, 11, 14: r<id> holds at `above` < V_est <= `upto`, not beyond a limit (r0: at standstill),
/// and what it revokes. EB: `never`, `always`, `if_permitted` by Q_NVEMRRLS, `or_zero`: also where Vt = 0.
enum class EbRelease : std::uint8_t { never, always, if_permitted, or_zero };
struct RevocationRow {
  std::uint8_t id;
  bool standstill;
  Bound above;
  Bound upto;
  Limit not_beyond;
  bool TCO;
  bool SB;
  EbRelease EB;
  Status to;  // the status after Overspeed, Warning, Intervention
};
inline constexpr RevocationRow kCSM_revocation[] = {
    {0, true,  Bound::none, Bound::none, Limit::none, false, false, EbRelease::always,       Status::Normal},
    {1, false, Bound::none, Bound::M,    Limit::none, false, true,  EbRelease::if_permitted, Status::Normal},
};
inline constexpr RevocationRow kTSM_revocation_3_4_0[] = {
    {0, true,  Bound::none, Bound::none, Limit::none, false, false, EbRelease::always,       Status::Normal},
    {1, false, Bound::none, Bound::Vt,   Limit::none, true,  true,  EbRelease::or_zero,      Status::Normal},
    {2, false, Bound::Vt,   Bound::M,    Limit::I,    true,  true,  EbRelease::if_permitted, Status::Normal},
    {3, false, Bound::Vt,   Bound::M,    Limit::P,    true,  true,  EbRelease::if_permitted, Status::Indication},
};
inline constexpr RevocationRow kTSM_revocation_4_0_0[] = {
    {0, true,  Bound::none, Bound::none, Limit::none, false, false, EbRelease::always,       Status::Indication},
    {1, false, Bound::none, Bound::Vt,   Limit::none, true,  true,  EbRelease::or_zero,      Status::Indication},
    {3, false, Bound::Vt,   Bound::M,    Limit::P,    true,  true,  EbRelease::if_permitted, Status::Indication},
};
inline constexpr RevocationRow kRSM_revocation[] = {
    {0, true,  Bound::none, Bound::none, Limit::none, false, false, EbRelease::always, Status::Indication},
    {1, false, Bound::none, Bound::Vt,   Limit::none, false, false, EbRelease::never,  Status::Indication},
};

/// Table 16 (3.13.10.6): from one type of monitoring to another by conditions [1]-[6], bit n for [n].
struct TransitionRow {
  Monitoring from;
  Monitoring to;
  std::uint8_t conditions;
};
constexpr std::uint8_t condition(int n) { return static_cast<std::uint8_t>(1u << n); }
inline constexpr TransitionRow kTransitions_3_4_0[] = {
    {Monitoring::CSM, Monitoring::RSM, condition(5)},
    {Monitoring::CSM, Monitoring::TSM, condition(1) | condition(4)},
    {Monitoring::TSM, Monitoring::RSM, condition(2) | condition(5)},
    {Monitoring::TSM, Monitoring::CSM, condition(3)},
    {Monitoring::RSM, Monitoring::TSM, condition(4)},
    {Monitoring::RSM, Monitoring::CSM, condition(3)},
};
inline constexpr TransitionRow kTransitions_4_0_0[] = {
    {Monitoring::CSM, Monitoring::RSM, condition(2) | condition(5)},
    {Monitoring::CSM, Monitoring::TSM, condition(1) | condition(4)},
    {Monitoring::TSM, Monitoring::RSM, condition(2) | condition(5)},
    {Monitoring::TSM, Monitoring::CSM, condition(3) | condition(6)},
    {Monitoring::RSM, Monitoring::TSM, condition(4)},
    {Monitoring::RSM, Monitoring::CSM, condition(3)},
};
// clang-format on

constexpr std::span<const TriggerRow> trigger_table(const Rules& rules, bool EOA_SvL) {
  if (rules.pre_indication)
    return EOA_SvL ? std::span<const TriggerRow>(kTSM_EOA_SvL_3_4_0) : std::span<const TriggerRow>(kTSM_MRSP_LOA_3_4_0);
  if (rules.ceiling_rows_need_indication)
    return EOA_SvL ? std::span<const TriggerRow>(kTSM_EOA_SvL_3_6_0) : std::span<const TriggerRow>(kTSM_MRSP_LOA_3_6_0);
  return EOA_SvL ? std::span<const TriggerRow>(kTSM_EOA_SvL_4_0_0) : std::span<const TriggerRow>(kTSM_MRSP_LOA_4_0_0);
}
constexpr std::span<const RevocationRow> revocation_table(const Rules& rules) {
  return rules.pre_indication ? std::span<const RevocationRow>(kTSM_revocation_3_4_0)
                              : std::span<const RevocationRow>(kTSM_revocation_4_0_0);
}
constexpr std::span<const TransitionRow> transition_table(const Rules& rules) {
  return rules.pre_indication ? std::span<const TransitionRow>(kTransitions_3_4_0)
                              : std::span<const TransitionRow>(kTransitions_4_0_0);
}

}  // namespace evc::sdm
