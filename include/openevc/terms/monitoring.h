#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// The type of speed and distance monitoring in force (3.13.10): ceiling speed, target speed, release speed.
enum class Monitoring : std::uint8_t { none, CSM, TSM, RSM };

inline constexpr auto kMonitoringRows = std::to_array<terms::Row<Monitoring>>({
    {Monitoring::none, "none"},
    {Monitoring::CSM, "CSM"},
    {Monitoring::TSM, "TSM"},
    {Monitoring::RSM, "RSM"},
});
static_assert(terms::in_order(kMonitoringRows));

/// The supervision status (3.13.10.1.2), in the order of severity; none where nothing is monitored.
enum class Status : std::uint8_t { none, Normal, Indication, Overspeed, Warning, Intervention };

inline constexpr auto kStatusRows = std::to_array<terms::Row<Status>>({
    {Status::none, "none"},
    {Status::Normal, "Normal"},
    {Status::Indication, "Indication"},
    {Status::Overspeed, "Overspeed"},
    {Status::Warning, "Warning"},
    {Status::Intervention, "Intervention"},
});
static_assert(terms::in_order(kStatusRows));

/// What a comparison of speed and limits comes to, trip and brakes included: the highest that holds.
enum class MemoStatus : std::uint8_t { Null, P, W, SB, EB, Trip };

inline constexpr auto kMemoStatusRows = std::to_array<terms::Row<MemoStatus>>({
    {MemoStatus::Null, "Null"},
    {MemoStatus::P, "P"},
    {MemoStatus::W, "W"},
    {MemoStatus::SB, "SB"},
    {MemoStatus::EB, "EB"},
    {MemoStatus::Trip, "Trip"},
});
static_assert(terms::in_order(kMemoStatusRows));

}  // namespace evc
