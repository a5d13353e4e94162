#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "base/inplace_vector.h"
#include "lang/schema.h"
#include "radio/messages.h"
#include "radio/radio.h"
#include "terms/consist_length.h"
#include "terms/level.h"
#include "terms/mode.h"

// Messages to the RBC as bits (8.6), in the version that the RBC gave in its message 32 (6.6.3.4).
namespace evc::radio {

/// The codes of packet 0, of packet 1 when NID_PRVLRBG is present (7.4.3.1-2).
struct PositionReport {
  std::uint8_t Q_SCALE = 1;
  std::uint32_t NID_LRBG = kUnknownLrbg;
  std::optional<std::uint32_t> NID_PRVLRBG;
  std::uint16_t D_LRBG = 32767;
  std::uint8_t Q_DIRLRBG = 2, Q_DLRBG = 2;
  std::uint16_t L_DOUBTOVER = 32767, L_DOUBTUNDER = 32767;
  std::uint8_t Q_LENGTH = 0;
  std::uint16_t L_TRAININT = 0;
  std::uint8_t V_TRAIN = 0, Q_DIRTRAIN = 2;
  bool standstill = false;  ///< V_TRAIN says so from 2.3 on
  Mode mode = Mode::SB;     ///< M_MODE is that of the version
  std::uint8_t M_LEVEL = evc::M_LEVEL(Level::L0), NID_NTC = 0;
};

/// Packets 10 to 12 (7.4.3.4.3 to 7.4.3.5.1).
struct TrainDataReport {
  std::uint8_t NC_CDTRAIN = 2;
  std::uint16_t NC_TRAIN = 0;
  std::uint16_t L_TRAIN = 0;    ///< m
  std::uint8_t V_MAXTRAIN = 0;  ///< steps of 5 km/h
  std::uint8_t M_LOADINGGAUGE = 1, M_AXLELOADCAT = 0, M_AIRTIGHT = 0;
  std::uint16_t N_AXLE = 1023;  ///< 1023: unknown
  InplaceVector<RouteData::Traction, 8> tractions;
  InplaceVector<std::uint8_t, 8> NID_NTC;  ///< fitted national systems
  std::optional<std::uint32_t> NID_OPERATIONAL;
  std::optional<ConsistLength> consist;  ///< absent: the safe consist length is not known
};

/// Who the unit is (3.18.4.4).
struct OnBoard {
  std::uint32_t NID_ENGINE = 0;
  std::span<const std::uint64_t> telephone_numbers;          ///< NID_RADIO of the mobile terminals, for packet 3
  lang::SystemVersion newest = lang::kNewest_of_baseline_3;  ///< the highest version supported, for packet 2
};

/// Writes the message in the older one of both versions. Returns the number of bytes; 0 when it is not sent to this
/// version (158 to X = 1; 131, 133 before 2.3) or `bytes` is too small. `M_VERSION`: of the RBC, 0 while it is unknown.
std::size_t compose(const Intent& intent, const PositionReport& position, const TrainDataReport& train,
                    const OnBoard& unit, std::uint8_t M_VERSION, std::span<std::uint8_t> bytes);

}  // namespace evc::radio
