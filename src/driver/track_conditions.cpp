#include "driver/driver.h"

namespace evc::driver {
namespace {

/// The symbols of a condition (5.18, 015560 13), in the order of its phases.
struct SymbolRow {
  TrackConditionKind kind{};
  std::optional<Symbol> announced, active, ending;
  std::optional<Symbol> planned, planned_end;  // in the advance display (015560 8.3.4)
};

// clang-format off
constexpr auto srs_5_18_symbols = [] {
  using enum TrackConditionKind;
  using enum Symbol;
  return std::to_array<SymbolRow>({
    {non_stopping_area,                       TC11, TC10, {},   PL09, {}},
    {tunnel_stopping_area,                    TC37, TC36, {},   {},   {}},
    {sound_horn,                              {},   TC35, {},   PL24, {}},
    {powerless_lower_pantograph,              TC03, TC01, TC05, PL02, PL04},
    {radio_hole,                              {},   TC12, {},   PL10, {}},
    {air_tightness,                           TC21, TC19, TC22, PL19, PL20},
    {switch_off_regenerative_brake,           TC18, TC17, {},   PL16, {}},
    {switch_off_eddy_current_service_brake,   TC16, TC15, {},   PL14, {}},
    {switch_off_magnetic_shoe_brake,          TC14, TC13, {},   PL12, {}},
    {powerless_main_switch_off,               TC07, TC06, TC09, PL06, PL08},
    {switch_off_eddy_current_emergency_brake, TC16, TC15, {},   PL14, {}},
  });
}();

/// By M_VOLTAGE.
constexpr auto kTractionSymbols = [] {
  using enum Symbol;
  struct Row {
    Symbol announced{}, active{}, planned{};
  };
  return std::to_array<Row>({
    {TC24, TC23, PL26},  // none
    {TC26, TC25, PL28},  // AC 25 kV 50 Hz
    {TC28, TC27, PL30},  // AC 15 kV 16.7 Hz
    {TC30, TC29, PL32},  // DC 3 kV
    {TC32, TC31, PL34},  // DC 1.5 kV
    {TC34, TC33, PL36},  // DC 600/750 V
  });
}();
// clang-format on

static_assert(
    [] {
      for (std::size_t i = 0; i < srs_5_18_symbols.size(); ++i)
        if (static_cast<std::size_t>(srs_5_18_symbols[i].kind) != i) return false;
      return srs_5_18_symbols.size() == kTrackConditionRows.size();
    }(),
    "every kind of track condition has its row, in the order of the codes");

}  // namespace

std::optional<Symbol> symbol(TrackConditionKind kind, ConditionPhase phase) {
  const SymbolRow& row = srs_5_18_symbols[static_cast<std::size_t>(kind)];
  switch (phase) {
    case ConditionPhase::announced:
      return row.announced;
    case ConditionPhase::active:
      return row.active;
    case ConditionPhase::ending:
      return row.ending;
    default:
      return std::nullopt;
  }
}

std::optional<Symbol> symbol_of_traction(std::uint8_t M_VOLTAGE, ConditionPhase phase) {
  if (M_VOLTAGE >= kTractionSymbols.size()) return std::nullopt;
  if (phase == ConditionPhase::announced) return kTractionSymbols[M_VOLTAGE].announced;
  if (phase == ConditionPhase::active) return kTractionSymbols[M_VOLTAGE].active;
  return std::nullopt;
}

std::optional<Symbol> planning_symbol(TrackConditionKind kind, bool end) {
  const SymbolRow& row = srs_5_18_symbols[static_cast<std::size_t>(kind)];
  return end ? row.planned_end : row.planned;
}

std::optional<Symbol> planning_symbol_of_traction(std::uint8_t M_VOLTAGE) {
  if (M_VOLTAGE >= kTractionSymbols.size()) return std::nullopt;
  return kTractionSymbols[M_VOLTAGE].planned;
}

}  // namespace evc::driver
