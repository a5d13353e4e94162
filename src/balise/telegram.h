#pragma once
#include <optional>
#include <span>

#include "balise/group.h"
#include "terms/srs_version.h"

// One telegram: the parts that the rules for groups need.
namespace evc::balise {

/// The 50 bits in front of the packets (8.4.2.1), and the marker for virtual balise covers.
struct Header {
  bool readable = false;  // the bits are complete, sent by the track, by a balise
  std::uint8_t M_VERSION = 0;
  std::uint8_t N_PIG = 0;
  std::uint8_t N_TOTAL = 0;
  std::uint8_t M_DUP = 0;
  std::uint8_t M_MCOUNT = 0;
  GroupId id;
  bool Q_LINK = false;
  std::optional<std::uint8_t> NID_VBCMK;  // first of all packets (3.15.9.3, 8.4.2.4)
  constexpr std::uint8_t X() const { return static_cast<std::uint8_t>(M_VERSION >> 4); }
};

Header read_header(std::span<const std::uint8_t> bytes, std::size_t bits);

/// Keeps the bits and looks at the packets as a unit of this SRS reads them; place and counter are not set. More bits
/// than a telegram has are faulty (3.16.1.1).
void look_into(Telegram& telegram, std::span<const std::uint8_t> bytes, std::size_t bits, const Header& header,
               SrsVersion srs);

}  // namespace evc::balise
