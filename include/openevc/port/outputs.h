#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "openevc/base/inplace_vector.h"
#include "openevc/base/set.h"
#include "openevc/base/units.h"
#include "openevc/port/event.h"
#include "openevc/terms/cause.h"
#include "openevc/terms/level.h"
#include "openevc/terms/mode.h"
#include "openevc/terms/monitoring.h"
#include "openevc/terms/requests.h"
#include "openevc/terms/symbol.h"

// The outputs of one cycle of the kernel: enumerations and numbers. Their names and texts for people and JSON are in
// the tables of `terms` and in `texts`.
namespace evc::port {

struct NidLrbg {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_BG = 0;
  friend constexpr bool operator==(const NidLrbg&, const NidLrbg&) = default;
};

/// A text on the driver interface (3.12.3).
struct ShownText {
  std::uint8_t id = 0;                 // given on board
  std::optional<std::uint8_t> Q_TEXT;  // a fixed text; absent: plain text
  std::uint8_t length = 0;
  std::array<char, 255> characters{};  // ISO 8859-1, not terminated
};

struct OutgoingMessage {
  InplaceVector<std::uint8_t, 192> bytes;
};
struct RbcAddress {
  std::uint16_t NID_C = 0;
  std::uint16_t NID_RBC = 0;
  std::uint64_t NID_RADIO = 0;  // BCD, as on the wire
};

struct Outputs {
  Duration now{};
  Mode mode = Mode::NP;
  Level level = Level::L0;
  std::uint8_t nid_ntc = 0;
  std::optional<NidLrbg> lrbg;
  OdometerPlace est_front, min_safe_front, max_safe_front;
  Speed v;
  Monitoring monitoring = Monitoring::none;
  Status status = Status::none;
  // Absent where not supervised.
  std::optional<Speed> V_P, V_W, V_SBI, V_EBI, V_MRSP, V_target, V_release;
  std::optional<Distance> d_target;
  // End of authority and supervised location (3.8.4.3, 3.8.4.5), as the nominal counter of a front
  // end at that place; absent without an authority.
  std::optional<OdometerPlace> EOA, SvL;
  bool tco = false, sb = false, eb = false;
  Set<Cause> brake_reasons;           // every cause that asks for a brake
  Set<Ack> requests;                  // acknowledgements asked of the driver
  Set<Entry> entries;                 // data that the driver is asked to enter
  bool start_offered = false;         // the driver may choose Start (5.4, 4.4.13)
  InplaceVector<ShownText, 6> texts;  // texts shown now (packets 72, 76)
  InplaceVector<Symbol, 32> symbols;  // in the order of the areas of the screen
  InplaceVector<OutgoingMessage, 24> radio_out;
  std::optional<RbcAddress> radio_connect, radio_disconnect;
  InplaceVector<Event, 96> events;
};

}  // namespace evc::port
