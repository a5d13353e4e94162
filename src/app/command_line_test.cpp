#include "app/command_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

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
  EXPECT_EQ(refused("run --last-ma abc"), "evc run: --last-ma: found abc, expected a whole number from 0 to 1000000\n");
  EXPECT_EQ(refused("replay in --every 1.5"),
            "evc replay: --every: found 1.5, expected a whole number from 1 to 1000000000\n");
  EXPECT_EQ(refused("serve --cycle 10"), "evc serve: found --cycle alone, expected --real-time with it\n");
  EXPECT_EQ(refused("serve --port 65536"), "evc serve: --port: found 65536, expected a whole number from 0 to 65535\n");
  EXPECT_EQ(refused("replay --diff - -"), "-: found standard input twice, expected it once\n");
  EXPECT_EQ(refused("replay /"), "/: found a directory, expected a file that can be read\n");
  EXPECT_EQ(refused("curves --explain 900"), "evc curves: --explain: found 900, expected a number from 0 to 600\n");
  EXPECT_EQ(refused("run --train"), "evc run: --train: found nothing after it, expected a value\n");
  EXPECT_EQ(refused("run --seed 1 --seed 2"), "evc run: --seed: found it 2 times, expected it once\n");
  EXPECT_EQ(refused("run --cycle 0"), "evc run: --cycle: found 0, expected a whole number from 1 to 1000\n");
  EXPECT_EQ(refused("run --real-time --cycle 1.5"),
            "evc run: --cycle: found 1.5, expected a whole number from 1 to 1000\n");
  EXPECT_EQ(refused("explain a --at 1.5"),
            "evc explain: --at: found 1.5, expected a whole number from 0 to 1000000000000\n");
  EXPECT_EQ(refused("run --foo"), "evc run: found --foo, expected an option that `evc run --help` lists\n");
  EXPECT_EQ(refused("run a b c"), "evc run: found \"b\", expected no further argument\n");
  EXPECT_EQ(refused("replay"), "evc replay: found no input, expected JSON Lines of inputs; - for standard input\n");
  EXPECT_EQ(refused("replay --diff a"), "evc replay: --diff: found 1 behind it, expected 2\n");
  EXPECT_EQ(refused("replay in --diff a b"), "evc replay: found input and --diff, expected one of them\n");
  for (const std::string other :
       {"-o c", "--config c", "--persistent c", "--every 2", "--changes", "--planning", "--dmi"})
    EXPECT_EQ(refused("replay --diff a b " + other),
              "evc replay: found " + other.substr(0, other.find(' ')) + " and --diff, expected one of them\n");
  EXPECT_EQ(refused("replay --diff /nonexistent /dev/null"),
            "/nonexistent: found No such file or directory, expected a file that can be read\n");
  EXPECT_EQ(refused("curves compare a"), "evc curves compare: found no b, expected input B\n");
  EXPECT_EQ(refused("decode radio 00"), "evc decode radio: found no direction, expected --to-train or --to-track\n");
  EXPECT_EQ(refused("decode balise 00 --strict --tolerant"),
            "evc decode balise: found --strict and --tolerant, expected one of them\n");
}

TEST(CommandLine, NamesAnOptionAsItWasWritten) {
  const std::string number = "expected a whole number from 1 to 1024\n";
  EXPECT_EQ(refused("sweep x -j 0"), "evc sweep: -j: found 0, " + number);
  EXPECT_EQ(refused("sweep x -j0"), "evc sweep: -j: found 0, " + number);
  EXPECT_EQ(refused("sweep x --threads 0"), "evc sweep: --threads: found 0, " + number);
  EXPECT_EQ(refused("sweep --threads=0 x"), "evc sweep: --threads: found 0, " + number);
  EXPECT_EQ(refused("brakes x -j"), "evc brakes: -j: found nothing after it, expected a value\n");
  EXPECT_EQ(refused("curves --batch x -j -5"), "evc curves: -j: found -5, " + number);
  EXPECT_EQ(refused("curves -j 3"), "evc curves: found -j alone, expected --batch with it\n");
  EXPECT_EQ(refused("run -o ''"), "evc run: -o: found an empty argument, expected a value\n");
  EXPECT_EQ(refused("run -o a -o b"), "evc run: -o: found it 2 times, expected it once\n");
  EXPECT_EQ(refused("sweep case r -o"), "evc sweep case: -o: found nothing after it, expected a value\n");
  EXPECT_EQ(refused("run --output"), "evc run: --output: found nothing after it, expected a value\n");
  // In both ways: the wrong one.
  EXPECT_EQ(refused("brakes x -j x --threads 3"), "evc brakes: -j: found x, " + number);
}

/// Of every option of every command that has two names and a value.
TEST(CommandLine, NamesEveryOptionAsItWasWritten) {
  const std::string commands[] = {"run",           "replay",        "serve",         "curves",        "curves compare",
                                  "decode balise", "decode airgap", "decode radio",  "decode packet", "encode balise",
                                  "encode airgap", "encode radio",  "encode packet", "make-line",     "check",
                                  "track",         "explain",       "dmi",           "cab",           "sweep",
                                  "sweep report",  "sweep case",    "brakes"};
  int options = 0;
  for (const std::string& command : commands) {
    const std::string help = ended(command + " --help").output;
    for (std::size_t at = 0; (at = help.find("\n  -", at)) != std::string::npos; ++at) {
      const std::string line = help.substr(at + 3, help.find('\n', at + 1) - at - 3);
      if (line[1] == '-' || line[2] != ',' || line.rfind("-h,", 0) == 0) continue;
      const std::string letter = line.substr(0, 2), word = line.substr(3, line.find(' ') - 3);
      ++options;
      for (const std::string& name : {letter, word})
        EXPECT_NE(refused(command + " " + name).find(": " + name + ": found nothing after it"), std::string::npos)
            << command << " " << name;
    }
  }
  EXPECT_GE(options, 15);
}

TEST(CommandLine, NamesTheCommandsThereAre) {
  const std::string all =
      "expected one of run, replay, serve, curves, decode, encode, describe, make-line, check, track, explain, dmi, "
      "cab, sweep, brakes\n";
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

/// What a shell makes of an unset variable in quotation marks is no absent argument.
TEST(CommandLine, AnEmptyArgumentIsAnError) {
  const char* const inputs[] = {"run ''",
                                "replay ''",
                                "curves ''",
                                "curves compare '' b",
                                "curves compare a ''",
                                "make-line ''",
                                "decode balise ''",
                                "decode airgap ''",
                                "decode radio '' --to-train",
                                "decode packet '' --to-train",
                                "encode balise ''",
                                "encode airgap ''",
                                "encode radio ''",
                                "encode packet ''",
                                "describe packets ''",
                                "describe variables ''",
                                "describe messages ''",
                                "replay --diff '' b",
                                "replay --diff a ''"};
  const char* const options[] = {"run --train ''",
                                 "run --driver ''",
                                 "run --last-ma ''",
                                 "run --seed ''",
                                 "run --cycle ''",
                                 "run -o ''",
                                 "replay in --config ''",
                                 "replay in -o ''",
                                 "replay in --every ''",
                                 "serve --port ''",
                                 "serve --real-time --cycle ''",
                                 "curves --format ''",
                                 "curves --model ''",
                                 "curves --explain ''",
                                 "curves --plot ''",
                                 "curves -o ''",
                                 "curves compare a b --format ''",
                                 "curves compare a b --plot ''",
                                 "curves compare a b -o ''",
                                 "decode balise 00 -o ''",
                                 "decode balise 00 --pcapng ''",
                                 "decode radio 00 --to-train --sv ''",
                                 "encode balise '{}' -o ''",
                                 "encode radio '{}' --sv ''",
                                 "make-line in -o ''"};
  const auto expect_refused = [](const char* arguments) {
    const std::string errors = refused(arguments);
    EXPECT_NE(errors.find("found an empty argument, expected "), std::string::npos) << arguments << ": " << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  };
  for (const char* arguments : inputs) expect_refused(arguments);
  for (const char* arguments : options) expect_refused(arguments);
  EXPECT_EQ(refused("run --train="), "evc run: --train: found nothing after it, expected a value\n");
}

TEST(CommandLine, ASpeedIsAFiniteNumber) {
  for (const char* speed : {"nan", "-nan", "NAN", "inf", "-5", "1e9"})
    EXPECT_EQ(refused(std::string("curves --explain=") + speed),
              std::string("evc curves: --explain: found ") + speed + ", expected a number from 0 to 600\n");
  for (const char* option : {"replay in --every=nan", "run --last-ma=nan"})
    EXPECT_NE(refused(option).find("found nan, expected a whole number from "), std::string::npos) << option;
}

/// Bytes of the input that are no text do not reach standard error.
TEST(CommandLine, ErrorsAreUtf8WhateverTheInput) {
  const Folder folder("bytes");
  ASSERT_TRUE(io::write_whole(folder / "f", "{\"a\":\xff\xfe"));
  const std::string file = "'" + (folder / "f") + "'";
  for (const std::string& arguments :
       {"run " + file, "run --train " + file, "replay " + file, "replay --diff " + file + " /dev/null",
        "curves " + file, "make-line " + file, "check " + file, "track --at 0 " + file, "encode packet " + file,
        std::string("run $(printf '\\377')"), std::string("describe variables $(printf '\\377')"),
        std::string("decode balise $(printf '\\377.')"), std::string("encode packet $(printf '\\377')"),
        std::string("decode radio 00 --to-train --sv $(printf '\\377')"),
        std::string("encode radio '{}' --sv $(printf '\\377')"), std::string("$(printf '\\377')"),
        std::string("run --$(printf '\\377')")}) {
    const Ended run = ended(arguments);
    EXPECT_NE(run.exit_code, 0) << arguments;
    EXPECT_EQ((run.errors + run.output).find('\xff'), std::string::npos) << arguments;
  }
}

/// A name in a file does not reach the terminal as an order to it.
TEST(CommandLine, NamesAreShownOnly) {
  const Folder folder("names");
  const std::string name = "\"name\":\"a\\u001b[2J\\u009b\\n\"";
  ASSERT_TRUE(io::write_whole(folder / "t", "{\"schema\":\"etcs-train/1\"," + name + "}"));
  ASSERT_TRUE(io::write_whole(folder / "l", "{\"schema\":\"etcs-line/1\",\"length_m\":1,\"end_m\":-49," + name +
                                                ",\"balise_groups\":[{\"balises\":[{\"position_m\":0,"
                                                "\"telegram_hex\":\"90\"}]}]}"));
  ASSERT_TRUE(io::write_whole(folder / "q", "{\"schema\":\"evc-curves/1\"," + name +
                                                ",\"train\":\"t\",\"target\":{\"type\":\"EOA_SvL\","
                                                "\"location_m\":5000}}"));
  for (const std::string& arguments :
       {"run '" + (folder / "l") + "' --train '" + (folder / "t") + "'", "curves '" + (folder / "q") + "' --explain 30",
        "curves '" + (folder / "q") + "' --format table",
        "curves compare --format table '" + (folder / "q") + "' '" + (folder / "q") + "'"}) {
    const Ended run = ended(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments << run.errors;
    EXPECT_EQ(run.output.find('\x1b'), std::string::npos) << arguments;
    EXPECT_EQ(run.output.find("\xc2\x9b"), std::string::npos) << arguments;
  }
}

/// A file that grew for ever, or a line of it, ends with an error before memory does.
TEST(CommandLine, InputWithoutAnEndIsAnError) {
  for (const char* arguments : {"run /dev/zero", "curves /dev/zero", "make-line /dev/zero", "replay /dev/zero",
                                "replay - < /dev/zero", "decode balise - < /dev/zero"}) {
    const Ended run = ended(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_NE(run.errors.find("expected at most "), std::string::npos) << arguments << ": " << run.errors;
  }
}

/// What is not an object is no telegram: one error, not one for each character.
TEST(CommandLine, EncodeTakesObjectsAndArraysOfThem) {
  const Folder folder("encode");
  const std::string file = folder / "f";
  const auto error_of = [&](const std::string& text) {
    EXPECT_TRUE(io::write_whole(file, text));
    std::string errors = refused("encode packet '" + file + "'");
    return errors.substr(std::min(errors.size(), file.size()));
  };
  const std::string expected = "found no JSON object, expected one, or an array of them\n";
  EXPECT_EQ(error_of("111"), ": line 1: " + expected);
  EXPECT_EQ(error_of("\n\ntrue"), ": line 3: " + expected);
  EXPECT_EQ(error_of("[]"), ": line 1: found an empty array, expected at least one JSON object\n");
  EXPECT_EQ(error_of("[{\"NID_PACKET\":255},1]"), ": line 1 /1: found 1, expected a JSON object\n");
  EXPECT_EQ(error_of("{}\n{\"a\":1,\"a\":2}"), ": line 2 /a: found a key given twice, expected each key once\n");
  EXPECT_EQ(error_of("{}\n{\n\"a\" 1}"), ": line 3 column 5: found \"1}\", expected JSON\n");
  EXPECT_NE(error_of(std::string(1 << 20, '[')).find("expected at most 64"), std::string::npos);
  const Ended both = ended("encode packet '[{\"NID_PACKET\":255},{\"NID_PACKET\":255}]'");
  EXPECT_EQ(both.exit_code, 0);
  EXPECT_EQ(both.output, "FF\nFF\n");
}

/// A signal that ends the program in the middle of a file leaves no part of it.
TEST(Signals, LeaveNoPartOfAFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Folder folder("signal");
    const Folder out("signal_out");
    int feed[2];
    ASSERT_EQ(::pipe(feed), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      // A test in the background ignores SIGINT.
      (void)::signal(signal, SIG_DFL);
      ::dup2(feed[0], 0);
      ::close(feed[0]);
      ::close(feed[1]);
      const std::string file = out / "telegrams.jsonl", trace = out / "trace.pcapng";
      ::execl(evc::test::evc_command().c_str(), "evc", "decode", "radio", "-", "--to-train", "-o", file.c_str(),
              "--pcapng", trace.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(feed[0]);
    const auto files = [&] {
      return std::distance(std::filesystem::directory_iterator(out.path()), std::filesystem::directory_iterator{});
    };
    // Until both files are begun; a child that has ended instead fails below.
    while (files() < 2 && ::waitpid(child, nullptr, WNOHANG) == 0) ::usleep(1000);
    EXPECT_EQ(files(), 2);
    ::kill(child, signal);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_EQ(files(), 0) << signal;
    ::close(feed[1]);
  }
}

/// A run by the clock has its files when it is stopped: they are those of the simulated run up to there.
TEST(Signals, EndARunInRealTime) {
  const Folder whole("real_time_whole");
  ASSERT_EQ(ended("run --cycle 50 -o '" + whole.path() + "'").exit_code, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder out("real_time");
    const std::string data = test::source_folder() + "/data";
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      (void)::signal(signal, SIG_DFL);
      (void)::setenv("OPENEVC_DATA", data.c_str(), 1);
      ::dup2(::open("/dev/null", O_WRONLY), 1);
      ::execl(evc::test::evc_command().c_str(), "evc", "run", "--real-time", "--cycle", "50", "-o", out.path().c_str(),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    // It drives when it has a second thread.
    const std::string threads = "/proc/" + std::to_string(child) + "/task";
    const auto running = [&] {
      return std::distance(std::filesystem::directory_iterator(threads), std::filesystem::directory_iterator{});
    };
    while (running() < 2 && ::waitpid(child, nullptr, WNOHANG) == 0) ::usleep(1000);
    ::kill(child, signal);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << signal;
    const std::string outputs = text_of(out / "outputs.jsonl");
    EXPECT_FALSE(outputs.empty());
    EXPECT_NE(text_of(out / "summary.json").find("\"real_time\""), std::string::npos);
    // A machine that hangs may make the world late; then a replay is what equals.
    const bool in_time = text_of(out / "summary.json").find("\"without_inputs\": 0,") != std::string::npos;
    std::string begin(outputs.size(), ' ');
    std::ifstream(whole / "outputs.jsonl").read(begin.data(), static_cast<std::streamsize>(begin.size()));
    EXPECT_TRUE(!in_time || begin == outputs);
    const Ended replay = ended("replay '" + (out / "inputs.jsonl") + "'");
    EXPECT_TRUE(replay.output == outputs);
  }
}

TEST(StandardOutput, WhatIsLostIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const std::string make_line = "make-line '" + evc::test::source_folder() + "/data/lines/brunnental.description.json'";
  for (const std::string arguments : {"--help", "--version", "describe packets", "describe packets 27",
                                      "describe schema", "run --help", "decode packet 41408E838352032020 --to-train",
                                      make_line.c_str(), "curves", "run", "check", "track --at 100", "serve"}) {
    const Ended run = ended(arguments + " >/dev/full");
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
