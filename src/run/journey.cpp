#include "run/journey.h"

#include <algorithm>
#include <cmath>

#include "io/output_lines.h"
#include "terms/message_numbers.h"

namespace evc::run {
namespace {

using kernel::Outputs;

double kmh(const std::optional<Speed>& v) { return v ? v->si * 3.6 : Sample::none; }

Sample sample_of(double t_s, double x_m, const Outputs& o) {
  Sample s;
  s.t_s = t_s;
  s.x_m = x_m;
  s.v = o.v.si * 3.6;
  s.mrsp = kmh(o.V_MRSP);
  s.p = kmh(o.V_P);
  s.w = kmh(o.V_W);
  s.sbi = kmh(o.V_SBI);
  s.ebi = kmh(o.V_EBI);
  s.target = kmh(o.V_target);
  s.d_target = o.d_target ? o.d_target->si : Sample::none;
  s.release = kmh(o.V_release);
  s.mode = static_cast<std::uint8_t>(o.mode);
  s.level = static_cast<std::uint8_t>(o.level);
  s.monitoring = static_cast<std::uint8_t>(o.monitoring);
  s.status = static_cast<std::uint8_t>(o.status);
  s.brakes = static_cast<std::uint8_t>((o.tco ? 1 : 0) | (o.sb ? 2 : 0) | (o.eb ? 4 : 0));
  return s;
}

}  // namespace

void Journey::record(const sim::CycleInputs& inputs, const Outputs& outputs, const Truth& truth) {
  const double t_s = static_cast<double>(inputs.t_ms) / 1000.0;
  ++cycles_;
  if (keep_ == Keep::measures) samples_.clear();
  samples_.push_back(sample_of(t_s, truth.front_m, outputs));
  telegrams_in_cycle_ = !inputs.balises.empty();
  course_.record(outputs);
  if (truth.reached) note_position(outputs, truth.front_m);
  note_events(outputs);
  count_messages(outputs, truth.deliveries);
}

/// The true position compared with that of the on-board, both measured from its reference group.
void Journey::note_position(const Outputs& o, double front) {
  const auto reference = o.lrbg ? world_.reference(*o.lrbg) : std::nullopt;
  if (!reference) return;
  const auto on_line = [&](OdometerPlace p) {
    return reference->position_m + (p.from_origin.si - reference->nominal_m);
  };
  max_position_error_ = std::max(max_position_error_, std::abs(on_line(o.est_front) - front));
  // A tolerance of a millimetre for the rounding of the counters.
  if (on_line(o.min_safe_front) > front + 1e-3 || on_line(o.max_safe_front) < front - 1e-3) ++violations_;
  const bool tripped = o.mode == Mode::TR || o.mode == Mode::PT;
  if (o.SvL)
    svl_m_ = on_line(*o.SvL);
  else if (!tripped)
    svl_m_.reset();
  if (svl_m_ && front > *svl_m_) svl_overrun_ = std::max(svl_overrun_.value_or(0.0), front - *svl_m_);
}

void Journey::note_events(const Outputs& o) {
  for (const kernel::Event& event : o.events) {
    count(event);
    if (keep_ == Keep::measures) continue;
    JourneyEvent e{samples_.back().t_s, samples_.back().x_m, {}};
    io::append_event(e.text, event);
    events_.push_back(std::move(e));
  }
}

/// The events of balise groups.
void Journey::count(const kernel::Event& e) {
  switch (e.what) {
    case What::linking_ok:
      ++counts_.groups_linked_ok;
      return;
    case What::linking_error_missed:
    case What::linking_error_later:
      ++counts_.groups_missed;
      return;
    case What::group_inconsistent:
    case What::linking_error_early:
    case What::group_wrong_direction:
      ++counts_.groups_rejected;
      return;
    case What::telegram_not_decoded:
      ++counts_.telegrams_rejected;
      return;
    default:
      return;
  }
}

namespace {

/// The result for a message or an authority: a result for packet 12 is one for the authority it contains.
enum class Fate : std::uint8_t { unknown, accepted, refused, rejected };

/// A message in a transition buffer has passed the checks and filters.
std::optional<Fate> fate_of_message(What what) {
  switch (what) {
    case What::message_accepted:
    case What::message_buffered:
      return Fate::accepted;
    case What::message_refused:
      return Fate::refused;
    case What::message_rejected:
      return Fate::rejected;
    case What::message_unknown:
      return Fate::unknown;
    default:
      return std::nullopt;
  }
}

bool is_verdict_on_packet(What what) {
  return what == What::packet_accepted || what == What::packet_buffered || what == What::packet_refused ||
         what == What::packet_kept || what == What::packet_contact_stored || what == What::packet_not_used ||
         what == What::packet_no_room || what == What::packet_shortened;
}

}  // namespace

/// The results for the messages that came with the inputs of this cycle, up to number `delivered`: for each one, the
/// first event of its number that does not belong to another one.
void Journey::count_messages(const Outputs& outputs, std::size_t delivered) {
  struct Verdict {
    std::int32_t NID_MESSAGE;
    Fate fate;
  };
  std::vector<Verdict> verdicts;
  bool authority_refused = false;
  const kernel::Event* authority_by_balise = nullptr;
  for (const kernel::Event& e : outputs.events) {
    if (const auto fate = fate_of_message(e.what)) verdicts.push_back({e.id, *fate});
    if (e.what == What::authority_refused) authority_refused = true;
    if (is_verdict_on_packet(e.what) && e.id == 12) authority_by_balise = &e;
  }
  const auto& deliveries = world_.radio().deliveries();
  for (; next_delivery_ < delivered; ++next_delivery_) {
    const sim::Delivery& d = deliveries[next_delivery_];
    const auto verdict = std::find_if(verdicts.begin(), verdicts.end(),
                                      [&](const Verdict& v) { return v.NID_MESSAGE == d.NID_MESSAGE; });
    const Fate fate = verdict == verdicts.end() ? Fate::unknown : verdict->fate;
    if (verdict != verdicts.end()) verdicts.erase(verdict);
    if (d.seq < 0) continue;
    if (fate == Fate::accepted) ++counts_.messages_accepted;
    if (fate == Fate::refused) ++counts_.messages_refused;
    if (fate == Fate::rejected) ++counts_.messages_rejected;
    if (d.NID_MESSAGE != message::movement_authority && d.NID_MESSAGE != message::movement_authority_shifted) continue;
    ++counts_.authorities_received;
    if (fate == Fate::accepted && !authority_refused) ++counts_.authorities_accepted;
  }
  // A buffered one that is released in a later cycle was counted at reception.
  if (authority_by_balise == nullptr || !telegrams_in_cycle_) return;
  ++counts_.authorities_received;
  if ((authority_by_balise->what == What::packet_accepted && !authority_refused) ||
      authority_by_balise->what == What::packet_buffered)
    ++counts_.authorities_accepted;
}

}  // namespace evc::run
