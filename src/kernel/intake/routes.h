#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "kernel/intake/evaluation.h"
#include "lang/telegram.h"
#include "terms/information.h"
#include "terms/packet_numbers.h"

// The route of each packet and message through the unit: its turn, its rows of the acceptance tables, the function that
// uses it.
namespace evc::kernel {

/// When a packet is evaluated (4.8.1).
enum class Turn : std::uint8_t {
  before,         ///< it is evaluated before the filters (4.8.2.2), or begins the infill part
  level_order,    ///< first (4.8.1.3)
  version_order,  ///< then: the rest depends on the version (3.17.3.3)
  linking,        ///< before other location data (4.8.1.6)
  rest,           ///< then
  authority,      ///< last: SSP and gradient have to cover it (4.8.3 [4])
  with_authority  ///< belongs to the MA, SR or SH authorisation it is sent with
};

/// The function that uses an accepted packet. The verdict is `accepted` or `only_contact_stored`.
using TakePacket = void (*)(Evaluation&, const lang::PacketView&, modes::Verdict);

/// The rows of the acceptance tables 4.8.3 and 4.8.4 to which a packet belongs; or, if this depends on its contents,
/// how it is selected.
struct Rows {
  using OfContents = evc::Information (*)(const lang::PacketView&);
  evc::Information first{}, second{};
  std::uint8_t count = 0;
  OfContents of_contents = nullptr;

  constexpr Rows() = default;
  constexpr Rows(evc::Information only) : first(only), count(1) {}
  constexpr Rows(evc::Information a, evc::Information b) : first(a), second(b), count(2) {}
  constexpr Rows(OfContents f) : count(1), of_contents(f) {}
};

/// Whether a packet has places: distances from the reference of its message.
using HasPlace = bool (*)(const lang::PacketView&);

struct PacketRoute {
  packet::ToTrain number;
  Turn turn;
  Rows rows;
  HasPlace place = nullptr;  ///< none: it never has
  /// Of turn `rest` alone: the other turns are steps of their own (filter.cpp, authority.cpp, messages.cpp).
  TakePacket take = nullptr;
};

/// An unknown number has neither a row nor a function.
const PacketRoute& route_of(const lang::PacketView& view);

using InformationRows = InplaceVector<evc::Information, 2>;
/// The rows of a packet of the direction track to train. Empty where the packet has no row: 49, 63 and 80 belong to the
/// MA, SR or SH authorisation they are sent with; 0, 145 and 255 are evaluated before the tables (4.8.2.2); or the
/// packet is unknown.
InformationRows rows_of(const PacketRoute& route, const lang::PacketView& view);

inline bool has_place(const PacketRoute& route, const lang::PacketView& view) {
  return route.place != nullptr && route.place(view);
}
/// Whether radio message NID_MESSAGE has a place itself, without its packets, or is an authority: without a reference
/// it has no use.
bool has_place(std::uint8_t NID_MESSAGE);

/// The row of radio message NID_MESSAGE itself, without its packets; none for messages that are their packets (3, 24,
/// 33, 37) and unknown ones.
std::optional<evc::Information> row_of_message(std::uint8_t NID_MESSAGE);

}  // namespace evc::kernel
