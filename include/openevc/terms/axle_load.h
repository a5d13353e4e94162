#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The axle load categories of trains (SUBSET-026 A.3.11, 7.5.1.62). Code: M_AXLELOADCAT.
enum class AxleLoad : std::uint8_t { A, HS17, B1, B2, C2, C3, C4, D2, D3, D4, D4XL, E4, E5, count };

inline constexpr auto kAxleLoadRows = std::to_array<terms::WireRow<AxleLoad>>({
    {AxleLoad::A, 0, "A"},
    {AxleLoad::HS17, 1, "HS17"},
    {AxleLoad::B1, 2, "B1"},
    {AxleLoad::B2, 3, "B2"},
    {AxleLoad::C2, 4, "C2"},
    {AxleLoad::C3, 5, "C3"},
    {AxleLoad::C4, 6, "C4"},
    {AxleLoad::D2, 7, "D2"},
    {AxleLoad::D3, 8, "D3"},
    {AxleLoad::D4, 9, "D4"},
    {AxleLoad::D4XL, 10, "D4XL"},
    {AxleLoad::E4, 11, "E4"},
    {AxleLoad::E5, 12, "E5"},
});
static_assert(terms::in_order(kAxleLoadRows) && terms::value_is_code(kAxleLoadRows) &&
              kAxleLoadRows.size() == terms::index(AxleLoad::count));

/// The loading gauges of trains (A.3.11). Code: M_LOADINGGAUGE; `none`: the train does not fit into one of them, which
/// the driver reads as "Out of GC" (015560 11.3.9).
enum class LoadingGauge : std::uint8_t { none, G1, GA, GB, GC, count };

inline constexpr auto kLoadingGaugeRows = std::to_array<terms::WireRow<LoadingGauge>>({
    {LoadingGauge::none, 0, "none"},
    {LoadingGauge::G1, 1, "G1"},
    {LoadingGauge::GA, 2, "GA"},
    {LoadingGauge::GB, 3, "GB"},
    {LoadingGauge::GC, 4, "GC"},
});
static_assert(terms::in_order(kLoadingGaugeRows) && terms::value_is_code(kLoadingGaugeRows) &&
              kLoadingGaugeRows.size() == terms::index(LoadingGauge::count));

}  // namespace evc
