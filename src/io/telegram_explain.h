#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lang/schema.h"
#include "lang/variable_table.h"

// The ETCS language for people: `evc decode --explain`, `evc describe` and the pages in docs/packets.
namespace evc::io {

/// The meaning of a raw code: in units, or as text. `Q_SCALE` is that of the packet, 1 if it has none.
std::string meaning_of(const lang::VariableInfo& variable, std::uint64_t code, std::uint64_t Q_SCALE);

/// A table of bit offset, variable, raw code and meaning. The bits must have been accepted by the append_..._json() of
/// their kind; if they are not consistent, a line that begins with "!" ends the table.
std::string explain_balise(std::span<const std::uint8_t> bytes, std::size_t bits);
std::string explain_radio(std::span<const std::uint8_t> bytes, lang::Direction direction, lang::SystemVersion sv);
std::string explain_packet(std::span<const std::uint8_t> bytes, std::size_t bits, lang::Direction direction,
                           lang::SystemVersion sv);

/// Lists of everything, one a line.
std::string list_packets();
std::string list_messages();
std::string list_variables();
/// All layouts of a packet, of one direction; "" if there is none.
std::string describe_packet(std::uint8_t NID_PACKET, lang::Direction direction, bool markdown);
std::string describe_message(std::uint8_t NID_MESSAGE, bool markdown);
/// By name ("V_STATIC": with its _V1 form) ; "" if there is none.
std::string describe_variable(std::string_view name, bool markdown);
/// The JSON schema of all results of append_..._json().
std::string telegram_schema();
/// The index of the packet pages.
std::string packet_index_page();
/// File name of a packet's page: `packet_5.md`, `train_packet_0.md`.
std::string packet_page_name(std::uint8_t NID_PACKET, lang::Direction direction);

}  // namespace evc::io
