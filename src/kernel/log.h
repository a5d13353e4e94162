#pragma once
#include "kernel/port.h"

namespace evc::kernel {

/// The log of the events of a cycle.
struct Log {
  decltype(Outputs::events)& events;

  /// Adds an event; when there is no room, the last one becomes `events_lost`.
  void note(const Event& event) const {
    if (events.push_back(event)) return;
    events.back() = Event{.what = What::events_lost};
  }
};

}  // namespace evc::kernel
