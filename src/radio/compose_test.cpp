#include "radio/compose.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_10.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_12.h"
#include "lang/packets/train_packet_2.h"
#include "lang/packets/train_packet_3.h"
#include "lang/packets/train_packet_4.h"
#include "lang/packets/train_packet_5.h"
#include "lang/packets/train_packet_9.h"
#include "lang/telegram.h"

namespace evc::radio {
namespace {

struct Sent {
  std::array<std::uint8_t, 192> bytes{};
  std::size_t size = 0;
  lang::MessageToTrackView view;

  Sent(const Intent& intent, std::uint8_t M_VERSION, const PositionReport& position = {}, TrainDataReport train = {},
       lang::SystemVersion newest = lang::kNewest) {
    const std::array<std::uint64_t, 1> telephone_numbers{0x0612345678FFFFFF};
    const OnBoard unit{.NID_ENGINE = 0xABCDEF, .telephone_numbers = telephone_numbers, .newest = newest};
    size = compose(intent, position, train, unit, M_VERSION, bytes);
    if (size == 0) return;
    view = lang::scan_message_to_track(std::span<const std::uint8_t>(bytes).first(size),
                                       M_VERSION == 0 || lang::system_version(M_VERSION) > newest
                                           ? lang::kNewest_of_baseline_3
                                           : lang::system_version(M_VERSION));
    EXPECT_EQ(view.fault, lang::Fault::none)
        << int{intent.NID_MESSAGE} << " in version " << int{M_VERSION} << ": " << lang::text_of(view.fault);
    EXPECT_EQ(view.T_TRAIN.raw, intent.T_TRAIN);
    EXPECT_EQ(view.NID_ENGINE.raw, 0xABCDEFu);
    EXPECT_EQ(view.NID_MESSAGE, intent.NID_MESSAGE);
  }
  bool has(std::uint16_t packet) const {
    for (const auto& p : view.packets)
      if (p.NID_PACKET == packet) return true;
    return false;
  }
  template <class P>
  P packet() const {
    P p;
    for (const auto& v : view.packets)
      if (v.NID_PACKET == P::info.NID_PACKET) {
        EXPECT_EQ(lang::decode(v, p), lang::Fault::none);
        return p;
      }
    ADD_FAILURE() << "no packet " << int{P::info.NID_PACKET};
    return p;
  }
  template <class M>
  M message() const {
    M m;
    EXPECT_EQ(lang::decode(view, m), lang::Fault::none);
    return m;
  }
};
Intent intent_of(std::uint8_t NID_MESSAGE) {
  Intent i;
  i.NID_MESSAGE = NID_MESSAGE;
  i.T_TRAIN = 4711;
  i.T_TRAIN_REF = 815;
  i.NID_EM = 5;
  return i;
}

TEST(Compose, EveryMessageInEveryVersionReadsBack) {
  for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 7>{0x10, 0x11, 0x20, 0x21, 0x22, 0x23, 0x30})
    for (const std::uint8_t id : std::array<std::uint8_t, 19>{129, 130, 131, 132, 133, 136, 137, 138, 146, 147, 149,
                                                              150, 153, 154, 155, 156, 157, 158, 159}) {
      PositionReport two_groups;
      two_groups.NID_PRVLRBG = 17;
      if ((id == 158 && M_VERSION < 0x20) || ((id == 131 || id == 133) && M_VERSION < 0x23)) {
        EXPECT_EQ(Sent(intent_of(id), M_VERSION).size, 0u) << "not in this version";
        continue;
      }
      EXPECT_GT(Sent(intent_of(id), M_VERSION).size, 0u);
      EXPECT_GT(Sent(intent_of(id), M_VERSION, two_groups).size, 0u);
    }
  std::array<std::uint8_t, 192> bytes{};
  EXPECT_EQ(compose(intent_of(99), {}, {}, {}, 0x21, bytes), 0u);
  EXPECT_EQ(compose(intent_of(136), {}, {}, {}, 0x21, std::span<std::uint8_t>(bytes).first(6)), 0u);
}

TEST(Compose, PositionReport) {
  PositionReport r;
  r.NID_LRBG = 123456;
  r.D_LRBG = 77;
  r.Q_DIRLRBG = r.Q_DLRBG = 1;
  r.L_DOUBTOVER = 5;
  r.L_DOUBTUNDER = 6;
  r.Q_LENGTH = 1;
  r.L_TRAININT = 210;
  r.V_TRAIN = 28;
  r.Q_DIRTRAIN = 1;
  r.mode = Mode::PS;
  r.M_LEVEL = 1;
  r.NID_NTC = 6;
  const auto p = Sent(intent_of(136), 0x21, r).packet<lang::TrainPacket0>();
  EXPECT_EQ(p.NID_LRBG.raw, 123456u);
  EXPECT_EQ(p.D_LRBG.raw, 77);
  EXPECT_EQ(p.L_TRAININT.raw, 210);
  EXPECT_EQ(p.M_MODE.raw, 15);
  EXPECT_EQ(p.NID_NTC.raw, 6);
  EXPECT_EQ(Sent(intent_of(136), 0x10, r).packet<lang::TrainPacket0_v1_0>().M_MODE.raw, 3) << "PS is SH for X = 1";
  r.NID_PRVLRBG = 99;
  EXPECT_EQ(Sent(intent_of(136), 0x21, r).packet<lang::TrainPacket1>().NID_PRVLRBG.raw, 99u);
  EXPECT_FALSE(Sent(intent_of(146), 0x21, r).has(1)) << "no position in an acknowledgement";
}

TEST(Compose, ErrorsAndRunningNumber) {
  Intent i = intent_of(136);
  i.M_ERROR = ErrorReport::safety_critical_fault;
  i.running_number = true;
  TrainDataReport train;
  train.NID_OPERATIONAL = 0x12345FFF;
  EXPECT_EQ(Sent(i, 0x21, {}, train).packet<lang::TrainPacket4>().M_ERROR.raw, 6);
  EXPECT_EQ(Sent(i, 0x21, {}, train).packet<lang::TrainPacket5>().NID_OPERATIONAL.raw, 0x12345FFFu);
  EXPECT_EQ(Sent(i, 0x10, {}, train).packet<lang::TrainPacket4_v1_0>().M_ERROR.raw, 7);
  EXPECT_FALSE(Sent(i, 0x10, {}, train).has(5));
  i.M_ERROR = ErrorReport::double_repositioning;
  EXPECT_FALSE(Sent(i, 0x10, {}, train).has(4)) << "X = 1 has no such error";
  EXPECT_TRUE(Sent(i, 0x20, {}, train).has(4));
}

// 7.5.1.64 of 4.0.0, 6.6.3.4.5 [2], 6.6.5.3.7 [3], 6.6.5.4.6 [2].
TEST(Compose, ErrorsOfTheOdometerByVersion) {
  for (const ErrorReport error : {ErrorReport::odometer_impaired, ErrorReport::odometer_beyond_safety}) {
    Intent i = intent_of(136);
    i.M_ERROR = error;
    for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 4>{0x10, 0x11, 0x20, 0x21})
      EXPECT_FALSE(Sent(i, M_VERSION).has(4));
    for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 3>{0x22, 0x23, 0x30})
      EXPECT_EQ(Sent(i, M_VERSION).packet<lang::TrainPacket4_v2_2>().M_ERROR.raw, static_cast<std::uint8_t>(error));
  }
}

TEST(Compose, EmergencyStopAnswers) {
  for (std::uint8_t q = 0; q < 4; ++q) {
    Intent i = intent_of(147);
    i.Q_EMERGENCYSTOP = q;
    EXPECT_EQ(Sent(i, 0x21).message<lang::TrainMessage147>().Q_EMERGENCYSTOP.raw, q);
    if (q == 3) continue;  // X = 1 does not have this code
    EXPECT_EQ(Sent(i, 0x10).message<lang::TrainMessage147_v1_0>().Q_EMERGENCYSTOP.raw, q);
    EXPECT_EQ(Sent(i, 0x10).message<lang::TrainMessage147_v1_0>().NID_EM.raw, 5);
  }
}

TEST(Compose, MaRequest) {
  Intent i = intent_of(132);
  i.Q_MARQSTREASON = 1 | 8;
  i.NID_LTRBG = 4242;
  EXPECT_EQ(Sent(i, 0x20).message<lang::TrainMessage132>().Q_MARQSTREASON.raw, 9);
  EXPECT_EQ(Sent(i, 0x20).packet<lang::TrainPacket9>().NID_LTRBG.raw, 4242u);
  EXPECT_EQ(Sent(i, 0x10).message<lang::TrainMessage132_v1_0>().Q_TRACKDEL.raw, 1);
  i.Q_MARQSTREASON = 1;
  EXPECT_EQ(Sent(i, 0x10).message<lang::TrainMessage132_v1_0>().Q_TRACKDEL.raw, 0);
}

TEST(Compose, AnswersNameTheirMessage) {
  EXPECT_EQ(Sent(intent_of(137), 0x21).message<lang::TrainMessage137>().T_TRAIN_REF.raw, 815u);
  EXPECT_EQ(Sent(intent_of(138), 0x21).message<lang::TrainMessage138>().T_TRAIN_REF.raw, 815u);
  EXPECT_EQ(Sent(intent_of(146), 0x10).message<lang::TrainMessage146>().T_TRAIN_REF.raw, 815u);
  Intent i = intent_of(157);
  i.Q_STATUS = 2;
  EXPECT_EQ(Sent(i, 0x21).message<lang::TrainMessage157>().Q_STATUS.raw, 2);
  i = intent_of(158);
  i.NID_TEXTMESSAGE = 66;
  EXPECT_EQ(Sent(i, 0x21).message<lang::TrainMessage158>().NID_TEXTMESSAGE.raw, 66);
}

TEST(Compose, TrainData) {
  TrainDataReport t;
  t.NC_CDTRAIN = 2;
  t.NC_TRAIN = 4;
  t.L_TRAIN = 200;
  t.V_MAXTRAIN = 32;
  t.M_AXLELOADCAT = 7;
  ASSERT_TRUE(t.tractions.push_back({1, 12}) && t.NID_NTC.push_back(6));
  const auto p = Sent(intent_of(129), 0x21, {}, t).packet<lang::TrainPacket11>();
  EXPECT_EQ(p.NC_CDTRAIN.raw, 2);
  EXPECT_EQ(p.L_TRAIN.raw, 200);
  EXPECT_EQ(p.M_AXLELOADCAT.raw, 7);
  ASSERT_EQ(p.tractions.size(), 1u);
  EXPECT_EQ(p.tractions[0].NID_CTRACTION.raw, 12);
  EXPECT_EQ(p.ntcs[0].NID_NTC.raw, 6);
  const auto old = Sent(intent_of(129), 0x10, {}, t).packet<lang::TrainPacket11_v1_0>();
  EXPECT_EQ(old.NC_TRAIN.raw, (1u << 3) | (1u << 11)) << "130 mm, passenger";
  t.NC_TRAIN = 5;
  EXPECT_EQ(Sent(intent_of(129), 0x11, {}, t).packet<lang::TrainPacket11_v1_0>().NC_TRAIN.raw, 1u << 3)
      << "several: none";
  EXPECT_EQ(old.M_AXLELOAD.raw, 45) << "22.5 t";
  EXPECT_EQ(old.NID_OPERATIONAL.raw, 0xFFFFFFFFu);
  EXPECT_TRUE(old.tractions.empty());
  EXPECT_EQ(old.ntcs.size(), 1u);
}

TEST(Compose, VersionsOrTelephoneNumbers) {  // 6.6.3.4.1.1
  const auto numbers = Sent(intent_of(159), 0x10).packet<lang::TrainPacket3>();
  ASSERT_EQ(numbers.numbers.size(), 1u);
  EXPECT_EQ(numbers.numbers[0].NID_RADIO.raw, 0x0612345678FFFFFFu);
  EXPECT_TRUE(Sent(intent_of(159), 0x20).has(3));
  const auto versions = Sent(intent_of(159), 0x21, {}, {}, lang::kNewest_of_baseline_3).packet<lang::TrainPacket2>();
  EXPECT_EQ(versions.M_VERSION.raw, 0x21);
  EXPECT_EQ(versions.versions.size(), 3u);
}

TEST(Compose, VersionsOfAUnitOf4_0_0) {  // 6.4.2.2
  for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 4>{0x21, 0x22, 0x23, 0x30}) {
    const auto versions = Sent(intent_of(159), M_VERSION).packet<lang::TrainPacket2>();
    EXPECT_EQ(versions.M_VERSION.raw, 0x30);
    std::vector<int> further;
    for (const auto& e : versions.versions) further.push_back(e.M_VERSION.raw);
    EXPECT_EQ(further, (std::vector<int>{0x23, 0x22, 0x21, 0x20, 0x11, 0x10}));
  }
}

// A unit of Baseline 3 speaks 2.1 with an RBC of a later version.
TEST(Compose, InTheOlderOfBothVersions) {
  for (const std::uint8_t M_VERSION : std::array<std::uint8_t, 2>{0x22, 0x23}) {
    const Sent report(intent_of(136), M_VERSION, {}, {}, lang::kNewest_of_baseline_3);
    EXPECT_EQ(report.packet<lang::TrainPacket0>().M_MODE.raw, 6);
    EXPECT_EQ(Sent(intent_of(131), M_VERSION, {}, {}, lang::kNewest_of_baseline_3).size, 0u);
  }
}

// 6.6.3.4.5 [1], 6.6.5.3.7 [1], 6.6.5.5.6 [1], 6.6.5.6.3 [1].
TEST(Compose, ModeLevelAndStandstillByVersion) {
  PositionReport r;
  r.mode = Mode::AD;
  r.M_LEVEL = evc::M_LEVEL(Level::L3);  // level 2, ordered as level 3
  r.standstill = true;
  const auto of_2_1 = Sent(intent_of(136), 0x21, r).packet<lang::TrainPacket0>();
  EXPECT_EQ(of_2_1.M_MODE.raw, 0);
  EXPECT_EQ(of_2_1.M_LEVEL.raw, 4);
  EXPECT_EQ(of_2_1.V_TRAIN.raw, 0);
  const auto of_2_2 = Sent(intent_of(136), 0x22, r).packet<lang::TrainPacket0_v2_2>();
  EXPECT_EQ(of_2_2.M_MODE.raw, 16);
  EXPECT_EQ(of_2_2.M_LEVEL.raw, 4);
  EXPECT_EQ(of_2_2.V_TRAIN.raw, 0);
  r.mode = Mode::SM;
  r.Q_LENGTH = 2;
  r.L_TRAININT = 77;
  const auto of_2_3 = Sent(intent_of(136), 0x23, r).packet<lang::TrainPacket0_v2_3>();
  EXPECT_EQ(of_2_3.M_MODE.raw, 17);
  EXPECT_EQ(of_2_3.M_LEVEL.raw, 4);
  EXPECT_EQ(of_2_3.V_TRAIN.raw, 127);
  EXPECT_EQ(of_2_3.L_TRAININT.raw, 77);
  const auto of_3_0 = Sent(intent_of(136), 0x30, r).packet<lang::TrainPacket0_v3_0>();
  EXPECT_EQ(of_3_0.M_LEVEL.raw, 3);
  r.standstill = false;
  r.V_TRAIN = 4;
  EXPECT_EQ(Sent(intent_of(136), 0x30, r).packet<lang::TrainPacket0_v3_0>().V_TRAIN.raw, 4);
}

// 8.4.4.4.3, 6.5.2.3.5.2, 6.5.2.3.6.3: what a start of mission reports beside the position.
TEST(Compose, StartOfMissionReportByVersion) {
  Intent intent = intent_of(157);
  intent.train_data = intent.consist_length = true;
  TrainDataReport train;
  train.L_TRAIN = 200;
  train.consist = ConsistLength{};
  train.consist->front.max = Distance{12.2};
  const Sent of_2_1(intent, 0x21, {}, train), of_2_2(intent, 0x22, {}, train), of_2_3(intent, 0x23, {}, train);
  EXPECT_FALSE(of_2_1.has(10) || of_2_1.has(11));
  EXPECT_TRUE(!of_2_2.has(10) && of_2_2.has(11));
  EXPECT_EQ(of_2_3.packet<lang::TrainPacket11>().L_TRAIN.raw, 200);
  const auto consist = of_2_3.packet<lang::TrainPacket10>();
  EXPECT_EQ(consist.Q_SAFECONSISTLENGTH.raw, 1);
  EXPECT_EQ(consist.L_CONSISTFRONTENGINEMAX.raw, 13) << "rounded up";
}

TEST(Compose, MessagesOfSupervisedManoeuvre) {  // 8.6.2.1, 8.6.3.1
  TrainDataReport train;
  train.N_AXLE = 4;
  ASSERT_TRUE(train.tractions.push_back({1, 12}));
  Intent request = intent_of(message::request_for_sm);
  EXPECT_FALSE(Sent(request, 0x23, {}, train).has(12));
  request.default_train_data = true;
  const Sent sent(request, 0x30, {}, train);
  EXPECT_EQ(sent.packet<lang::TrainPacket10>().Q_SAFECONSISTLENGTH.raw, 0);
  const auto data = sent.packet<lang::TrainPacket12>();
  EXPECT_EQ(data.N_AXLE.raw, 4);
  ASSERT_EQ(data.tractions.size(), 1u);
  EXPECT_EQ(data.tractions[0].NID_CTRACTION.raw, 12);
  train.consist =
      ConsistLength{{Distance{10.9}, Distance{10.1}, Distance{5000.0}}, {Distance{-1.0}, Distance{}, Distance{30.0}}};
  const auto length = Sent(intent_of(message::safe_consist_length), 0x23, {}, train).packet<lang::TrainPacket10>();
  EXPECT_EQ(length.L_CONSISTFRONTENGINENOM.raw, 10);
  EXPECT_EQ(length.L_CONSISTFRONTENGINEMIN.raw, 10);
  EXPECT_EQ(length.L_CONSISTFRONTENGINEMAX.raw, 4095);
  EXPECT_EQ(length.L_CONSISTREARENGINENOM.raw, 0);
  EXPECT_EQ(length.L_CONSISTREARENGINEMAX.raw, 30);
}

TEST(Compose, EndOfMissionSaysWhetherADeskIsOpen) {  // 8.6.10, 6.5.2.3.7.2
  Intent intent = intent_of(150);
  EXPECT_EQ(Sent(intent, 0x23).message<lang::TrainMessage150_v2_3>().Q_DESK.raw, 0);
  intent.desk_open = true;
  EXPECT_EQ(Sent(intent, 0x30).message<lang::TrainMessage150_v2_3>().Q_DESK.raw, 1);
  EXPECT_EQ(Sent(intent, 0x22).message<lang::TrainMessage150>().NID_ENGINE.raw, 0xABCDEFu);
}

TEST(Compose, RadioInfillRequest) {  // 8.6.11
  Intent intent = intent_of(message::radio_infill_request);
  intent.signal = {426, 101};
  for (const std::uint8_t passed : {std::uint8_t{0}, std::uint8_t{1}}) {
    intent.Q_INFILL = passed;
    const Sent sent(intent, 0x21);
    const auto m = sent.message<lang::TrainMessage153>();
    EXPECT_EQ(m.NID_C.raw, 426);
    EXPECT_EQ(m.NID_BG.raw, 101);
    EXPECT_EQ(m.Q_INFILL.raw, passed);
    EXPECT_TRUE(sent.has(0));
  }
}

}  // namespace
}  // namespace evc::radio
