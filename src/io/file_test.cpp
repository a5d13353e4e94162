#include "io/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "io/input_stream.h"
#include "io/program_test.h"

namespace evc::io {
namespace {

TEST(ReadText, AFileBeyondTheLimitIsAnError) {
  const Folder folder("large");
  ASSERT_TRUE(write_whole(folder / "f", std::string(101, 'x')));
  EXPECT_TRUE(read_text(folder / "f", 101));
  const auto refused = read_text(folder / "f", 100);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), (folder / "f") + ": found more than 100 bytes, expected at most 100");
  // A file without an end.
  const auto endless = read_text("/dev/zero", 1 << 20);
  ASSERT_FALSE(endless);
  EXPECT_NE(endless.error().text().find("expected at most 1048576"), std::string::npos);
}

TEST(ReadText, APipeThatNobodyWritesIntoIsAnError) {
  const Folder folder("silent");
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto refused = read_text(pipe);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), pipe + ": found a pipe that nobody writes into, expected a file that can be read");
  const auto unread = WholeFile::create(pipe);
  ASSERT_FALSE(unread);
  EXPECT_EQ(unread.error().text(), pipe + ": found a pipe that nobody reads from, expected a file that can be written");
}

TEST(ReadText, APipeWithAWriterIsReadHoweverSlowItIs) {
  const Folder folder("slow");
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const int descriptor = ::open(pipe.c_str(), O_WRONLY);
    std::this_thread::sleep_for(std::chrono::milliseconds(3500));
    EXPECT_EQ(::write(descriptor, "ab", 2), 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(::write(descriptor, "c", 1), 1);
    ::close(descriptor);
  });
  const auto text = read_text(pipe);
  writer.join();
  ASSERT_TRUE(text) << text.error().text();
  EXPECT_EQ(*text, "abc");
}

TEST(WholeFile, APipeIsWrittenWhenAReaderComes) {
  const Folder folder("reader");
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    read = *read_text(pipe);
  });
  const std::string text(200000, 'x');  // more than a pipe holds
  EXPECT_TRUE(write_whole(pipe, text));
  reader.join();
  EXPECT_EQ(read, text);
}

/// The lines of a text, and the error that ended them.
std::pair<std::vector<std::string>, std::string> lines_in(const std::string& text) {
  const Folder folder("lines");
  EXPECT_TRUE(write_whole(folder / "f", text));
  std::vector<std::string> lines;
  const auto read = guarded([&] {
    Lines source(folder / "f");
    for (std::string line; source.next(line);) lines.push_back(line);
    return true;
  });
  return {lines, read ? "" : read.error().text().substr((folder / "f").size())};
}

TEST(Lines, AreReadOneByOne) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(lines_in("").first, Texts{});
  EXPECT_EQ(lines_in("a\n\nb").first, (Texts{"a", "", "b"}));
  EXPECT_EQ(lines_in(std::string("a\0b\n", 4)).first, (Texts{std::string("a\0b", 3)}));
  EXPECT_EQ(lines_in("a\nb\n").second, "");
}

TEST(Lines, OneBeyondTheLimitIsAnErrorWithItsNumber) {
  EXPECT_EQ(lines_in("a\n" + std::string(kLongestLine, ' ') + "\nb\n").first.size(), 3u);
  const auto [before, error] = lines_in("a\n" + std::string(kLongestLine + 1, ' ') + "\nb\n");
  EXPECT_EQ(before.size(), 1u);
  EXPECT_EQ(error, ": line 2: found a line of more than 1048576 bytes, expected at most 1048576");
}

TEST(Lines, WhatCannotBeReadIsAnError) {
  for (const char* file : {"/nonexistent", "/"}) {
    const auto read = guarded([&] {
      Lines source(file);
      std::string line;
      return source.next(line);
    });
    ASSERT_FALSE(read) << file;
    EXPECT_NE(read.error().text().find("expected a file that can be read"), std::string::npos) << file;
  }
}

}  // namespace
}  // namespace evc::io
