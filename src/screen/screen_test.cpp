#include "screen/screen_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "io/json.h"
#include "io/program_test.h"
#include "screen/command.h"
#include "screen/player.h"

namespace evc::screen {
namespace {

using dmi::Area;
using dmi::Item;
using dmi::Kind;
using io::Json;

TEST(ScreenJson, WritesWhatTheContractShows) {
  auto screen = std::make_unique<dmi::Screen>();
  screen->t_ms = 12300.0;
  screen->window = "default";
  Item text;
  text.kind = Kind::text;
  text.area = Area::A2;
  text.at = {0, 0, 54, 30};
  text.text = "810";
  text.height = 10;
  text.indent = 10;
  text.align = dmi::Align::right;
  text.colour = dmi::Colour::grey;
  ASSERT_TRUE(screen->items.push_back(text));
  Item symbol;
  symbol.kind = Kind::symbol;
  symbol.area = Area::B7;
  symbol.at = {2, 2, 32, 32};
  symbol.picture = Picture::MO11;
  ASSERT_TRUE(screen->items.push_back(symbol));
  ASSERT_TRUE(screen->flashing.push_back(Area::C1));
  ASSERT_TRUE(screen->sounds.push_back({dmi::Sound::Sinfo, dmi::SoundDo::once}));
  ASSERT_TRUE(screen->sounds.push_back({dmi::Sound::S2, dmi::SoundDo::loop}));
  ASSERT_TRUE(screen->sounds.push_back({dmi::Sound::S1, dmi::SoundDo::stop}));
  const Json written = Json::parse(screen_json(*screen));
  EXPECT_EQ(written["schema"], "evc-screen/1");
  EXPECT_EQ(written["t_ms"], 12300);
  EXPECT_EQ(written["flashing"], Json::parse(R"(["C1"])"));
  EXPECT_EQ(written["sounds"], Json::parse(R"(["Sinfo", "S2"])"));  // those that start
  const Json& a2 = written["items"][0];
  EXPECT_EQ(a2["value"], "810");
  EXPECT_EQ(a2["right_edge"], 44);
  EXPECT_EQ(a2["y"], 79);
  EXPECT_EQ(a2["align"], "right");
  const Json& b7 = written["items"][1];
  EXPECT_EQ(b7["id"], "MO11");
  EXPECT_EQ(b7["x"], 292);
  EXPECT_EQ(b7["y"], 273);
  EXPECT_EQ(b7["centre"], Json::parse("[308.0, 289.0]"));
}

TEST(ScreenJson, IsJsonForEveryScreenOfAPlayer) {
  Player player;
  player.display().mode = Mode::FS;
  player.display().v = Speed{33.3};
  player.show();
  for (const dmi::Area area : {Area::F1, Area::F2, Area::F3, Area::F4, Area::F5}) {
    ASSERT_TRUE(player.press(middle_of(dmi::rect_of(area))));
    player.run_to(player.now_ms() + 100);
    player.release();
    const Json written = Json::parse(screen_json(*player.screen()));
    EXPECT_NE(written["window"], "default");
    EXPECT_FALSE(written["touch"].empty());
    ASSERT_TRUE(player.touch(dmi::Action{dmi::ActionKind::close}));
  }
  EXPECT_EQ(Json::parse(screen_json(*player.screen()))["window"], "default");
}

TEST(Press, IsCellsAndSeconds) {
  const auto press = press_of("580,40@12.5");
  ASSERT_TRUE(press);
  EXPECT_EQ(press->at.x, 580);
  EXPECT_EQ(press->at.y, 40);
  EXPECT_EQ(press->ms, 12500);
  for (const char* wrong :
       {"", "580,40", "580@1", "640,0@1", "-1,0@1", "1,480@1", "1,1@-1", "1,1@nan", "1,1@1s", "1;1@1", "1,1@1e99"})
    EXPECT_FALSE(press_of(wrong)) << wrong;
}

/// A short stream: a desk is opened.
std::string stream_in(const Folder& folder) {
  const std::string file = folder / "inputs.jsonl";
  std::ofstream(file) << R"({"t_ms":0,"config":{"srs":"4.0.0"}})"
                      << "\n"
                      << R"({"t_ms":100,"train":{"desk_open":true}})"
                      << "\n"
                      << R"({"t_ms":5000})"
                      << "\n";
  return file;
}

TEST(ScreenJson, NamesTheMenusBehindTheirButtons) {
  Player player;
  player.display().mode = Mode::FS;
  player.display().level = Level::L1;
  player.show();
  const Json list = Json::parse(screen_json(*player.screen()));
  std::map<std::string, std::string> actions;
  for (const Json& touch : list["touch"]) actions[touch["name"]] = touch["action"];
  EXPECT_EQ(actions["F1"], "main");
  EXPECT_EQ(actions["F2"], "override");
  EXPECT_EQ(actions["F3"], "data view");
  EXPECT_EQ(actions["F4"], "special");
  EXPECT_EQ(actions["F5"], "settings");
}

TEST(Command, WritesTheScreenInEachForm) {
  const Folder folder("dmi_forms");
  const std::string input = stream_in(folder);
  EXPECT_EQ(ended("dmi " + input + " --at 2 -o " + (folder / "a.svg")).exit_code, 0);
  EXPECT_EQ(ended("dmi " + input + " --at 2 -o " + (folder / "a.png")).exit_code, 0);
  EXPECT_EQ(ended("dmi " + input + " --at 2 -o " + (folder / "a.json")).exit_code, 0);
  EXPECT_EQ(text_of(folder / "a.svg").substr(0, 5), "<svg ");
  EXPECT_EQ(text_of(folder / "a.png").substr(1, 3), "PNG");
  const Json list = Json::parse(text_of(folder / "a.json"));
  EXPECT_EQ(list["schema"], "evc-screen/1");
  EXPECT_EQ(list["t_ms"], 2000);
  EXPECT_EQ(ended("dmi " + input + " --at 2").output, text_of(folder / "a.json"));
}

TEST(Command, PressesActOnTheScreenAndOnTheUnit) {
  const Folder folder("dmi_press");
  const std::string input = stream_in(folder);
  const auto window_at = [&](const std::string& arguments) {
    const Ended e = ended("dmi " + input + " " + arguments);
    EXPECT_EQ(e.exit_code, 0) << e.errors;
    return Json::parse(e.output)["window"].get<std::string>();
  };
  // Start of mission asks for the driver's identity (5.4.4 S1), which the unit then has.
  EXPECT_EQ(window_at("--at 2"), "Driver ID");
  const std::string typed = "--press 385,240@2 --press 487,240@2.5 --press 487,90@3 ";
  EXPECT_NE(window_at(typed + "--at 4.5"), "Driver ID");
}

TEST(Command, RefusesWhatItDoesNotUnderstand) {
  const Folder folder("dmi_refused");
  const std::string input = stream_in(folder);
  const Ended missed = ended("dmi " + input + " --at 3 --press 5,5@2 -o " + (folder / "a.svg"));
  EXPECT_EQ(missed.exit_code, 1);
  EXPECT_NE(missed.errors.find("nothing to touch at 5,5"), std::string::npos) << missed.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
  for (const std::string& arguments :
       {input + " --at 3 --press 5", input + " --at 99", input + " -o a.gif", input + " --at 1 --press 600,40@2",
        (folder / "none.jsonl"), std::string("--cases ") + input, input + " --cases " + input}) {
    const Ended e = ended("dmi " + arguments);
    EXPECT_EQ(e.exit_code, 2) << arguments;
    EXPECT_EQ(e.output, "") << arguments;
    EXPECT_EQ(std::count(e.errors.begin(), e.errors.end(), '\n'), 1) << e.errors;
    EXPECT_NE(e.errors.find("expected"), std::string::npos) << e.errors;
  }
}

TEST(Command, AnswersCasesOneLineEach) {
  const Folder folder("dmi_cases");
  std::ofstream(folder / "two.json")
      << R"({"cases":[{"id":"A","given":{"mode":"FS"},"expect":{"must":[]}},)"
      << R"({"id":"B","given":{"mode":"OS","events":["touch A"]},"expect":{"result":{"toggle_after":[true]}}}]})";
  const Ended e = ended("dmi --cases " + (folder / "two.json"));
  EXPECT_EQ(e.exit_code, 0) << e.errors;
  std::istringstream lines(e.output);
  std::string a, b;
  ASSERT_TRUE(std::getline(lines, a) && std::getline(lines, b));
  EXPECT_EQ(Json::parse(a)["id"], "A");
  EXPECT_FALSE(Json::parse(a)["items"].empty());
  EXPECT_EQ(Json::parse(b)["result"], Json::parse(R"({"toggle_after":[true]})"));
  // A case that cannot be set is a line with its reason, and takes nothing from the others.
  std::ofstream(folder / "wrong.json") << R"({"cases":[{"id":"A","given":{"moode":"FS"},"expect":{"must":[]}},)"
                                       << R"({"id":"B","given":{"mode":"FS"},"expect":{"must":[]}}]})";
  const Ended wrong = ended("dmi --cases " + (folder / "wrong.json"));
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.errors.find("/cases/0/given/moode"), std::string::npos) << wrong.errors;
  std::istringstream answers(wrong.output);
  ASSERT_TRUE(std::getline(answers, a) && std::getline(answers, b));
  EXPECT_NE(Json::parse(a)["error"].get<std::string>().find("/cases/0/given/moode"), std::string::npos) << a;
  EXPECT_FALSE(Json::parse(b)["items"].empty());
}

}  // namespace
}  // namespace evc::screen
