#pragma once
#include "openevc/terms/row.h"

namespace evc {

/// What the bearer reports of the safe radio connection to an RBC (3.5.3).
enum class RadioLink : std::uint8_t { unchanged, connected, lost, refused };

inline constexpr auto kRadioLinkRows = std::to_array<terms::Row<RadioLink>>({
    {RadioLink::unchanged, "unchanged"},
    {RadioLink::connected, "connected"},
    {RadioLink::lost, "lost"},
    {RadioLink::refused, "refused"},
});
static_assert(terms::in_order(kRadioLinkRows));

/// What the driver is shown of a session: nothing, that it could not be set up or is lost (ST04), or that it is up
/// (ST03) (3.5.3.7, 3.5.4).
enum class RadioIndication : std::uint8_t { none, failed, up };

/// How far a communication session is (3.5.3 to 3.5.5).
enum class SessionPhase : std::uint8_t {
  idle,
  connecting,       ///< a connection is asked for
  waiting_version,  ///< message 155 was sent, message 32 is awaited
  up,
  lost,        ///< the connection is lost, the session is kept (3.5.4.1)
  terminating  ///< message 156 was sent, message 39 is awaited
};

inline constexpr auto kSessionPhaseRows = std::to_array<terms::Row<SessionPhase>>({
    {SessionPhase::idle, "none"},
    {SessionPhase::connecting, "connecting"},
    {SessionPhase::waiting_version, "version check"},
    {SessionPhase::up, "open"},
    {SessionPhase::lost, "lost"},
    {SessionPhase::terminating, "terminating"},
});
static_assert(terms::in_order(kSessionPhaseRows));

/// The part of an RBC in a handover; without one it supervises (3.15.1).
enum class SessionRole : std::uint8_t {
  supervising,
  accepting,    ///< it will supervise beyond the border
  handing_over  ///< it supervised up to the border
};

inline constexpr auto kSessionRoleRows = std::to_array<terms::Row<SessionRole>>({
    {SessionRole::supervising, "supervising"},
    {SessionRole::accepting, "accepting"},
    {SessionRole::handing_over, "handing over"},
});
static_assert(terms::in_order(kSessionRoleRows));

}  // namespace evc
