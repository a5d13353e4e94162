#include <gtest/gtest.h>

#include <chrono>
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

}  // namespace
}  // namespace evc::language
