#pragma once
#include <string>

#include "dmi/dmi.h"
#include "port/display.h"
#include "train/train_data.h"

namespace evc::ride {

/// The driver-machine interface of a ride: it is shown the on-board's record in each cycle, touched, and drawn.
class Panel {
 public:
  Panel();

  /// The record to be filled by the on-board for the cycle at `now`, then `shown`.
  port::Display& record_at(Duration now);
  void shown() { dmi::show(state_, record_); }
  /// The record of an on-board that runs elsewhere. Time does not fall: one of an earlier moment is of another unit,
  /// for which a new panel is made.
  void show(const port::Display& record);

  /// Whether something enabled was hit.
  bool touch(dmi::Cell cell) { return dmi::press(state_, cell, record_.now); }
  void slide(dmi::Cell cell) { dmi::slide(state_, cell, record_.now); }
  /// Touches a button of the window that is open, where it is enabled.
  void touch_button(Button button);
  void lift() { dmi::release(state_, record_.now); }
  /// What the driver did since the last call.
  dmi::Commands take() { return dmi::take(state_); }

  const dmi::Screen& screen();
  /// The display list, evc-screen/1.
  std::string display_list();
  /// The screen as a JSON list of shapes in drawing order, `["#C3C3C3", 0, "M0 0L3 4Z", 20, 30]`: the colour, the width
  /// of the line (0: filled), the path as in SVG counted from its begin, and where that is, in cells.
  std::string drawing();

 private:
  port::Display record_;
  dmi::State state_;
  dmi::Screen screen_;
};

}  // namespace evc::ride
