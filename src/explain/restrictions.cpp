#include <fmt/format.h>

#include <iterator>

#include "explain/origins.h"
#include "explain/words.h"
#include "kernel/basis.h"
#include "kernel/curves.h"
#include "kernel/here.h"
#include "kernel/train_category.h"
#include "terms/message_numbers.h"
#include "terms/packet_numbers.h"

// The parts of the MRSP and the targets of a moment.
namespace evc::explain {
namespace {

constexpr Speed kEqual{0.01 / 3.6};

std::optional<Step> packet_step(const Journal& journal, const Moment& m, std::int32_t packet) {
  return step_of_last(journal.last(What::packet_accepted, m.t_ms, packet));
}

/// Where a restriction ends on the track, and where the front end is when it no longer counts: with Q_FRONT 0 until the
/// rear end has left it (3.11.3.1.3).
struct End {
  Place on_track, counts;
};

/// Of a restriction that the front end has left and the rear end has not.
std::string rear_words(const Moment& m, const End& end, Place from) {
  return end.on_track < from && end.counts > end.on_track
             ? fmt::format(", until the rear end of the train of {} has left it", metres_words(m.after.train.L_TRAIN))
             : "";
}

/// A packet, and what there is to say of its element.
struct Found {
  std::optional<Step> step;
  std::string rear;
};

/// The packet that brought an element, among those that lie between two places and are as slow as `V`; of several the
/// last one. `speed` and `end` of an element: its speed for the train, and where it no longer counts.
template <class Elements, class Of, class Speed_, class EndOf>
Found slowest(const Journal& journal, const Moment& m, const Elements& elements, const Of& brought, Place from,
              Place to, Speed V, const Speed_& speed, const EndOf& end) {
  Found found;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i].from <= to && end(i).counts >= from && speed(i) <= V + kEqual)
      if (const Note* note = journal.note(brought.of(elements[i]))) {
        found = {step_of(*note), rear_words(m, end(i), from)};
        if (!found.rear.empty()) found.rear = " up to " + place_words(m.after, end(i).on_track) + found.rear;
      }
  return found;
}

/// The speeds and places of the restrictions of a moment.
struct Stored {
  const Journal& journal;
  const Moment& m;
  Place from, to;
  Speed V;
  const track::Description& d = m.after.track;
  track::TrainCategory train = kernel::category_of(m.after.train);

  /// A restriction counts until the rear end has left it, unless it is of the front end (Q_FRONT).
  End left(Place end, bool Q_FRONT) const { return {end, Q_FRONT ? end : end + m.after.train.L_TRAIN}; }

  Found ssp() const {
    const auto& steps = d.ssp.steps;
    const auto end = [&](std::size_t i) {
      return i + 1 < steps.size() ? left(steps[i + 1].from, steps[i].value.Q_FRONT) : End{to, to};
    };
    const auto speed = [&](std::size_t i) { return track::speed_of(steps[i].value.speed_for(train)); };
    return slowest(journal, m, steps, journal.brought().ssp, from, to, V, speed, end);
  }
  Found asp() const {
    const auto end = [&](std::size_t i) { return left(d.asp[i].to, d.asp[i].Q_FRONT); };
    const auto speed = [&](std::size_t i) { return track::speed_of(d.asp[i].speed_for(train)); };
    return slowest(journal, m, d.asp, journal.brought().asp, from, to, V, speed, end);
  }
  Found pbd() const {
    const auto& speeds = m.curves.pbd_speeds;
    const auto speed = [&](std::size_t i) { return i < speeds.size() ? track::speed_of(speeds[i]) : track::kNoLimit; };
    return slowest(journal, m, d.pbd, journal.brought().pbd, from, to, V, speed, [&](std::size_t i) {
      return End{d.pbd[i].to, d.pbd[i].to};
    });
  }
  std::optional<Step> lx() const {
    const auto speed = [&](std::size_t i) {
      return d.lx[i].substituted ? track::speed_of(d.lx[i].V_LX) : track::kNoLimit;
    };
    std::optional<Step> step;
    for (std::size_t i = 0; i < d.lx.size(); ++i)
      if (d.lx[i].V_LX_from <= to && d.lx[i].to >= from && speed(i) <= V + kEqual) {
        if (const Note* note = journal.note(journal.brought().lx.of(d.lx[i]))) step = step_of(*note);
        const Note* instead = journal.last(What::level_crossing_speed, m.t_ms, std::int32_t{d.lx[i].NID_LX});
        if (step)
          step->text += fmt::format(
              ": level crossing {} is not protected{}", d.lx[i].NID_LX,
              instead == nullptr
                  ? ""
                  : fmt::format(", its speed instead of the stop since {} (5.16.2)", time_words(instead->t_ms)));
      }
    return step;
  }
};

const char* national_speed(Mode mode) {
  switch (mode) {
    case Mode::SR:
      return "V_NVSTFF";
    case Mode::OS:
      return "V_NVONSIGHT";
    case Mode::LS:
      return "V_NVLIMSUPERV";
    case Mode::SH:
      return "V_NVSHUNT";
    case Mode::UN:
      return "V_NVUNFIT";
    default:
      return "of the mode";
  }
}

/// Whether the speed is that of an area of packet 80, not the national one.
bool of_area(const kernel::State& s) {
  if (s.mode == Mode::SH) return s.V_SH != track::kNoSpeed;  // the area itself is deleted (4.10)
  const auto area = kernel::area_of_mode(s, kernel::here(s));
  return area && area->V_MAMODE != track::kNoSpeed;
}

/// The speed of the mode: of its area, of reversing, of the authorisation for SM, entered by the driver, or the
/// national one.
Restriction mode_limit(const Journal& journal, const Moment& m, Speed V) {
  const Mode mode = m.after.mode;
  Restriction r{MrspSource::mode, V, fmt::format("{} of mode {}", kmh_words(V), name(mode)), {}};
  if (of_area(m.after)) {
    const auto area = kernel::area_of_mode(m.after, kernel::here(m.after));
    const Note* note = area ? journal.note(journal.brought().areas.of(*area)) : nullptr;
    r.from = note != nullptr ? step_of(*note) : packet_step(journal, m, packet::mode_profile);
  }
  if (mode == Mode::RV) r.from = packet_step(journal, m, packet::reversing_supervision);
  if (const Note* note = journal.last(What::message_accepted, m.t_ms, std::int32_t{message::sm_authorised});
      mode == Mode::SM && note != nullptr)
    r.from = Step{note->t_ms, message_words(message::sm_authorised), ""};
  const Act* entered = journal.last(Act::Kind::SR_speed, m.t_ms);
  if (mode == Mode::SR && m.after.staff_responsible.V && entered != nullptr) r.from = step_of(*entered);
  if (r.from || mode == Mode::RV) return r;
  r.from = national_values_step(journal, m.t_ms, national_speed(mode), "A.3.2");
  return r;
}

Restriction of_source(const Journal& journal, const Moment& m, MrspSource source, Place from, Place to, Speed V) {
  Restriction r{
      source, V, fmt::format("{} of {}", terms::kNames<kMrspSourceRows>[terms::index(source)], kmh_words(V)), {}};
  const Stored stored{journal, m, from, to, V};
  const auto add = [&r](Found found) {
    r.from = std::move(found.step);
    r.text += found.rear;
  };
  switch (source) {
    case MrspSource::SSP:
      add(stored.ssp());
      return r;
    case MrspSource::ASP:
      add(stored.asp());
      return r;
    case MrspSource::TSR:
      for (const track::TemporarySpeedRestriction& t : m.after.track.tsr) {
        const End end = stored.left(t.to, t.Q_FRONT);
        if (t.from > to || end.counts < from || track::speed_of(t.V_TSR) > V + kEqual) continue;
        r.text = fmt::format("TSR {} of {} from {} to {}", t.NID_TSR, kmh_words(track::speed_of(t.V_TSR)),
                             place_words(m.after, t.from), place_words(m.after, t.to)) +
                 rear_words(m, end, from);
        r.from = step_of_last(journal.note(journal.brought().tsr.of(t)));
      }
      return r;
    case MrspSource::PBD:
      add(stored.pbd());
      return r;
    case MrspSource::LX:
      r.from = stored.lx();
      return r;
    case MrspSource::signalling:
      r.from = packet_step(journal, m, packet::level_1_movement_authority);
      return r;
    case MrspSource::train:
      r.text = fmt::format("{} of the train", kmh_words(V));
      if (const Note* note = journal.last(What::train_data_valid, m.t_ms)) r.from = step_of(*note);
      return r;
    case MrspSource::mode:
      return mode_limit(journal, m, V);
    default:
      // 3.11.10: a national value, as long as override is active.
      r.text = fmt::format("{} of override", kmh_words(V));
      if (const Note* note = journal.last(What::override_active, m.t_ms))
        r.text += fmt::format(" since {}", time_words(note->t_ms));
      r.from = national_values_step(journal, m.t_ms, "V_NVSUPOVTRP", "A.3.2");
      return r;
  }
}

}  // namespace

const char* clause_of(MrspSource source) {
  // In the order of MrspSource.
  constexpr const char* kClauses[] = {"3.11.3", "3.11.4", "3.11.5", "3.11.11", "3.11.9",
                                      "3.11.6", "3.11.8", "3.11.7", "3.11.10"};
  static_assert(std::size(kClauses) == terms::index(MrspSource::count));
  return kClauses[terms::index(source)];
}

Step step_of(const Restriction& r) {
  const std::string clause = clause_of(r.source);
  return r.from ? Step{r.from->t_ms, r.from->text + ": " + r.text, clause} : Step{{}, r.text, clause};
}

std::vector<Restriction> restrictions(const Journal& journal, const Moment& m, Place from, Place to, Speed V) {
  std::vector<Restriction> out;
  for (std::size_t i = 0; i < terms::index(MrspSource::count); ++i) {
    const auto source = static_cast<MrspSource>(i);
    track::Mrsp part;
    kernel::mrsp_of(source, part, m.after, m.curves, m.after.basis);
    if (sdm::V_MRSP(part, from, to) <= V + kEqual) out.push_back(of_source(journal, m, source, from, to, V));
  }
  return out;
}

std::string target_words(const Moment& m, const sdm::TargetId& target) {
  const std::string at = place_words(m.after, target.d_target);
  switch (target.kind) {
    case sdm::TargetKind::EOA_SvL:
      return "EOA at " + at;
    case sdm::TargetKind::LOA:
      return fmt::format("LOA of {} at {}", kmh_words(target.V_target), at);
    case sdm::TargetKind::SR_end:
      return "end of the SR distance at " + at;
    default:
      return fmt::format("{} at {}", kmh_words(target.V_target), at);
  }
}

std::string target_distance_words(const Moment& m, const sdm::TargetId& target) {
  const track::Here here = kernel::here(m.after);
  const auto ahead = [](Place at, Place front) {
    return at > front ? metres_words(at - front) + " ahead" : std::string("passed");
  };
  if (target.kind != sdm::TargetKind::EOA_SvL)
    return target_words(m, target) +
           (target.d_target > here.max_safe_front
                ? ", " + ahead(target.d_target, here.max_safe_front) + " of the max safe front end"
                : ", passed by the max safe front end");
  const std::string EOA = fmt::format("{}, {}", target_words(m, target), ahead(target.d_target, here.est_front));
  const auto& SvL = m.after.basis.authority.SvL;
  if (!SvL) return EOA;
  const std::string at = *SvL == target.d_target ? " there" : " at " + place_words(m.after, *SvL);
  return *SvL > here.max_safe_front
             ? fmt::format("{}; SvL{}, {} of the max safe front end", EOA, at, ahead(*SvL, here.max_safe_front))
             : fmt::format("{}; SvL{}, passed by the max safe front end", EOA, at);
}

Steps target_steps(const Journal& journal, const Moment& m, const sdm::TargetId& target) {
  if (target.kind == sdm::TargetKind::SR_end) {
    Step step = SR_distance_step(journal, m);
    step.text += ", " + target_words(m, target);
    return {step};
  }
  if (target.kind != sdm::TargetKind::MRSP) return authority_steps(journal, m);
  Steps steps;
  for (const Restriction& r : restrictions(journal, m, target.d_target, target.d_target, target.V_target))
    steps.push_back(step_of(r));
  return steps;
}

}  // namespace evc::explain
