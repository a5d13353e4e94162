#include "track/from_packets.h"

#include <new>
#include <tuple>

#include "lang/decode.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_141.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_16.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_52.h"
#include "lang/packets/packet_64.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "lang/si.h"
#include "lang/translate.h"
#include "terms/packet_numbers.h"
#include "track/from_packets_parts.h"

namespace evc::track {
namespace {

using lang::Fault;
using lang::metres;

Release release_of(unsigned code) {
  if (code == 126) return {ReleaseSpeedChoice::on_board, {}};
  if (code == 127) return {ReleaseSpeedChoice::national, {}};
  return {ReleaseSpeedChoice::value, speed_of(static_cast<SpeedCode>(code))};
}

template <class P>
Section section_of(const P& p, lang::var::Q_SCALE scale, Place begin, Distance length, Duration time) {
  Section section;
  section.begin = begin;
  section.end = begin + length;
  section.timed = p.Q_SECTIONTIMER.raw == 1;
  if (section.timed) {
    section.stop = begin + metres(scale, p.D_SECTIONTIMERSTOPLOC);
    section.timer = {lang::seconds(p.T_SECTIONTIMER), time, true};
  }
  return section;
}

/// Packets 12 and 15 have the same form, except for V_MAIN (3.8.3).
template <class P>
MovementAuthority& take_authority(AuthorityContents& c, Duration time, const P& p, const Reference& r) {
  MovementAuthority& ma = c.ma.emplace();
  Place at = r.place;
  for (const auto& s : p.sections) {
    // 31 sections and the last one fit.
    (void)ma.sections.push_back(section_of(s, p.Q_SCALE, at, metres(p.Q_SCALE, s.L_SECTION), time));
    at = ma.sections.back().end;
  }
  (void)ma.sections.push_back(section_of(p, p.Q_SCALE, at, metres(p.Q_SCALE, p.L_ENDSECTION), time));
  const Place end = ma.end();
  ma.V_LOA = speed_of(p.V_EMA.raw);
  if (ma.limited()) ma.loa_timer = {lang::seconds(p.T_EMA), time, true};
  if (p.Q_ENDTIMER.raw == 1)
    ma.end_section =
        EndSectionTimer{end - metres(p.Q_SCALE, p.D_ENDTIMERSTARTLOC), {lang::seconds(p.T_ENDTIMER), {}, false}};
  if (p.Q_DANGERPOINT.raw == 1)
    ma.danger_point = DangerPoint{end + metres(p.Q_SCALE, p.D_DP), release_of(p.V_RELEASEDP.raw)};
  if (p.Q_OVERLAP.raw == 1)
    ma.overlap = Overlap{end - metres(p.Q_SCALE, p.D_STARTOL),
                         end + metres(p.Q_SCALE, p.D_OL),
                         {lang::seconds(p.T_OL), {}, false},
                         release_of(p.V_RELEASEOL.raw)};
  return ma;
}

void take(AuthorityContents& c, Duration time, const lang::Packet12& p, const Reference& r) {
  take_authority(c, time, p, r).level_1 = true;
  c.V_MAIN = p.V_MAIN.raw;
}
void take(AuthorityContents& c, Duration time, const lang::Packet15& p, const Reference& r) {
  (void)take_authority(c, time, p, r);
}

void take(AuthorityContents& c, Duration, const lang::Packet80& p, const Reference& r) {
  ModeProfile& profile = c.mode_profile.emplace();
  Place at = r.place;
  const auto append = [&](const lang::Packet80_modes& m) {
    at = at + metres(p.Q_SCALE, m.D_MAMODE);
    ModeArea area;
    area.from = at;
    area.mode = mode_of_area(m.M_MAMODE.raw);
    const std::optional<Distance> length = metres(p.Q_SCALE, m.L_MAMODE);
    // The length of a shunting area is not used: SH is left by its own rules (3.12.4.2).
    if (length && area.mode != Mode::SH) area.to = at + *length;
    if (m.V_MAMODE.raw <= 120) area.V_MAMODE = m.V_MAMODE.raw;
    area.ack_from = at - metres(p.Q_SCALE, m.L_ACKMAMODE);
    area.also_SvL = m.Q_MAMODE.raw == 1;
    (void)profile.push_back(area);
  };
  append(p.first_modes());
  for (const auto& m : p.modes) append(m);
}

void take(Contents& c, const lang::Packet16& p, const Reference& r) {
  c.repositioned_section = metres(p.Q_SCALE, p.L_SECTION);
  c.reference = r.place;
}

void take(Contents& c, const lang::Packet21& p, const Reference& r) {
  NewGradientProfile& profile = c.gradient.emplace();
  Place at = r.place;
  const auto append = [&](const lang::Packet21_steps& step) {
    at = at + metres(p.Q_SCALE, step.D_GRADIENT);
    Gradient gradient;
    if (step.G_A.raw <= lang::var::G_A::max)
      gradient.permille = static_cast<std::int16_t>(step.Q_GDIR.raw == 1 ? step.G_A.raw : -step.G_A.raw);
    profile.append(at, gradient);
  };
  append(p.first_steps());
  for (const auto& step : p.steps) append(step);
}

void limit_to(SpeedCode& stored, unsigned code) {
  if (code < stored) stored = static_cast<SpeedCode>(code);
}

StaticSpeed element_of(const lang::Packet27_steps& step) {
  StaticSpeed element;
  element.V_STATIC = step.V_STATIC.raw;
  element.Q_FRONT = step.Q_FRONT.raw == 1;
  for (const auto& diff : step.diffs) {
    if (diff.Q_DIFF.raw == 0) {
      // The code is the index of the class in the rising order of 3.11.3.2.2.
      if (diff.NC_CDDIFF.raw < element.cd.size()) limit_to(element.cd[diff.NC_CDDIFF.raw], diff.V_DIFF.raw);
    } else if (diff.NC_DIFF.raw < element.other.size()) {
      limit_to(element.other[diff.NC_DIFF.raw], diff.V_DIFF.raw);
      if (diff.Q_DIFF.raw == 1)
        element.replaces_cd = static_cast<std::uint8_t>(element.replaces_cd | (1u << diff.NC_DIFF.raw));
    }
  }
  return element;
}

/// 6.6.3.2.3 [3]: the lowest cant deficiency category for which a profile of X = 1 has speeds, above all where it has
/// none: "other" categories replace the basic speed for trains below it. 0 for a profile of X = 2.
std::uint8_t replaces_below(const lang::Packet27& p) {
  bool by_train = false;
  std::uint8_t lowest = std::tuple_size_v<decltype(StaticSpeed::cd)>;
  const auto look = [&](const auto& diffs) {
    for (const auto& diff : diffs) {
      by_train = by_train || diff.Q_DIFF.raw == lang::kQ_DIFF_by_train;
      if (diff.Q_DIFF.raw == 0 && diff.NC_CDDIFF.raw < lowest) lowest = static_cast<std::uint8_t>(diff.NC_CDDIFF.raw);
    }
  };
  look(p.diffs);
  for (const auto& step : p.steps) look(step.diffs);
  return by_train ? lowest : std::uint8_t{0};
}

void take(Contents& c, const lang::Packet27& p, const Reference& r) {
  NewStaticSpeedProfile& profile = c.ssp.emplace();
  Place at = r.place;
  const std::uint8_t below = replaces_below(p);
  const auto append = [&](const lang::Packet27_steps& step) {
    at = at + metres(p.Q_SCALE, step.D_STATIC);
    StaticSpeed element = element_of(step);
    element.replaces_below = below;
    profile.append(at, element);
  };
  append(p.first_steps());
  for (const auto& step : p.steps) append(step);
}

void take(Contents& c, const lang::Packet51& p, const Reference& r) {
  Fresh<AxleLoadRestriction>& fresh = c.asp.emplace();
  if (p.Q_TRACKINIT.raw == 1) {
    fresh.initial_state = true;
    fresh.from = r.place + metres(p.Q_SCALE, p.D_TRACKINIT);
    return;
  }
  Place at = r.place;
  const auto append = [&](const lang::Packet51_restrictions& e) {
    at = at + metres(p.Q_SCALE, e.D_AXLELOAD);
    AxleLoadRestriction element;
    element.from = at;
    element.to = at + metres(p.Q_SCALE, e.L_AXLELOAD);
    element.Q_FRONT = e.Q_FRONT.raw == 1;
    for (const auto& category : e.categories)
      if (category.M_AXLELOADCAT.raw < element.V_AXLELOAD.size())
        limit_to(element.V_AXLELOAD[category.M_AXLELOADCAT.raw], category.V_AXLELOAD.raw);
    (void)fresh.elements.push_back(element);  // one and 31 further ones fit
  };
  append(p.first_restrictions());
  fresh.from = at;
  for (const auto& e : p.restrictions) append(e);
}

void take(Contents& c, const lang::Packet52& p, const Reference& r) {
  Fresh<PermittedBrakingDistance>& fresh = c.pbd.emplace();
  if (p.Q_TRACKINIT.raw == 1) {
    fresh.initial_state = true;
    fresh.from = r.place + metres(p.Q_SCALE, p.D_TRACKINIT);
    return;
  }
  Place at = r.place;
  const auto append = [&](const lang::Packet52_restrictions& e) {
    at = at + metres(p.Q_SCALE, e.D_PBDSR);
    PermittedBrakingDistance element;
    element.from = at;
    element.to = at + metres(p.Q_SCALE, e.L_PBDSR);
    element.D_PBD = metres(p.Q_SCALE, e.D_PBD);
    element.gradient_permille = static_cast<std::int16_t>(e.Q_GDIR.raw == 1 ? e.G_PBDSR.raw : -e.G_PBDSR.raw);
    element.service_brake = e.Q_PBDSR.raw == 1;
    (void)fresh.elements.push_back(element);
  };
  append(p.first_restrictions());
  fresh.from = at;
  for (const auto& e : p.restrictions) append(e);
}

void take(Contents& c, const lang::Packet65& p, const Reference& r) {
  TemporarySpeedRestriction tsr;
  tsr.from = r.place + metres(p.Q_SCALE, p.D_TSR);
  tsr.to = tsr.from + metres(p.Q_SCALE, p.L_TSR);
  tsr.NID_TSR = p.NID_TSR.raw;
  tsr.Q_FRONT = p.Q_FRONT.raw == 1;
  tsr.V_TSR = p.V_TSR.raw;
  tsr.from_rbc = r.medium == Medium::rbc;
  if (c.tsr.push_back(tsr)) return;
  cover(c.tsr.back(), tsr);
  c.lose(packet::temporary_speed_restriction);
}
void take(Contents& c, const lang::Packet66& p, const Reference&) {
  if (!c.revoked_tsr.push_back(p.NID_TSR.raw)) c.lose(packet::tsr_revocation);  // the restriction is kept
}
void take(Contents& c, const lang::Packet64&, const Reference&) { c.inhibit_revocable_tsr = true; }
void take(Contents& c, const lang::Packet141& p, const Reference&) {
  c.default_gradient = static_cast<std::int16_t>(p.Q_GDIR.raw == 1 ? p.G_TSR.raw : -p.G_TSR.raw);
}

void take(Contents& c, const lang::Packet88& p, const Reference& r) {
  LevelCrossing lx;
  lx.from = r.place + metres(p.Q_SCALE, p.D_LX);
  lx.to = lx.from + metres(p.Q_SCALE, p.L_LX);
  lx.NID_LX = p.NID_LX.raw;
  lx.unprotected = p.Q_LXSTATUS.raw == 1;
  if (lx.unprotected) {
    lx.V_LX = p.V_LX.raw;
    lx.stop_required = p.Q_STOPLX.raw == 1;
    if (lx.stop_required) lx.L_STOPLX = metres(p.Q_SCALE, p.L_STOPLX);
  }
  if (c.lx.push_back(lx)) return;
  c.lose(packet::level_crossing);
  if (lx.unprotected) c.lose(packet::level_crossing, lx.from);
}

Added added_if(Fault fault) {
  return fault == Fault::none ? Added::added : fault == Fault::not_applicable ? Added::not_stored_here : Added::faulty;
}
template <class P>
Added decode_and_take(Contents& c, const lang::PacketView& view, const Reference& r) {
  P packet;
  const Fault fault = lang::decode(view, packet);
  if (fault == Fault::none) take(c, packet, r);
  return added_if(fault);
}
template <class P>
Added decode_and_take(AuthorityContents& c, Duration time, const lang::PacketView& view, const Reference& r) {
  P packet;
  const Fault fault = lang::decode(view, packet);
  if (fault == Fault::none) take(c, time, packet, r);
  return added_if(fault);
}

}  // namespace

bool valid_direction(std::uint8_t Q_DIR, Direction orientation) {
  if (Q_DIR == 2) return true;
  if (orientation == Direction::unknown) return false;
  return (Q_DIR == 1) == (orientation == Direction::nominal);
}

Reference shifted(const Reference& reference, Distance D_REF) {
  Reference r = reference;
  r.place = r.place + (r.orientation == Direction::reverse ? -D_REF : D_REF);
  return r;
}

std::optional<Place> stop_location(const lang::Message15& message, const Reference& lrbg) {
  if (!valid_direction(message.Q_DIR.raw, lrbg.orientation)) return std::nullopt;
  return shifted(lrbg, metres(message.Q_SCALE, message.D_REF)).place + metres(message.Q_SCALE, message.D_EMERGENCYSTOP);
}

void begin(Contents& contents, const Reference& reference, Duration time, const std::optional<Place>& infill) {
  new (&contents) Contents;
  contents.medium = reference.medium;
  contents.time = time;
  contents.infill = infill;
  contents.reference = reference.place;
}

Added add(AuthorityContents& contents, Duration time, const lang::PacketView& view, const Reference& reference) {
  if (!valid_direction(view.Q_DIR, reference.orientation)) return Added::other_direction;
  switch (view.NID_PACKET) {
    case packet::level_1_movement_authority:
      return decode_and_take<lang::Packet12>(contents, time, view, reference);
    case packet::level_2_3_movement_authority:
      return decode_and_take<lang::Packet15>(contents, time, view, reference);
    case packet::mode_profile:
      return decode_and_take<lang::Packet80>(contents, time, view, reference);
    case packet::balise_groups_for_sh_area:
      return add_sh_list(contents, view, reference);
    default:
      return Added::not_stored_here;
  }
}

Added add(Contents& contents, const lang::PacketView& view, const Reference& reference) {
  if (!valid_direction(view.Q_DIR, reference.orientation)) return Added::other_direction;
  contents.medium = reference.medium;
  switch (view.NID_PACKET) {
    case packet::level_1_movement_authority:
    case packet::level_2_3_movement_authority:
    case packet::mode_profile:
    case packet::balise_groups_for_sh_area:
      return add(contents, contents.time, view, reference);
    case packet::repositioning_information:
      return decode_and_take<lang::Packet16>(contents, view, reference);
    case packet::gradient_profile:
      return decode_and_take<lang::Packet21>(contents, view, reference);
    case packet::static_speed_profile:
      return decode_and_take<lang::Packet27>(contents, view, reference);
    case packet::axle_load_speed_profile:
      return decode_and_take<lang::Packet51>(contents, view, reference);
    case packet::permitted_braking_distance:
      return decode_and_take<lang::Packet52>(contents, view, reference);
    case packet::inhibition_of_revocable_tsr:
      return decode_and_take<lang::Packet64>(contents, view, reference);
    case packet::temporary_speed_restriction:
      return decode_and_take<lang::Packet65>(contents, view, reference);
    case packet::tsr_revocation:
      return decode_and_take<lang::Packet66>(contents, view, reference);
    case packet::level_crossing:
      return decode_and_take<lang::Packet88>(contents, view, reference);
    case packet::default_gradient_for_tsr:
      return decode_and_take<lang::Packet141>(contents, view, reference);
    default:
      break;
  }
  const Added condition = add_condition(contents, view, reference);
  return condition == Added::not_stored_here ? add_order(contents, view, reference) : condition;
}

}  // namespace evc::track
