#include "modes/levels.h"

namespace evc::modes {

OrderedLevel select_level(const LevelTable& table, const AvailableLevels& available) {
  for (const OrderedLevel& entry : table)
    if (available.has(entry)) return entry;
  return table.back();
}

bool acknowledgement_needed(const OrderedLevel& from, const OrderedLevel& to, Mode mode, SrsVersion srs) {
  // In SL nobody can give it, and nothing brakes (4.4.6.1.2, 4.4.6.1.3).
  if (mode == Mode::NL || mode == Mode::SL || from.same_level(to)) return false;
  if (srs == SrsVersion::v4_0_0 && from.level == Level::NTC && (to.level == Level::L1 || to.level == Level::L2))
    return false;
  return srs_5_10_4[static_cast<std::size_t>(from.level)][static_cast<std::size_t>(to.level)];
}

OrderDecision judge(OrderKind kind, const LevelTable& table, const OrderedLevel& current, Mode mode,
                    const AvailableLevels& available) {
  OrderDecision decision;
  if (table.empty() || mode == Mode::RV) return decision;
  decision.to = select_level(table, available);
  const bool announcement = kind == OrderKind::announcement;
  if (mode == Mode::SH || mode == Mode::PS || mode == Mode::SM) {
    decision.effect = announcement ? OrderEffect::rejected : OrderEffect::keep_until_mode_left;
    return decision;
  }
  if (mode == Mode::PT && !announcement) return decision;  // 4.8.4 [5]
  if (kind == OrderKind::conditional) {
    for (const OrderedLevel& entry : table)
      if (entry.same_level(current)) {
        decision.effect = OrderEffect::none;
        decision.to = current;
        return decision;
      }
  }
  // 5.10.1.6: the newest order replaces a pending one.
  decision.cancels_pending = true;
  if (decision.to.same_level(current))
    decision.effect = OrderEffect::none;
  else
    decision.effect = announcement ? OrderEffect::announce : OrderEffect::execute;
  return decision;
}

bool driver_may_select(const OrderedLevel& level, const LevelTable* trackside_table, const AvailableLevels& available) {
  if (!available.has(level)) return false;
  if (trackside_table == nullptr || trackside_table->empty()) return true;
  for (const OrderedLevel& entry : *trackside_table)
    if (entry.same_level(level)) return true;
  return false;
}

Set<Level> levels_allowed(const LevelTable* trackside_table, const AvailableLevels& available) {
  Set<Level> levels;
  if (trackside_table != nullptr && !trackside_table->empty()) {
    for (const OrderedLevel& entry : *trackside_table) levels.add(entry.level, available.has(entry));
    return levels;
  }
  bool national = false;
  for (const std::uint64_t systems : available.national_systems) national = national || systems != 0;
  for (const Level level : {Level::L0, Level::L1, Level::L2, Level::L3})
    levels.add(level, available.has({.level = level}));
  levels.add(Level::NTC, national && available.fitted[static_cast<std::size_t>(Level::NTC)]);
  return levels;
}

}  // namespace evc::modes
