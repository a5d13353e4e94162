#include "driver/driver.h"

#include <array>

namespace evc::driver {
namespace {

template <std::size_t Capacity>
void put(InplaceVector<const char*, Capacity>& list, const char* text) {
  // The capacities hold everything that can be shown at once; a list that is full shows the first entries.
  if (text != nullptr) static_cast<void>(list.push_back(text));
}

/// What Start needs beside the mode (window Main): SB with all data, PT after its procedure, SR with an RBC.
bool start_possible(const ActionContext& c) {
  switch (c.mode) {
    case Mode::SB:
      return c.standstill && c.driver_id_valid && c.train_data_valid && c.train_running_number_valid &&
             (!level_2_or_3(c.level) || !c.session_open || c.train_data_acknowledged) && c.offers.has(Offer::start);
    case Mode::PT:
      return c.standstill && c.offers.has(Offer::start);
    default:
      return level_2_or_3(c.level) && c.session_open;
  }
}

bool shunting_possible(const ActionContext& c) {
  if (!c.standstill || (level_2_or_3(c.level) && !c.session_open)) return false;
  if (c.mode == Mode::PT) return c.offers.has(Offer::shunting);
  return c.driver_id_valid && (c.mode != Mode::SB || c.offers.has(Offer::shunting));
}

bool override_possible(const ActionContext& c) {
  if (!c.slow_enough_for_override) return false;
  switch (c.mode) {
    case Mode::SH:
      return true;
    case Mode::SB:
      return c.offers.has(Offer::override_) && c.driver_id_valid && c.train_data_valid &&
             c.train_running_number_valid && level_2_or_3(c.level);
    case Mode::PT:
      return c.train_data_valid && c.train_running_number_valid;
    default:
      return c.train_data_valid;
  }
}

/// The acknowledgement an input stands for.
std::optional<Ack> acknowledged_by(Input input) {
  switch (input) {
    case Input::ack_OS:
      return Ack::OS;
    case Input::ack_LS:
      return Ack::LS;
    case Input::ack_SH:
      return Ack::SH;
    case Input::ack_SR:
      return Ack::SR;
    case Input::ack_UN:
      return Ack::UN;
    case Input::ack_SN:
      return Ack::SN;
    case Input::ack_RV:
      return Ack::RV;
    case Input::ack_trip:
      return Ack::trip;
    case Input::ack_level:
      return Ack::level;
    case Input::ack_fixed_text:
    case Input::ack_plain_text:
      return Ack::text;
    case Input::ack_train_data_change:
      return Ack::train_data;
    case Input::ack_roll_away:
    case Input::ack_reverse_movement:
    case Input::ack_standstill:
    case Input::ack_pt_distance:
    case Input::ack_rv_distance:
      return Ack::brake;
    default:
      return std::nullopt;
  }
}

/// The further conditions of an input that the mode marks as available (windows Main, Override, Special, Settings).
bool further_conditions(Input input, const ActionContext& c) {
  if (const std::optional<Ack> ack = acknowledged_by(input)) return c.requests.has(*ack);
  const bool level = c.level.has_value();
  const bool in_standby = c.mode == Mode::SB;
  switch (input) {
    case Input::start:
      return level && start_possible(c);
    case Input::shunting:
      return level && shunting_possible(c);
    case Input::override_:
      return override_possible(c);
    case Input::driver_id:
      return in_standby ? c.standstill : c.standstill || c.driver_id_while_running;
    case Input::train_data:
      return c.standstill && c.driver_id_valid && level && (!in_standby || c.offers.has(Offer::train_data));
    case Input::level:
      return c.standstill && c.driver_id_valid;
    case Input::train_running_number:
      return !in_standby || (c.standstill && c.driver_id_valid);
    case Input::rbc_contact:
    case Input::radio_network_id:
      return c.standstill && c.driver_id_valid;
    case Input::non_leading:
      return c.standstill && c.driver_id_valid && level && c.non_leading_signal;
    case Input::continue_shunting:
      return c.passive_shunting_signal;
    case Input::adhesion:
      return c.driver_may_change_adhesion && (!in_standby || c.standstill);
    case Input::sr_speed_distance:
    case Input::exit_shunting:
    case Input::vbc:
      return c.standstill;
    case Input::integrity_confirmation:
      return c.standstill && c.driver_id_valid && c.train_data_valid && level;
    case Input::track_ahead_free:
      return c.track_ahead_free_asked;
    default:  // language, isolation
      return true;
  }
}

}  // namespace

Set<Input> enabled(const ActionContext& context) {
  Set<Input> out;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const Input input = static_cast<Input>(i);
    if (!allowed(input, context.mode)) continue;
    if (input != Input::isolation) {
      if (!context.desk_open) continue;
      // 015560 5.4: the menus are closed while an acknowledgement is asked for.
      if (!context.requests.empty() && !acknowledged_by(input).has_value()) continue;
      if (!further_conditions(input, context)) continue;
    }
    out.add(input);
  }
  return out;
}

namespace {

void put_level(Show& show, const ShowContext& c) {
  if (c.level.has_value()) put(show.symbols, symbol(*c.level));
}

/// Area C1: an acknowledgement of a mode hides the announcement of a level (015560 8.2.3.1).
void put_c1(Show& show, const ShowContext& c) {
  constexpr Ack modes_first[] = {Ack::trip, Ack::SH, Ack::OS, Ack::LS, Ack::SR, Ack::RV, Ack::UN, Ack::SN};
  bool mode = false;
  for (const Ack ack : modes_first)
    if (c.requests.has(ack) && !mode) {
      put(show.symbols, symbol(ack));
      mode = true;
    }
  if (mode) return;
  const bool level = c.requests.has(Ack::level);
  // After the transition the level to acknowledge is the one shown.
  const std::optional<Level> shown = c.announced.has_value() ? c.announced : level ? c.level : std::nullopt;
  if (shown.has_value() && (level || allowed(Output::level_announcement, c.mode)))
    put(show.symbols, announcement_symbol(*shown, level));
}

}  // namespace

Show show(const ShowContext& c) {
  Show out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Ack::count); ++i)
    if (c.requests.has(static_cast<Ack>(i))) put(out.requests, name(static_cast<Ack>(i)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(Entry::count); ++i)
    if (c.entries.has(static_cast<Entry>(i))) put(out.requests, name(static_cast<Entry>(i)));

  const bool nothing = !c.desk_open && c.mode != Mode::SF && c.mode != Mode::IS;
  if (nothing || c.mode == Mode::NP || c.mode == Mode::PS || c.mode == Mode::SL) return out;
  put(out.symbols, symbol(c.mode));                       // B7
  if (allowed(Output::level, c.mode)) put_level(out, c);  // C8
  put_c1(out, c);                                         // C1
  const auto where = [&](bool when, Output output, const char* which) {
    if (when && allowed(output, c.mode)) put(out.symbols, which);
  };
  where(c.slippery_rail, Output::slippery_rail, "ST02");                    // A4
  where(c.lssma, Output::lssma, "LS01");                                    // A1
  where(c.lx_not_protected, Output::lx_not_protected, "LX01");              // B3
  where(c.reversing_possible, Output::reversing_allowed, "ST06");           // C6
  where(c.override_active, Output::override_status, "MO03");                // C7
  where(c.brake_commanded, Output::brake_indication, "ST01");               // C9
  where(c.track_ahead_free_asked, Output::taf_request, "DR02");             // D
  where(c.radio == RadioStatus::up, Output::radio_link_status, "ST03");     // E1
  where(c.radio == RadioStatus::lost, Output::radio_link_status, "ST04");   // E1
  where(c.tunnel_stopping_area, Output::track_cond_horn_stopping, "TC36");  // C2
  return out;
}

const char* symbol(Mode mode) {
  constexpr std::array<const char*, kModes> symbols{
      /* NP */ nullptr, /* SB */ "MO13", /* PS */ nullptr, /* SH */ "MO01", /* FS */ "MO11", /* LS */ "MO21",
      /* SR */ "MO09",  /* OS */ "MO07", /* SL */ nullptr, /* NL */ "MO12", /* UN */ "MO16", /* TR */ "MO04",
      /* PT */ "MO06",  /* SF */ "MO18", /* IS */ nullptr, /* SN */ "MO19", /* RV */ "MO14"};
  return symbols[static_cast<std::size_t>(mode)];
}

const char* symbol(Ack ack) {
  switch (ack) {
    case Ack::SH:
      return "MO02";
    case Ack::trip:
      return "MO05";
    case Ack::OS:
      return "MO08";
    case Ack::SR:
      return "MO10";
    case Ack::RV:
      return "MO15";
    case Ack::UN:
      return "MO17";
    case Ack::SN:
      return "MO20";
    case Ack::LS:
      return "MO22";
    default:
      return nullptr;
  }
}

const char* symbol(Level level) {
  constexpr std::array<const char*, modes::kLevels> symbols{"LE01", "LE02", "LE03", "LE04", "LE05"};
  return symbols[static_cast<std::size_t>(level)];
}

const char* announcement_symbol(Level level, bool acknowledgement) {
  constexpr std::array<const char*, modes::kLevels> grey{"LE06", "LE08", "LE10", "LE12", "LE14"};
  constexpr std::array<const char*, modes::kLevels> yellow{"LE07", "LE09", "LE11", "LE13", "LE15"};
  return (acknowledgement ? yellow : grey)[static_cast<std::size_t>(level)];
}

const char* name(Ack ack) {
  constexpr std::array<const char*, static_cast<std::size_t>(Ack::count)> names{
      "OS", "LS", "SH", "SR", "UN", "SN", "RV", "trip", "level", "text", "brake", "train_data"};
  return names[static_cast<std::size_t>(ack)];
}

const char* name(Entry entry) {
  constexpr std::array<const char*, static_cast<std::size_t>(Entry::count)> names{
      "enter driver_id", "enter level", "enter rbc_contact", "enter train_data", "enter train_running_number"};
  return names[static_cast<std::size_t>(entry)];
}

const char* text(modes::Inform inform) {
  switch (inform) {
    case modes::Inform::network_registration_failed:
      return "Radio network registration failed";
    case modes::Inform::train_rejected:
      return "Train is rejected";
    case modes::Inform::SH_refused:
      return "SH refused";
    case modes::Inform::SH_request_failed:
      return "SH request failed";
    default:  // a session that could not be opened is shown by ST04
      return nullptr;
  }
}

const char* trip_reason(int condition) {
  switch (condition) {
    case 17:
    case 66:
      return "Balise read error";
    case 41:
      return "Communication error";
    case 35:
      return "SH refused";
    case 65:
      return "Trackside not compatible";
    case 12:
    case 16:
    case 18:
    case 43:
      return "Unauthorized passing of EOA / LOA";
    case 39:
    case 67:
      return "No MA received at level transition";
    case 42:
      return "SR distance exceeded";
    case 49:
    case 52:
      return "SH stop order";
    case 36:
    case 54:
      return "SR stop order";
    case 20:
      return "Emergency stop";
    case 69:
      return "No track description";
    case 38:
      return "National system brake demand";
    default:
      return nullptr;
  }
}

}  // namespace evc::driver
