#include "explain/screen.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/brake.h"
#include "explain/words.h"
#include "kernel/here.h"
#include "modes/next_mode.h"
#include "position/position.h"
#include "terms/packet_numbers.h"

namespace evc::explain {
namespace {

constexpr std::size_t kColumns = 100;

/// `head` and then `text`, broken at blanks; further lines are indented to the width of the head.
std::string wrapped(std::string head, const std::string& text) {
  const std::size_t indent = head.size();
  std::string out, line = std::move(head);
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find(' ', at);
    if (end == std::string::npos) end = text.size();
    const bool first = line.size() <= indent;
    if (!first && line.size() + 1 + (end - at) > kColumns) {
      out += line + "\n";
      line.assign(indent, ' ');
    } else if (!first) {
      line += ' ';
    }
    line.append(text, at, end - at);
    at = end + 1;
  }
  return out + line + "\n";
}

std::string with_clause(const Step& step) {
  return step.clause.empty() ? step.text : fmt::format("{} [{}]", step.text, step.clause);
}
std::string origin_line(const Step& step) {
  return step.t_ms ? fmt::format("{}: {}", time_words(*step.t_ms), with_clause(step)) : with_clause(step);
}

/// Without its clause.
std::string from_line(const Step& step) {
  return step.t_ms ? fmt::format("{}: {}", time_words(*step.t_ms), step.text) : step.text;
}

std::string row(const char* subject, const std::string& text) { return wrapped(fmt::format("{:<11}", subject), text); }

std::string mode_lines(const Journal& journal) {
  const Moment* entry = journal.mode_entry();
  const Moment& now = journal.now();
  if (entry == nullptr) return row("mode", fmt::format("{} since power-up", name(now.after.mode)));
  std::string text = row("mode", fmt::format("{} since {}, from {}", name(now.after.mode), time_words(entry->t_ms),
                                             name(entry->before.mode)));
  for (const Step& step : entry_steps(journal, *entry)) text += row("", origin_line(step));
  return text;
}

std::string level_lines(const Journal& journal) {
  const kernel::State& s = journal.now().after;
  std::string text = name(s.level.level);
  const auto origin = level_step(journal, journal.now().t_ms);
  if (origin) text += ", " + origin_line(*origin);
  const auto& pending = s.level_transition.pending;
  if (!pending) return row("level", text);
  text += fmt::format("; announced: {} at {}", name(pending->to.level), place_words(s, pending->border));
  const Note* order = journal.last_packet(packet::level_transition_order);
  if (order != nullptr && !order->source.empty())
    text += fmt::format(", ordered by {} at {} (packet 41)", order->source, time_words(order->t_ms));
  return row("level", text);
}

/// For whom or what a procedure of chapter 5 waits; nothing: for nobody.
std::string waiting_lines(const Moment& now) {
  const auto& shown = now.outputs.dialogue;
  if (!shown) return "";
  const DialogueRow& of = kDialogueRows[terms::index(shown->step)];
  std::string what = of.waits_for;
  if (shown->acknowledges)
    what = fmt::format("acknowledgement of {}", kAckRows[terms::index(*shown->acknowledges)].name);
  std::string text = fmt::format("for {} ({} {})", what, of.procedure, of.step);
  std::replace(text.begin(), text.end(), '_', ' ');
  return row("waits", text);
}

std::string brake_lines(const Journal& journal) {
  const Moment& now = journal.now();
  std::string text;
  for (const auto& [cause, braking] : journal.brakings()) {
    if (!now.outputs.brake_reasons.has(cause)) continue;
    const Command command{cause, &braking};
    const auto release = release_words(command, now);
    text +=
        row(text.empty() ? "brake" : "",
            fmt::format("{}: {} [{}] since {}; {}", brake_words(command), name(cause), clause_of(cause, *braking.onset),
                        time_words(braking.onset->t_ms), release ? "released " + *release : "permanent"));
  }
  return text.empty() ? row("brake", "no command") : text;
}

/// To keep one screen: the first cause and the last two.
Steps shortest(Steps steps) {
  if (steps.size() > 3) steps.erase(steps.begin() + 1, steps.end() - 2);
  return steps;
}

std::string speed_lines(const Journal& journal) {
  const Moment& now = journal.now();
  const kernel::Outputs& o = now.outputs;
  if (!o.V_P) return row("speed", fmt::format("{}, not supervised in this mode", kmh_words(o.v)));
  std::string text =
      row("speed", fmt::format("{} in {}; permitted {}, SBI {}, EBI {}", kmh_words(o.v),
                               terms::kNames<kMonitoringRows>[terms::index(o.monitoring)], kmh_words(*o.V_P),
                               o.V_SBI ? kmh_words(*o.V_SBI) : "none", o.V_EBI ? kmh_words(*o.V_EBI) : "none"));
  const track::Here here = kernel::here(now.after);
  if (o.V_MRSP)
    for (const Restriction& r : restrictions(journal, now, here.min_safe_front, here.max_safe_front, *o.V_MRSP))
      text += row("", fmt::format("{} [{}]{}", r.text, clause_of(r.source), r.from ? ", " + from_line(*r.from) : ""));
  if (now.after.supervision.has_MRDT) {
    const sdm::TargetId& target = now.after.supervision.MRDT;
    text += row("", "MRDT: " + target_distance_words(now, target));
    for (const Step& step : shortest(target_steps(journal, now, target))) text += row("", "  " + origin_line(step));
    for (const Step& step : curve_steps(journal, now)) text += row("", "  " + origin_line(step));
  } else if (now.after.basis.authority.EOA_or_LOA()) {  // in SR, SH, UN none counts (4.5.2)
    for (const Step& step : shortest(authority_steps(journal, now))) text += row("", origin_line(step));
  }
  return text;
}

std::string position_lines(const Journal& journal) {
  const Moment& now = journal.now();
  const kernel::Outputs& o = now.outputs;
  std::string text =
      fmt::format("front end at {}, between {} and {} [3.6.4]", metres_words(o.est_front.from_origin),
                  metres_words(o.min_safe_front.from_origin), metres_words(o.max_safe_front.from_origin));
  const position::Reference* lrbg = position::lrbg(now.after.position);
  if (lrbg == nullptr) return row("position", text + "; no LRBG");
  const track::Here here = kernel::here(now.after);
  const bool ahead = lrbg->place > here.est_front;  // the train ran back over it
  const Distance from_front = ahead ? lrbg->place - here.est_front : here.est_front - lrbg->place;
  text += fmt::format("; LRBG {}/{}, {} {}, accuracy {}", lrbg->id.NID_C, lrbg->id.NID_BG, metres_words(from_front),
                      ahead ? "ahead" : "behind", metres_words(lrbg->Q_LOCACC));
  if (const Note* read = journal.last(What::group_accepted, now.t_ms, std::int32_t{lrbg->id.NID_BG}))
    text += fmt::format(", read at {}", time_words(read->t_ms));
  return row("position", text);
}

/// The conditions of the transitions out of a mode, with the facts of this cycle.
std::string transition_lines(const Moment& now, Mode left) {
  std::string text;
  const Reasons all = reasons(now.facts, now.after.srs);
  for (const auto& cell : modes::cells_leaving(left, now.after.srs)) {
    std::string conditions;
    for (const Reason& reason : all) {
      if (!cell.any.test(reason.number)) continue;
      conditions += fmt::format("{}[{}] {}{}", conditions.empty() ? "" : " | ", reason.number,
                                reason.holds ? "holds: " : "", words(reason));
    }
    text += wrapped(fmt::format("  {:<2} p{}  ", name(cell.to), cell.priority), conditions);
  }
  return text;
}

/// In the cycle of a transition the facts are those of the mode that is left; of the new one they say nothing.
std::string leaving_lines(const Moment& now) {
  const Mode before = now.before.mode;
  if (before == now.after.mode)
    return fmt::format("{} is not left, because (4.6.2, 4.6.3; any [condition]; of terms with / one suffices)\n",
                       name(before)) +
           transition_lines(now, before);
  return fmt::format("{} is left for {} in this cycle (4.6.2, 4.6.3; any [condition]; of terms with / one suffices)\n",
                     name(before), name(now.after.mode)) +
         transition_lines(now, before);
}

std::string steps_lines(const Steps& steps) {
  std::string text;
  int n = 0;
  for (const Step& step : steps)
    text += wrapped(fmt::format("{:>3} {:>9}  ", ++n, step.t_ms ? time_words(*step.t_ms) : ""), with_clause(step));
  return text;
}

bool is_overspeed(Cause cause) {
  return cause == Cause::overspeed_traction || cause == Cause::overspeed_service || cause == Cause::overspeed_emergency;
}

/// Of the commands by speed the strongest, and those before it in the order of time (3.13.10.2.2): the emergency brake
/// is kept while others come and go.
std::vector<Command> up_to_strongest(const std::vector<Command>& asked) {
  std::vector<Command> speed;
  const Command* strongest = nullptr;
  for (const Command& command : asked)
    if (is_overspeed(command.cause) && (strongest == nullptr || command.cause > strongest->cause)) strongest = &command;
  for (const Command& command : asked)
    if (is_overspeed(command.cause) && command.braking->onset->t_ms <= strongest->braking->onset->t_ms)
      speed.push_back(command);
  return speed;
}

/// Those that are not released, without them those released last; by their time, the stronger brake behind.
std::vector<Command> commands(const Journal& journal) {
  std::vector<Command> out;
  std::int64_t released = -1;
  for (const auto& [cause, braking] : journal.brakings())
    if (!braking.until)
      out.push_back({cause, &braking});
    else
      released = std::max(released, *braking.until);
  if (out.empty())
    for (const auto& [cause, braking] : journal.brakings())
      if (braking.until == released) out.push_back({cause, &braking});
  std::stable_sort(out.begin(), out.end(),
                   [](const Command& a, const Command& b) { return a.braking->onset->t_ms < b.braking->onset->t_ms; });
  return out;
}

}  // namespace

std::string situation(const Journal& journal) {
  const Moment& now = journal.now();
  std::string text = fmt::format("{}: {}, level {}, {}\n", time_words(now.t_ms), name(now.after.mode),
                                 name(now.after.level.level), kmh_words(now.outputs.v));
  text += mode_lines(journal) + level_lines(journal) + waiting_lines(now) + brake_lines(journal) +
          speed_lines(journal) + position_lines(journal);
  return text + leaving_lines(now);
}

std::string why_brake(const Journal& journal, bool& answered) {
  const Moment& now = journal.now();
  answered = !journal.brakings().empty();
  if (!answered) return fmt::format("{}: no brake has been commanded\n", time_words(now.t_ms));
  const std::vector<Command> asked = commands(journal);
  std::string text = time_words(now.t_ms);
  text += asked.front().braking->until ? ": no brake is commanded; the last command\n" : "\n";
  const std::vector<Command> speed = up_to_strongest(asked);
  for (const Command& command : asked) {
    if (is_overspeed(command.cause) && command.cause != speed.back().cause) continue;
    text += fmt::format("why the {} ({})\n", brake_words(command), name(command.cause));
    text += steps_lines(is_overspeed(command.cause) ? overspeed_chain(journal, speed) : chain_of(command, journal));
    const auto release = release_words(command, now);
    text += command.braking->until ? fmt::format("    released at {}\n", time_words(*command.braking->until))
            : release              ? fmt::format("    will be released {}\n", *release)
                                   : "    will not be released: it is permanent\n";
  }
  return text;
}

}  // namespace evc::explain
