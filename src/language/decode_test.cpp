#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/program_test.h"

namespace evc::language {
namespace {

const std::string kPacket = "41408E838352032020";  // a temporary speed restriction

/// A pipe that stays open is answered line by line.
TEST(CommandDecode, AnswersALiveStreamAsItComes) {
  const Folder folder("live");
  const std::string out = folder / "out";
  std::FILE* pipe = ::popen((program() + "decode packet - --to-train >'" + out + "'").c_str(), "w");
  ASSERT_NE(pipe, nullptr);
  for (int n = 1; n <= 2; ++n) {
    std::fputs((kPacket + "\n").c_str(), pipe);
    std::fflush(pipe);
    const auto lines = [&] {
      const std::string text = text_of(out);
      return std::count(text.begin(), text.end(), '\n');
    };
    for (int wait = 0; wait < 1000 && lines() < n; ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(lines(), n);
  }
  EXPECT_EQ(::pclose(pipe), 0);
}

/// The line number as in an editor: comments and empty lines count.
TEST(CommandDecode, NamesTheLineThatIsBad) {
  const Folder folder("line");
  ASSERT_TRUE(io::write_whole(folder / "f", "# two\n\n" + kPacket + "\nXY\n" + kPacket + "\r\nZ"));
  const Ended run = ended("decode packet '" + (folder / "f") + "' --to-train");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("\n{\"error\":{\"line\":4,\"bit\":0,\"why\":\"not a hexadecimal digit: X\"}}\n"),
            std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("{\"error\":{\"line\":6,"), std::string::npos) << run.output;
  // Digits on the command line have no line number.
  EXPECT_EQ(ended("decode packet XY --to-train").output,
            "{\"error\":{\"bit\":0,\"why\":\"not a hexadecimal digit: X\"}}\n");
}

TEST(CommandDecode, NothingIsNoTelegram) {
  const Folder folder("nothing");
  for (const char* text : {"", "\n\n", "# no telegram\n"}) {
    ASSERT_TRUE(io::write_whole(folder / "f", text));
    const Ended run = ended("decode balise - <'" + (folder / "f") + "'");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.errors, "-: found nothing, expected a line of hexadecimal digits\n");
    EXPECT_EQ(run.output, "");
  }
}

TEST(CommandEncode, NothingIsNoTelegram) {
  const Ended run = ended("encode balise - </dev/null");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.errors, "-: found nothing, expected a JSON object\n");
}

TEST(CommandDecode, TwoOutputsNeedTwoFiles) {
  const Folder folder("two");
  ASSERT_TRUE(io::write_whole(folder / "f", "kept"));
  const auto refused = [&](const std::string& arguments) {
    const Ended run = ended("decode radio " + kPacket + " --to-train " + arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.output, "") << arguments;
    return run.errors;
  };
  const std::string f = folder / "f";
  EXPECT_EQ(refused("-o '" + f + "' --pcapng '" + f + "'"),
            "--pcapng: found " + f + ", expected another file than the one for JSON or tables (-o)\n");
  EXPECT_NE(refused("-o '" + f + "' --pcapng '" + (folder / "./f") + "'"), "");
  EXPECT_EQ(refused("--pcapng -"),
            "--pcapng: found standard output, expected another file than the one for JSON or tables (-o)\n");
  EXPECT_EQ(text_of(f), "kept");
}

TEST(CommandDecode, BothOutputsOrNeither) {
  const Folder folder("both");
  ASSERT_TRUE(io::write_whole(folder / "old", "old"));
  const std::string message = "decode radio 180014 --to-train --tolerant";
  // The device of the capture is full.
  const Ended full = ended(message + " -o '" + (folder / "old") + "' --pcapng /dev/full");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(text_of(folder / "old"), "old");
  // The device of the answers is full.
  const Ended other = ended(message + " -o /dev/full --pcapng '" + (folder / "old") + "'");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(text_of(folder / "old"), "old");
  // With space for both, both are written; the capture may be standard output when the answers are not.
  const Ended done = ended(message + " -o '" + (folder / "new") + "' --pcapng -");
  EXPECT_LT(done.exit_code, 2);
  EXPECT_EQ(done.output.substr(0, 4), "\x0A\x0D\x0D\x0A");
  EXPECT_NE(text_of(folder / "new"), "");
}

/// What the air gap gave is shown even where the language then rejects it.
TEST(CommandDecode, ShowsTheUserBitsThatTheLanguageRejects) {
  // Packet 65 with a spare code of V_TSR.
  const std::string telegram =
      R"('{"header":{"Q_UPDOWN":1,"M_VERSION":33,"Q_MEDIA":0,"N_PIG":0,"N_TOTAL":1,"M_DUP":0,"M_MCOUNT":255,"NID_C":1,)"
      R"("NID_BG":42,"Q_LINK":1},"packets":[{"NID_PACKET":65,"Q_DIR":1,"Q_SCALE":1,"NID_TSR":7,"D_TSR":850,"L_TSR":400,)"
      R"("Q_FRONT":0,"V_TSR":127}]}')";
  const auto encoded = [&](const std::string& form) {
    const Ended run = ended("encode " + form + " " + telegram);
    EXPECT_EQ(run.exit_code, 0) << run.errors << run.output;
    return run.output.substr(0, run.output.find('\n'));
  };
  const std::string user = encoded("balise"), coded = encoded("airgap");
  const Ended run = ended("decode airgap " + coded);
  EXPECT_EQ(run.exit_code, 1);
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json.at("error").at("variable"), "V_TSR");
  const auto& airgap = json.at("airgap");
  EXPECT_EQ(airgap.at("format"), "short");
  EXPECT_EQ(airgap.at("rotation"), 0);
  EXPECT_EQ(airgap.at("inverted"), false);
  const std::string bits = airgap.at("user_bits");
  EXPECT_EQ(bits.size(), 53u);  // 210 bits
  // The last digit of the telegram is filled up.
  EXPECT_EQ(bits.substr(0, user.size() - 1), user.substr(0, user.size() - 1));
  // The bits are those of the accepted telegram.
  const Ended tolerant = ended("decode balise " + bits + " --tolerant");
  EXPECT_EQ(tolerant.exit_code, 0);
  const Ended explained = ended("decode airgap " + coded + " --explain");
  EXPECT_EQ(explained.exit_code, 1);
  EXPECT_NE(explained.output.find("air gap    short format"), std::string::npos) << explained.output;
  EXPECT_NE(explained.output.find("user bits  " + bits), std::string::npos) << explained.output;
  EXPECT_NE(explained.output.find("{\"error\":"), std::string::npos) << explained.output;
  // Where the air gap itself gave nothing there is no member.
  const Ended none = ended("decode airgap " + std::string(86, '0'));
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_FALSE(nlohmann::json::parse(none.output).contains("airgap"));
}

}  // namespace
}  // namespace evc::language
