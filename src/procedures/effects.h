#pragma once
#include <cstddef>
#include <cstdint>

#include "base/set.h"
#include "base/units.h"
#include "terms/requests.h"

namespace evc::procedures {

/// Messages and session orders; each is sent once per cycle in which the effects contain it. A position report for a
/// new mode or level is combined with those due by the rules of radio in the same cycle (3.6.5.1.4 b, g).
enum class Send : std::uint8_t {
  open_session,
  terminate_session,
  train_data,               // 129
  shunting_request,         // 130
  manoeuvre_request,        // 131
  position_report,          // 136 with the new mode or level
  end_of_mission,           // 150
  start_of_mission_report,  // 157
  count
};

/// Changes of the status of data (5.4.3.3, "status of data"). If one cycle has both for a kind of data, "invalid" and
/// "unknown" are applied before "valid".
enum class Status : std::uint8_t {
  position_unknown,
  position_valid,
  level_invalid,
  level_valid,
  rbc_contact_invalid,
  rbc_contact_valid,
  count
};

/// The effects of a procedure in this cycle. The kernel combines those of all procedures.
struct Effects {
  Set<Ack> requests;
  Set<Entry> entries;
  Set<Offer> offers;
  Set<Send> send;
  Set<Inform> inform;
  Set<Status> status;

  constexpr Effects& operator|=(const Effects& b) {
    requests |= b.requests;
    entries |= b.entries;
    offers |= b.offers;
    send |= b.send;
    inform |= b.inform;
    status |= b.status;
    return *this;
  }
};

/// A.3.1: time in which a change of mode or level has to be acknowledged.
inline constexpr Duration T_ACK{5.0};
/// A.3.1: a message without an answer is repeated three times, 15 s apart.
inline constexpr Duration T_REPEAT{15.0};
inline constexpr std::uint8_t N_REPEAT = 3;

/// Send, wait 15 s, repeat three times, wait again, then give up (A.3.1).
struct Repetition {
  Duration next{};        // time of the next repetition, or of the end
  std::uint8_t left = 0;  // repetitions left
  bool waiting = false;

  enum class Due : std::uint8_t { nothing, send_again, give_up };

  constexpr void start(Duration now) { *this = {now + T_REPEAT, N_REPEAT, true}; }
  constexpr void stop() { waiting = false; }
  constexpr Due due(Duration now) {
    if (!waiting || now < next) return Due::nothing;
    if (left == 0) {
      waiting = false;
      return Due::give_up;
    }
    --left;
    next = now + T_REPEAT;
    return Due::send_again;
  }
};

}  // namespace evc::procedures
