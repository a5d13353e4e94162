#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "ride/ride.h"

// What the WebAssembly module exports; web/src/module.ts is its caller. A ride is a handle; texts are read from the
// memory of the module, where they stay until the next call.
#ifdef __wasm__
#define EVC_EXPORT(name) extern "C" __attribute__((export_name(#name))) auto name
#else  // compiled for the checks of sources alone
#define EVC_EXPORT(name) extern "C" auto name
#endif

namespace {

struct Page {
  Page(evc::ride::Given given, const evc::ride::Ride::Settings& settings) : ride(std::move(given), settings) {}
  evc::ride::Ride ride;
  std::string text;       ///< made on demand
  std::string_view last;  ///< the part asked for last
};

enum class Part : int { outputs, inputs, points, events, summary, scene, drawing, screen };

std::string_view part_of(Page& page, Part part) {
  const evc::ride::Ride& ride = page.ride;
  switch (part) {
    case Part::outputs:
      return ride.outputs();
    case Part::inputs:
      return ride.inputs();
    case Part::points:
      return {reinterpret_cast<const char*>(ride.points().data()),  // NOLINT: an array of numbers for the page
              ride.points().size() * sizeof(evc::ride::Point)};
    case Part::events:
      return ride.events();
    case Part::summary:
      page.text = ride.summary();
      return page.text;
    case Part::scene:
      page.text = ride.scene();
      return page.text;
    case Part::drawing:
      page.text = page.ride.panel().drawing();
      return page.text;
    case Part::screen:
      page.text = page.ride.panel().display_list();
      return page.text;
  }
  return {};
}

}  // namespace

/// Memory for the bytes that `begin` reads.
EVC_EXPORT(take)(std::size_t size)->void* { return std::malloc(size); }

/// A ride with these bytes (given.h). driver: -1 by hand, else a DriverKind. Null: the bytes are not ours.
EVC_EXPORT(begin)(const char* bytes, std::size_t size, int driver, std::uint32_t seed)->Page* {
  auto given = evc::ride::given_of({bytes, size});
  if (!given) return nullptr;
  evc::ride::Ride::Settings settings;
  settings.seed = seed;
  if (driver >= 0) settings.driver = static_cast<evc::sim::DriverKind>(driver);
  return new Page(*std::move(given), settings);
}

EVC_EXPORT(advance)(Page* page, int cycles)->int { return page->ride.advance(cycles); }
EVC_EXPORT(finished)(const Page* page)->bool { return page->ride.finished(); }

/// direction: a DirectionController.
EVC_EXPORT(desk)(Page* page, double lever, int direction, bool open, bool emergency)->void {
  page->ride.set_desk({lever, static_cast<evc::port::DirectionController>(direction), open, emergency});
}

/// A finger on the display: cells of the screen.
EVC_EXPORT(touch)(Page* page, int x, int y)->bool { return page->ride.panel().touch({x, y}); }
EVC_EXPORT(slide)(Page* page, int x, int y)->void { page->ride.panel().slide({x, y}); }
EVC_EXPORT(lift)(Page* page)->void { page->ride.panel().lift(); }

/// Where a part is in the memory; `part_size` gives the bytes of the one asked for last.
EVC_EXPORT(part)(Page* page, int part)->const char* {
  page->last = part_of(*page, static_cast<Part>(part));
  return page->last.data();
}
EVC_EXPORT(part_size)(const Page* page)->std::size_t { return page->last.size(); }
