#include "app/command_line.h"

#include <gtest/gtest.h>

#include "io/program_test.h"
#include "run/on_board.h"

namespace evc::app {
namespace {

std::string refused(const std::string& arguments) {
  const Ended run = ended(arguments);
  EXPECT_EQ(run.exit_code, 2) << arguments;
  EXPECT_EQ(run.output, "") << arguments;
  return run.errors;
}

TEST(CommandLine, SaysWhatWasFoundAndWhatWasExpected) {
  EXPECT_EQ(refused("run --driver x"), "evc run: --driver: found x, expected one of perfect, late, reckless\n");
  EXPECT_EQ(refused("run --last-ma abc"), "evc run: --last-ma: found abc, expected a number from 0 to 1000000\n");
  EXPECT_EQ(refused("curves --explain 900"), "evc curves: --explain: found 900, expected a number from 0 to 600\n");
  EXPECT_EQ(refused("run --train"), "evc run: --train: found nothing after it, expected a value\n");
  EXPECT_EQ(refused("run --seed 1 --seed 2"), "evc run: --seed: found it 2 times, expected it once\n");
  EXPECT_EQ(refused("run --foo"), "evc run: found --foo, expected an option that `evc run --help` lists\n");
  EXPECT_EQ(refused("run a b c"), "evc run: found \"b\", expected no further argument\n");
  EXPECT_EQ(refused("replay"), "evc replay: found no input, expected JSON Lines of inputs; - for standard input\n");
  EXPECT_EQ(refused("replay --diff a"), "evc replay: --diff: found 1 behind it, expected 2\n");
  EXPECT_EQ(refused("replay in --diff a b"), "evc replay: found input and --diff, expected one of them\n");
  EXPECT_EQ(refused("replay --diff /nonexistent /dev/null"),
            "/nonexistent: found No such file or directory, expected a file that can be read\n");
  EXPECT_EQ(refused("curves compare a"), "evc curves compare: found no b, expected input B\n");
  EXPECT_EQ(refused("decode radio 00"), "evc decode radio: found no direction, expected --to-train or --to-track\n");
  EXPECT_EQ(refused("decode balise 00 --strict --tolerant"),
            "evc decode balise: found --strict and --tolerant, expected one of them\n");
}

TEST(CommandLine, NamesTheCommandsThereAre) {
  const std::string all = "expected one of run, replay, curves, decode, encode, describe, make-line\n";
  EXPECT_EQ(refused(""), "evc: found no command, " + all);
  EXPECT_EQ(refused("sing"), "evc: found \"sing\", " + all);
  EXPECT_EQ(refused("decode"), "evc decode: found no command, expected one of balise, airgap, radio, packet\n");
  EXPECT_EQ(refused("decode foo"), "evc decode: found \"foo\", expected one of balise, airgap, radio, packet\n");
}

TEST(CommandLine, ASeedIsAWholeNumberThatFits) {
  const std::string expected = ", expected a whole number from 0 to 18446744073709551615\n";
  for (const char* seed : {"18446744073709551616", "99999999999999999999999", "abc", "-1", "1.5", "0x10", "7s"})
    EXPECT_EQ(refused(std::string("run --seed ") + seed), std::string("evc run: --seed: found ") + seed + expected);
  // Accepted; the next error is reported.
  for (const char* seed : {"0", "18446744073709551615"})
    EXPECT_EQ(refused(std::string("run /nonexistent.json --seed ") + seed),
              "/nonexistent.json: found No such file or directory, expected a file that can be read\n");
}

TEST(StandardOutput, WhatIsLostIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  for (const char* arguments :
       {"--help", "--version", "describe packets", "describe packets 27", "describe schema", "run --help",
        "decode packet 41408E838352032020 --to-train",
        "make-line '" EVC_SOURCE_DIR "/data/lines/brunnental.description.json'", "curves", "run"}) {
    const Ended run = ended(std::string(arguments) + " >/dev/full");
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_NE(run.errors.find("found No space left on device, expected space for the whole file"), std::string::npos)
        << arguments << ": " << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  }
}

TEST(StandardOutput, OneThatIsClosedIsAnError) {
  for (const char* arguments : {"--help", "describe packets", "decode packet 41408E838352032020 --to-train"})
    EXPECT_EQ(ended(std::string(arguments) + " >&-").exit_code, 2) << arguments;
  // No file gets its number.
  const Folder folder("closed");
  const Ended run = ended("decode packet 41408E838352032020 --to-train -o '" + (folder / "out") + "' >&- <&-");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(text_of(folder / "out").substr(0, 16), "{\"NID_PACKET\":65");
  EXPECT_EQ(ended("decode packet - --to-train <&-").exit_code, 2);
}

/// A live stream has no end: memory must not grow with it.
TEST(OnBoard, KeepsCostsOnlyWhenAsked) {
  run::OnBoard dropped{kernel::Config{}};
  run::OnBoard kept{kernel::Config{}, run::OnBoard::Costs::kept};
  for (int n = 0; n < 10; ++n) {
    kernel::Inputs inputs;
    inputs.now = {0.1 * n};
    (void)dropped.step(inputs);
    (void)kept.step(inputs);
  }
  EXPECT_EQ(dropped.costs().capacity(), 0u);
  EXPECT_EQ(kept.costs().size(), 10u);
}

}  // namespace
}  // namespace evc::app
