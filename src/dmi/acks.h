#pragma once
#include "dmi/screen.h"
#include "dmi/state.h"

// Acknowledgements (015560 5.4): one request at a time, in order of arrival, the next one a second after the last.
namespace evc::dmi {

/// Where an acknowledgement stands, and where it is touched.
struct AckPlace {
  Area frame{};
  Area touch{};
  ButtonType type = ButtonType::up;
};
AckPlace place_of(Ack);
inline bool for_text(Ack what) { return what == Ack::text || what == Ack::train_data; }
/// The symbol of areas C1 or C9; none for texts.
std::optional<Picture> ack_picture(const port::Display&, Ack);

/// Whether the driver has answered the request, and the on-board has not taken it yet.
bool is_answered(const State&, const port::AskedAck&);
/// Whether a text to be acknowledged waits, shown or not.
bool text_ack_waits(const State&);
/// Whether the driver has something to acknowledge: the buttons of the menus are disabled then (015560 11.2).
bool ack_pending(const State&);

/// Takes the queue of the display: withdraws, offers. Data entry windows are left for it (015560 11.7.1.9).
void offer_acks(State&, const port::Display& before);
/// The driver acknowledges what is on offer.
void acknowledge(State&, Duration now);

/// A sound that starts, once.
void order_sound(State&, Sound, SoundDo = SoundDo::once);

}  // namespace evc::dmi
