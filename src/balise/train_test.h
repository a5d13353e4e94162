#pragma once
// For the tests of this room: telegrams built bit by bit, and a train that reads them.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "balise/balise.h"

namespace evc::balise::test {

/// Bits, most significant first.
class Bits {
 public:
  Bits& put(std::uint64_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) bits_.push_back(((value >> i) & 1u) != 0);
    return *this;
  }
  Bits& put(const Bits& other) {
    bits_.insert(bits_.end(), other.bits_.begin(), other.bits_.end());
    return *this;
  }
  std::size_t size() const { return bits_.size(); }
  std::vector<std::uint8_t> bytes() const {
    std::vector<std::uint8_t> out((bits_.size() + 7) / 8);
    for (std::size_t i = 0; i < bits_.size(); ++i)
      if (bits_[i]) out[i / 8] = static_cast<std::uint8_t>(out[i / 8] | (1u << (7 - i % 8)));
    return out;
  }

 private:
  std::vector<bool> bits_;
};

inline Bits packet(unsigned nid, unsigned Q_DIR, const Bits& body = {}) {
  return Bits{}.put(nid, 8).put(Q_DIR, 2).put(23 + body.size(), 13).put(body);
}
inline Bits default_information() { return packet(254, 2); }
inline Bits inhibition() { return packet(145, 2); }
inline Bits repositioning(unsigned Q_DIR) { return packet(16, Q_DIR, Bits{}.put(1, 2).put(500, 15)); }
/// "Stop if in staff responsible": a packet for one direction or for both.
inline Bits directional(unsigned Q_DIR) { return packet(137, Q_DIR, Bits{}.put(0, 1)); }
inline Bits outside_etcs(unsigned Q_DIR) { return packet(44, Q_DIR, Bits{}.put(300, 9)); }
/// A temporary speed restriction for both directions.
inline Bits restriction(unsigned NID_TSR) {
  return packet(65, 2, Bits{}.put(1, 2).put(NID_TSR, 8).put(100, 15).put(100, 15).put(0, 1).put(10, 7));
}
inline Bits spare() { return packet(137, 3, Bits{}.put(0, 1)); }
inline Bits marker(unsigned NID_VBCMK) { return Bits{}.put(0, 8).put(NID_VBCMK, 6); }
inline Bits old_marker(unsigned NID_VBCMK) { return packet(200, 2, Bits{}.put(NID_VBCMK, 6)); }

struct Balise {
  std::uint16_t NID_BG = 1;
  unsigned N_PIG = 0;
  unsigned N_TOTAL = 1;
  unsigned Q_LINK = 1;
  unsigned M_DUP = 0;
  unsigned M_MCOUNT = 255;
  unsigned M_VERSION = 0x21;
  unsigned NID_C = 426;
  unsigned Q_UPDOWN = 1;
  unsigned Q_MEDIA = 0;
  std::vector<Bits> packets{};

  Bits telegram(std::size_t length = 210) const {
    Bits bits;
    bits.put(Q_UPDOWN, 1).put(M_VERSION, 7).put(Q_MEDIA, 1).put(N_PIG, 3).put(N_TOTAL, 3).put(M_DUP, 2);
    bits.put(M_MCOUNT, 8).put(NID_C, 10).put(NID_BG, 14).put(Q_LINK, 1);
    for (const Bits& p : packets) bits.put(p);
    bits.put(255, 8);
    while (bits.size() < length) bits.put(1, 1);
    return bits;
  }
};

/// A train whose antenna runs along the track frame; counter and place are the same number.
struct Train {
  State state;
  Situation situation;
  double under = 0;  // max safe antenna ahead of the estimated one
  double over = 0;   // min safe antenna behind
  double at = 0;
  double counter_sense = 1;
  // Everything since the last clear.
  std::vector<Group> groups;
  std::vector<Event> events;
  Reaction reaction = Reaction::none;
  bool shorten = false;
  bool wrong_direction = false;
  bool version_too_high = false;

  PlaceInterval antenna() const {
    return {Place{Distance{at - over}}, Place{Distance{at}}, Place{Distance{at + under}}};
  }
  OdometerReading counter() const {
    const OdometerPlace c{Distance{counter_sense * at}};
    return {c, c, c};
  }
  void take(const Outcome& outcome) {
    for (const Group& g : outcome.groups) groups.push_back(g);
    for (const Event& e : outcome.events) events.push_back(e);
    if (stronger(outcome.reaction, reaction)) reaction = outcome.reaction;
    shorten = shorten || outcome.shorten_at_standstill;
    wrong_direction = wrong_direction || outcome.wrong_direction;
    version_too_high = version_too_high || outcome.version_too_high;
  }
  void read_at(double x, const Balise& balise) { read_at(x, balise.telegram()); }
  void read_at(double x, const Bits& bits) {
    at = x;
    const std::vector<std::uint8_t> bytes = bits.bytes();
    Outcome outcome;
    read(state, {bytes, bits.size(), counter(), antenna()}, situation, outcome);
    take(outcome);
  }
  void undecodable_at(double x) {
    at = x;
    Outcome outcome;
    read(state, {{}, 0, counter(), antenna()}, situation, outcome);
    take(outcome);
  }
  /// A cycle without a balise.
  void run_to(double x) {
    at = x;
    Outcome outcome;
    close_overdue(state, counter(), situation, outcome);
    take(outcome);
    expect(state, antenna(), situation, outcome);
    take(outcome);
  }
  /// Two balises 3 m apart, crossed nominal (0 first) or reverse; the reference balise is at `x`.
  void pass(double x, std::uint16_t NID_BG, bool nominal = true, unsigned Q_LINK = 1) {
    if (nominal) {
      read_at(x, Balise{NID_BG, 0, 1, Q_LINK});
      read_at(x + 3, Balise{NID_BG, 1, 1, Q_LINK});
    } else {
      read_at(x - 3, Balise{NID_BG, 1, 1, Q_LINK});
      read_at(x, Balise{NID_BG, 0, 1, Q_LINK});
    }
  }
  const Group& last() const { return groups.back(); }
  int count(What what) const {
    int n = 0;
    for (const Event& e : events) n += e.what == what ? 1 : 0;
    return n;
  }
  const Event* first(What what) const {
    for (const Event& e : events)
      if (e.what == what) return &e;
    return nullptr;
  }
};

inline LinkingList::Entry entry(double D_LINK, std::uint16_t NID_BG, Reaction reaction = Reaction::service_brake,
                                double Q_LOCACC = 5, bool nominal = true) {
  return {Distance{D_LINK}, std::nullopt, NID_BG, nominal, reaction, Distance{Q_LOCACC}};
}

/// Linking with its reference at place 0 (group 100 of country 426).
inline void announce(Train& train, std::initializer_list<LinkingList::Entry> entries) {
  LinkingList list;
  for (const LinkingList::Entry& e : entries) static_cast<void>(list.entries.push_back(e));
  train.situation.linking_checked = true;
  store(train.state.linking, list, {{426, 100}, Place{Distance{0}}, 426, true, false}, train.antenna(), std::nullopt);
}

}  // namespace evc::balise::test
