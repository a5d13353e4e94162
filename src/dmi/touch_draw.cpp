#include <array>
#include <string_view>

#include "dmi/acks.h"
#include "dmi/dmi.h"
#include "dmi/drawing.h"
#include "dmi/labels.h"
#include "dmi/touch.h"
#include "dmi/windows.h"

namespace evc::dmi {
namespace {

/// Names and actions of what is touched, for the display list.
struct TouchRow {
  ActionKind kind;
  const char* name;
  const char* action;
};
constexpr auto kTouchRows = std::to_array<TouchRow>({
    TouchRow{ActionKind::close, "close", "close"},
    TouchRow{ActionKind::next, "next", "next"},
    TouchRow{ActionKind::previous, "previous", "previous"},
    TouchRow{ActionKind::complete, "Yes", "complete"},
    TouchRow{ActionKind::switch_entry, "switch", "switch"},
    TouchRow{ActionKind::toggle_speed, "", "toggle_speed"},
    TouchRow{ActionKind::toggle_tunnel, "C2+C3+C4", "toggle_tunnel"},
    TouchRow{ActionKind::toggle_geo, "G12", "toggle_geo"},
    TouchRow{ActionKind::zoom_in, "D9", "zoom_in"},
    TouchRow{ActionKind::zoom_out, "D12", "zoom_out"},
    TouchRow{ActionKind::scroll_up, "E10", "scroll_up"},
    TouchRow{ActionKind::scroll_down, "E11", "scroll_down"},
    TouchRow{ActionKind::track_ahead_free, "Yes", "track_ahead_free"},
    TouchRow{ActionKind::ato_engage, "G1", "engage"},
    TouchRow{ActionKind::ato_disengage, "G1", "disengage"},
    TouchRow{ActionKind::skip_stop, "G5", "skip_stop"},
});

/// "F1" does "main": the title in small letters.
void name_opening(Touch& touch, const Target& target) {
  for (const Area area : {Area::F1, Area::F2, Area::F3, Area::F4, Area::F5})
    if (rect_of(area) == target.abs) touch.name.append(name(area));
  if (touch.name.empty()) touch.name.append(target.abs == kNumberPlace ? "TRN" : "SE04");
  const char* const title = row_of(static_cast<WindowId>(target.action.argument)).title;
  for (std::size_t i = 0; title[i] != '\0'; ++i) {
    const char small = title[i] >= 'A' && title[i] <= 'Z' ? static_cast<char>(title[i] - 'A' + 'a') : title[i];
    touch.action.append(std::string_view(&small, 1));
  }
}

void name_ack(Touch& touch, const State& state) {
  if (!state.offered) return;
  const Ack what = state.offered->ack.what;
  touch.name.append(name(place_of(what).frame));
  touch.action.append("ack ");
  if (what < Ack::count) touch.action.append(terms::kNames<kAckRows>[terms::index(what)]);
}

}  // namespace

void draw_touch(const Drawing& to) {
  for (const Target& target : targets(to.state)) {
    Touch touch;
    touch.abs = target.abs;
    touch.enabled = target.enabled;
    touch.type = target.type;
    for (const TouchRow& row : kTouchRows)
      if (row.kind == target.action.kind) {
        touch.name.append(row.name);
        touch.action.append(row.action);
      }
    switch (target.action.kind) {
      case ActionKind::open:
        name_opening(touch, target);
        break;
      case ActionKind::ack:
        name_ack(touch, to.state);
        break;
      case ActionKind::button:
        touch.name.append(label(static_cast<Button>(target.action.argument), to.display.config.srs).view());
        touch.action.append("button");
        break;
      case ActionKind::key:
        touch.name.append("key ");
        append_number(touch.name, target.action.argument);
        touch.action.append("key");
        break;
      case ActionKind::field:
        touch.name.append("field ");
        append_number(touch.name, target.action.argument + 1);
        touch.action.append("field");
        break;
      case ActionKind::toggle_speed:
        touch.name.append(target.abs == rect_of(Area::A) ? "A" : "B");
        break;
      default:
        break;
    }
    if (!to.screen.touch.push_back(touch)) return;
  }
}

}  // namespace evc::dmi
