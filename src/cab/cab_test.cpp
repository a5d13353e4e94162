#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/test_paths.h"
#include "cab/command.h"
#include "io/file.h"
#include "ride/given.h"
#include "run/load.h"

namespace evc::cab {
namespace {

/// Data of its own for the command, which `io::data_file` finds through the environment.
class Cab : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / "evc_cab";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "cab");
    const char* before = std::getenv("OPENEVC_DATA");
    if (before != nullptr) before_ = before;
    std::filesystem::create_directories(folder_ / "lines");
    std::filesystem::copy_file(std::filesystem::path(source_data()) / "lines/brunnental.json",
                               folder_ / "lines/brunnental.json");
    setenv("OPENEVC_DATA", folder_.c_str(), 1);
  }
  void TearDown() override {
    if (before_.empty())
      unsetenv("OPENEVC_DATA");
    else
      setenv("OPENEVC_DATA", before_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }
  static std::string source_data() { return test::source_folder() + "/data"; }
  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  /// What the command said on standard error, after its exit status.
  static std::string said(const Options& options) {
    ::testing::internal::CaptureStderr();
    const int status = cab(options);
    return std::to_string(status) + " " + ::testing::internal::GetCapturedStderr();
  }

 private:
  std::filesystem::path folder_;
  std::string before_;
};

TEST_F(Cab, ThePageGetsTheLineAndTheTrain) {
  write("cab/page.html", "<a>" + ride::given_place() + "</a>");
  const Options options{"", "", in_folder("cab.html")};
  EXPECT_EQ(said(options), "0 ");
  const std::string page = io::read_text(options.output).value();
  ride::Given given;
  given.line = run::load_line("").value();
  const io::Train standard;
  given.train_name = standard.name;
  given.train_document = standard.document;
  EXPECT_EQ(page, "<a>" + base64(ride::bytes_of(given)) + "</a>");
}

TEST_F(Cab, TheLineMayBeStandardInput) {
  write("cab/page.html", "<a>" + ride::given_place() + "</a>");
  EXPECT_EQ(said({"", "", in_folder("cab.html")}), "0 ");
  ASSERT_NE(std::freopen(in_folder("lines/brunnental.json").c_str(), "rb", stdin), nullptr);
  EXPECT_EQ(said({"-", "", in_folder("from_input.html")}), "0 ");
  EXPECT_EQ(io::read_text(in_folder("from_input.html")).value(), io::read_text(in_folder("cab.html")).value());
}

TEST_F(Cab, WithoutTheCompiledPageItSaysHowToGetIt) {
  const std::string text = said({"", "", in_folder("cab.html")});
  EXPECT_EQ(text.rfind("2 ", 0), 0u) << text;
  EXPECT_NE(text.find("page.html: found no file, expected the compiled page: `make cab` makes it"), std::string::npos)
      << text;
  EXPECT_FALSE(std::filesystem::exists(in_folder("cab.html")));
}

// A page that was compiled for other bytes could not begin.
TEST_F(Cab, AnOlderPageIsAnError) {
  for (const char* page : {"<a>@given@</a>", "<a>@given 45564302@</a>"}) {
    write("cab/page.html", page);
    const std::string text = said({"", "", in_folder("cab.html")});
    EXPECT_EQ(text.rfind("2 ", 0), 0u) << text;
    EXPECT_NE(text.find("page.html: found the page of another version"), std::string::npos) << text;
    EXPECT_NE(text.find("`make cab` makes it"), std::string::npos) << text;
    EXPECT_FALSE(std::filesystem::exists(in_folder("cab.html")));
  }
}

TEST(Page, HasThePlaceOfThisVersion) {
  const std::string page = io::read_text(test::source_folder() + "/web/index.html").value();
  const std::size_t at = page.find(ride::given_place());
  ASSERT_NE(at, std::string::npos) << ride::given_place();
  EXPECT_EQ(page.find("@given", at + 1), std::string::npos);
}

TEST_F(Cab, WrongFilesAreErrors) {
  write("cab/page.html", "no place for it");
  EXPECT_NE(said({"", "", in_folder("cab.html")}).find("found no @given "), std::string::npos);
  EXPECT_EQ(said({in_folder("none.json"), "", in_folder("cab.html")}).rfind("2 ", 0), 0u);
  write("line.json", "{}");
  EXPECT_EQ(said({in_folder("line.json"), "", in_folder("cab.html")}).rfind("2 ", 0), 0u);
  EXPECT_EQ(said({in_folder("line.json"), "", in_folder("line.json")}).rfind("2 ", 0), 0u);
}

TEST(Base64, AgreesWithTheVectorsOfItsStandard) {
  // RFC 4648 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

}  // namespace
}  // namespace evc::cab
