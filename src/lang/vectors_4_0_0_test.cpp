// Packets and messages of SRS 4.0.0, written field by field from the tables of its chapters 6, 7 and 8 and read by the
// unit. Neither the reference data nor the writer of this room has a part in the bits.
#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "lang/decode.h"
#include "lang/messages.h"
#include "lang/packets.h"
#include "lang/telegram.h"

namespace evc::lang {
namespace {

constexpr SystemVersion v22{2, 2}, v23{2, 3}, v30{3, 0};

/// Fields as "value/bits", most significant bit first.
struct Bits {
  std::vector<std::uint8_t> bytes;
  std::size_t count = 0;

  explicit Bits(const std::string& fields) {
    std::istringstream in(fields);
    std::uint64_t value = 0;
    unsigned width = 0;
    char slash = 0;
    while (in >> value >> slash >> width)
      for (unsigned i = width; i-- > 0;) push(((value >> i) & 1u) != 0);
  }
  void push(bool one) {
    if (count % 8 == 0) bytes.push_back(0);
    if (one) bytes.back() = static_cast<std::uint8_t>(bytes.back() | (0x80u >> (count % 8)));
    ++count;
  }
};

/// 8.4.2.1: the header of a single balise, packets, and the end of the telegram.
std::string telegram(unsigned M_VERSION, const std::string& packets) {
  return "1/1 " + std::to_string(M_VERSION) + "/7 0/1 0/3 0/3 0/2 255/8 1/10 9/14 1/1 " + packets + " 255/8";
}

/// The only packet of a telegram as the unit reads it.
template <class P>
P read_packet(unsigned M_VERSION, const std::string& fields) {
  const Bits bits(telegram(M_VERSION, fields));
  const TelegramView t = scan_telegram(bits.bytes, bits.count);
  EXPECT_EQ(t.fault, Fault::none) << text_of(t.fault) << " at bit " << t.at.bit;
  P packet{};
  if (t.packets.size() != 1) {
    ADD_FAILURE() << "packets: " << t.packets.size();
    return packet;
  }
  EXPECT_EQ(decode(t.packets[0], packet), Fault::none);
  return packet;
}

Fault fault_of_packet(unsigned M_VERSION, const std::string& fields) {
  const Bits bits(telegram(M_VERSION, fields));
  return scan_telegram(bits.bytes, bits.count).fault;
}

// --- to the train

const std::string kPacket31 = "31/8 1/2 65/13 1/2 1200/15 26/10 77/14 1/1";
const std::string kPacket32 = "32/8 2/2 49/13 1/1 26/10 77/14 0/1";

TEST(Vectors4_0_0, RbcsWithFrmcsOnly) {  // 7.4.2.7.1, 7.4.2.7.2
  for (const unsigned M_VERSION : {0x23u, 0x30u}) {
    const auto transition = read_packet<Packet131>(M_VERSION, kPacket31);
    EXPECT_EQ(transition.Q_DIR.raw, 1);
    EXPECT_EQ(transition.Q_SCALE.raw, 1);
    EXPECT_EQ(transition.D_RBCTR.raw, 1200);
    EXPECT_EQ(transition.NID_C.raw, 26);
    EXPECT_EQ(transition.NID_RBC.raw, 77);
    EXPECT_EQ(transition.NID_RADIO.raw, kNo_number);
    EXPECT_EQ(transition.Q_SLEEPSESSION.raw, 1);
    const auto session = read_packet<Packet42>(M_VERSION, kPacket32);
    EXPECT_EQ(session.Q_DIR.raw, 2);
    EXPECT_EQ(session.Q_RBC.raw, 1);
    EXPECT_EQ(session.NID_C.raw, 26);
    EXPECT_EQ(session.NID_RBC.raw, 77);
    EXPECT_EQ(session.NID_RADIO.raw, kNo_number);
    EXPECT_EQ(session.Q_SLEEPSESSION.raw, 0);
  }
  // 6.5.2.3.14.1, 6.5.2.3.1.1.1: 2.0 to 2.2 do not list them.
  for (const unsigned M_VERSION : {0x20u, 0x21u, 0x22u}) {
    EXPECT_EQ(fault_of_packet(M_VERSION, kPacket31), Fault::spare_value);
    EXPECT_EQ(fault_of_packet(M_VERSION, kPacket32), Fault::spare_value);
  }
}

TEST(Vectors4_0_0, RadioNetworks) {
  // 7.4.2.11.1
  const auto both = read_packet<Packet45_v3_0>(0x30, "45/8 2/2 49/13 1/2 2192703/24");
  EXPECT_EQ(both.Q_NETWORKTYPE.raw, 1);
  EXPECT_EQ(both.NID_MN.raw, 2192703u);
  EXPECT_EQ(read_packet<Packet45_v3_0>(0x30, "45/8 2/2 25/13 0/2").Q_NETWORKTYPE.raw, 0);
  EXPECT_NE(fault_of_packet(0x30, "45/8 2/2 49/13 3/2 2192703/24"), Fault::none) << "a spare type";
  // 6.5.2.3.13.1 with 6.6.5.2.7
  for (const unsigned M_VERSION : {0x20u, 0x22u, 0x23u}) {
    const auto gsm_r = read_packet<Packet45_v3_0>(M_VERSION, "45/8 1/2 47/13 2192703/24");
    EXPECT_EQ(gsm_r.Q_DIR.raw, 1);
    EXPECT_EQ(gsm_r.Q_NETWORKTYPE.raw, 2);
    EXPECT_EQ(gsm_r.NID_MN.raw, 2192703u);
  }
  // 6.5.2.3.16.2: of 2.3 alone
  EXPECT_EQ(read_packet<Packet245>(0x23, "245/8 2/2 25/13 1/2").Q_NETWORKTYPE.raw, 1);
  EXPECT_EQ(fault_of_packet(0x22, "245/8 2/2 25/13 1/2"), Fault::spare_value);
  EXPECT_EQ(fault_of_packet(0x30, "245/8 2/2 25/13 1/2"), Fault::spare_value);
}

TEST(Vectors4_0_0, RouteSuitability) {
  // 7.4.2.21: categories up to D2, then the gauges G1 and GB, then 15 kV of country 7.
  const auto x3 = read_packet<Packet70_v3_0>(
      0x30, "70/8 1/2 120/13 1/2 0/1 100/15 1/2 255/16 2/5 200/15 0/2 5/8 300/15 2/2 2/4 7/10");
  EXPECT_EQ(x3.D_SUITABILITY.raw, 100);
  EXPECT_EQ(x3.M_LINEAXLELOADCAT.raw, 255);
  ASSERT_EQ(x3.points.size(), 2u);
  EXPECT_EQ(x3.points[0].D_SUITABILITY.raw, 200);
  EXPECT_EQ(x3.points[0].M_LINEGAUGE.raw, 5);
  EXPECT_EQ(x3.points[1].D_SUITABILITY.raw, 300);
  EXPECT_EQ(x3.points[1].M_VOLTAGE.raw, 2);
  EXPECT_EQ(x3.points[1].NID_CTRACTION.raw, 7);
  // 7.5.1.67.2: no category at all is spare, as is one beside the thirteen.
  EXPECT_NE(fault_of_packet(0x30, "70/8 1/2 64/13 1/2 0/1 100/15 1/2 0/16 0/5"), Fault::none);
  EXPECT_NE(fault_of_packet(0x30, "70/8 1/2 64/13 1/2 0/1 100/15 1/2 8192/16 0/5"), Fault::none);
  // 6.5.2.3.12.2 with the table of [18] of 6.6.3.2.3
  constexpr std::uint16_t sets[] = {0x0001, 0x0003, 0x0007, 0x000F, 0x001F, 0x003F, 0x007F,
                                    0x00FF, 0x01FF, 0x03FF, 0x07FF, 0x0FFF, 0x1FFF};
  for (unsigned category = 0; category < 13; ++category) {
    const auto x2 =
        read_packet<Packet70_v3_0>(0x23, "70/8 1/2 55/13 1/2 0/1 100/15 1/2 " + std::to_string(category) + "/7 0/5");
    EXPECT_EQ(x2.M_LINEAXLELOADCAT.raw, sets[category]);
  }
}

const std::string kTextBegin = " 1/2 1/2 0/1 500/15 ";

TEST(Vectors4_0_0, PlainText) {  // 7.4.2.23
  // Of 3.0: in supervised manoeuvre (5), whatever the level (4), until level NTC 28 is left, to be reported to RBC 77.
  const auto text = read_packet<Packet72>(0x30, "73/8 2/2 150/13" + kTextBegin +
                                                    "5/4 4/3 600/15 30/10 15/4 1/3 28/8 1/2 1/1 1/1 9/8 26/10 77/14 "
                                                    "2/8 72/8 105/8");
  EXPECT_EQ(text.Q_DIR.raw, 2);
  EXPECT_EQ(text.Q_SCALE.raw, 1);
  EXPECT_EQ(text.Q_TEXTCLASS.raw, 1);
  EXPECT_EQ(text.Q_TEXTDISPLAY.raw, 0);
  EXPECT_EQ(text.D_TEXTDISPLAY.raw, 500);
  EXPECT_EQ(text.M_MODETEXTDISPLAY_START.raw, 5);
  EXPECT_EQ(text.M_LEVELTEXTDISPLAY_START.raw, 5) << "not limited by level, in the code of 2.1";
  EXPECT_EQ(text.L_TEXTDISPLAY.raw, 600);
  EXPECT_EQ(text.T_TEXTDISPLAY.raw, 30);
  EXPECT_EQ(text.M_MODETEXTDISPLAY_END.raw, 15);
  EXPECT_EQ(text.M_LEVELTEXTDISPLAY_END.raw, 1);
  EXPECT_EQ(text.NID_NTC_END.raw, 28);
  EXPECT_EQ(text.Q_TEXTCONFIRM.raw, 1);
  EXPECT_EQ(text.Q_CONFTEXTDISPLAY.raw, 1);
  EXPECT_EQ(text.NID_TEXTMESSAGE.raw, 9);
  EXPECT_EQ(text.NID_C.raw, 26);
  EXPECT_EQ(text.NID_RBC.raw, 77);
  ASSERT_EQ(text.text.size(), 2u);
  EXPECT_EQ(text.text[0].X_TEXT.raw, 'H');
  EXPECT_EQ(text.text[1].X_TEXT.raw, 'i');
}

TEST(Vectors4_0_0, ModesAndLevelsOfTexts) {
  // Begin at mode and level, end at any: packet 74 without confirmation, Q_TEXT 1.
  const auto fault = [](unsigned M_VERSION, unsigned mode, unsigned level, unsigned any_level) {
    return fault_of_packet(M_VERSION, "74/8 1/2 92/13" + kTextBegin + std::to_string(mode) + "/4 " +
                                          std::to_string(level) + "/3 600/15 30/10 15/4 " + std::to_string(any_level) +
                                          "/3 0/2 1/8");
  };
  EXPECT_EQ(fault(0x22, 3, 4, 5), Fault::none) << "AD is of 2.2 (6.5.2.3.6.2), level 3 of X = 2 (6.5.1.5.27.4)";
  EXPECT_NE(fault(0x22, 5, 3, 5), Fault::none) << "SM is not";
  EXPECT_EQ(fault(0x23, 5, 4, 5), Fault::none) << "it is of 2.3";
  EXPECT_EQ(fault(0x30, 5, 3, 4), Fault::none);
  EXPECT_NE(fault(0x30, 5, 5, 4), Fault::none) << "5 is spare in X = 3 (7.5.1.66)";
  EXPECT_NE(fault(0x30, 9, 3, 4), Fault::none) << "so is mode 9 (7.5.1.73)";
  // 6.5.2.3.1.1.2, 6.5.2.3.1.1.3: up to 2.1 other numbers
  EXPECT_EQ(fault(0x21, 0, 3, 5), Fault::spare_value);
  const auto fixed =
      read_packet<Packet76>(0x30, "74/8 1/2 92/13" + kTextBegin + "3/4 3/3 600/15 30/10 15/4 4/3 0/2 1/8");
  EXPECT_EQ(fixed.M_MODETEXTDISPLAY_START.raw, 3);
  EXPECT_EQ(fixed.M_LEVELTEXTDISPLAY_START.raw, 3);
  EXPECT_EQ(fixed.M_LEVELTEXTDISPLAY_END.raw, 5);
  EXPECT_EQ(fixed.Q_TEXT.raw, 1);
}

TEST(Vectors4_0_0, LevelsOrdered) {  // 7.5.1.67: X = 3 has no level 3
  const std::string order = "41/8 1/2 63/13 1/2 100/15 ";
  EXPECT_EQ(fault_of_packet(0x23, order + "4/3 50/15 0/5"), Fault::none);
  EXPECT_EQ(fault_of_packet(0x30, order + "3/3 50/15 0/5"), Fault::none);
  EXPECT_NE(fault_of_packet(0x30, order + "4/3 50/15 0/5"), Fault::none);
}

MessageToTrainView read_message(const Bits& bits, SystemVersion sv, Media sender = media::RBC) {
  return scan_message_to_train(bits.bytes, sv, Check::all, sender == media::RIU ? sender : Media{0});
}

const std::string kAuthority = "15/8 1/2 66/13 1/2 0/7 1023/10 0/5 2000/15 0/1 0/1 0/1 0/1 ";
const std::string kGradient = "21/8 1/2 54/13 1/2 0/15 1/1 3/8 0/5 ";
const std::string kSpeeds = "27/8 1/2 58/13 1/2 0/15 12/7 1/1 0/5 0/5 ";
const std::string kEngine = " 123456/32 4711/24 ";

TEST(Vectors4_0_0, AuthorisationOfAManoeuvre) {  // 8.7.2.1
  const Bits bits("4/8 39/10 1000/32 1/1 1048585/24 900/32 1/2 65436/16 8/7 " + kAuthority + kGradient + kSpeeds +
                  "0/2");
  for (const SystemVersion sv : {v23, v30}) {
    const MessageToTrainView view = read_message(bits, sv);
    ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault) << " at bit " << view.at.bit;
    Message4 m;
    ASSERT_EQ(decode(view, m), Fault::none);
    EXPECT_EQ(m.T_TRAIN.raw, 1000u);
    EXPECT_EQ(m.M_ACK.raw, 1);
    EXPECT_EQ(m.NID_LRBG.raw, 1048585u);
    EXPECT_EQ(m.T_TRAIN_REF.raw, 900u);
    EXPECT_EQ(m.Q_SCALE.raw, 1);
    EXPECT_EQ(static_cast<std::int16_t>(m.D_REF.raw), -100);
    EXPECT_EQ(m.V_SM.raw, 8);
    EXPECT_EQ(view.packets.size(), 3u);
  }
  EXPECT_EQ(read_message(bits, v22).fault, Fault::unknown_message) << "6.5.2.3.7.1";
  const Bits without_speeds("4/8 32/10 1000/32 1/1 1048585/24 900/32 1/2 65436/16 8/7 " + kAuthority + kGradient +
                            "0/4");
  EXPECT_NE(read_message(without_speeds, v30).fault, Fault::none);
}

TEST(Vectors4_0_0, AnswersAboutManoeuvres) {  // 8.7.2.2, 8.7.3.1
  for (const unsigned NID_MESSAGE : {5u, 7u}) {
    const Bits bits(std::to_string(NID_MESSAGE) + "/8 14/10 1000/32 0/1 16777215/24 900/32 0/5");
    for (const SystemVersion sv : {v23, v30}) {
      const MessageToTrainView view = read_message(bits, sv);
      ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault);
      Message5 refused;
      Message7 acknowledged;
      if (NID_MESSAGE == 5) {
        ASSERT_EQ(decode(view, refused), Fault::none);
        EXPECT_EQ(refused.T_TRAIN_REF.raw, 900u);
      } else {
        ASSERT_EQ(decode(view, acknowledged), Fault::none);
        EXPECT_EQ(acknowledged.T_TRAIN_REF.raw, 900u);
      }
    }
    EXPECT_EQ(read_message(bits, v22).fault, Fault::unknown_message);
  }
}

TEST(Vectors4_0_0, AcknowledgementOfASession) {  // 8.7.16: it ends with M_ACK
  const Bits bits("38/8 7/10 1000/32 0/1 0/5");
  for (const SystemVersion sv : {v23, v30})
    for (const Media sender : {media::RBC, media::RIU}) {
      const MessageToTrainView view = read_message(bits, sv, sender);
      EXPECT_EQ(view.fault, Fault::none) << text_of(view.fault);
      EXPECT_EQ(view.T_TRAIN.raw, 1000u);
      EXPECT_EQ(view.M_ACK.raw, 0);
    }
  EXPECT_NE(read_message(bits, v22).fault, Fault::none) << "6.5.2.3.8.1";
}

TEST(Vectors4_0_0, RevocationsByRadioInfill) {  // 7.4.2.18, 8.4.4.4.1
  const Bits bits(
      "37/8 27/10 1000/32 0/1 1048585/24 136/8 1/2 38/13 0/1 12/14 "
      "12/8 1/2 73/13 1/2 20/7 0/7 1023/10 0/5 2000/15 0/1 0/1 0/1 0/1 66/8 1/2 31/13 5/8 0/0");
  ASSERT_EQ(bits.count, 217u);
  const Bits padded(
      "37/8 28/10 1000/32 0/1 1048585/24 136/8 1/2 38/13 0/1 12/14 "
      "12/8 1/2 73/13 1/2 20/7 0/7 1023/10 0/5 2000/15 0/1 0/1 0/1 0/1 66/8 1/2 31/13 5/8 0/7");
  EXPECT_EQ(read_message(padded, {2, 1}, media::RIU).fault, Fault::none);
  for (const SystemVersion sv : {v22, v23, v30}) EXPECT_NE(read_message(padded, sv, media::RIU).fault, Fault::none);
}

// --- to the trackside

/// Packet 0 with `mode` of 5 bits, V_TRAIN and M_LEVEL (7.4.3.1): at group 9 of country 64, length not confirmed.
std::string position(unsigned V_TRAIN, unsigned mode, unsigned level) {
  return "0/8 115/13 1/2 1048585/24 250/15 1/2 1/2 12/15 13/15 0/2 " + std::to_string(V_TRAIN) + "/7 1/2 " +
         std::to_string(mode) + "/5 " + std::to_string(level) + "/3 ";
}

/// Message 136 with that packet.
Fault fault_of_report(SystemVersion sv, unsigned V_TRAIN, unsigned mode, unsigned level) {
  return scan_message_to_track(Bits("136/8 24/10" + kEngine + position(V_TRAIN, mode, level) + "0/3").bytes, sv).fault;
}

TEST(Vectors4_0_0, ModesSpeedsAndLevelsReported) {
  EXPECT_EQ(fault_of_report(v22, 8, 16, 4), Fault::none) << "AD (6.5.2.3.6.1), level 3 (6.5.1.5.27.3)";
  EXPECT_NE(fault_of_report(v22, 8, 17, 3), Fault::none) << "SM is of 2.3 on";
  EXPECT_NE(fault_of_report(v22, 127, 0, 3), Fault::none) << "so is the code of standstill (6.5.2.3.8.2)";
  EXPECT_EQ(fault_of_report(v23, 127, 17, 4), Fault::none);
  EXPECT_NE(fault_of_report(v23, 127, 18, 3), Fault::none);
  EXPECT_EQ(fault_of_report(v30, 127, 17, 3), Fault::none);
  EXPECT_NE(fault_of_report(v30, 126, 17, 3), Fault::none);
  EXPECT_NE(fault_of_report(v30, 127, 17, 4), Fault::none) << "X = 3 has no level 3 (7.5.1.65)";
}

TEST(Vectors4_0_0, PositionByTwoGroups) {  // 7.4.3.2, with both optional variables
  const Bits bits(
      "136/8 30/10" + kEngine +
      "1/8 162/13 1/2 1048585/24 1048584/24 250/15 1/2 0/2 12/15 13/15 2/2 300/15 8/7 1/2 16/5 1/3 28/8 0/4");
  ASSERT_EQ(bits.count, 240u);
  const MessageToTrackView view = scan_message_to_track(bits.bytes, v30);
  ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault) << " at bit " << view.at.bit;
  TrainPacket1_v3_0 p;
  ASSERT_EQ(decode(view.packets[0], p), Fault::none);
  EXPECT_EQ(p.NID_LRBG.raw, 1048585u);
  EXPECT_EQ(p.NID_PRVLRBG.raw, 1048584u);
  EXPECT_EQ(p.D_LRBG.raw, 250);
  EXPECT_EQ(p.Q_INTEGRITY.raw, 2);
  EXPECT_EQ(p.L_TRAININT.raw, 300);
  EXPECT_EQ(p.V_TRAIN.raw, 8);
  EXPECT_EQ(p.M_MODE.raw, 16);
  EXPECT_EQ(p.M_LEVEL.raw, 1);
  EXPECT_EQ(p.NID_NTC.raw, 28);
}

TEST(Vectors4_0_0, RequestForAManoeuvre) {  // 8.6.2.1, 7.4.3.4.3, 7.4.3.5.1
  const Bits bits("131/8 48/10" + kEngine + position(127, 2, 3) +
                  "10/8 94/13 1/1 11/12 10/12 12/12 200/12 199/12 201/12 "
                  "12/8 97/13 2/4 4/15 24/7 3/8 9/7 1/2 16/10 2/5 0/4 1/4 12/10 0/4");
  ASSERT_EQ(bits.count, 384u);
  for (const SystemVersion sv : {v23, v30}) {
    const MessageToTrackView view = scan_message_to_track(bits.bytes, sv);
    ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault) << " at bit " << view.at.bit;
    ASSERT_EQ(view.packets.size(), 3u);
    TrainPacket10 consist;
    ASSERT_EQ(decode(view.packets[1], consist), Fault::none);
    EXPECT_EQ(consist.Q_SAFECONSISTLENGTH.raw, 1);
    EXPECT_EQ(consist.L_CONSISTFRONTENGINENOM.raw, 11);
    EXPECT_EQ(consist.L_CONSISTFRONTENGINEMIN.raw, 10);
    EXPECT_EQ(consist.L_CONSISTFRONTENGINEMAX.raw, 12);
    EXPECT_EQ(consist.L_CONSISTREARENGINENOM.raw, 200);
    EXPECT_EQ(consist.L_CONSISTREARENGINEMIN.raw, 199);
    EXPECT_EQ(consist.L_CONSISTREARENGINEMAX.raw, 201);
    TrainPacket12 train;
    ASSERT_EQ(decode(view.packets[2], train), Fault::none);
    EXPECT_EQ(train.NC_CDTRAIN.raw, 2);
    EXPECT_EQ(train.NC_TRAIN.raw, 4);
    EXPECT_EQ(train.V_MAXTRAIN.raw, 24);
    EXPECT_EQ(train.M_LOADINGGAUGE.raw, 3);
    EXPECT_EQ(train.M_AXLELOADCAT.raw, 9);
    EXPECT_EQ(train.M_AIRTIGHT.raw, 1);
    EXPECT_EQ(train.N_AXLE.raw, 16);
    ASSERT_EQ(train.tractions.size(), 2u);
    EXPECT_EQ(train.tractions[0].M_VOLTAGE.raw, 0);
    EXPECT_EQ(train.tractions[1].M_VOLTAGE.raw, 1);
    EXPECT_EQ(train.tractions[1].NID_CTRACTION.raw, 12);
  }
  EXPECT_NE(scan_message_to_track(bits.bytes, v22).fault, Fault::none);
}

TEST(Vectors4_0_0, ConsistLength) {  // 8.6.3.1
  const Bits bits("133/8 27/10" + kEngine + position(127, 2, 3) + "10/8 22/13 0/1 0/5");
  for (const SystemVersion sv : {v23, v30}) {
    const MessageToTrackView view = scan_message_to_track(bits.bytes, sv);
    ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault);
    TrainPacket10 consist;
    ASSERT_EQ(decode(view.packets[1], consist), Fault::none);
    EXPECT_EQ(consist.Q_SAFECONSISTLENGTH.raw, 0);
  }
  EXPECT_NE(scan_message_to_track(bits.bytes, v22).fault, Fault::none);
}

TEST(Vectors4_0_0, EndOfMission) {  // 8.6.10: Q_DESK is before the position
  const Bits with_desk("150/8 24/10" + kEngine + "1/1 " + position(0, 6, 3) + "0/2");
  const Bits without("150/8 24/10" + kEngine + position(0, 6, 3) + "0/3");
  for (const SystemVersion sv : {v23, v30}) {
    const MessageToTrackView view = scan_message_to_track(with_desk.bytes, sv);
    ASSERT_EQ(view.fault, Fault::none) << text_of(view.fault);
    TrainMessage150_v2_3 m;
    ASSERT_EQ(decode(view, m), Fault::none);
    EXPECT_EQ(m.Q_DESK.raw, 1);
    EXPECT_NE(scan_message_to_track(without.bytes, sv).fault, Fault::none);
  }
  EXPECT_EQ(scan_message_to_track(without.bytes, v22).fault, Fault::none) << "6.5.2.3.7.2";
}

}  // namespace
}  // namespace evc::lang
