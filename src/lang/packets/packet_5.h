#pragma once
#include "lang/variables.h"

namespace evc::lang {

struct Packet5_links {
  var::D_LINK D_LINK;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::Q_LINKORIENTATION Q_LINKORIENTATION;
  var::Q_LINKREACTION Q_LINKREACTION;
  var::Q_LOCACC Q_LOCACC;
  friend constexpr bool operator==(const Packet5_links&, const Packet5_links&) = default;
};

/// Packet 5, Linking (7.4.2.2), system version 1.0, 1.1, 2.0, 2.1, 2.2, 2.3, 3.0.
struct Packet5 {
  static constexpr PacketInfo info{5,
                                   "Linking",
                                   Direction::to_train,
                                   v1_0 | v1_1 | v2_0 | v2_1 | v2_2 | v2_3 | v3_0,
                                   media::balise | media::loop | media::RBC | media::RIU,
                                   "7.4.2.2",
                                   ""};
  var::Q_DIR Q_DIR;
  var::Q_SCALE Q_SCALE;
  var::D_LINK D_LINK;
  var::Q_NEWCOUNTRY Q_NEWCOUNTRY;
  var::NID_C NID_C;  ///< only if Q_NEWCOUNTRY == 1
  var::NID_BG NID_BG;
  var::Q_LINKORIENTATION Q_LINKORIENTATION;
  var::Q_LINKREACTION Q_LINKREACTION;
  var::Q_LOCACC Q_LOCACC;
  InplaceVector<Packet5_links, 31> links;
  /// The element before the counter, in the form of the others.
  constexpr Packet5_links first_links() const {
    return {D_LINK, Q_NEWCOUNTRY, NID_C, NID_BG, Q_LINKORIENTATION, Q_LINKREACTION, Q_LOCACC};
  }
  friend constexpr bool operator==(const Packet5&, const Packet5&) = default;
};

template <>
inline constexpr auto layout_of<Packet5_links> = layout(&Packet5_links::D_LINK, &Packet5_links::Q_NEWCOUNTRY,
                                                        when(&Packet5_links::Q_NEWCOUNTRY, is(1),
                                                             &Packet5_links::NID_C),
                                                        &Packet5_links::NID_BG, &Packet5_links::Q_LINKORIENTATION,
                                                        &Packet5_links::Q_LINKREACTION, &Packet5_links::Q_LOCACC);

template <>
inline constexpr auto layout_of<Packet5> = layout(&Packet5::Q_DIR, &Packet5::Q_SCALE, &Packet5::D_LINK,
                                                  &Packet5::Q_NEWCOUNTRY,
                                                  when(&Packet5::Q_NEWCOUNTRY, is(1), &Packet5::NID_C),
                                                  &Packet5::NID_BG, &Packet5::Q_LINKORIENTATION,
                                                  &Packet5::Q_LINKREACTION, &Packet5::Q_LOCACC,
                                                  repeat<var::N_ITER>("links", &Packet5::links));

}  // namespace evc::lang
