#include <gtest/gtest.h>

#include "ways.h"

// Headers, lengths and numbers of telegrams, packets and messages to the train (7.3.3, 8.4.2, 8.4.4).
namespace evc::through_step {
namespace {

struct HeaderCase {
  Codes header;
  const char* says;
};

TEST(LanguageThroughStep, HeaderOfATelegram) {
  const std::vector<HeaderCase> cases{
      {{}, "group 200 accepted"},
      {{{"Q_UPDOWN", 0}}, "telegram not decoded [3.16.1.1]"},  // 7.5.1.142: train to track
      {{{"Q_MEDIA", 1}}, "telegram not decoded [3.16.1.1]"},   // 7.5.1.119: a loop
      {{{"M_VERSION", 0}}, "version too old [3.17.3.5"},
      {{{"M_VERSION", 16}}, "group 200 accepted"},
      {{{"M_VERSION", 17}}, "group 200 accepted"},
      {{{"M_VERSION", 32}}, "group 200 accepted"},
      {{{"M_VERSION", 47}}, "group 200 accepted"},  // a later Y (3.17.3.11)
      {{{"M_VERSION", 48}}, "version too new [3.17.3.5"},
      {{{"M_VERSION", 127}}, "version too new [3.17.3.5"},
      {{{"0/N_PIG", 7}}, "not decoded"},                        // above N_TOTAL
      {{{"N_TOTAL", 7}}, "message inconsistent [3.16.2.5.1]"},  // six are missed
      {{{"M_DUP", 3}}, "telegram not decoded [3.16.1.1]"},
      {{{"0/M_DUP", 1}, {"1/M_DUP", 2}}, "group 200 accepted"},
      {{{"M_MCOUNT", 0}}, "group 200 accepted"},
      {{{"M_MCOUNT", 253}}, "group 200 accepted"},
      {{{"0/M_MCOUNT", 253}}, "group 200 accepted"},  // 255 of the other one fits all
      {{{"0/M_MCOUNT", 3}, {"1/M_MCOUNT", 4}}, "message inconsistent [3.16.2.5.1]"},
      {{{"0/M_MCOUNT", 254}, {"1/M_MCOUNT", 4}}, "message inconsistent [3.16.2.5.1]"},  // fits none
      {{{"NID_C", 0}}, "group 200 accepted"},
      {{{"NID_C", 1023}}, "group 200 accepted"},
      {{{"NID_BG", 0}}, "group 0 accepted"},
      {{{"NID_BG", 16382}}, "group 16382 accepted"},
      {{{"Q_LINK", 0}}, "group 200 accepted"},
      {{{"Q_LINK", 1}}, "group 200 accepted"},
  };
  for (const HeaderCase& c : cases) {
    OnBoard unit(OnBoard::after(kFS1));
    const Answer answer = unit.pass(200, {}, "2.1", c.header);
    std::string what;
    for (const auto& [name, code] : c.header) what += name + " " + std::to_string(code) + " ";
    const Answer later = unit.run(20);
    EXPECT_NE(answer.event({c.says}) + later.event({c.says}), "") << what << c.says << answer.text() << later.text();
  }
}

TEST(LanguageThroughStep, LengthOfEachPacket) {
  for (const Json& p : reference("packets_to_train").at("packets")) {
    const unsigned id = p.at("id");
    if (find_packet("to_train", id, "2.1") != &p || id == 0 || id == 255) continue;
    if (id == 44) continue;  // its contents end where L_PACKET says (7.4.2.11 packet 44)
    for (const int wrong : {-1, 1}) {
      const auto answer = send_packet(id, "2.1", {}, wrong);
      ASSERT_TRUE(answer) << "packet " << id;
      EXPECT_TRUE(!answer->event({"telegram not decoded [3.16.1.1]"}).empty() ||
                  !answer->event({"rejected [3.16.3.1.1]"}).empty() ||
                  !answer->event({"loop", "refused [3.16"}).empty())
          << "packet " << id << " with L_PACKET " << wrong << answer->text();
    }
  }
}

TEST(LanguageThroughStep, NumbersThatAreNotListed) {
  for (unsigned id = 0; id < 256; ++id) {
    if (find_packet("to_train", id, "2.1") != nullptr) continue;
    BitList bits;
    bits.put(id, 8);
    bits.put(1, 2);
    bits.put(8 + 2 + 13, 13);
    OnBoard unit(OnBoard::after(kFS1));
    const Answer answer = unit.pass(200, bits);
    EXPECT_NE(answer.event({"telegram not decoded [3.16.1.1]"}), "") << "packet " << id << answer.text();
    OnBoard later(OnBoard::after(kFS1));  // a later Y may have it (7.3.3.4, 3.17.3.11)
    EXPECT_NE(later.pass(200, bits, "2.2").event({"group 200 accepted"}), "") << "packet " << id;
  }
  for (unsigned id = 0; id < 256; ++id) {
    if (find_message("to_train", id, "2.1") != nullptr) continue;
    OnBoard unit(OnBoard::after(kFS2));
    BitList bits;
    bits.put(id, 8);
    bits.put(10, 10);
    bits.put(static_cast<std::uint64_t>(unit.t_ms() / 10), 32);
    bits.put(0, 1);
    bits.put(1 << 14 | 100, 24);
    while (bits.size() < 80) bits.put(0, 1);
    const Answer answer = unit.receive(bits.bytes());
    EXPECT_NE(answer.event({"rejected [3.16.3.1.1]"}), "") << "message " << id << answer.text();
  }
}

TEST(LanguageThroughStep, LengthOfEachMessage) {
  for (const Json& m : reference("messages_to_train").at("messages")) {
    const unsigned id = m.at("id");
    if (find_message("to_train", id, "2.1") != &m) continue;
    for (const int wrong : {-1, 1}) {
      const Answer answer = send_message(id, {}, wrong);
      EXPECT_NE(answer.event({"message " + std::to_string(id) + " rejected [3.16.3.1.1]"}), "")
          << "message " << id << " with L_MESSAGE " << wrong << answer.text();
    }
  }
}

}  // namespace
}  // namespace evc::through_step
