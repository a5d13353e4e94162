#include "check/journey.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/rules.h"
#include "kernel/intake/levels.h"
#include "kernel/intake/routes.h"
#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_66.h"
#include "lang/si.h"
#include "terms/message_numbers.h"
#include "terms/packet_numbers.h"

namespace evc::check {
namespace {

using enum Severity;
using kernel::Turn;

/// Data this far behind the front end are not needed any more.
constexpr Distance kBehind{3000.0};

Place place(double metres) { return Place{Distance{metres}}; }

/// A train that is fitted with every level and has every national system.
modes::AvailableLevels every_level() {
  modes::AvailableLevels available;
  available.national_systems.fill(~std::uint64_t{0});
  return available;
}

track::Here here_at(Place front) {
  track::Here here;
  here.est_front = here.min_safe_front = here.max_safe_front = here.min_safe_antenna = front;
  here.min_safe_rear = front - kBehind;
  return here;
}

/// Of two balises with the same information one counts (3.16.2.4.8): M_DUP 2 marks the duplicate of the one before it.
bool counts(const Telegram& telegram) {
  return telegram.view.fault == lang::Fault::none && telegram.view.M_DUP.raw != 2;
}

}  // namespace

Journey::Journey(const Trackside& trackside, Findings& out)
    : trackside_(trackside),
      out_(out),
      by_linking_(trackside.groups.size()),
      stored_(std::make_unique<track::Description>()),
      contents_(std::make_unique<track::Contents>()) {
  level_.level = trackside.line->start_level;
  if (level_.level == Level::NTC) level_.nid_ntc = trackside.line->start_nid_ntc;
}

void Journey::run() {
  auto message = trackside_.messages.begin();
  const auto deliver_before = [&](double front_m) {
    for (; message != trackside_.messages.end() && message->sent->position_m < front_m; ++message) receive(*message);
  };
  for (const Group& group : trackside_.groups) {
    deliver_before(group.last_m());
    pass(group);
  }
  deliver_before(1e300);
}

void Journey::advance(Place front) {
  if (pending_ && modes::border_reached(*pending_, front)) {
    level_ = pending_->to;
    pending_.reset();
  }
  // The stores have a fixed capacity; a train deletes what it has left behind, too (A.3.6).
  stored_->ssp.forget_before(front - kBehind);
  stored_->gradient.forget_before(front - kBehind);
  stored_->tsr.erase_if([&](const track::TemporarySpeedRestriction& t) { return t.to < front - kBehind; });
}

Direction Journey::orientation_of(const Group& group) const {
  if (group.crossing != Direction::unknown) return group.crossing;
  const auto index = static_cast<std::size_t>(&group - trackside_.groups.data());
  return by_linking_[index].value_or(Direction::nominal);
}

void Journey::pass(const Group& group) {
  advance(place(group.last_m()));
  check_announced(group);
  Source source{group.where(), Medium::balise, place(group.last_m()), nullptr, {}};
  const track::Reference reference{place(group.at_m), orientation_of(group), group.id, Medium::balise, {}, {}};
  std::vector<Part> parts{{reference, false, {}}};
  for (const Telegram& telegram : group.telegrams) {
    if (!counts(telegram)) continue;
    std::size_t part = 0;
    for (const lang::PacketView& view : telegram.view.packets) {
      if (view.NID_PACKET == packet::infill_location_reference && part == 0) {
        begin_infill(parts, source, view);
        part = parts.size() - 1;
      }
      parts[part].packets.push_back(&view);
    }
  }
  evaluate_parts(source, parts);
}

/// 3.6.2.3.1: what follows packet 136 counts from another group.
void Journey::begin_infill(std::vector<Part>& parts, const Source& source, const lang::PacketView& view) {
  Part part = parts.front();
  part.packets.clear();
  part.infill = true;
  lang::Packet136 p;
  if (lang::decode(view, p) == lang::Fault::none) {
    const GroupId sender = part.reference.group;
    const GroupId id{p.Q_NEWCOUNTRY.raw == 1 ? static_cast<std::uint16_t>(p.NID_C.raw) : sender.NID_C,
                     static_cast<std::uint16_t>(p.NID_BG.raw)};
    if (const Group* group = trackside_.find(id, metres(source.front))) {
      part.reference.place = place(group->at_m);
      part.reference.infill = id;
    } else {
      out_.add(error, source.where, "3.6.2.3.1"_srs,
               fmt::format("infill for group {}/{}, which is not on the line", id.NID_C, id.NID_BG));
    }
  }
  parts.push_back(std::move(part));
}

void Journey::receive(const Message& message) {
  if (message.view.fault != lang::Fault::none) return;
  const Place front = place(message.sent->position_m);
  advance(front);
  Source source{message.where(), Medium::rbc, front, &message.view, {}};
  const Group* lrbg = message.lrbg ? trackside_.find(*message.lrbg, message.sent->position_m) : nullptr;
  Part part;
  part.reference.medium = Medium::rbc;
  if (lrbg != nullptr) {
    part.reference.place = place(lrbg->at_m);
    part.reference.orientation = orientation_of(*lrbg);
    part.reference.group = lrbg->id;
  } else if (message.lrbg) {
    return;  // a finding of check_messages
  }
  lang::Message33 shifted;
  if (message.view.NID_MESSAGE == message::movement_authority_shifted &&
      lang::decode(message.view, shifted) == lang::Fault::none)
    part.reference = track::shifted(part.reference, lang::metres(shifted.Q_SCALE, shifted.D_REF));
  for (const lang::PacketView& view : message.view.packets) part.packets.push_back(&view);
  evaluate_parts(source, {part});
}

void Journey::evaluate_parts(Source& source, const std::vector<Part>& parts) {
  executed_.reset();
  context_ = {};
  context_.mode = Mode::FS;
  context_.level = level_.level;
  context_.medium = source.medium;
  context_.described_over_whole_ma = true;
  if (pending_) context_.announced = pending_->to.level;
  for (const Part& part : parts) evaluate_part(source, part);
  if (!executed_) return;
  level_ = *executed_;
  pending_.reset();
}

void Journey::evaluate_part(Source& source, const Part& part) {
  context_.infill = part.infill;
  track::begin(*contents_, part.reference, {}, part.infill ? std::optional(part.reference.place) : std::nullopt);
  take_level_orders(source, part);
  take_linking(source, part);
  take_rest(source, part);
  if (source.message != nullptr) take_message(source, part);
  take_authority(source, part);
  (void)track::store(*stored_, *contents_, here_at(source.front));
}

void Journey::reject(Source& source, int packet, const std::string& what, Clause clause) {
  if (!source.rejected.insert(packet).second) return;
  // An exception of the table depends on what else was received: it is how conditional orders are used.
  out_.add(clause.exception() == 0 ? warning : note, source.where, clause,
           fmt::format("{} is rejected in level {}", what, name(level_.level)));
}

bool Journey::passes(Source& source, const lang::PacketView& view) {
  for (const Information row : kernel::rows_of(kernel::route_of(view), view)) {
    const modes::Acceptance a = modes::accept_by_level(row, context_);
    if (a.verdict != modes::Verdict::rejected) continue;
    reject(source, view.NID_PACKET, fmt::format("packet {} ({})", view.NID_PACKET, name(row)), a.clause);
    return false;
  }
  return true;
}

/// First (4.8.1.3): the rest is judged with the new level announced, also where it is reached at once.
void Journey::take_level_orders(Source& source, const Part& part) {
  const auto is_order = [](const lang::PacketView* view) { return kernel::route_of(*view).turn == Turn::level_order; };
  context_.level_order_along_or_announced =
      pending_.has_value() || std::any_of(part.packets.begin(), part.packets.end(), [](const lang::PacketView* view) {
        return view->NID_PACKET == packet::level_transition_order;
      });
  for (const lang::PacketView* view : part.packets) {
    if (!is_order(view)) continue;
    const auto order = kernel::order_of(*view, SrsVersion::v3_6_0);
    if (!order || !passes(source, *view)) continue;
    const modes::OrderDecision decision = modes::judge(order->kind, order->table, level_, Mode::FS, every_level());
    if (decision.cancels_pending) pending_.reset();
    if (decision.effect == modes::OrderEffect::execute) executed_ = decision.to;
    if (decision.effect == modes::OrderEffect::announce) {
      lang::Packet41 p;
      if (lang::decode(*view, p) != lang::Fault::none ||
          !track::valid_direction(p.Q_DIR.raw, part.reference.orientation))
        continue;
      const Distance D_LEVELTR = lang::metres(p.Q_SCALE, p.D_LEVELTR).value_or(Distance{});
      pending_ = modes::PendingTransition{decision.to, part.reference.place + D_LEVELTR, {}};
    }
    context_.announced.reset();
    if (pending_) context_.announced = pending_->to.level;
    if (executed_) context_.announced = executed_->level;
    context_.immediate_order_to_1_2_3 = executed_ && executed_->level != Level::L0 && executed_->level != Level::NTC;
  }
}

void Journey::take_rest(Source& source, const Part& part) {
  for (const lang::PacketView* view : part.packets) {
    if (kernel::route_of(*view).turn != Turn::rest) continue;
    lang::Packet42 session;
    if (view->NID_PACKET == packet::session_management && lang::decode(*view, session) == lang::Fault::none)
      context_.orders_establishment = session.Q_RBC.raw == 1;
    if (!passes(source, *view)) continue;
    if (view->NID_PACKET == packet::tsr_revocation) check_revocation(source, *view);
    if (view->NID_PACKET == packet::gradient_profile || view->NID_PACKET == packet::static_speed_profile ||
        view->NID_PACKET == packet::temporary_speed_restriction || view->NID_PACKET == packet::tsr_revocation)
      (void)track::add(*contents_, *view, part.reference);
  }
}

void Journey::check_revocation(const Source& source, const lang::PacketView& view) const {
  lang::Packet66 p;
  if (lang::decode(view, p) != lang::Fault::none) return;
  if (p.NID_TSR.raw == 255) return out_.add(error, source.where, "3.11.5.6"_srs, "restriction 255 cannot be revoked");
  const auto same = [&](const track::TemporarySpeedRestriction& t) { return t.NID_TSR == p.NID_TSR.raw; };
  if (std::none_of(stored_->tsr.begin(), stored_->tsr.end(), same))
    out_.add(warning, source.where, "3.11.5.5"_srs,
             fmt::format("revokes restriction {}, which no group or message before it has sent", p.NID_TSR.raw));
}

/// The information of the message itself, without its packets.
void Journey::take_message(Source& source, const Part& part) {
  const lang::MessageToTrainView& view = *source.message;
  const auto row = kernel::row_of_message(view.NID_MESSAGE);
  if (!row) return;
  const modes::Acceptance a = modes::accept_by_level(*row, context_);
  if (a.verdict == modes::Verdict::rejected)
    return reject(source, -1, fmt::format("message {} ({})", view.NID_MESSAGE, name(*row)), a.clause);
  lang::Message15 stop;
  if (view.NID_MESSAGE != message::conditional_emergency_stop || lang::decode(view, stop) != lang::Fault::none) return;
  const std::optional<Place> at = track::stop_location(stop, part.reference);
  if (at && source.front > *at)
    out_.add(note, source.where, "3.10.2.2 a"_srs,
             fmt::format("emergency stop {} for {:.1f} m, already passed: the train refuses it", stop.NID_EM.raw,
                         metres(*at)));
}

void check_journey(const Trackside& trackside, Findings& out) { Journey(trackside, out).run(); }

}  // namespace evc::check
