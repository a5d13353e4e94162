#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "modes/conditions.h"

namespace evc::modes {

/// One cell of the matrix 4.6.2: `from` is left for `to` when any of the listed conditions holds.
/// Priority 1 is the highest; it orders the cells that leave one mode.
template <class M>
struct Cell {
  M to{};
  M from{};
  std::array<std::uint8_t, 10> when{};  // the numbers in the page's order, 0 after the last
  std::uint8_t priority = 0;
  Conditions any;  // the same numbers as a set

  constexpr Cell() = default;
  constexpr Cell(M to_, M from_, std::initializer_list<int> numbers, int p)
      : to(to_), from(from_), priority(static_cast<std::uint8_t>(p)) {
    std::size_t i = 0;
    for (const int n : numbers) {
      when[i++] = static_cast<std::uint8_t>(n);
      any.set(n);
    }
  }
};

/// A transition that fires: the mode entered, the first condition of the cell that holds and the
/// cell's priority.
template <class M>
struct Transition {
  M to{};
  int number = 0;
  int priority = 0;
};

/// The same table with the cells that leave one mode next to each other (in the page's order), so that a cycle
/// evaluates a dozen cells instead of all.
template <class M, std::size_t N, std::size_t Modes>
struct ByLeaving {
  std::array<Cell<M>, N> cells{};
  std::array<std::uint16_t, Modes + 1> first{};

  constexpr explicit ByLeaving(const std::array<Cell<M>, N>& table) {
    std::size_t n = 0;
    for (std::size_t m = 0; m < Modes; ++m) {
      first[m] = static_cast<std::uint16_t>(n);
      for (const Cell<M>& cell : table)
        if (static_cast<std::size_t>(cell.from) == m) cells[n++] = cell;
    }
    first[Modes] = static_cast<std::uint16_t>(n);
  }
};

/// The cells that leave a mode, in the page's order.
template <class M, std::size_t N, std::size_t Modes>
constexpr std::span<const Cell<M>> leaving(const ByLeaving<M, N, Modes>& table, M mode) {
  const std::size_t m = static_cast<std::size_t>(mode);
  return std::span<const Cell<M>>(table.cells)
      .subspan(table.first[m], std::size_t{table.first[m + 1]} - table.first[m]);
}

/// The cell that fires, if any. If several hold, the priority decides (4.6.2). The standard assumes
/// that cells of equal priority exclude each other. If two hold in one cycle all the same, a level
/// transition comes first, then an event, because these would be lost, while a state still holds in
/// the next cycle; then the page's order.
template <class M, std::size_t N, std::size_t Modes>
constexpr std::optional<Transition<M>> select(const ByLeaving<M, N, Modes>& table, M current,
                                              const Conditions& holding) {
  constexpr Conditions level_transitions = conditions_of(Nature::level);
  constexpr Conditions events = conditions_of(Nature::event);
  const std::span<const Cell<M>> cells = leaving(table, current);
  std::size_t chosen = N;  // none; a pointer to a cell could not be compared at compile time under a sanitizer
  int chosen_rank = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].any.any_of(holding)) continue;
    const Conditions firing = cells[i].any & holding;
    const int rank = cells[i].priority * 4 + (firing.any_of(level_transitions) ? 0 : firing.any_of(events) ? 1 : 2);
    if (chosen == N || rank < chosen_rank) {
      chosen = i;
      chosen_rank = rank;
    }
  }
  if (chosen == N) return std::nullopt;
  const Cell<M>& cell = cells[chosen];
  std::size_t k = 0;
  while (!holding.test(cell.when[k])) ++k;
  return Transition<M>{cell.to, cell.when[k], cell.priority};
}

/// Every mode can be reached from NP.
template <class M, std::size_t N>
constexpr bool every_mode_is_reachable(const std::array<Cell<M>, N>& table, std::size_t modes) {
  std::array<bool, 32> seen{};
  seen[static_cast<std::size_t>(M::NP)] = true;
  for (std::size_t round = 0; round < modes; ++round)
    for (const Cell<M>& cell : table)
      if (seen[static_cast<std::size_t>(cell.from)]) seen[static_cast<std::size_t>(cell.to)] = true;
  for (std::size_t m = 0; m < modes; ++m)
    if (!seen[m]) return false;
  return true;
}

template <class M, std::size_t N>
constexpr bool no_cell_twice(const std::array<Cell<M>, N>& table) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j)
      if (table[i].to == table[j].to && table[i].from == table[j].from) return false;
  return true;
}

/// Two cells that leave one mode with one priority share no condition: arbitration is total.
template <class M, std::size_t N>
constexpr bool equal_priority_means_disjoint_conditions(const std::array<Cell<M>, N>& table) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j)
      if (table[i].from == table[j].from && table[i].priority == table[j].priority && table[i].any.any_of(table[j].any))
        return false;
  return true;
}

}  // namespace evc::modes
