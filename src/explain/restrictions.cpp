#include <fmt/format.h>

#include <iterator>

#include "explain/origins.h"
#include "explain/words.h"
#include "kernel/curves.h"
#include "kernel/here.h"
#include "terms/packet_numbers.h"

// The parts of the MRSP and the targets of a moment.
namespace evc::explain {
namespace {

constexpr Speed kEqual{0.01 / 3.6};

std::optional<Step> packet_step(const Journal& journal, const Moment& m, std::int32_t packet) {
  const Note* note = journal.last(What::packet_accepted, m.t_ms, packet);
  return note == nullptr ? std::nullopt : std::optional(step_of(*note));
}

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
  const auto area = track::area_due(s.track, kernel::here(s));
  return area && area->mode == s.mode && area->V_MAMODE != track::kNoSpeed;
}

/// The speed of the mode: of its area, of reversing, entered by the driver, or the national one.
Restriction mode_limit(const Journal& journal, const Moment& m, Speed V) {
  const Mode mode = m.after.mode;
  Restriction r{MrspSource::mode, V, fmt::format("{} of mode {}", kmh_words(V), name(mode)), {}};
  if (of_area(m.after)) r.from = packet_step(journal, m, packet::mode_profile);
  if (mode == Mode::RV) r.from = packet_step(journal, m, packet::reversing_supervision);
  const Act* entered = journal.last(Act::Kind::SR_speed, m.t_ms);
  if (mode == Mode::SR && m.after.staff_responsible.V && entered != nullptr) r.from = step_of(*entered);
  if (r.from || mode == Mode::RV) return r;
  r.from = national_values_step(journal, m.t_ms);
  r.from->text += fmt::format(": {}", national_speed(mode));
  r.from->clause = "A.3.2";
  return r;
}

Restriction of_source(const Journal& journal, const Moment& m, MrspSource source, Place from, Place to, Speed V) {
  Restriction r{
      source, V, fmt::format("{} of {}", terms::kNames<kMrspSourceRows>[terms::index(source)], kmh_words(V)), {}};
  switch (source) {
    case MrspSource::SSP:
      r.from = packet_step(journal, m, packet::static_speed_profile);
      return r;
    case MrspSource::ASP:
      r.from = packet_step(journal, m, packet::axle_load_speed_profile);
      return r;
    case MrspSource::TSR:
      for (const track::TemporarySpeedRestriction& t : m.after.track.tsr) {
        const Place end = t.Q_FRONT ? t.to : t.to + m.after.train.L_TRAIN;
        if (t.from > to || end < from || track::speed_of(t.V_TSR) > V + kEqual) continue;
        r.text = fmt::format("TSR {} of {} from {} to {}", t.NID_TSR, kmh_words(track::speed_of(t.V_TSR)),
                             place_words(m.after, t.from), place_words(m.after, t.to));
        if (const Note* note = journal.of_tsr(t.NID_TSR, t.V_TSR)) r.from = step_of(*note);
      }
      return r;
    case MrspSource::PBD:
      r.from = packet_step(journal, m, packet::permitted_braking_distance);
      return r;
    case MrspSource::LX:
      r.from = packet_step(journal, m, packet::level_crossing);
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
      r.text = fmt::format("{} of override", kmh_words(V));
      if (const Note* note = journal.last(What::override_active, m.t_ms)) r.from = step_of(*note);
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
