#include "openevc/sim.h"
#include "base/test_paths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>

namespace evc::sim {
namespace {

std::string file(const std::string& name) {
  std::ifstream in(evc::test::source_folder() + "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Public headers alone drive the shipped line to its end.
TEST(Simulation, ShippedLine) {
  std::string why;
  auto world = Simulation::load(file("data/lines/brunnental.json"), "", {}, why);
  ASSERT_TRUE(world) << why;
  const auto unit = std::make_unique<kernel::Unit>();
  const auto outputs = std::make_unique<kernel::Outputs>();
  kernel::power_up(*unit, world->config());
  bool full_supervision = false;
  int brakes = 0;
  while (!world->finished()) {
    kernel::step(*unit, world->advance(), *outputs);
    world->observe(*outputs);
    full_supervision = full_supervision || outputs->mode == evc::Mode::FS;
    brakes += outputs->mode == evc::Mode::FS && (outputs->sb || outputs->eb);
  }
  EXPECT_TRUE(full_supervision);
  EXPECT_EQ(brakes, 0);
  EXPECT_GT(world->front(), Distance{10'000.0});
}

TEST(Simulation, EqualSettingsGiveEqualInputs) {
  std::string why;
  const std::string line = file("data/lines/brunnental.json");
  auto a = Simulation::load(line, "", {DriverKind::late, 7}, why);
  auto b = Simulation::load(line, "", {DriverKind::late, 7}, why);
  ASSERT_TRUE(a && b) << why;
  const auto unit = std::make_unique<kernel::Unit>();
  const auto outputs = std::make_unique<kernel::Outputs>();
  kernel::power_up(*unit, a->config());
  for (int cycle = 0; cycle < 600; ++cycle) {
    const kernel::Inputs& inputs = a->advance();
    const kernel::Inputs& same = b->advance();
    ASSERT_EQ(inputs.now, same.now);
    ASSERT_EQ(inputs.odometry.nominal, same.odometry.nominal);
    ASSERT_EQ(inputs.balise_telegrams.size(), same.balise_telegrams.size());
    kernel::step(*unit, inputs, *outputs);
    a->observe(*outputs);
    b->observe(*outputs);
  }
  EXPECT_EQ(a->front(), b->front());
  EXPECT_GT(a->speed(), Speed{0.0});
}

TEST(Simulation, DocumentsThatAreNotAsTheyHaveToBe) {
  std::string why;
  EXPECT_FALSE(Simulation::load("{", "", {}, why));
  EXPECT_EQ(why.rfind("line: ", 0), 0u) << why;
  EXPECT_FALSE(Simulation::load(file("data/lines/brunnental.json"), "[]", {}, why));
  EXPECT_EQ(why.rfind("train: ", 0), 0u) << why;
}

}  // namespace
}  // namespace evc::sim
