#include "driver/driver.h"

namespace evc::driver {
namespace {

/// Where an action is due: the symbol that asks the driver for it, and the one for what the train does by itself.
struct Due {
  std::optional<Symbol> driver, train;
  constexpr std::optional<Symbol> of(bool by_train) const { return by_train ? train : driver; }
};

/// The symbols of a condition (5.18, 015560 13), in the order of its phases.
struct SymbolRow {
  TrackConditionKind kind{};
  Due announced;
  std::optional<Symbol> active;
  Due ending;
  Due planned, planned_end;  // in the advance display (015560 8.3.4)
};

// clang-format off
constexpr auto srs_5_18_symbols = [] {
  using enum TrackConditionKind;
  using enum Symbol;
  return std::to_array<SymbolRow>({
    {non_stopping_area,                       {TC11, TC11}, TC10, {},           {PL09, PL09}, {}},
    {tunnel_stopping_area,                    {TC37, TC37}, TC36, {},           {},           {}},
    {sound_horn,                              {},           TC35, {},           {PL24, PL24}, {}},
    {powerless_lower_pantograph,              {TC03, TC02}, TC01, {TC05, TC04}, {PL02, PL01}, {PL04, PL03}},
    {radio_hole,                              {},           TC12, {},           {PL10, PL10}, {}},
    {air_tightness,                           {TC21, TC19}, TC19, {TC22, TC20}, {PL19, PL17}, {PL20, PL18}},
    {switch_off_regenerative_brake,           {TC18, TC17}, TC17, {},           {PL16, PL15}, {}},
    {switch_off_eddy_current_service_brake,   {TC16, TC15}, TC15, {},           {PL14, PL13}, {}},
    {switch_off_magnetic_shoe_brake,          {TC14, TC13}, TC13, {},           {PL12, PL11}, {}},
    {powerless_main_switch_off,               {TC07, TC06}, TC06, {TC09, TC08}, {PL06, PL05}, {PL08, PL07}},
    {switch_off_eddy_current_emergency_brake, {TC16, TC15}, TC15, {},           {PL14, PL13}, {}},
  });
}();

/// By M_VOLTAGE.
constexpr auto kTractionSymbols = [] {
  using enum Symbol;
  struct Row {
    Due announced;
    Symbol active{};
    Due planned;
  };
  return std::to_array<Row>({
    {{TC24, TC23}, TC23, {PL26, PL25}},  // none
    {{TC26, TC25}, TC25, {PL28, PL27}},  // AC 25 kV 50 Hz
    {{TC28, TC27}, TC27, {PL30, PL29}},  // AC 15 kV 16.7 Hz
    {{TC30, TC29}, TC29, {PL32, PL31}},  // DC 3 kV
    {{TC32, TC31}, TC31, {PL34, PL33}},  // DC 1.5 kV
    {{TC34, TC33}, TC33, {PL36, PL35}},  // DC 600/750 V
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

static_assert(
    [] {
      const auto differs = [](const Due& due) { return due.driver != due.train; };
      for (const SymbolRow& row : srs_5_18_symbols)
        if (may_be_by_train(row.kind) != (differs(row.announced) || differs(row.ending) || differs(row.planned)))
          return false;
      return true;
    }(),
    "what the train may execute by itself has a symbol of its own for that");

}  // namespace

std::optional<Symbol> symbol(TrackConditionKind kind, ConditionPhase phase, const ByTrain& by_train) {
  const auto row = static_cast<std::size_t>(kind);
  switch (phase) {
    case ConditionPhase::announced:
      return srs_5_18_symbols[row].announced.of(by_train.conditions[row]);
    case ConditionPhase::active:
      return srs_5_18_symbols[row].active;
    case ConditionPhase::ending:
      return srs_5_18_symbols[row].ending.of(by_train.conditions[row]);
    default:
      return std::nullopt;
  }
}

std::optional<Symbol> symbol_of_traction(std::uint8_t M_VOLTAGE, ConditionPhase phase, const ByTrain& by_train) {
  if (M_VOLTAGE >= kTractionSymbols.size()) return std::nullopt;
  if (phase == ConditionPhase::announced) return kTractionSymbols[M_VOLTAGE].announced.of(by_train.traction_system);
  if (phase == ConditionPhase::active) return kTractionSymbols[M_VOLTAGE].active;
  return std::nullopt;
}

std::optional<Symbol> planning_symbol(TrackConditionKind kind, bool end, const ByTrain& by_train) {
  const auto row = static_cast<std::size_t>(kind);
  const Due& due = end ? srs_5_18_symbols[row].planned_end : srs_5_18_symbols[row].planned;
  return due.of(by_train.conditions[row]);
}

std::optional<Symbol> planning_symbol_of_traction(std::uint8_t M_VOLTAGE, const ByTrain& by_train) {
  if (M_VOLTAGE >= kTractionSymbols.size()) return std::nullopt;
  return kTractionSymbols[M_VOLTAGE].planned.of(by_train.traction_system);
}

}  // namespace evc::driver
