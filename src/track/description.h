#pragma once
#include <cstdint>
#include <optional>

#include "base/inplace_vector.h"
#include "base/step_function.h"
#include "base/units.h"
#include "terms/medium.h"
#include "track/conditions.h"
#include "track/mode_profile.h"
#include "track/movement_authority.h"
#include "track/orders.h"
#include "track/speed_restrictions.h"
#include "track/texts.h"

namespace evc::track {

/// The position of the train in the track frame, as needed for stored data.
struct Here {
  Place est_front{}, min_safe_front{}, max_safe_front{};
  Place min_safe_rear{};
  Place min_safe_antenna{}, max_safe_antenna{};
  Place hole_front{}, hole_rear{};  ///< the ends to which a radio hole is related (3.12.1.2.1.5)
  Duration now{};
  bool standstill = false;
  /// The last movement was against the train orientation; not in editions before 4.0.0, which take no notice of it.
  bool ran_back = false;
};

/// Everything that trackside sent about the track ahead. All places are in the track frame, which is fixed to the
/// balise groups: relocation moves the train, not the data.
struct Description {
  // 3.8
  std::optional<MovementAuthority> ma;
  InplaceVector<SignallingSpeed, 4> signalling;  ///< the one in force, and those from infill locations ahead
  ModeProfile mode_profile;
  // 3.11
  StaticSpeedProfile ssp;
  GradientProfile gradient;
  InplaceVector<AxleLoadRestriction, 40> asp;
  InplaceVector<TemporarySpeedRestriction, 48> tsr;
  InplaceVector<PermittedBrakingDistance, 40> pbd;
  InplaceVector<LevelCrossing, 16> lx;
  bool revocable_tsr_inhibited = false;          ///< packet 64
  std::optional<std::int16_t> default_gradient;  ///< packet 141, per mille
  // 3.12
  InplaceVector<TrackCondition, 48> conditions;
  InplaceVector<BigMetalMass, 40> big_metal;
  InplaceVector<Platform, 40> platforms;
  std::optional<TractionChange> traction;
  std::optional<CurrentChange> current;
  ConditionWatch watch;  ///< of these
  InplaceVector<RouteSuitability, 40> suitability;
  InplaceVector<AdhesionArea, 16> adhesion;
  InplaceVector<Text, 6> texts;
  // orders
  std::optional<RbcTransition> rbc_transition;
  std::optional<RadioInfillArea> radio_infill;
  std::optional<GroupList> sh_list, sr_list;
  std::optional<ReversingArea> reversing_area;
  std::optional<Place> reversing_reference;  ///< end of the area as received; shortening does not move it (3.15.4)
  std::optional<ReversingSupervision> reversing_supervision;
  InplaceVector<GeoReference, 32> geo;
  bool stop_shunting_on_desk_opening = false;  ///< packet 135
  bool generic_ls_marker = false;              ///< packet 181

  std::uint8_t next_text_id = 1;
  /// Increases with every change that affects speed and distance monitoring.
  std::uint32_t revision = 0;
};
static_assert(sizeof(Description) < 30 * 1024);

/// New data of a non-continuous profile: a list from a place on, or the return to the initial state there
/// (Q_TRACKINIT; 3.7.3.2).
template <class T, std::size_t N = 32>
struct Fresh {
  Place from{};
  bool initial_state = false;
  InplaceVector<T, N> elements;
};

/// The authority that one message brings, with what belongs to it.
struct AuthorityContents {
  std::optional<MovementAuthority> ma;
  bool ma_is_shortening_request = false;  ///< message 9: the proposed MA is acceptable (3.8.6)
  std::optional<SpeedCode> V_MAIN;        ///< packet 12; 0 is a trip order
  std::optional<ModeProfile> mode_profile;
  std::optional<GroupList> sh_list;
};

/// The contents of one message, already filtered (4.8) and in the track frame. They are evaluated together, in any
/// order of the packets (8.4.1.3).
struct Contents : AuthorityContents {
  Medium medium = Medium::balise;
  Duration time{};              ///< of the section timers: time stamp, or passage of the group's first balise
  std::optional<Place> infill;  ///< infill location reference of packet 136; then all contents are infill

  std::optional<Distance> repositioned_section;  ///< packet 16, from the group that sent it
  Place reference{};                             ///< of that group

  std::optional<NewStaticSpeedProfile> ssp;
  std::optional<NewGradientProfile> gradient;
  std::optional<Fresh<AxleLoadRestriction>> asp;
  std::optional<Fresh<PermittedBrakingDistance>> pbd;
  InplaceVector<TemporarySpeedRestriction, 32> tsr;
  InplaceVector<std::uint8_t, 32> revoked_tsr;
  bool inhibit_revocable_tsr = false;
  std::optional<std::int16_t> default_gradient;
  InplaceVector<LevelCrossing, 8> lx;

  std::optional<Fresh<TrackCondition>> conditions;
  std::optional<Fresh<BigMetalMass>> big_metal;
  std::optional<Fresh<Platform>> platforms;
  std::optional<TractionChange> traction;
  std::optional<CurrentChange> current;
  std::optional<Fresh<RouteSuitability>> suitability;
  std::optional<AdhesionArea> adhesion;
  InplaceVector<Text, 2> texts;

  std::optional<RbcTransition> rbc_transition;
  std::optional<RadioInfillArea> radio_infill;
  std::optional<ReversingArea> reversing_area;
  std::optional<ReversingSupervision> reversing_supervision;
  std::optional<InplaceVector<GeoReference, 32>> geo;
  bool stop_shunting_on_desk_opening = false;
  bool generic_ls_marker = false;

  // Not stored: these take effect at once.
  std::optional<bool> stop_if_in_sr;           ///< packet 137: true stop
  std::optional<bool> danger_for_shunting;     ///< packet 132: true stop
  std::optional<GroupId> track_ahead_free_to;  ///< packet 90: border group

  // Packets for which there was no room, and the nearest place from which restrictive data are missing.
  InplaceVector<std::uint8_t, 4> lost;
  std::optional<Place> lost_from;
  void lose(std::uint8_t packet) {
    for (const std::uint8_t known : lost)
      if (known == packet) return;
    (void)lost.push_back(packet);  // room for 65, 66, 88 and one of 72, 76
  }
  void lose(std::uint8_t packet, Place from) {
    lose(packet);
    if (!lost_from || from < *lost_from) lost_from = from;
  }
};

}  // namespace evc::track
