// Counted by callgrind (tools/count_instructions.py): one scenario, counted only in the relevant part. Prints the
// number of repetitions. Usage: instructions busy|change|telegram|gamma|worst|plain|swept|journey|last [INPUT.jsonl]
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "curves_work.h"
#include "io/input_stream.h"
#include "ride.h"
#include "run/drive.h"
#include "run/load.h"
#include "sweep/plan.h"
#include "sweep/store.h"
#include "telegram_work.h"
#include "worst_cycle.h"

namespace {

using evc::bench::Ride;

template <class F>
void counted(F&& step) {
  CALLGRIND_TOGGLE_COLLECT;
  step();
  CALLGRIND_TOGGLE_COLLECT;
}

int busy() {
  Ride ride;
  ride.into_full_supervision(35.0);
  if (ride.outputs().mode != evc::Mode::FS) return -1;
  constexpr int cycles = 600;
  for (int i = 0; i < cycles; ++i) {
    ride.prepare(35.0);
    counted([&] { ride.step(); });
    ride.finish();
  }
  return cycles;
}

int change() {
  Ride ride;
  ride.into_full_supervision(35.0);
  int cycles = 0;
  for (std::uint16_t n = 2; n < 52; ++n, ++cycles) {
    for (int i = 0; i < 10; ++i) ride.cycle(35.0);
    const auto telegrams = evc::bench::group(n);
    ride.read(telegrams);
    ride.prepare(35.0);
    counted([&] { ride.step(); });
    ride.finish();
    if (ride.outputs().mode != evc::Mode::FS) return -1;
  }
  return cycles;
}

int telegram() {
  const evc::bench::BusyTelegram t;
  evc::bench::Decoded decoded;
  bool sound = true;
  constexpr int times = 100;
  for (int i = 0; i < times; ++i) counted([&] { sound = evc::bench::read(t, decoded) && sound; });
  return sound && decoded.p5.links.size() == 3 ? times : -1;
}

int gamma() {
  auto in = evc::bench::gamma_target();
  auto d = std::make_unique<evc::sdm::Derived>();
  constexpr int times = 100;
  double sum = 0.0;
  for (int i = 0; i < times; ++i) counted([&] { sum += evc::bench::gamma_from_raw(*d, in).EBD.d_EBI->from_origin.si; });
  return sum != 0.0 ? times : -1;
}

/// The most instructions of what worst_cycle found with four seeds.
constexpr evc::bench::Genome kWorst{
    1826482132u, 2687834572u, 54800860u,   2101595842u, 3531766507u, 1375788766u, 2992872731u, 2472951970u,
    1886380540u, 3398973286u, 3929107341u, 663735309u,  2004369008u, 3954157062u, 2197769841u, 1965836577u,
    2328768799u, 851368196u,  3730726628u, 2516995388u, 2817272046u, 537809660u,  2596798871u, 3747192512u,
    1158991870u, 1866974187u, 2805740722u, 417500438u,  2429269820u, 85607275u,   3450637566u, 3249143978u};

int worst() {
  const auto ride = evc::bench::hostile_ride(kWorst);
  counted([&] { ride->step(); });
  return 1;
}

/// Calls `step` for each cycle of a stream of inputs. Returns their number.
template <class F>
int each_cycle(const char* file, F&& step) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  auto stream = evc::io::InputStream::open(file, evc::io::lines_of(text.str()));
  if (!stream) return -1;
  auto state = std::make_unique<evc::kernel::State>();
  auto derived = std::make_unique<evc::kernel::Derived>();
  auto outputs = std::make_unique<evc::kernel::Outputs>();
  evc::kernel::power_up(*state, *derived, stream->configuration().for_kernel());
  evc::sim::CycleInputs cycle;
  int cycles = 0;
  for (auto more = stream->next(cycle); more && *more; more = stream->next(cycle), ++cycles) {
    const evc::kernel::Inputs& inputs = cycle.view();
    step(cycles, [&] { evc::kernel::step(*state, *derived, inputs, *outputs); });
  }
  return cycles;
}

int journey(const char* file) {
  return each_cycle(file, [](int, auto&& step) { counted(step); });
}

int last_cycle(const char* file) {
  const int cycles = each_cycle(file, [](int, auto&& step) { step(); });
  (void)each_cycle(file, [=](int n, auto&& step) {
    if (n + 1 < cycles) return step();
    counted(step);
  });
  return cycles > 0 ? 1 : -1;
}

constexpr int kJourneys = 4;

/// The reckless journeys of swept() in a loop that does nothing but simulate and step.
int plain() {
  const auto line = evc::run::load_line(evc::run::line_file(""));
  if (!line) return -1;
  evc::io::Configuration configuration;
  configuration.document = evc::io::configuration_document(configuration);
  for (int n = 0; n < kJourneys; ++n) {
    evc::sim::World::Settings settings;
    settings.driver = evc::sim::DriverKind::reckless;
    settings.seed = static_cast<std::uint64_t>(n) + 1;
    counted([&] {
      evc::sim::World world(*line, configuration.train.data, configuration.train.dynamics, settings);
      evc::run::OnBoard on_board(configuration.for_kernel());
      do world.observe(on_board.step(world.advance().view()));
      while (!world.finished());
    });
  }
  return kJourneys;
}

/// The same with their measures, kept in a file of results.
int swept() {
  std::string folder = (std::filesystem::temp_directory_path() / "openevc.XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return -1;
  const std::string file = folder + "/results.sqlite";
  const auto plan = evc::sweep::Plan::make(R"({"schema":"evc-sweep/1","kind":"run",
      "base":{"line":"brunnental","driver":"reckless"},"vary":[{"at":"/seed","count":4}],
      "measure":["duration_s","interventions.sb","interventions.eb","svl_overrun_m","min_margin_to_EBI_kmh","energy_kwh"]})",
                                           "spec");
  if (!plan) return -1;
  auto store = evc::sweep::Store::open(file, evc::sweep::Store::Open::created, **plan, "bench");
  if (!store) return -1;
  const auto scratch = (*plan)->scratch();
  bool kept = true;
  counted([&] {
    for (std::uint64_t n = 0; n < kJourneys; ++n)
      kept = kept && (*store)->add({(*plan)->compute(n, *scratch)}).has_value();
    kept = kept && (*store)->commit().has_value();
  });
  store->reset();
  std::filesystem::remove_all(folder);
  return kept ? kJourneys : -1;
}

}  // namespace

int main(int argc, char** argv) {
  int cycles = -1;
  if (argc == 2 && std::strcmp(argv[1], "busy") == 0) cycles = busy();
  if (argc == 2 && std::strcmp(argv[1], "change") == 0) cycles = change();
  if (argc == 2 && std::strcmp(argv[1], "telegram") == 0) cycles = telegram();
  if (argc == 2 && std::strcmp(argv[1], "gamma") == 0) cycles = gamma();
  if (argc == 2 && std::strcmp(argv[1], "worst") == 0) cycles = worst();
  if (argc == 2 && std::strcmp(argv[1], "plain") == 0) cycles = plain();
  if (argc == 2 && std::strcmp(argv[1], "swept") == 0) cycles = swept();
  if (argc == 3 && std::strcmp(argv[1], "last") == 0) cycles = last_cycle(argv[2]);
  if (argc == 3 && std::strcmp(argv[1], "journey") == 0) cycles = journey(argv[2]);
  std::printf("%d\n", cycles);
  return cycles > 0 ? 0 : 1;
}
