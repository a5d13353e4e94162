#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "port/inputs.h"
#include "port/outputs.h"

namespace evc::sim {

/// Bits as sent: left aligned, padded to a byte.
struct Bits {
  std::vector<std::uint8_t> bytes;
  std::size_t size = 0;
  /// The unsigned number in `width` <= 32 bits from `first`; bits beyond the end read as 0.
  std::uint32_t number(std::size_t first, unsigned width) const;
};

/// A balise in the track: its centre in metres along the run and the telegram it sends.
struct Balise {
  double position_m = 0.0;
  Bits telegram;
  std::size_t group = 0;  // index of the group in the file
  std::size_t index = 0;  // of the balise in its group, in the file
};

/// A radio message and the place of the true front end at which the trackside sends it.
struct TracksideMessage {
  int seq = 0;
  double position_m = 0.0;
  double delay_s = 0.0;  // after the front end has reached the place
  Bits message;
  std::size_t index = 0;  // in the file
};

struct GradientSegment {
  double start_m = 0.0, end_m = 0.0, permille = 0.0;
};
struct SpeedSegment {
  double start_m = 0.0, end_m = 0.0, kmh = 0.0;
};

/// The RBC of a line: what the driver enters where the mission starts in level 2 or 3, and how it answers a request for
/// shunting.
struct Rbc {
  port::DriverActions::RbcContact contact{0, 1, 1};
  bool grants_shunting = false;
};

/// What trackside sends and where, and the data of the track (etcs-line/1).
struct Line {
  std::string name;
  double length_m = 0.0;
  double start_front_m = -50.0;
  std::optional<double> end_m;
  Level start_level = Level::NTC;
  std::uint8_t start_nid_ntc = 1;
  Rbc rbc;
  std::size_t groups = 0;
  std::vector<Balise> balises;            // in order of position
  std::vector<TracksideMessage> radio;    // in order of position
  std::size_t absent_messages = 0;        // recorded without bits: not sent
  std::vector<GradientSegment> gradient;  // in order
  std::vector<SpeedSegment> ssp;          // in order
};

}  // namespace evc::sim
