#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/buttons.h"
#include "driver/status_texts.h"
#include "io/json.h"
#include "screen/player.h"
#include "terms/dialogue.h"

// The described cases of a display (`evc dmi --cases`): their state, and what happens.
namespace evc::screen {

/// A step of the dialogues of 015560 11.7.
struct Step {
  const char* name;               ///< "start-up S3-1", with the numbers of Tables 49 to 54a
  std::optional<Dialogue> start;  ///< where the start of mission is; none: there is none
  port::Waiting waiting;          ///< for what the on-board waits
  const char* window;             ///< null: that which the on-board opens
  bool asks_one_radio_system = false;
};

/// The place of a display in a case. What the case does not name is neutral: SRS 4.0.0, dial to 400 km/h, mode SB, no
/// target, no text, not at standstill, every button of the menus enabled, all data stored and valid.
struct Scene {
  Scene();

  Player player;
  driver::StatusTexts status_texts;            ///< the on-board's
  std::map<std::uint16_t, std::string> names;  ///< of texts, as the case calls them
  std::uint16_t next_text = 1;
  std::map<std::string, std::string> labels;    ///< of choices, as the case calls them
  std::optional<driver::ButtonContext> tables;  ///< the facts by which Tables 33 to 37 enable the buttons of the case
  Set<driver::Fact> denied;                     ///< facts of these tables that do not hold, where nothing else is said
  const Step* step = nullptr;                   ///< of the dialogues
  std::vector<bool> toggled;                    ///< of the speed toggle, after each touch

  // How a button behaved (015560 5.3.2.6).
  struct Watched {
    std::optional<dmi::Target> target;
    std::map<std::int64_t, bool> pressed;  ///< how it looked, by time in ms
    int activations = 0;
    std::string acted_at;  ///< "press" or "release", the first time
  } watched;
  std::vector<std::string> choices_after_more, choices_after_second_more;
};

/// Sets the display to `given`, shows it, and opens the window that is wanted. `expect` names the window of a button
/// and the layers of the planning area where `given` does not. Throws ReadError for what is not known.
void set_given(Scene& scene, const io::JsonPlace& given, const io::JsonPlace& expect);

/// Plays what happens: `events`, `event`, `sequence`, `press`, `presses` and what a window is given. Throws ReadError.
void play(Scene& scene, const io::JsonPlace& given, const io::JsonPlace& expect);

/// Plays `system_status`: the on-board starts these texts, and ends them where the case says so. Throws ReadError.
void play_status_texts(Scene& scene, const io::JsonPlace& given);

// Shared by the three.
/// The step with this name. Throws ReadError.
const Step& step_named(const io::JsonPlace& place);
/// Opens a window by touching buttons; false: it cannot be reached.
bool open_window(Scene& scene, std::string_view title);
/// The events of a case with times, up to `ms`. `next`: the first that is not played yet.
void play_events_to(Scene& scene, const io::JsonPlace& events, std::size_t& next, std::int64_t ms);
/// A text in areas E5 to E9; its id.
std::uint16_t add_text(Scene& scene, std::string_view words, bool important, bool acknowledge);
/// What the driver acknowledges: "mode OS", "level 0", "text X", "brake release". Throws ReadError.
void add_request(Scene& scene, const io::JsonPlace& request);
/// What is acknowledged of a mode, "OS"; "TR" is the trip. Throws ReadError.
Ack ack_named(const io::JsonPlace& mode);
/// The symbol or text whose acknowledgement is on offer; none.
std::optional<std::string> shown_request(const Scene& scene);
/// A time of a case, up to 1e6 s, in ms. Throws ReadError.
std::int64_t ms_of(const io::JsonPlace& seconds);
/// The picture with this name, "PL21". Throws ReadError.
Picture picture_named(const io::JsonPlace& place);

}  // namespace evc::screen
