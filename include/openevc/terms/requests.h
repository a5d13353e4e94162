#pragma once
#include "openevc/terms/row.h"

// What the procedures ask of the driver, offer and show.
namespace evc {

/// What the driver can be asked to acknowledge; the numbers are those of the driver interface.
enum class Ack : std::uint8_t { OS, LS, SH, SR, UN, SN, RV, trip, level, text, brake, train_data, count };

inline constexpr auto kAckRows = std::to_array<terms::Row<Ack>>({
    {Ack::OS, "OS"},
    {Ack::LS, "LS"},
    {Ack::SH, "SH"},
    {Ack::SR, "SR"},
    {Ack::UN, "UN"},
    {Ack::SN, "SN"},
    {Ack::RV, "RV"},
    {Ack::trip, "trip"},
    {Ack::level, "level"},
    {Ack::text, "text"},
    {Ack::brake, "brake"},
    {Ack::train_data, "train_data"},
});
static_assert(terms::in_order(kAckRows) && kAckRows.size() == terms::index(Ack::count));

/// Data that the driver is asked to enter or to revalidate.
enum class Entry : std::uint8_t { driver_id, level, rbc_contact, train_data, train_running_number, count };

inline constexpr auto kEntryRows = std::to_array<terms::Row<Entry>>({
    {Entry::driver_id, "enter driver_id"},
    {Entry::level, "enter level"},
    {Entry::rbc_contact, "enter rbc_contact"},
    {Entry::train_data, "enter train_data"},
    {Entry::train_running_number, "enter train_running_number"},
});
static_assert(terms::in_order(kEntryRows) && kEntryRows.size() == terms::index(Entry::count));

/// What the procedure lets the driver choose now (in addition to the conditions of the mode, driver/driver.h).
enum class Offer : std::uint8_t {
  start,
  shunting,
  non_leading,
  train_data,
  override_,
  driver_id,
  train_running_number,
  level,
  rbc_contact,
  radio_network,
  vbc,
  bmm_inhibition,
  count
};

/// What happened that the driver is informed of by a text (terms/status_text.h).
enum class Inform : std::uint8_t {
  network_registration_failed,    ///< 5.4.3.2 A29
  train_rejected,                 ///< 5.4.3.2 A40
  SH_refused,                     ///< 5.6.2 A220
  SH_request_failed,              ///< 5.6.4.1.2
  trackside_not_compatible,       ///< 3.5.3.7 d
  trackside_malfunction,          ///< 3.16.2.4.9
  train_data_changed,             ///< 5.17.2.2 A1
  national_system_not_available,  ///< in level NTC, that of the level (SUBSET-035 10.3.3.8)
  NL_no_longer_permitted,         ///< 4.4.15.1.1.3 of 4.0.0
  odometer_impaired,              ///< 3.6.8.5, 3.6.8.6 of 4.0.0: as long as it is
  SM_refused,                     ///< 5.21.2.2 A220
  SM_request_failed,              ///< 5.21.4.1
  consist_length_lost,            ///< 4.4.21.1.12: the safe consist length became unavailable
  count
};

}  // namespace evc
