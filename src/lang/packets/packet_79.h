#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet79_references {
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_POSOFF D_POSOFF;
  var::Q_MPOSITION Q_MPOSITION;
  var::M_POSITION M_POSITION;
  friend constexpr bool operator==(const Packet79_references&, const Packet79_references&) = default;
};

/// Packet 79, Geographical position (7.4.2.25), system version 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet79 {
  static constexpr PacketInfo info{79,
                                   "Geographical position",
                                   Direction::to_train,
                                   v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::RBC,
                                   "7.4.2.25",
                                   "M_POSITION has 24 bits"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_POSOFF D_POSOFF;
  var::Q_MPOSITION Q_MPOSITION;
  var::M_POSITION M_POSITION;
  InplaceVector<Packet79_references, 31> references;
  /// The element before the counter, in the form of the others.
  constexpr Packet79_references first_references() const {
    return {Q_NEWCOUNTRY, NID_C, NID_BG, D_POSOFF, Q_MPOSITION, M_POSITION};
  }
  friend constexpr bool operator==(const Packet79&, const Packet79&) = default;
};

template <>
inline constexpr auto layout_of<Packet79_references> =
    layout(&Packet79_references::Q_NEWCOUNTRY,
           when(&Packet79_references::Q_NEWCOUNTRY, is(1), &Packet79_references::NID_C), &Packet79_references::NID_BG,
           &Packet79_references::D_POSOFF, &Packet79_references::Q_MPOSITION, &Packet79_references::M_POSITION);

template <>
inline constexpr auto layout_of<Packet79> = layout(&Packet79::Q_DIR, &Packet79::Q_SCALE, &Packet79::Q_NEWCOUNTRY,
                                                   when(&Packet79::Q_NEWCOUNTRY, is(1), &Packet79::NID_C),
                                                   &Packet79::NID_BG, &Packet79::D_POSOFF, &Packet79::Q_MPOSITION,
                                                   &Packet79::M_POSITION,
                                                   repeat<var::N_ITER>("references", &Packet79::references));

struct Packet79_v1_0_references {
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_POSOFF D_POSOFF;
  var::Q_MPOSITION Q_MPOSITION;
  var::M_POSITION_V1 M_POSITION;
  friend constexpr bool operator==(const Packet79_v1_0_references&, const Packet79_v1_0_references&) = default;
};

/// Packet 79, Geographical position (6.5.1.5.17), system version 1.0, 1.1.
struct Packet79_v1_0 {
  static constexpr PacketInfo info{
      79,           "Geographical position", Direction::to_train, v1_0 | v1_1, media::balise | media::RBC,
      "6.5.1.5.17", "M_POSITION has 20 bits"};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::D_POSOFF D_POSOFF;
  var::Q_MPOSITION Q_MPOSITION;
  var::M_POSITION_V1 M_POSITION;
  InplaceVector<Packet79_v1_0_references, 31> references;
  /// The element before the counter, in the form of the others.
  constexpr Packet79_v1_0_references first_references() const {
    return {Q_NEWCOUNTRY, NID_C, NID_BG, D_POSOFF, Q_MPOSITION, M_POSITION};
  }
  friend constexpr bool operator==(const Packet79_v1_0&, const Packet79_v1_0&) = default;
};

template <>
inline constexpr auto layout_of<Packet79_v1_0_references> =
    layout(&Packet79_v1_0_references::Q_NEWCOUNTRY,
           when(&Packet79_v1_0_references::Q_NEWCOUNTRY, is(1), &Packet79_v1_0_references::NID_C),
           &Packet79_v1_0_references::NID_BG, &Packet79_v1_0_references::D_POSOFF,
           &Packet79_v1_0_references::Q_MPOSITION, named("M_POSITION", &Packet79_v1_0_references::M_POSITION));

template <>
inline constexpr auto layout_of<Packet79_v1_0> =
    layout(&Packet79_v1_0::Q_DIR, &Packet79_v1_0::Q_SCALE, &Packet79_v1_0::Q_NEWCOUNTRY,
           when(&Packet79_v1_0::Q_NEWCOUNTRY, is(1), &Packet79_v1_0::NID_C), &Packet79_v1_0::NID_BG,
           &Packet79_v1_0::D_POSOFF, &Packet79_v1_0::Q_MPOSITION, named("M_POSITION", &Packet79_v1_0::M_POSITION),
           repeat<var::N_ITER>("references", &Packet79_v1_0::references));

}  // namespace evc::lang
