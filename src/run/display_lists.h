#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "dmi/screen.h"
#include "dmi/state.h"
#include "kernel/port.h"
#include "paint/path_text.h"

namespace evc::run {

/// The driver-machine interface along a run, for its report: the shapes on the screen, kept where they changed and at
/// most once a second. A display as that of `evc dmi` is shown the record of every cycle.
class DisplayLists {
 public:
  DisplayLists();
  ~DisplayLists();
  DisplayLists(const DisplayLists&) = delete;
  DisplayLists& operator=(const DisplayLists&) = delete;

  /// After each cycle: its record, and what the driver did in it.
  void add(std::int64_t t_ms, const kernel::Display& record, const port::DriverActions& done);

  /// How many lists are kept.
  std::size_t size() const { return lists_.size(); }

  /// The lists as JSON that web/src/display_lists.js reads, at most `most` bytes. What would be longer is thinned: at
  /// most one list in `least_s` seconds, 1, 2, 4 and so on; without any list where not even one fits.
  std::string json(std::size_t most) const;

 private:
  using Form = std::uint32_t;   ///< a shape without its place
  using Stood = std::uint32_t;  ///< a shape at its place
  struct List {
    std::int64_t t_ms = 0;
    std::vector<Stood> stood;  ///< in drawing order
  };
  /// A screen, and where in its list the shapes of each of its items end.
  struct Drawn {
    std::optional<std::size_t> find(const dmi::Item& item, std::size_t next) const;
    dmi::Screen screen;
    std::vector<std::size_t> ends;
  };

  void touch_start();
  void draw(std::vector<Stood>& stood);
  Stood standing(const paint::Shape& shape);
  std::string json_of(std::int64_t least_ms) const;

  std::unique_ptr<dmi::State> state_;
  std::unique_ptr<Drawn> before_, now_;
  std::vector<Stood> stood_before_;
  std::unordered_map<std::string, Form> forms_;
  std::vector<const std::string*> form_texts_;  ///< by Form: keys of `forms_`
  std::map<std::tuple<Form, paint::Hundredths>, Stood> places_;
  std::vector<std::tuple<Form, paint::Hundredths>> place_of_;  ///< by Stood
  std::vector<List> lists_;
};

}  // namespace evc::run
