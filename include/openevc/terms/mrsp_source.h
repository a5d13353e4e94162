#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// What a step of the most restrictive speed profile comes from (3.13.7).
enum class MrspSource : std::uint8_t { SSP, ASP, TSR, PBD, LX, signalling, train, mode, override_, count };

inline constexpr auto kMrspSourceRows = std::to_array<terms::Row<MrspSource>>({
    {MrspSource::SSP, "SSP"},
    {MrspSource::ASP, "ASP"},
    {MrspSource::TSR, "TSR"},
    {MrspSource::PBD, "PBD"},
    {MrspSource::LX, "LX"},
    {MrspSource::signalling, "signalling"},
    {MrspSource::train, "train"},
    {MrspSource::mode, "mode"},
    {MrspSource::override_, "override"},
});
static_assert(terms::in_order(kMrspSourceRows) && kMrspSourceRows.size() == terms::index(MrspSource::count));

}  // namespace evc
