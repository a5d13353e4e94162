// A train along a line under an on-board unit's supervision, with openevc::sim: `simulation LINE.json` (docs/line.md).
// It prints the place of each mode change and what is shown to the driver.
#include <openevc/sim.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace kernel = evc::kernel;
namespace sim = evc::sim;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: simulation LINE.json\n");
    return 2;
  }
  std::ifstream file(argv[1]);
  const std::string line{std::istreambuf_iterator<char>(file), {}};
  std::string why;
  auto world = sim::Simulation::load(line, "", {sim::DriverKind::perfect, 1}, why);
  if (!world) {
    std::fprintf(stderr, "%s\n", why.c_str());
    return 2;
  }
  const auto unit = std::make_unique<kernel::Unit>();
  const auto outputs = std::make_unique<kernel::Outputs>();
  kernel::power_up(*unit, world->config());
  evc::Mode mode = evc::Mode::NP;
  bool braked = false;
  while (!world->finished()) {
    kernel::step(*unit, world->advance(), *outputs);
    world->observe(*outputs);
    braked = braked || (outputs->eb && outputs->mode == evc::Mode::FS);
    if (outputs->mode == mode) continue;
    mode = outputs->mode;
    std::printf("%8.1f s %9.1f m  %s, %5.1f km/h", outputs->now.si, world->front().si, name(mode),
                world->speed().si * 3.6);
    if (outputs->V_P) std::printf(", permitted %5.1f km/h", outputs->V_P->si * 3.6);
    std::printf("\n");
  }
  std::printf("%8.1f s %9.1f m  at the end%s\n", outputs->now.si, world->front().si, braked ? ", braked" : "");
  return braked ? 1 : 0;
}
