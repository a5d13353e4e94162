#pragma once
#include "lang/messages.h"
#include "lang/packets/packet_0.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_200.h"
#include "lang/packets/packet_206.h"
#include "lang/packets/packet_207.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_31.h"
#include "lang/packets/packet_32.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_44.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_46.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_73.h"
#include "lang/packets/packet_74.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_4.h"

// Information of system version X = 1 in the form of X = 2, and in the other direction for messages to an RBC of X = 1
// (SUBSET-026-6 6.6.3). decode() and encode() with a version call these.
//
// The form used by the unit is that of 2.1 also for information of 2.2 to 3.0, which says the same in other codes; it
// is that of 3.0 where 2.1 cannot say it: packets 45 and 70 (6.6.5.2). A level of a text of X = 3 "not limited by
// level" is 5, as before; levels ordered are as received, and level 3 of X = 1 and 2 is taken for level 2 by a unit of
// SRS 4.0.0 where it is used (translations 21 and 22).
namespace evc::lang {

/// Q_DIFF of a translated packet 27: 1 or 2, by the train (6.6.3.2.3 [3]); spare on the wire.
inline constexpr std::uint8_t kQ_DIFF_by_train = 3;
/// NID_XUSER of data for a national system, which NID_NTC names (7.4.2.11).
inline constexpr std::uint16_t kNationalSystem = 102;

/// Q_NETWORKTYPE of a trackside with GSM-R alone, and without it (7.5.1.120.1).
inline constexpr std::uint8_t kGsm_r_only = 2, kFrmcs_only = 0;

/// NID_C of a packet 3 of X = 1 that names no country: that of no group.
inline constexpr std::uint16_t kNoCountry = 1024;

template <class... P>
struct Forms {};
/// The other layouts from which a packet can be made.
template <class P>
struct OlderForms {
  using type = Forms<>;
};
#define EVC_OLDER_FORMS(NEW, ...)    \
  template <>                        \
  struct OlderForms<NEW> {           \
    using type = Forms<__VA_ARGS__>; \
  };
EVC_OLDER_FORMS(Packet0, Packet200)
EVC_OLDER_FORMS(Packet3, Packet3_v1_0)
EVC_OLDER_FORMS(Packet27, Packet27_v1_0)
EVC_OLDER_FORMS(Packet39, Packet39_v1_0, Packet239)
EVC_OLDER_FORMS(Packet41, Packet41_v3_0)
EVC_OLDER_FORMS(Packet42, Packet32)
EVC_OLDER_FORMS(Packet44, Packet44_v1_0)
EVC_OLDER_FORMS(Packet45_v3_0, Packet45)
EVC_OLDER_FORMS(Packet46, Packet46_v3_0)
EVC_OLDER_FORMS(Packet51, Packet51_v1_0)
EVC_OLDER_FORMS(Packet68, Packet68_v1_0, Packet206)
EVC_OLDER_FORMS(Packet70, Packet70_v1_0, Packet207)
EVC_OLDER_FORMS(Packet70_v3_0, Packet70, Packet70_v1_0, Packet207)
EVC_OLDER_FORMS(Packet72, Packet72_v1_0, Packet73_v2_2, Packet73_v2_3, Packet73)
EVC_OLDER_FORMS(Packet76, Packet76_v1_0, Packet74_v2_2, Packet74_v2_3, Packet74)
EVC_OLDER_FORMS(Packet79, Packet79_v1_0)
EVC_OLDER_FORMS(Packet80, Packet80_v1_0)
EVC_OLDER_FORMS(Packet131, Packet31)
EVC_OLDER_FORMS(Packet140, Packet140_v1_0)
#undef EVC_OLDER_FORMS

/// 6.6.3.2.3. False: a unit of X = 2 ignores the packet (exceptions 10 to 13).
bool translate(const Packet200& from, Packet0& to);
/// Q_NVSRBKTRG is used as Q_NVSBTSMPERM. V_NVLIMSUPERV and Q_NVLOCACC get their defaults (A.3.2; exception 1a), as do
/// the values of packet 203. The receiver reads packet 203 (exception 16) and keeps stored values (exceptions 1b and
/// 2).
bool translate(const Packet3_v1_0& from, Packet3& to);
bool translate(const Packet27_v1_0& from, Packet27& to);
bool translate(const Packet39_v1_0& from, Packet39& to);
bool translate(const Packet239& from, Packet39& to);
bool translate(const Packet41_v3_0& from, Packet41& to);
/// With kNo_number.
bool translate(const Packet32& from, Packet42& to);
bool translate(const Packet31& from, Packet131& to);
bool translate(const Packet44_v1_0& from, Packet44& to);
/// GSM-R only (6.6.5.2.7). The receiver reads packet 245 of 2.3 (6.6.5.2.6), and knows NID_MN 901999 of X = 1 ([23]).
bool translate(const Packet45& from, Packet45_v3_0& to);
bool translate(const Packet46_v3_0& from, Packet46& to);
bool translate(const Packet51_v1_0& from, Packet51& to);
bool translate(const Packet68_v1_0& from, Packet68& to);
bool translate(const Packet206& from, Packet68& to);
bool translate(const Packet70_v1_0& from, Packet70& to);
bool translate(const Packet207& from, Packet70& to);
/// [18]: the greatest category allowed as the set of those up to it.
bool translate(const Packet70& from, Packet70_v3_0& to);
bool translate(const Packet70_v1_0& from, Packet70_v3_0& to);
bool translate(const Packet207& from, Packet70_v3_0& to);
bool translate(const Packet72_v1_0& from, Packet72& to);
bool translate(const Packet73_v2_2& from, Packet72& to);
bool translate(const Packet73_v2_3& from, Packet72& to);
bool translate(const Packet73& from, Packet72& to);
bool translate(const Packet74_v2_2& from, Packet76& to);
bool translate(const Packet74_v2_3& from, Packet76& to);
bool translate(const Packet74& from, Packet76& to);
bool translate(const Packet76_v1_0& from, Packet76& to);
bool translate(const Packet79_v1_0& from, Packet79& to);
bool translate(const Packet80_v1_0& from, Packet80& to);
bool translate(const Packet140_v1_0& from, Packet140& to);

/// 6.6.3.4.5: messages to an RBC or RIU of X = 1. `M_LEVEL` 4 stays 4.
TrainPacket0_v1_0 for_version_1(const TrainPacket0& from);
TrainPacket1_v1_0 for_version_1(const TrainPacket1& from);
TrainPacket4_v1_0 for_version_1(const TrainPacket4& from);
/// NID_OPERATIONAL is not in the packet of X = 2 and is a parameter (6.6.3.4.5 exception 3a).
TrainPacket11_v1_0 for_version_1(const TrainPacket11& from, var::NID_OPERATIONAL_V1 NID_OPERATIONAL);
TrainMessage132_v1_0 for_version_1(const TrainMessage132& from);
TrainMessage147_v1_0 for_version_1(const TrainMessage147& from);

}  // namespace evc::lang
