#pragma once
#include "dmi/screen.h"
#include "dmi/state.h"
#include "openevc/base/units.h"
#include "openevc/port/display.h"
#include "openevc/train/train_data.h"

// The driver-machine interface of ERA_ERTMS_015560, touch screen, 640 x 480 cells. Pure: no clock, no heap; the same
// calls give the same screens. No call traps, whatever the display's content or the place of a touch.
namespace evc::dmi {

/// A cell of the screen.
struct Cell {
  int x = 0, y = 0;
};

/// Takes the on-board's state of `display.now`, which must not fall: windows follow the dialogue, acknowledgements are
/// offered one at a time, sounds start and stop. To be called in every cycle.
void show(State&, const port::Display&);

/// A finger touches the screen, moves while it touches, leaves it (015560 5.3.2.6). Press: whether something enabled
/// was hit; a second finger is ignored. `now` as in Display.
bool press(State&, Cell, Duration now);
void slide(State&, Cell, Duration now);
void release(State&, Duration now);
/// Time passes between cycles: a held button repeats.
void tick(State&, Duration now);

/// What the driver did, and the sounds ordered, since the last call: each is given once; `windows` are those open
/// now.
Commands take(State&);

/// The screen at `now`.
void draw(const State&, Duration now, Screen&);

/// The places that react to touch now, the topmost first.
Targets targets(const State&);

/// The train data of a train with what the driver entered.
train::TrainData with_entered(const train::TrainData&, const port::ShownTrainData&);

}  // namespace evc::dmi
