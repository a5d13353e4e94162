#include "kernel/show.h"

#include "driver/buttons.h"
#include "driver/driver.h"
#include "kernel/driver_inputs.h"
#include "kernel/here.h"

namespace evc::kernel {
namespace {

using enum DriverOutput;

/// What is left of the SR distance is at most this when the driver enters it (4.4.11, intake).
constexpr Distance kLongestSR{100000.0};

/// For what the display shows the hour glass (11.7).
port::Waiting waiting_in(std::optional<ShownDialogue> dialogue) {
  if (!dialogue) return port::Waiting::nothing;
  switch (dialogue->step) {
    case Dialogue::start_S0:
    case Dialogue::start_A40:
      return port::Waiting::end_of_session;
    case Dialogue::start_S4:
      return port::Waiting::radio_registration;
    case Dialogue::start_D31:
      return port::Waiting::session;
    case Dialogue::start_D33:
      return port::Waiting::train_accepted;
    case Dialogue::start_S11:
      return port::Waiting::train_data_acknowledged;
    case Dialogue::start_S21:
    case Dialogue::trip_S150:
      return port::Waiting::answer_to_ma_request;
    case Dialogue::shunting_S050:
      return port::Waiting::answer_to_sh_request;
    case Dialogue::manoeuvre_S050:
      return port::Waiting::answer_to_sm_request;
    default:
      return port::Waiting::nothing;
  }
}

/// 015560 11.7.2 S3-2-1 and -3, 11.7.3 S5-2-1 and -3: the driver changes the network, at standstill. There is a list to
/// choose from when the sessions that this ends (3.18.4.3.6.1 b) have ended; then he waits for the network that he
/// chose. Other registrations, of a network of trackside or of a second terminal, close no menu.
port::Waiting waiting_for_network(const State& s, const track::Here& here) {
  if (!s.network.by_driver || !here.standstill) return port::Waiting::nothing;
  bool registers_later = false;
  for (const radio::Peer peer : radio::kPeers)
    registers_later = registers_later || s.radio.session(peer).registers_after.has_value();
  return s.network.awaited || registers_later ? port::Waiting::radio_registration : port::Waiting::network_list;
}

class Teller {
 public:
  Teller(const State& state, const Outputs& outputs, Set<DriverOutput> may, const track::Here& here, Display& to)
      : s_(state), out_(outputs), may_(may), here_(here), to_(to) {}

  void tell() {
    show_texts();
    show_data();
    show_driver();
  }

 private:
  bool has(DriverOutput output) const { return may_.has(output); }

  /// With the local time of its begin, where the clock is known.
  void begin(port::DisplayedText& text, Duration since) const {
    text.since = since;
    if (to_.second_of_day)
      text.minute_of_day = static_cast<std::uint16_t>(second_of_day(*out_.clock, out_.now - since) / 60);
  }

  void show_texts() {
    for (const ShownText& shown : out_.texts) {
      if (!has(shown.Q_TEXT ? fixed_text : plain_text)) continue;
      port::DisplayedText* const text = to_.texts.grow();
      if (text == nullptr) return;
      *text = {};
      text->id = shown.id;
      text->kind = shown.Q_TEXT ? port::TextKind::fixed : port::TextKind::plain;
      text->important = shown.important;
      text->acknowledge = shown.acknowledge;
      text->Q_TEXT = shown.Q_TEXT.value_or(0);
      text->length = shown.length;
      text->characters = shown.characters;
      begin(*text, shown.since);
    }
    for (const ShownStatus& shown : out_.status_texts) {
      port::DisplayedText* const text = to_.texts.grow();
      if (text == nullptr) return;
      *text = {};
      text->id = static_cast<std::uint16_t>(kFirstStatusId + terms::index(shown.text));
      text->kind = port::TextKind::status;
      text->important = true;
      text->acknowledge = asks_acknowledgement(shown.text);
      text->status = shown.text;
      if (names_national_system(shown.text)) text->nid_ntc = out_.national_system.value_or(0);
      begin(*text, shown.since);
    }
  }

  void show_data() {
    port::DisplayedData& data = to_.data;
    data.stored = out_.data;
    const auto hide = [this](DriverOutput output, DataStatus& status) {
      if (!has(output)) status = DataStatus::unknown;
    };
    hide(DriverOutput::train_data, data.stored.train_status);
    hide(driver_id, data.stored.driver_id_status);
    hide(train_running_number, data.stored.train_running_number_status);
    hide(rbc_contact, data.stored.rbc_status);
    if (!has(radio_network_id)) data.stored.network = std::nullopt;
    data.levels = static_cast<std::uint8_t>(out_.levels_allowed.bits());
    show_national_systems();
    data.networks = s_.network.offered;
    if (has(vbc)) data.covers = out_.covers;
    data.M_VERSION = out_.M_VERSION;
    data.radio = port::RadioNetworkType::gsmr;
    data.gsmr_registered = s_.network.registered;
    if (out_.mode == Mode::SR) data.D_sr_most = kLongestSR;
  }
  /// Those that the driver may choose (5.10.2.8): of the table of trackside, else all that there are.
  void show_national_systems() {
    if (!out_.levels_allowed.has(Level::NTC)) return;
    const std::uint64_t available = s_.displayed.national_systems;
    const auto offer = [&](std::uint8_t nid_ntc) {
      if (nid_ntc < 64 && ((available >> nid_ntc) & 1u) != 0) (void)to_.data.ntcs.push_back(nid_ntc);
    };
    if (s_.level_table && !s_.level_table->empty()) {
      for (const modes::OrderedLevel& entry : *s_.level_table)
        if (entry.level == Level::NTC) offer(entry.nid_ntc);
      return;
    }
    for (std::uint8_t nid_ntc = 0; nid_ntc < 64; ++nid_ntc) offer(nid_ntc);
  }

  void show_driver() {
    for (const port::AskedAck& asked : s_.displayed.acks) (void)to_.acks.push_back(asked);  // there is room
    driver::ButtonContext context = button_context(s_, out_.enabled, here_);
    to_.buttons = driver::buttons(context);
    to_.enabled = out_.enabled;
    if (out_.dialogue) to_.step = out_.dialogue->step;
    to_.start_of_mission = to_.step && s_.mode == Mode::SB && *to_.step < Dialogue::start_S10;
    const port::Waiting for_network = waiting_for_network(s_, here_);
    to_.waiting = for_network != port::Waiting::nothing ? for_network : waiting_in(out_.dialogue);
  }

  const State& s_;
  const Outputs& out_;
  Set<DriverOutput> may_;
  const track::Here& here_;
  Display& to_;
};

}  // namespace

std::uint32_t second_of_day(const DateTime& clock, Duration ago) {
  constexpr std::int64_t day = std::int64_t{24} * 3600;
  // The difference of two times may be a little below a whole second.
  const std::int64_t local =
      clock.utc + 60 * std::int64_t{clock.local_offset_min} - static_cast<std::int64_t>(ago.si + 0.0005);
  return static_cast<std::uint32_t>((local % day + day) % day);
}

void show_to_driver(const State& state, const Outputs& outputs, Set<DriverOutput> may, const track::Here& here,
                    Display& display) {
  Teller(state, outputs, may, here, display).tell();
}

}  // namespace evc::kernel
