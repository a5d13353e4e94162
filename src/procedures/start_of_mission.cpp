#include "procedures/start_of_mission.h"

namespace evc::procedures::start_of_mission {
namespace {

bool valid(DataStatus status) { return status == DataStatus::valid; }

bool no_session(const Inputs& in) { return in.session == Session::none || in.session == Session::terminating; }
bool session_lost(const Inputs& in) { return level_2_or_3(in.level) && in.session != Session::open; }

/// S10, S20: Start leads to the acknowledgement of the level's mode, or to the RBC. In level 2/3 without a session the
/// mission starts in SR (5.4.5.3 h).
Step after_start(State& state, const Inputs& in) {
  switch (in.level) {
    case Level::NTC:
      return Step::S22;
    case Level::L0:
      return Step::S23;
    case Level::L1:
      return Step::S24;
    default:
      state.without_session = in.session != Session::open;
      return state.without_session ? Step::S24 : Step::S21;
  }
}

/// A31.
Step call(Effects& out) {
  out.send.add(Send::open_session);
  return Step::D31;
}

/// D2, D3, D7: the next step once the driver identity is known.
Step after_driver_id(const Inputs& in, Effects& out) {
  if (!valid(in.position) || !valid(in.level_status)) {
    // A level selected in this cycle is the driver's answer.
    if (!in.enters_level) out.status.add(Status::level_invalid, valid(in.level_status));
    out.status.add(Status::rbc_contact_invalid);
    return Step::S2;
  }
  if (!level_2_or_3(in.level)) return Step::S10;
  if (in.mobile_terminal_registered) return call(out);
  if (in.srs == SrsVersion::v4_0_0) return Step::S4;
  out.inform.add(Inform::network_registration_failed);  // A29
  return Step::S10;
}

/// S4 of 4.0.0, with GSM-R alone: A42 leads to S10 (D9).
Step after_registration(const Inputs& in, Effects& out) {
  if (in.mobile_terminal_registered) return call(out);  // E6
  if (!in.registration_failed) return Step::S4;
  out.inform.add(Inform::network_registration_failed);  // E7
  return Step::S10;
}

/// S3: RBC contact. Without a network to choose (E3) 3.x goes on at once, 4.0.0 as soon as the registration has failed.
Step after_level(const Inputs& in, Effects& out) {
  if (!level_2_or_3(in.level)) return Step::S10;
  if (!in.mobile_terminal_registered) {
    const bool registers = in.srs == SrsVersion::v4_0_0 && !in.registration_failed;
    if (in.network_offered || registers) return Step::S3;
    out.inform.add(Inform::network_registration_failed);
    return Step::S10;
  }
  if (!in.enters_rbc_contact && !in.selects_short_number) return Step::S3;
  out.status.add(Status::rbc_contact_valid, in.enters_rbc_contact);
  return call(out);
}

/// D31, D32, A32 to A34: once the attempt to open the session has ended.
Step after_session(const Inputs& in, Effects& out) {
  if (in.session == Session::establishing) return Step::D31;
  if (in.session != Session::open) return Step::S10;  // the driver sees it by the radio indication (ST04)
  out.status.add(Status::rbc_contact_valid);
  out.send.add(Send::start_of_mission_report);
  const bool of_LRBG = in.srs != SrsVersion::v4_0_0 || in.position_refers_to_LRBG;
  return valid(in.position) && of_LRBG ? Step::S10 : Step::D33;
}

/// D34, D35 of 4.0.0: a valid position that refers to an unlinked group is no reason for the answer, and stays.
bool position_stays(const Inputs& in) {
  return in.srs == SrsVersion::v4_0_0 && valid(in.position) && !in.position_refers_to_LRBG;
}

/// D33, D22: the RBC has confirmed the position, or accepted or rejected the train.
Step after_validation(const Inputs& in, Effects& out) {
  if (!level_2_or_3(in.level)) return Step::S10;  // ordered by trackside: the answers are of level 2 (4.8.3)
  if (in.position_confirmed && in.position == DataStatus::invalid) {
    out.status.add(Status::position_valid);  // A35
    return Step::S10;
  }
  if (in.train_accepted) {
    out.status.add(Status::position_unknown, !position_stays(in));  // A24
    return Step::S10;
  }
  if (in.train_rejected) {
    out.status.add(Status::position_unknown, !position_stays(in));  // A39
    out.send.add(Send::terminate_session);
    return Step::A40;
  }
  return in.session == Session::open ? Step::D33 : Step::S10;
}

/// A40: the driver is informed once the session is terminated.
Step after_rejection(const Inputs& in, Effects& out) {
  if (in.session == Session::open || in.session == Session::terminating) return Step::A40;
  out.inform.add(Inform::train_rejected);
  return Step::S10;
}

/// D10, D11: train data and running number are valid. The RBC gets train data when they are validated (3.18.3.4); up to
/// 3.6.0 S11 sends them, also again; in 4.0.0 it only waits, and D15 leaves it out when they are acknowledged.
Step after_running_number(const Inputs& in, Effects& out) {
  if (!level_2_or_3(in.level)) return Step::S20;
  if (in.session != Session::open) return Step::S10;
  if (in.srs == SrsVersion::v4_0_0) return in.train_data_acknowledged ? Step::S20 : Step::S11;
  out.send.add(Send::train_data);
  return Step::S11;
}

/// S11: the RBC acknowledges the train data, or the session is lost (5.4.5.1). In another level they need not be (D10).
Step after_train_data(const Inputs& in) {
  if (!level_2_or_3(in.level)) return Step::S20;
  if (in.session != Session::open) return Step::S10;
  return in.train_data_acknowledged ? Step::S20 : Step::S11;
}

/// S21: the RBC answers, or the session is lost (5.4.5.1). In another level it does not: the start is offered for that
/// (D10).
Step after_ma_request(State& state, const Inputs& in) {
  if (!level_2_or_3(in.level)) return Step::S20;
  if (in.session != Session::open) return Step::S10;
  if (in.SR_authorised) return Step::S24;
  if (in.profile_at_front.has_value()) {
    state.profile = *in.profile_at_front;
    return Step::S25;
  }
  return Step::S21;
}

/// S10 and S20, which offer nearly the same choices.
Step choose(State& state, const Inputs& in, Effects& out) {
  if (in.enters_level) {  // a new entry: level and RBC data are asked for again
    out.status |= {Status::rbc_contact_invalid, Status::level_valid};
    return level_2_or_3(in.level) ? Step::S3 : Step::S10;
  }
  // 5.4.5.3 j: another RBC, or the same one, is called from S3 on.
  if ((in.enters_rbc_contact || in.selects_short_number) && level_2_or_3(in.level)) return Step::S3;
  if (in.enters_train_data || (in.entry_of_train_data_open && !state.entry_was_open)) return Step::S12;  // E11
  if (state.step == Step::S20 && session_lost(in)) return Step::S10;
  if (in.selects_start && valid(in.train_data) && valid(in.train_running_number)) return after_start(state, in);
  return state.step;
}

/// S12 is left as it was entered.
Step without_entry(const Inputs& in) {
  const bool ready = valid(in.train_data) && valid(in.train_running_number);
  return ready && (!level_2_or_3(in.level) || in.train_data_acknowledged) ? Step::S20 : Step::S10;
}

/// S22 to S25: the acknowledgement is asked for while the level does not change. Loss of the session leads back
/// (5.4.5.1), except after a start without a session.
Step while_acknowledging(State& state, const Inputs& in) {
  switch (state.step) {
    case Step::S22:
      return in.level == Level::NTC ? Step::S22 : Step::S20;
    case Step::S23:
      return in.level == Level::L0 ? Step::S23 : Step::S20;
    case Step::S25:  // the RBC sent the mode profile, and may have sent another one since
      if (in.profile_at_front.has_value()) state.profile = *in.profile_at_front;
      if (!level_2_or_3(in.level)) return Step::S20;
      return session_lost(in) ? Step::S10 : Step::S25;
    default:
      if (!level_2_or_3(in.level)) return in.level == Level::L1 ? Step::S24 : Step::S20;
      return session_lost(in) && !state.without_session ? Step::S10 : Step::S24;
  }
}

Step next(State& state, const Inputs& in, Effects& out) {
  switch (state.step) {
    case Step::S0:
      return no_session(in) ? Step::S1 : Step::S0;
    case Step::S1:
      return valid(in.driver_id) ? after_driver_id(in, out) : Step::S1;
    case Step::S2:
      if (!in.enters_level) return Step::S2;
      out.status.add(Status::level_valid);
      return level_2_or_3(in.level) ? Step::S3 : Step::S10;
    case Step::S3:
      return after_level(in, out);
    case Step::S4:
      return after_registration(in, out);
    case Step::D31:
      return after_session(in, out);
    case Step::D33:
      return after_validation(in, out);
    case Step::A40:
      return after_rejection(in, out);
    case Step::S10:
    case Step::S20:
      return choose(state, in, out);
    case Step::S12:
      if (!in.enters_train_data && in.entry_of_train_data_open) return Step::S12;
      if (!in.enters_train_data) return without_entry(in);
      return valid(in.train_running_number) ? after_running_number(in, out) : Step::S13;
    case Step::S13:
      return valid(in.train_running_number) ? after_running_number(in, out) : Step::S13;
    case Step::S11:
      return after_train_data(in);
    case Step::S21:
      return after_ma_request(state, in);
    default:
      return while_acknowledging(state, in);
  }
}

/// The requests and offers of a waiting step.
void ask(const State& state, const Inputs& in, Effects& out) {
  switch (state.step) {
    case Step::S1:
      out.entries.add(Entry::driver_id);
      out.offers |= {Offer::train_running_number, Offer::vbc};
      break;
    case Step::S2:
      out.entries.add(Entry::level);
      break;
    case Step::S3:
      out.entries.add(Entry::rbc_contact, in.mobile_terminal_registered);
      out.offers.add(Offer::radio_network);
      break;
    case Step::S10:
    case Step::S20:
      out.offers |= {Offer::shunting,  Offer::non_leading,   Offer::train_data,
                     Offer::override_, Offer::driver_id,     Offer::train_running_number,
                     Offer::level,     Offer::rbc_contact,   Offer::radio_network,
                     Offer::vbc,       Offer::bmm_inhibition};
      out.offers.add(Offer::start, valid(in.train_data) && valid(in.train_running_number));
      // The standard does not require this request, but without train data only shunting and non leading are possible.
      out.entries.add(Entry::train_data, !valid(in.train_data));
      break;
    case Step::S12:
      out.entries.add(Entry::train_data);
      break;
    case Step::S13:
      out.entries.add(Entry::train_running_number);
      break;
    case Step::S22:
      out.requests.add(Ack::SN);
      break;
    case Step::S23:
      out.requests.add(Ack::UN);
      break;
    case Step::S24:
      out.requests.add(Ack::SR);
      break;
    case Step::S25:
      out.requests.add(state.profile == Mode::OS ? Ack::OS : state.profile == Mode::LS ? Ack::LS : Ack::SH);
      break;
    default:
      break;
  }
}

/// 5.4.1.4: S0 ends a session that is open when the desk is opened. One that comes later, in which the end of shunting
/// is reported, is ended in its second cycle: the RBC has the report, and the driver does not depend on its order.
bool ends_session(State& state, const Inputs& in) {
  if (state.step != Step::S0 || in.session != Session::open) {
    state.cycles_in_session = 0;
    return false;
  }
  if (state.cycles_in_session == 2) return false;
  state.cycles_in_session = state.desk_was_open && state.cycles_in_session == 0 ? 1 : 2;
  return state.cycles_in_session == 2;
}

}  // namespace

bool without_session(const State& state) { return state.step != Step::S0 && !state.had_session; }

Effects step(State& state, const Inputs& in) {
  Effects out;
  if (in.mode != Mode::SB || !in.desk_open) {
    // E10, E12, E30 to E32: when the mission starts, an invalid position becomes unknown (5.4.3.3).
    if (in.mode != Mode::SB && state.step != Step::S0 && in.position == DataStatus::invalid)
      out.status.add(Status::position_unknown);
    out.send.add(Send::terminate_session, in.mode == Mode::SB && state.step != Step::S0);
    state = State{};
    state.desk_was_open = in.desk_open;
    return out;
  }
  out.send.add(Send::terminate_session, ends_session(state, in));
  state.desk_was_open = true;
  state.had_session = state.had_session || (state.step != Step::S0 && in.session == Session::open);
  // Decisions take no time: continue until a step waits. Every step is executed at most once in a cycle.
  Inputs now = in;
  for (int k = 0; k < 16; ++k) {
    const Step before = state.step;
    state.step = next(state, now, out);
    if (before == Step::S10 || before == Step::S20 || before == Step::S2) now.enters_level = false;
    if (before == Step::S10 || before == Step::S20) now.selects_start = false;
    if (before == Step::S3) now.enters_rbc_contact = now.selects_short_number = false;
    if (before == Step::S12) now.enters_train_data = now.entry_of_train_data_open = false;
    if (state.step == before) break;
    // A request in the outputs of this cycle is answered in the next one at the earliest.
    if (state.step == Step::D31 || state.step == Step::S11 || state.step == Step::S21) break;
  }
  state.entry_was_open = in.entry_of_train_data_open;
  ask(state, in, out);
  return out;
}

}  // namespace evc::procedures::start_of_mission
