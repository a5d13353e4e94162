// Balise groups, linking and position: for any telegrams and movements there is no crash, no interval with min > max,
// no group accepted with an error, and equal states give equal results.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

#include "balise/balise.h"
#include "position/position.h"
#include "position/report.h"

namespace {

using namespace evc;

void require(bool holds) {
  if (!holds) std::abort();
}

/// The input as a script.
struct Script {
  std::span<const std::uint8_t> left;
  std::uint8_t next() {
    if (left.empty()) return 0;
    const std::uint8_t b = left.front();
    left = left.subspan(1);
    return b;
  }
  std::span<const std::uint8_t> take(std::size_t n) {
    n = n < left.size() ? n : left.size();
    const auto out = left.first(n);
    left = left.subspan(n);
    return out;
  }
};

struct Unit {
  position::State position;
  balise::State balise;
  balise::Situation situation;
  OdometerReading counter;
  position::ReportState reports;
  double time = 0;

  void run(std::uint8_t how) {
    const double d = static_cast<double>(static_cast<std::int8_t>(how)) / 4.0;
    const double slack = 0.05 * (d < 0 ? -d : d);
    counter.nominal = counter.nominal + Distance{d};
    counter.min = counter.min + Distance{d - slack};
    counter.max = counter.max + Distance{d + slack};
    position::update(position, {counter, Speed{d}, {}, {}, {}}, Duration{time += 0.1});
  }
  void take(const balise::Outcome& outcome) {
    for (const balise::Group& group : outcome.groups) {
      require(!group.accepted || group.finding == balise::Finding::none);
      require(!group.lrbg_compliant || (group.accepted && group.linked));
      if (!group.accepted) continue;
      const position::Passage passage{group.id,
                                      group.counter,
                                      Distance{2},
                                      group.link_place,
                                      group.Q_LOCACC.value_or(Distance{12}),
                                      group.counter_against_group,
                                      group.single};
      if (group.lrbg_compliant)
        position::relocate(position, passage);
      else
        position::refer_to_unlinked(position, passage);
    }
  }
  void check() {
    const PlaceInterval f = position::front(position);
    require(f.min <= f.est && f.est <= f.max);
    require(position.references.empty() == (position::lrbg(position) == nullptr));
    const position::Report r = position::report(position, {});
    require(r.V_TRAIN <= 120 && r.Q_SCALE <= 2);
    position::note_reported(position, r);
    for (std::size_t i = 1; i < balise.linking.links.size(); ++i) require(balise.linking.links[i].Q_LOCACC.si >= 0);
  }
};

balise::Reading reading(const Unit& unit, std::span<const std::uint8_t> bytes, std::size_t bits) {
  return {bytes, bits, unit.counter, position::antenna(unit.position, Distance{2})};
}

/// A telegram with a plausible header and arbitrary packets.
void read(Unit& unit, Script& script, balise::Outcome& outcome) {
  std::uint8_t bytes[27];
  std::memset(bytes, 0xFF, sizeof bytes);
  const auto body = script.take(2 + script.next() % 23);
  std::memcpy(bytes + 3, body.data(), body.size());
  const std::uint8_t a = script.next(), b = script.next();
  bytes[0] = static_cast<std::uint8_t>(0x80 | (a & 1 ? 0x21 : a >> 2));
  bytes[1] = static_cast<std::uint8_t>(b & 0x7F);              // Q_MEDIA, N_PIG, N_TOTAL, M_DUP's first bit
  bytes[2] = static_cast<std::uint8_t>(script.next() | 0x7F);  // M_DUP's second bit, M_MCOUNT
  bytes[3] |= 0x80;
  bytes[4] = 0;  // NID_C, NID_BG: few groups
  bytes[5] &= 0x07;
  balise::read(unit.balise, reading(unit, bytes, 210), unit.situation, outcome);
}

void announce(Unit& unit, Script& script) {
  balise::LinkingList list;
  const std::size_t n = script.next() % 33;
  for (std::size_t i = 0; i < n && !script.left.empty(); ++i) {
    const std::uint8_t a = script.next(), b = script.next();
    balise::LinkingList::Entry e;
    e.D_LINK = Distance{static_cast<double>(a)};
    e.NID_BG = b == 255 ? balise::kIdentityUnknown : static_cast<std::uint16_t>(b & 15);
    e.nominal = (b & 16) != 0;
    e.reaction = *reaction_of((b >> 5) % 3);
    e.Q_LOCACC = Distance{static_cast<double>(a & 63)};
    require(list.entries.push_back(e));
  }
  balise::LinkingReference reference;
  reference.infill = (script.next() & 1) != 0;
  std::optional<balise::CurrentLrbg> current;
  if (const position::Reference* lrbg = position::lrbg(unit.position)) {
    reference.id = lrbg->id;
    reference.place = lrbg->place;
    current = balise::CurrentLrbg{lrbg->id, lrbg->place};
  }
  balise::store(unit.balise.linking, list, reference, position::antenna(unit.position, Distance{2}), current);
}

void play(Unit& unit, Script script) {
  balise::Outcome outcome;
  while (!script.left.empty()) {
    const std::uint8_t what = script.next();
    outcome = {};
    switch (what % 12) {
      case 0:
      case 1:
        read(unit, script, outcome);
        break;
      case 2: {
        const auto bytes = script.take(script.next());
        balise::read(unit.balise, reading(unit, bytes, bytes.size() * 8), unit.situation, outcome);
        break;
      }
      case 3:
        balise::read(unit.balise, reading(unit, {}, 0), unit.situation, outcome);
        break;
      case 4:
        announce(unit, script);
        break;
      case 5: {
        const std::uint8_t s = script.next();
        unit.situation.linking_checked = (s & 1) != 0;
        unit.situation.braking_on_message_error = (s & 2) != 0;
        unit.situation.against_permitted_movement = (s & 12) == 12;
        unit.situation.level_1_2_3 = (s & 16) != 0;
        break;
      }
      case 6:
        if (script.next() % 8 == 0) {
          position::change_cab(unit.position, Distance{20});
          balise::clear(unit.balise.linking);
          balise::abandon(unit.balise);
        }
        break;
      case 7:
        if (!balise::set_cover(unit.balise, {script.next(), 0, Duration{unit.time + 10}}))
          balise::remove_cover(unit.balise, 0, 0);
        break;
      case 8: {
        const auto id = GroupId{0, script.next()};
        (void)position::assign_orientation(unit.position, id, Direction::nominal);
        break;
      }
      default:
        unit.run(script.next());
    }
    unit.situation.counter_rises = position::counter_rises(unit.position);
    unit.take(outcome);
    balise::close_overdue(unit.balise, unit.counter, unit.situation, outcome);
    unit.take(outcome);
    balise::expect(unit.balise, position::antenna(unit.position, Distance{2}), unit.situation, outcome);
    unit.check();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Unit a;
  a.run(0);
  Unit b = a;
  play(a, {{data, size}});
  play(b, {{data, size}});
  require(position::front(a.position) == position::front(b.position));
  require(a.balise.linking.links == b.balise.linking.links);
  return 0;
}
