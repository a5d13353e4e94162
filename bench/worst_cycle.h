#pragma once
// Cycles made to be slow: a gamma train whose stores three groups of eight full telegrams have filled, and a fourth one
// that replaces all of it in one cycle. What the telegrams contain follows from a number each: a search changes one
// at a time and keeps what was slower.
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/input_stream.h"
#include "lang/packets/packet_141.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_52.h"
#include "lang/packets/packet_67.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_71.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "ride.h"

namespace evc::bench {

/// Seven steps of each deceleration, every brake, every input of 3.13.
inline const char* const kHostileConfiguration = R"({"cycle_ms":100,"srs":"3.6.0","train":{"schema":"etcs-train/1",
"brake_model":"gamma",
"A_brake_emergency":[[0,1.289],[40,1.241],[80,1.195],[120,1.14],[160,1.081],[200,1.024],[240,0.981]],
"A_brake_service":[[0,0.9],[40,0.85],[80,0.8],[120,0.75],[160,0.7],[200,0.65],[240,0.6]],
"A_brake_normal_service":[[0,0.7],[40,0.66],[80,0.62],[120,0.58],[160,0.54],[200,0.5],[240,0.46]],
"Kdry_rst":[[0,0.8]],"Kwet_rst":[[0,0.9]],"T_brake_emergency_s":3,"T_brake_service_s":4,
"T_brake_emergency_react_s":1,"T_brake_service_react_s":1,
"Kn_plus":[[0,0.1],[50,0.2],[100,0.3],[150,0.2],[200,0.1]],
"Kn_minus":[[0,0.1],[50,0.2],[100,0.3],[150,0.2],[200,0.1]],"length_m":200,"max_speed_kmh":350,
"service_brake_feedback":true,"special_brakes":{"regenerative":"affects both","eddy current":"affects both",
"models":[{"with":["regenerative"],
"A_brake_service":[[0,1.0],[40,0.95],[80,0.9],[120,0.85],[160,0.8],[200,0.75],[240,0.7]]}]}},
"national_values":{"Q_NVSBTSMPERM":true,"Q_NVGUIPERM":true,"Q_NVSBFBPERM":true,"V_NVREL":40,
"Q_NVDRIVER_ADHES":true}})";

constexpr std::size_t kBalises = 8;
constexpr std::size_t kGroups = 4;
/// What decides on everything: a number for each telegram.
using Genome = std::array<std::uint32_t, kGroups * kBalises>;

/// A telegram that is filled packet by packet.
class Filler {
 public:
  Filler(std::uint16_t NID_BG, std::size_t N_PIG, std::uint32_t seed) : out_(telegram_.bytes), random_(seed) {
    lang::TelegramHeader header;
    header.N_PIG.raw = static_cast<std::uint8_t>(N_PIG);
    header.N_TOTAL.raw = kBalises - 1;
    header.NID_C.raw = 1;
    header.NID_BG.raw = NID_BG;
    lang::begin_telegram(out_, header);
  }
  unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
  /// The variable gets one of the first `n` codes from `least` on.
  template <class V>
  void any(V& variable, unsigned n, unsigned least = 0) {
    variable.raw = static_cast<decltype(variable.raw)>(least + below(n));
  }
  /// False when there is no room for it.
  template <class P>
  bool add(const P& packet) {
    std::array<std::uint8_t, 512> bytes{};
    BitWriter alone(bytes);
    lang::encode(alone, packet);
    constexpr std::size_t end = 8;  // packet 255
    if (alone.faulty() || out_.position() + alone.position() + end > Telegram::bits) return false;
    lang::encode(out_, packet);
    return true;
  }
  /// As many elements of a packet as there is room for, `most` at most.
  template <class P, class List, class Make>
  void add_list(P packet, List P::*list, unsigned most, Make make) {
    P last = packet;
    for (unsigned i = 0; i < most; ++i) {
      typename List::value_type element;
      make(element);
      if (!(packet.*list).push_back(element)) break;
      std::array<std::uint8_t, 512> bytes{};
      BitWriter alone(bytes);
      lang::encode(alone, packet);
      if (alone.faulty() || out_.position() + alone.position() + 8 > Telegram::bits) break;
      last = packet;
    }
    (void)add(last);
  }
  Telegram finish() {
    lang::end_telegram(out_, Telegram::bits);
    return telegram_;
  }

 private:
  Telegram telegram_;
  BitWriter out_;
  std::mt19937 random_;
};

template <class P>
P forward() {
  P p;
  p.Q_DIR.raw = 1;
  p.Q_SCALE.raw = 1;
  return p;
}

inline void add_authority(Filler& f) {
  auto p = forward<lang::Packet12>();
  p.V_MAIN.raw = 70;
  p.T_EMA.raw = 1023;
  for (unsigned i = f.below(12); i > 0; --i) {
    lang::Packet12_sections section;
    f.any(section.L_SECTION, 2000, 500);
    (void)p.sections.push_back(section);
  }
  f.any(p.L_ENDSECTION, 5000, 2000);
  p.Q_DANGERPOINT.raw = 1;
  f.any(p.D_DP, 300);
  p.V_RELEASEDP.raw = f.below(2) == 0 ? 126 : 4;  // 126: the unit computes the release speed
  p.Q_OVERLAP.raw = static_cast<std::uint8_t>(f.below(2));
  f.any(p.D_STARTOL, 300);
  p.T_OL.raw = 1023;
  f.any(p.D_OL, 500, 300);
  p.V_RELEASEOL.raw = f.below(2) == 0 ? 126 : 4;
  (void)f.add(p);
}

inline void add_gradients(Filler& f) {
  auto p = forward<lang::Packet21>();
  f.any(p.Q_GDIR, 2);
  f.any(p.G_A, 25);
  const unsigned way = 20 + f.below(600);
  f.add_list(p, &lang::Packet21::steps, 31, [&](lang::Packet21_steps& s) {
    f.any(s.D_GRADIENT, way, 10);
    f.any(s.Q_GDIR, 2);
    f.any(s.G_A, 25);
  });
}

inline void add_speeds(Filler& f) {
  auto p = forward<lang::Packet27>();
  p.V_STATIC.raw = 60;
  const unsigned way = 20 + f.below(600);
  const bool falling = f.below(2) == 0;
  unsigned v = 60;
  f.add_list(p, &lang::Packet27::steps, 31, [&](lang::Packet27_steps& s) {
    f.any(s.D_STATIC, way, 10);
    if (v > 3) --v;
    s.V_STATIC.raw = static_cast<std::uint8_t>(falling ? v : 2 + f.below(58));
  });
}

inline void add_restrictions(Filler& f) {
  for (unsigned i = 0; i < 12; ++i) {
    auto p = forward<lang::Packet65>();
    f.any(p.NID_TSR, 250);
    f.any(p.D_TSR, 8000, 100);
    f.any(p.L_TSR, 600, 20);
    f.any(p.Q_FRONT, 2);
    f.any(p.V_TSR, 50, 2);
    if (!f.add(p)) return;
  }
}

inline void add_axle_loads(Filler& f) {
  auto p = forward<lang::Packet51>();
  const auto fill = [&](auto& s) {
    f.any(s.D_AXLELOAD, 800, 50);
    f.any(s.L_AXLELOAD, 500, 20);
    lang::Packet51_categories c;
    f.any(c.V_AXLELOAD, 50, 2);
    (void)s.categories.push_back(c);
  };
  fill(p);
  f.add_list(p, &lang::Packet51::restrictions, 31, fill);
}

inline void add_conditions(Filler& f) {
  auto p = forward<lang::Packet68>();
  const auto fill = [&](auto& s) {
    f.any(s.D_TRACKCOND, 700, 20);
    f.any(s.L_TRACKCOND, 700, 20);
    // Powerless sections, air tightness, inhibition of special brakes: those that change the brakes among them.
    f.any(s.M_TRACKCOND, 10);
  };
  fill(p);
  f.add_list(p, &lang::Packet68::conditions, 31, fill);
}

inline void add_modes(Filler& f) {
  auto p = forward<lang::Packet80>();
  const auto fill = [&](auto& s) {
    f.any(s.D_MAMODE, 1500, 50);
    s.M_MAMODE.raw = f.below(2) == 0 ? 0 : 2;  // on sight, limited supervision
    f.any(s.V_MAMODE, 30, 2);
    f.any(s.L_MAMODE, 400, 50);
    f.any(s.L_ACKMAMODE, 200);
    f.any(s.Q_MAMODE, 2);
  };
  fill(p);
  f.add_list(p, &lang::Packet80::modes, 31, fill);
}

inline void add_links(Filler& f) {
  auto p = forward<lang::Packet5>();
  const auto fill = [&](auto& s) {
    f.any(s.D_LINK, 900, 300);
    f.any(s.NID_BG, 10000, 100);
    f.any(s.Q_LINKORIENTATION, 2);
    s.Q_LINKREACTION.raw = 2;
    f.any(s.Q_LOCACC, 30, 2);
  };
  fill(p);
  f.add_list(p, &lang::Packet5::links, 31, fill);
}

/// Permitted braking distances: each speed is searched for in steps (3.11.11).
inline void add_braking_distances(Filler& f) {
  auto p = forward<lang::Packet52>();
  const auto fill = [&](auto& s) {
    f.any(s.D_PBD, 3000, 300);
    f.any(s.Q_GDIR, 2);
    f.any(s.G_PBDSR, 20);
    f.any(s.Q_PBDSR, 2);
    f.any(s.D_PBDSR, 1500, 50);
    f.any(s.L_PBDSR, 800, 50);
  };
  fill(p);
  f.add_list(p, &lang::Packet52::restrictions, 31, fill);
}

inline void add_crossing(Filler& f) {
  auto p = forward<lang::Packet88>();
  f.any(p.NID_LX, 250);
  f.any(p.D_LX, 8000, 200);
  f.any(p.L_LX, 100, 5);
  p.Q_LXSTATUS.raw = 1;
  f.any(p.V_LX, 20, 2);
  f.any(p.Q_STOPLX, 2);
  f.any(p.L_STOPLX, 200, 5);
  (void)f.add(p);
}

inline void add_adhesion(Filler& f) {
  auto p = forward<lang::Packet71>();
  f.any(p.D_ADHESION, 5000);
  f.any(p.L_ADHESION, 3000, 100);
  (void)f.add(p);
}

inline void add_any(Filler& f) {
  using Add = void (*)(Filler&);
  constexpr Add all[] = {add_restrictions, add_axle_loads,        add_conditions, add_modes,
                         add_links,        add_braking_distances, add_crossing,   add_adhesion};
  // Another kind fills what the first left.
  const unsigned first = f.below(std::size(all));
  all[first](f);
  all[(first + 1 + f.below(std::size(all) - 1)) % std::size(all)](f);
}

/// The first three balises of a group carry authority, gradients and speeds, the others what their numbers say.
inline std::vector<Telegram> hostile_group(std::size_t n, const Genome& genome) {
  std::vector<Telegram> telegrams;
  for (std::size_t i = 0; i < kBalises; ++i) {
    Filler f(static_cast<std::uint16_t>(n + 1), i, genome[n * kBalises + i]);
    if (i == 0) add_authority(f);
    if (i == 1) add_gradients(f);
    if (i == 2) add_speeds(f);
    add_any(f);
    telegrams.push_back(f.finish());
  }
  return telegrams;
}

/// Up to the cycle that is to be measured: call `step` of the ride.
inline std::unique_ptr<Ride> hostile_ride(const Genome& genome) {
  const auto configuration = io::read_configuration(kHostileConfiguration, "configuration");
  if (!configuration) throw std::runtime_error(configuration.error().text());
  auto ride = std::make_unique<Ride>(configuration->for_kernel());
  ride->start();
  double v = 0.0;
  for (; v < 8.0; v += 0.1) ride->cycle(v);
  const double fastest = 10.0 + genome[0] % 60;
  for (std::size_t n = 0; n < kGroups; ++n) {
    const auto telegrams = hostile_group(n, genome);
    ride->read(telegrams);
    if (n + 1 == kGroups) break;
    ride->cycle(v);
    for (int i = 0; i < 40; ++i) ride->cycle(v = std::min(fastest, v + 0.5));
  }
  ride->prepare(v);
  return ride;
}

}  // namespace evc::bench
