#include "driver/driver.h"

#include <array>

namespace evc::driver {
namespace {

void put(Show& show, std::optional<Symbol> symbol) {
  // The list holds everything that can be shown at once; if it is full, further entries are not
  // shown.
  if (symbol) static_cast<void>(show.symbols.push_back(*symbol));
}

/// The conditions of Start in addition to the mode (window Main): SB with all data, PT after its procedure, SR with an
/// RBC.
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

/// In SB and PT in the steps that offer shunting as well (5.4.3.2 S10, 5.4.5.3 k, 5.11.2.2 S140).
bool manoeuvre_possible(const ActionContext& c) {
  const bool by_step = c.mode == Mode::SB || c.mode == Mode::PT;
  return c.standstill && c.manoeuvre_possible && (!by_step || c.offers.has(Offer::shunting));
}

bool override_possible(const ActionContext& c) {
  if (!c.slow_enough_for_override) return false;
  switch (c.mode) {
    case Mode::SH:
      return true;
    case Mode::SB:
      return c.offers.has(Offer::override_) && c.driver_id_valid && c.train_data_valid &&
             c.train_running_number_valid && level_2_or_3(c.level);
    case Mode::PT:  // in every step of 5.11: with a session and emergency stops too, which SR deletes (5.8.3.4)
      return c.train_data_valid && c.train_running_number_valid;
    default:
      return c.train_data_valid;
  }
}

/// The acknowledgement that an input gives.
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
    case Input::ack_nl_no_longer_permitted:
      return Ack::text;
    case Input::ack_roll_away:
    case Input::ack_reverse_movement:
    case Input::ack_standstill:
    case Input::ack_pt_distance:
    case Input::ack_train_data_change:
    case Input::ack_rv_distance:
      return Ack::brake;
    default:
      return std::nullopt;
  }
}

/// What each mode allows in each edition, further conditions left aside.
template <class What, std::size_t count>
constexpr auto kAllowed = [] {
  std::array<std::array<Set<What>, kModes>, kSrsVersionRows.size()> out{};
  for (std::size_t e = 0; e < kSrsVersionRows.size(); ++e)
    for (std::size_t m = 0; m < kModes; ++m)
      for (std::size_t i = 0; i < count; ++i) {
        const auto what = static_cast<What>(i);
        out[e][m].add(what, allowed(what, static_cast<Mode>(m), static_cast<SrsVersion>(e)));
      }
  return out;
}();

constexpr Set<Input> allowed_inputs(Mode mode, SrsVersion srs) {
  return kAllowed<Input, kInputs>[terms::index(srs)][terms::index(mode)];
}

constexpr Set<Output> allowed_outputs(Mode mode, SrsVersion srs) {
  return kAllowed<Output, kOutputs>[terms::index(srs)][terms::index(mode)];
}

/// The acknowledgements that are asked for.
Set<Input> acknowledgements(Set<Ack> requests) {
  Set<Input> out;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const std::optional<Ack> ack = acknowledged_by(static_cast<Input>(i));
    if (ack.has_value() && requests.has(*ack)) out.add(static_cast<Input>(i));
  }
  return out;
}

/// 5.4: in SB the driver enters what the step of the start of mission asks for or offers; in other modes its windows
/// are open.
Set<Offer> open_offers(const ActionContext& c) { return c.mode == Mode::SB ? c.offers : Set<Offer>::of_bits(~0u); }

/// The data that may be entered, the mode left aside.
Set<Input> entries(const ActionContext& c) {
  const bool in_standby = c.mode == Mode::SB;
  const bool entry = c.standstill && c.driver_id_valid;
  const Set<Offer> offers = open_offers(c);
  Set<Input> out;
  out.add(Input::language, !in_standby || c.standstill);
  out.add(Input::driver_id,
          (c.standstill && offers.has(Offer::driver_id)) || (!in_standby && c.driver_id_while_running));
  out.add(Input::train_data, entry && c.level.has_value() && !c.consist_in_front && offers.has(Offer::train_data));
  out.add(Input::level, entry && offers.has(Offer::level));
  // 5.4.3.2 S1: before the driver ID too
  out.add(Input::train_running_number, !in_standby || (c.standstill && offers.has(Offer::train_running_number)));
  out.add(Input::rbc_contact, entry && level_2_or_3(c.level) && offers.has(Offer::rbc_contact));  // 3.18.4.3.2
  out.add(Input::radio_network_id, entry && c.network_offered && offers.has(Offer::radio_network));
  out.add(Input::adhesion, c.driver_may_change_adhesion && (!in_standby || c.standstill));
  out.add(Input::sr_speed_distance, c.standstill);
  out.add(Input::vbc, c.standstill && c.offers.has(Offer::vbc));  // 3.15.9.2
  return out;
}

/// What is open beside acknowledgements, the mode left aside (windows Main, Override, Special, Settings).
Set<Input> choices(const ActionContext& c) {
  const bool level = c.level.has_value();
  const bool entry = c.standstill && c.driver_id_valid;
  const Set<Offer> offers = open_offers(c);
  Set<Input> out = entries(c);
  out.add(Input::start, level && start_possible(c));
  out.add(Input::shunting, level && shunting_possible(c));
  out.add(Input::override_, override_possible(c));
  out.add(Input::non_leading, entry && level && c.non_leading_signal && offers.has(Offer::non_leading));
  out.add(Input::continue_shunting, c.passive_shunting_signal);
  out.add(Input::exit_shunting, c.standstill);
  out.add(Input::integrity_confirmation, entry && (c.train_data_valid || c.consist_acknowledged) && level);
  out.add(Input::track_ahead_free, c.track_ahead_free_asked);
  out.add(Input::ato_engage, c.automatic_driving_asked);
  out.add(Input::ato_disengage);
  out.add(Input::sm, manoeuvre_possible(c));
  out.add(Input::exit_sm, c.standstill);
  // 5.4.5.3 l, 5.22.2.1
  out.add(Input::bmm_inhibit,
          c.standstill && c.alarm_may_be_inhibited && !c.alarm_inhibited && offers.has(Offer::bmm_inhibition));
  out.add(Input::bmm_revoke, c.alarm_inhibited);
  return out;
}

}  // namespace

Set<Input> enabled(const ActionContext& context) {
  Set<Input> out;
  // 015560 5.4: the menus are closed while an acknowledgement is asked for.
  if (context.desk_open) {
    if (!context.requests.empty()) out = acknowledgements(context.requests);
    if (context.requests.empty() || context.start_up) out |= choices(context);
  }
  out.add(Input::isolation);
  return out & allowed_inputs(context.mode, context.srs);
}

Set<Ack> answerable(Set<Ack> asked, Mode mode, SrsVersion srs) {
  const Set<Input> allowed = allowed_inputs(mode, srs);
  Set<Ack> out;
  out.add(Ack::train_data, asked.has(Ack::train_data));  // an entry, judged as one
  for (std::size_t i = 0; i < kInputs; ++i) {
    const std::optional<Ack> ack = acknowledged_by(static_cast<Input>(i));
    if (ack.has_value() && asked.has(*ack) && allowed.has(static_cast<Input>(i))) out.add(*ack);
  }
  return out;
}

namespace {

void put_level(Show& show, const ShowContext& c) {
  if (c.level.has_value()) put(show, symbol(*c.level));
}

/// Area C1: a mode acknowledgement hides the announcement of a level (015560 8.2.3.1).
void put_c1(Show& show, const ShowContext& c) {
  constexpr Ack modes_first[] = {Ack::trip, Ack::SH, Ack::OS, Ack::LS, Ack::SR, Ack::RV, Ack::UN, Ack::SN};
  bool mode = false;
  for (const Ack ack : modes_first)
    if (c.requests.has(ack) && !mode) {
      put(show, symbol(ack));
      mode = true;
    }
  if (mode) return;
  const bool level = c.requests.has(Ack::level);
  // After the transition, the level to be acknowledged is shown.
  const std::optional<Level> shown = c.announced.has_value() ? c.announced : level ? c.level : std::nullopt;
  if (shown.has_value() && (level || allowed(Output::level_announcement, c.mode, c.srs)))
    put(show, announcement_symbol(*shown, level));
}

/// The tunnel stopping area has an area of its own (015560 8.2.3.6).
bool in_C2(Symbol symbol) { return symbol == Symbol::TC36 || symbol == Symbol::TC37; }

}  // namespace

Show show(const ShowContext& c) {
  Show out;
  const bool nothing = !c.desk_open && c.mode != Mode::SF && c.mode != Mode::IS;
  if (nothing || c.mode == Mode::NP || c.mode == Mode::PS || c.mode == Mode::SL) return out;
  put(out, symbol(c.mode));                                      // B7
  if (allowed(Output::level, c.mode, c.srs)) put_level(out, c);  // C8
  put_c1(out, c);                                                // C1
  const auto where = [&](bool when, Output output, Symbol which) {
    if (when && allowed(output, c.mode, c.srs)) put(out, which);
  };
  where(c.slippery_rail, Output::slippery_rail, Symbol::ST02);        // A4
  where(c.lssma, Output::lssma, Symbol::LS01);                        // A1
  where(c.lx_not_protected, Output::lx_not_protected, Symbol::LX01);  // B3
  for (const Symbol s : c.track_conditions)
    if (!in_C2(s)) put(out, s);                                                        // B3 to B5
  where(c.reversing_possible, Output::reversing_allowed, Symbol::ST06);                // C6
  where(c.override_active, Output::override_status, Symbol::MO03);                     // C7
  where(c.brake_commanded, Output::brake_indication, Symbol::ST01);                    // C9
  where(c.track_ahead_free_asked, Output::taf_request, Symbol::DR02);                  // D
  where(c.radio == RadioIndication::up, Output::radio_link_status, Symbol::ST03);      // E1
  where(c.radio == RadioIndication::failed, Output::radio_link_status, Symbol::ST04);  // E1
  for (const Symbol s : c.track_conditions)
    if (in_C2(s)) put(out, s);
  return out;
}

namespace {

/// Hooks, digits of release speed and distance, planning area, time to indication (015560 8.2.2.4, tables 10 and 11).
constexpr Set<Output> kToggled{Output::permitted_speed,
                               Output::target_speed,
                               Output::target_distance,
                               Output::release_speed,
                               Output::time_to_indication,
                               Output::gradient,
                               Output::mrsp,
                               Output::first_indication_location,
                               Output::eoa_loa};

}  // namespace

Set<Output> shown(Set<Output> given, Mode mode, SrsVersion srs, bool desk_open, bool toggled_on) {
  if (!desk_open && mode != Mode::SF && mode != Mode::IS) return {};
  given &= allowed_outputs(mode, srs);
  if (can_be_toggled(mode) && !toggled_on) given.remove(kToggled);
  return given;
}

std::optional<Output> output_of(Symbol symbol) {
  if (symbol >= Symbol::LE06 && symbol <= Symbol::LE15) return Output::level_announcement;
  switch (symbol) {
    case Symbol::ST01:
      return Output::brake_indication;
    case Symbol::ST02:
      return Output::slippery_rail;
    case Symbol::ST03:
    case Symbol::ST04:
      return Output::radio_link_status;
    case Symbol::ST06:
      return Output::reversing_allowed;
    case Symbol::MO03:
      return Output::override_status;
    case Symbol::LX01:
      return Output::lx_not_protected;
    case Symbol::DR02:
      return Output::taf_request;
    default:
      return std::nullopt;
  }
}

std::optional<StatusText> trip_reason(int condition) {
  switch (condition) {
    case 17:
    case 66:
      return StatusText::balise_read_error;
    case 41:
      return StatusText::communication_error;
    case 35:
      return StatusText::SH_refused;
    case 65:
      return StatusText::trackside_not_compatible;
    case 11:
    case 12:
    case 16:
    case 18:
    case 43:
      return StatusText::passing_of_EOA_or_LOA;
    case 39:
    case 67:
      return StatusText::no_MA_at_level_transition;
    case 42:
      return StatusText::SR_distance_exceeded;
    case 49:
    case 52:
      return StatusText::SH_stop_order;
    case 36:
    case 54:
      return StatusText::SR_stop_order;
    case 20:
      return StatusText::emergency_stop;
    case 69:
      return StatusText::no_track_description;
    case 38:
      return StatusText::national_system_brake_demand;
    default:
      return std::nullopt;
  }
}

}  // namespace evc::driver
