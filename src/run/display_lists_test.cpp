#include "run/display_lists.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/test_paths.h"
#include "dmi/dmi.h"
#include "kernel/evc.h"
#include "paint/svg.h"
#include "run/drive.h"
#include "run/load.h"

namespace evc::run {
namespace {

using nlohmann::json;

/// A cycle as the display has it.
struct Shown {
  std::int64_t t_ms = 0;
  kernel::Display record;
  port::DriverActions done;
};

/// The cycles of a journey along the shipped line, its first `seconds`.
std::vector<Shown> journey(double seconds) {
  const sim::Line line = load_line(test::source_folder() + "/data/lines/brunnental.json").value();
  io::Configuration configuration;
  configuration.document = io::configuration_document(configuration);
  sim::World world(line, configuration.train.data, configuration.train.dynamics, {});
  OnBoard on_board(configuration.for_kernel());
  std::vector<Shown> cycles;
  do {
    sim::CycleInputs& inputs = world.advance();
    world.observe(on_board.step(inputs.view()));
    cycles.push_back({inputs.t_ms, on_board.show(), inputs.levels.driver});
  } while (!world.finished() && static_cast<double>(world.t_ms()) < seconds * 1000.0);
  return cycles;
}

void add_all(DisplayLists& lists, const std::vector<Shown>& cycles) {
  for (const Shown& cycle : cycles) lists.add(cycle.t_ms, cycle.record, cycle.done);
}

/// A display as that of `evc dmi`: it is shown every cycle, and Start is touched when the driver selects it.
class Display {
 public:
  void show(const Shown& cycle) {
    if (cycle.done.has(port::Select::start)) {
      for (const dmi::Target& target : dmi::targets(*state_)) {
        if (target.action.kind != dmi::ActionKind::button || target.action.argument != 0) continue;
        EXPECT_TRUE(dmi::press(*state_, {target.abs.x + 5, target.abs.y + 5}, state_->display.now));
        dmi::release(*state_, state_->display.now);
        break;
      }
    }
    dmi::show(*state_, cycle.record);
    (void)dmi::take(*state_);
  }
  /// The elements of its picture, `<path .../>`.
  std::vector<std::string> picture(Duration now) {
    dmi::draw(*state_, now, *screen_);
    std::vector<std::string> paths;
    const std::string svg = paint::svg_of(*screen_);
    for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1))
      paths.push_back(svg.substr(at, svg.find("/>", at) + 2 - at));
    return paths;
  }
  const std::string window() const { return std::string(screen_->window.view()); }

 private:
  std::unique_ptr<dmi::State> state_ = std::make_unique<dmi::State>();
  std::unique_ptr<dmi::Screen> screen_ = std::make_unique<dmi::Screen>();
};

/// 12.34 cells as in a picture.
std::string cells(double value) {
  const long hundredths = std::lround(value * 100.0);
  std::string text = std::to_string(std::labs(hundredths) / 100);
  const long rest = std::labs(hundredths) % 100;
  if (rest != 0) text += '.' + std::string(1, static_cast<char>('0' + rest / 10));
  if (rest % 10 != 0) text += static_cast<char>('0' + rest % 10);
  return (hundredths < 0 ? "-" : "") + text;
}

/// A path that begins at x, y instead of 0, 0.
std::string moved(const std::string& path, double x, double y) {
  std::string out;
  bool is_x = true;
  for (const char* at = path.c_str(); *at != '\0';) {
    if (*at == 'M' || *at == 'L' || *at == 'C' || *at == 'Z' || *at == ' ') {
      out += *at++;
      continue;
    }
    char* end = nullptr;
    out += cells(std::strtod(at, &end) + (is_x ? x : y));
    is_x = !is_x;
    at = end;
  }
  return out;
}

/// A shape as an element of the picture.
std::string element_of(const json& form, double x, double y) {
  const std::string colour = form[0], path = moved(form[2], x, y);
  std::string out = "<path d=\"" + path + '"';
  if (form[1] == 0) return out + " fill=\"" + colour + "\"/>";
  return out + " fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + cells(form[1]) + "\"/>";
}

struct List {
  std::int64_t t_ms = 0;
  std::vector<std::string> elements;
};

/// What a reader makes of the text: written from the description of its form alone.
std::vector<List> read(const json& written) {
  std::vector<List> lists;
  for (const json& numbers : written["lists"]) {
    List list{std::llround(numbers[0].get<double>() * 1000.0), {}};
    std::int64_t at = 0;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const double what = numbers[i];
      if (what < 0) {
        for (int n = 0; n < -static_cast<int>(what); ++n)
          list.elements.push_back(lists.back().elements.at(static_cast<std::size_t>(at++)));
      } else if (what == 0) {
        at += numbers.at(++i).get<int>();
      } else {
        const double x = numbers.at(i + 1), y = numbers.at(i + 2);
        list.elements.push_back(element_of(written["shapes"].at(static_cast<std::size_t>(what) - 1), x, y));
        i += 2;
        ++at;
      }
    }
    lists.push_back(std::move(list));
  }
  return lists;
}

constexpr std::size_t kNoLimit = 1 << 30;
const std::string kBackground = R"(<path d="M0 0L640 0L640 480L0 480Z" fill="#031122"/>)";

/// Walked through cycle by cycle: a list is there exactly where a second has passed since the last one and the picture
/// is another one, and it is that picture.
TEST(DisplayLists, AreThePicturesOfTheDisplayWhereItChanged) {
  const auto cycles = journey(500.0);
  DisplayLists kept;
  add_all(kept, cycles);
  const auto lists = read(json::parse(kept.json(kNoLimit)));
  ASSERT_EQ(lists.size(), kept.size());
  EXPECT_GT(lists.size(), 300u);
  Display display;
  std::size_t next = 0;
  std::vector<std::string> last;
  for (const Shown& cycle : cycles) {
    display.show(cycle);
    if (next > 0 && cycle.t_ms - lists[next - 1].t_ms < 1000) continue;
    auto picture = display.picture(cycle.record.now);
    picture.insert(picture.begin(), kBackground);
    if (picture == last) continue;
    ASSERT_LT(next, lists.size());
    EXPECT_EQ(lists[next].t_ms, cycle.t_ms);
    ASSERT_TRUE(lists[next].elements == picture) << cycle.t_ms;
    ++next;
    last = std::move(picture);
  }
  EXPECT_EQ(next, lists.size());
  // Start has closed the window of the start of mission.
  EXPECT_EQ(display.window(), "default");
}

TEST(DisplayLists, AreTheSameBytesEachTime) {
  const auto cycles = journey(120.0);
  DisplayLists first, second;
  add_all(first, cycles);
  add_all(second, cycles);
  EXPECT_TRUE(first.json(kNoLimit) == second.json(kNoLimit));
}

/// A screen on which nothing changes is one list.
TEST(DisplayLists, HaveNoneWhereNothingChanges) {
  DisplayLists lists;
  Shown cycle;
  cycle.record.mode = Mode::SH;
  for (; cycle.t_ms < 60'000; cycle.t_ms += 100) {
    cycle.record.now = Duration{static_cast<double>(cycle.t_ms) / 1000.0};
    lists.add(cycle.t_ms, cycle.record, cycle.done);
  }
  EXPECT_EQ(lists.size(), 1u);
}

/// What would be too long is thinned: fewer lists, at least `least_s` apart, each as it was.
TEST(DisplayLists, AreThinnedToASize) {
  DisplayLists kept;
  add_all(kept, journey(300.0));
  const std::string whole = kept.json(kNoLimit);
  const auto all = read(json::parse(whole));
  EXPECT_EQ(kept.json(whole.size()), whole);
  std::size_t before = all.size();
  for (const std::size_t percent : {90u, 70u, 50u}) {
    const std::size_t most = whole.size() * percent / 100;
    const std::string text = kept.json(most);
    EXPECT_LE(text.size(), most);
    const json written = json::parse(text);
    const int least_s = written["least_s"];
    EXPECT_GT(least_s, 1);
    const auto lists = read(written);
    EXPECT_LT(lists.size(), before);
    before = lists.size();
    ASSERT_FALSE(lists.empty());
    std::size_t i = 0;
    for (std::size_t n = 0; n < lists.size(); ++n) {
      while (i < all.size() && all[i].t_ms != lists[n].t_ms) ++i;
      ASSERT_LT(i, all.size());
      EXPECT_TRUE(all[i].elements == lists[n].elements);
      if (n > 0) {
        EXPECT_GE(lists[n].t_ms - lists[n - 1].t_ms, least_s * 1000);
      }
    }
    // Every shape in the table is used.
    EXPECT_LT(written["shapes"].size(), json::parse(whole)["shapes"].size());
  }
  EXPECT_EQ(kept.json(100), R"({"least_s":0,"shapes":[],"lists":[]})");
}

}  // namespace
}  // namespace evc::run
