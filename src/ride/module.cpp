#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ride/remote.h"
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
  std::unique_ptr<evc::ride::Ride> ride;      ///< a journey of the page's own
  std::unique_ptr<evc::ride::Remote> remote;  ///< else the driver's place at a unit elsewhere
  evc::ride::Panel& panel() { return ride ? ride->panel() : remote->panel(); }
  std::string acts;       ///< lines for the unit elsewhere
  std::string text;       ///< made on demand
  std::string_view last;  ///< the part asked for last
};

enum class Part : int { outputs, inputs, points, events, summary, scene, drawing, screen, acts };

/// The display, and what there is of a journey of the page's own.
std::string_view part_of(Page& page, Part part) {
  if (part == Part::drawing) return page.text = page.panel().drawing();
  if (part == Part::screen) return page.text = page.panel().display_list();
  if (part == Part::acts || !page.ride) return page.acts;
  const evc::ride::Ride& ride = *page.ride;
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
    case Part::screen:
    case Part::acts:
      break;
  }
  return {};
}

}  // namespace

/// Memory for the bytes that `begin` and `remote_show` read; `free_taken` gives it back.
EVC_EXPORT(take)(std::size_t size)->void* { return std::malloc(size); }
EVC_EXPORT(free_taken)(void* memory)->void { std::free(memory); }

/// A ride with these bytes (given.h). driver: -1 by hand, else a DriverKind. srs: a SrsVersion. utc: the begin in
/// seconds since 1970; below 0: as if not said. Null: the bytes are not ours.
EVC_EXPORT(begin)(const char* bytes, std::size_t size, int driver, std::uint32_t seed, int srs, double utc)->Page* {
  auto given = evc::ride::given_of({bytes, size});
  if (!given) return nullptr;
  evc::ride::Ride::Settings settings;
  settings.seed = seed;
  if (driver >= 0) settings.driver = static_cast<evc::sim::DriverKind>(driver);
  settings.srs = static_cast<evc::SrsVersion>(srs);
  if (utc >= 0.0) settings.utc = static_cast<std::int64_t>(utc);
  auto page = std::make_unique<Page>();
  page->ride = std::make_unique<evc::ride::Ride>(*std::move(given), settings);
  return page.release();
}

EVC_EXPORT(advance)(Page* page, int cycles)->int { return page->ride->advance(cycles); }
EVC_EXPORT(finished)(const Page* page)->bool { return page->ride->finished(); }

/// direction: a DirectionController.
EVC_EXPORT(desk)(Page* page, double lever, int direction, bool open, bool emergency)->void {
  page->ride->set_desk({lever, static_cast<evc::port::DirectionController>(direction), open, emergency});
}

/// The driver's place at a unit elsewhere; the part `acts` is the lines that begin its session.
EVC_EXPORT(remote_begin)()->Page* {
  auto page = std::make_unique<Page>();
  page->remote = std::make_unique<evc::ride::Remote>();
  page->acts = page->remote->begin();
  return page.release();
}
/// Shows the record of these bytes; false: they are none.
EVC_EXPORT(remote_show)(Page* page, const char* bytes, std::size_t size)->bool {
  return page->remote->show({bytes, size});
}
EVC_EXPORT(remote_desk)(Page* page, int direction, bool open)->void {
  page->remote->set_desk(static_cast<evc::port::DirectionController>(direction), open);
}
/// The part `acts` is then the lines of what the driver did up to the cycle at `t_ms`.
EVC_EXPORT(remote_acts)(Page* page, double t_ms)->void {
  page->acts = page->remote->acts(static_cast<std::int64_t>(t_ms));
}

/// A finger on the display: cells of the screen.
EVC_EXPORT(touch)(Page* page, int x, int y)->bool { return page->panel().touch({x, y}); }
EVC_EXPORT(slide)(Page* page, int x, int y)->void { page->panel().slide({x, y}); }
EVC_EXPORT(lift)(Page* page)->void { page->panel().lift(); }

/// Where a part is in the memory; `part_size` gives the bytes of the one asked for last.
EVC_EXPORT(part)(Page* page, int part)->const char* {
  page->last = part_of(*page, static_cast<Part>(part));
  return page->last.data();
}
EVC_EXPORT(part_size)(const Page* page)->std::size_t { return page->last.size(); }
