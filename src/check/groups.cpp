#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "balise/balise.h"
#include "check/rules.h"
#include "lang/schema.h"
#include "lang/variable_table.h"

namespace evc::check {
namespace {

using enum Severity;

/// The paragraph that the bits do not follow.
Clause clause_of(lang::Fault fault) {
  using lang::Fault;
  switch (fault) {
    case Fault::spare_value:
      return "3.16.1.1.1"_srs;
    case Fault::length_mismatch:
    case Fault::length_too_small:
      return "7.3.3.2"_srs;
    case Fault::no_end_packet:
      return "7.3.3.5"_srs;
    case Fault::duplicate_packet:
      return "8.4.1.4"_srs;
    case Fault::wrong_medium:
      return "7.3.3.10"_srs;
    case Fault::wrong_direction:
      return "8.4.2.1"_srs;
    case Fault::wrong_place:
      return "8.4.2.3"_srs;
    case Fault::missing_packet:
      return "8.4.4.3"_srs;
    case Fault::unexpected_packet:
      return "8.4.4.4.1"_srs;
    case Fault::unknown_message:
      return "8.4.4.1.1"_srs;
    case Fault::message_length_mismatch:
      return "8.4.4.2.1"_srs;
    case Fault::unknown_version:
      return "3.17.3.5"_srs;
    default:
      return "3.16.1.1"_srs;
  }
}

std::string text_of(const lang::FaultAt& at) {
  std::string text = fmt::format("bit {}: {}", at.bit, lang::text_of(at.fault));
  if (at.packet >= 0) text += fmt::format(", packet {}", at.packet);
  if (at.variable != nullptr) {
    const lang::VariableInfo* info = lang::find_variable(at.variable);
    text += fmt::format(", {} {}", info != nullptr ? info->name : at.variable, at.value);
  }
  return text;
}

/// Packets that a train skips: their numbers are unknown in the version `sv` of trackside (3.17.3.11).
void check_known(const lang::PacketViews& packets, lang::SystemVersion sv, const Where& where, Findings& out) {
  for (const lang::PacketView& packet : packets)
    if (!packet.known)
      out.add(warning, where, "3.17.3.11"_srs,
              fmt::format("packet {} is unknown in system version {}.{}: a train ignores it", packet.NID_PACKET, sv.x,
                          sv.y));
}

void check_telegrams(const Group& group, Findings& out) {
  for (const Telegram& t : group.telegrams) {
    if (t.view.fault != lang::Fault::none)
      out.add(error, group.where(t), clause_of(t.view.fault), "telegram rejected, " + text_of(t.view.at));
    else
      check_known(t.view.packets, lang::system_version(t.view.M_VERSION.raw), group.where(t), out);
  }
}

/// Header variables that have one value in the whole group.
void check_common_header(const Group& group, Findings& out) {
  const lang::TelegramView& first = group.telegrams.front().view;
  for (const Telegram& t : group.telegrams) {
    const Where where = group.where(t);
    if (t.id() != group.telegrams.front().id())
      return out.add(error, where, "3.4.1.1"_srs,
                     fmt::format("identity {} in group {}", group_text(t.id()), group_text(group.id)));
    if (t.view.N_TOTAL.raw != first.N_TOTAL.raw)
      return out.add(error, where, "3.4.1.2"_srs,
                     fmt::format("N_TOTAL {} and {} in one group", first.N_TOTAL.raw, t.view.N_TOTAL.raw));
    if (t.view.Q_LINK.raw != first.Q_LINK.raw)
      return out.add(error, where, "3.4.4.1.2"_srs, "balises marked linked and unlinked in one group");
    const bool both_read = t.view.fault == lang::Fault::none && first.fault == lang::Fault::none;
    if (both_read && t.view.M_VERSION.raw != first.M_VERSION.raw) {
      const lang::SystemVersion a = lang::system_version(first.M_VERSION.raw);
      const lang::SystemVersion b = lang::system_version(t.view.M_VERSION.raw);
      return out.add(
          warning, where, "3.17.2.3"_srs,
          fmt::format("system versions {}.{} and {}.{} in one group: the highest X is operated", a.x, a.y, b.x, b.y));
    }
  }
}

/// N_PIG: each number once, all of them, in order along the run.
void check_numbers(const Group& group, Findings& out) {
  std::size_t count[balise::kBalises] = {};
  const unsigned last = group.telegrams.front().view.N_TOTAL.raw;
  for (const Telegram& t : group.telegrams) {
    const unsigned number = t.view.N_PIG.raw;
    if (number > last)
      return out.add(error, group.where(t), "3.4.1.2"_srs, fmt::format("N_PIG {} above N_TOTAL {}", number, last));
    if (++count[number] > 1)
      return out.add(error, group.where(t), "3.4.1.3"_srs, fmt::format("N_PIG {} twice in one group", number));
  }
  for (unsigned number = 0; number <= last; ++number)
    if (count[number] == 0)
      return out.add(error, group.where(), "3.16.2.1.3"_srs,
                     fmt::format("balise N_PIG {} of {} is not on the line: it is missed", number, last + 1));
  if (group.telegrams.size() > 1 && group.crossing == Direction::unknown)
    out.add(error, group.where(), "3.4.2.2.2"_srs, "the numbers N_PIG neither rise nor fall along the run");
}

/// M_MCOUNT: 255 fits all, 254 fits none, others are equal (3.16.2.4.6-7).
void check_counters(const Group& group, Findings& out) {
  std::optional<unsigned> counter;
  for (const Telegram& t : group.telegrams) {
    const unsigned M_MCOUNT = t.view.M_MCOUNT.raw;
    if (M_MCOUNT == 255) continue;
    if (M_MCOUNT == 254 || (counter && *counter != M_MCOUNT))
      return out.add(error, group.where(t), "3.16.2.4.7"_srs,
                     counter ? fmt::format("M_MCOUNT {} and {} in one group", *counter, M_MCOUNT)
                             : fmt::format("M_MCOUNT {} fits no telegram", M_MCOUNT));
    counter = M_MCOUNT;
  }
}

void check_spacing(const Group& group, Findings& out) {
  for (std::size_t i = 1; i < group.telegrams.size(); ++i) {
    const double gap = group.telegrams[i].balise->position_m - group.telegrams[i - 1].balise->position_m;
    if (gap > balise::kBaliseSpacing.si)
      out.add(error, group.where(group.telegrams[i]), "SUBSET-040 4.1.1.2",
              fmt::format("{:.1f} m to the balise before it, at most {:.0f} m in one group", gap,
                          balise::kBaliseSpacing.si));
    if (gap < balise::kSameBalise.si)
      out.add(error, group.where(group.telegrams[i]), "SUBSET-036 4.2.10.2",
              fmt::format("{:.1f} m to the balise before it: a train reads them as one", gap));
  }
}

void check_identities(const Trackside& trackside, Findings& out) {
  const auto& groups = trackside.groups;
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (groups[i].id == groups[j].id)
        out.add(error, groups[i].where(), "3.4.1.1"_srs,
                fmt::format("two groups {}: the other one is at {:.1f} m", group_text(groups[i].id), groups[j].at_m));
}

/// Groups one in another, or not in the order of the run.
void check_order(const Trackside& trackside, Findings& out) {
  const auto& groups = trackside.groups;
  for (std::size_t i = 1; i < groups.size(); ++i) {
    if (groups[i].first_m() <= groups[i - 1].last_m())
      out.add(error, groups[i].where(), "3.16.2.1.3"_srs,
              fmt::format("it begins before group {} ends", group_text(groups[i - 1].id)));
    if (groups[i].index < groups[i - 1].index)
      out.add(warning, groups[i].where(), "docs/line.md",
              fmt::format("in the file it is before group {}, on the line behind it", group_text(groups[i - 1].id)));
  }
}

bool all_headers_readable(const Group& group) {
  return std::all_of(group.telegrams.begin(), group.telegrams.end(), [](const Telegram& t) { return t.has_header(); });
}

/// A group that the train passes before the front end is at the place.
bool passed(const Group& group, double front_m) { return group.first_m() <= front_m; }

void check_reference(const Trackside& trackside, const Message& message, Findings& out) {
  if (!message.lrbg) return;  // only while the train reports none (3.6.2.2.2.3)
  const Group* lrbg = trackside.find(*message.lrbg, message.sent->position_m);
  if (lrbg == nullptr)
    return out.add(error, message.where(), "3.6.2.2.1"_srs,
                   fmt::format("its LRBG {} is not on the line", group_text(*message.lrbg)));
  if (!passed(*lrbg, message.sent->position_m))
    return out.add(error, message.where(), "3.6.2.2.2 b"_srs,
                   fmt::format("its LRBG {} is at {:.1f} m, not passed yet", group_text(*message.lrbg), lrbg->at_m));
  if (!lrbg->linked())
    out.add(error, message.where(), "3.6.2.2.2 a"_srs,
            fmt::format("its LRBG {} is marked unlinked", group_text(*message.lrbg)));
}

}  // namespace

void check_groups(const Trackside& trackside, Findings& out) {
  for (const Group& group : trackside.groups) {
    check_telegrams(group, out);
    check_spacing(group, out);
    if (!all_headers_readable(group)) continue;
    const std::size_t before = out.all().size();
    check_common_header(group, out);
    if (out.all().size() == before) check_numbers(group, out);
    check_counters(group, out);
    if (!group.linked() && group.telegrams.size() == 1)
      out.add(error, group.where(), "3.4.4.3.2"_srs, "one balise alone is marked unlinked: it has no orientation");
  }
  check_identities(trackside, out);
  check_order(trackside, out);
}

void check_messages(const Trackside& trackside, Findings& out) {
  const auto& messages = trackside.messages;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const Message& message = messages[i];
    for (std::size_t j = 0; j < i; ++j)
      if (message.sent->seq == messages[j].sent->seq)
        out.add(error, message.where(), "docs/line.md",
                fmt::format("two messages {}: the other one is sent at {:.1f} m", message.sent->seq,
                            messages[j].sent->position_m));
    if (i > 0 && message.sent->index < messages[i - 1].sent->index)
      out.add(warning, message.where(), "docs/line.md",
              fmt::format("in the file it is before message {}, on the line behind it", messages[i - 1].sent->seq));
    if (message.view.fault != lang::Fault::none) {
      out.add(error, message.where(), clause_of(message.view.fault), "message rejected, " + text_of(message.view.at));
      continue;
    }
    check_known(message.view.packets, message.view.sv, message.where(), out);
    check_reference(trackside, message, out);
  }
}

void check_track(const Trackside& trackside, Findings& out) {
  const auto look = [&](const auto& segments, const char* what) {
    for (std::size_t i = 1; i < segments.size(); ++i) {
      const double gap = segments[i].start_m - segments[i - 1].end_m;
      if (gap > 0.5)
        out.add(warning, {segments[i - 1].end_m, {}, {}}, "docs/line.md",
                fmt::format("physical_track: no {} from {:.1f} to {:.1f} m", what, segments[i - 1].end_m,
                            segments[i].start_m));
      if (gap < -0.5)
        out.add(error, {segments[i].start_m, {}, {}}, "docs/line.md",
                fmt::format("physical_track: two {}s from {:.1f} to {:.1f} m", what, segments[i].start_m,
                            segments[i - 1].end_m));
    }
  };
  look(trackside.line->gradient, "gradient");
  look(trackside.line->ssp, "speed");
}

}  // namespace evc::check
