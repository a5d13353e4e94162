#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// Status of stored data: position, train data, level, RBC contact, driver identity, train running number (4.11,
/// 5.4.2).
enum class DataStatus : std::uint8_t { invalid, valid, unknown };

/// Code: Q_STATUS (7.5.1.134).
inline constexpr auto kDataStatusRows = std::to_array<terms::WireRow<DataStatus>>({
    {DataStatus::invalid, 0, "invalid"},
    {DataStatus::valid, 1, "valid"},
    {DataStatus::unknown, 2, "unknown"},
});
static_assert(terms::in_order(kDataStatusRows));

constexpr std::uint8_t Q_STATUS(DataStatus status) { return terms::kCodes<kDataStatusRows>[terms::index(status)]; }

}  // namespace evc
