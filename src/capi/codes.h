#pragma once
#include "openevc/evc.h"
#include "openevc/language.h"
#include "openevc/openevc.h"

// The numbers of openevc.h are those of our enumerations: casts between them rely on it. Each enumerator of C has its
// row here (tests/tools/codes_test.py), and the number of enumerators is compared so that a new one is noticed.
namespace evc::capi {

template <class C, class Ours>
constexpr bool same(C number, Ours enumerator) {
  return static_cast<int>(number) == static_cast<int>(enumerator);
}

static_assert(same(OPENEVC_NP, Mode::NP));
static_assert(same(OPENEVC_SB, Mode::SB));
static_assert(same(OPENEVC_PS, Mode::PS));
static_assert(same(OPENEVC_SH, Mode::SH));
static_assert(same(OPENEVC_FS, Mode::FS));
static_assert(same(OPENEVC_LS, Mode::LS));
static_assert(same(OPENEVC_SR, Mode::SR));
static_assert(same(OPENEVC_OS, Mode::OS));
static_assert(same(OPENEVC_SL, Mode::SL));
static_assert(same(OPENEVC_NL, Mode::NL));
static_assert(same(OPENEVC_UN, Mode::UN));
static_assert(same(OPENEVC_TR, Mode::TR));
static_assert(same(OPENEVC_PT, Mode::PT));
static_assert(same(OPENEVC_SF, Mode::SF));
static_assert(same(OPENEVC_IS, Mode::IS));
static_assert(same(OPENEVC_SN, Mode::SN));
static_assert(same(OPENEVC_RV, Mode::RV));
static_assert(same(OPENEVC_SM, Mode::SM));
static_assert(same(OPENEVC_AD, Mode::AD));
static_assert(kModes == 19);

static_assert(same(OPENEVC_L0, Level::L0));
static_assert(same(OPENEVC_NTC, Level::NTC));
static_assert(same(OPENEVC_L1, Level::L1));
static_assert(same(OPENEVC_L2, Level::L2));
static_assert(same(OPENEVC_L3, Level::L3));
static_assert(kLevels == 5);

static_assert(same(OPENEVC_LINK_UNCHANGED, RadioLink::unchanged));
static_assert(same(OPENEVC_LINK_CONNECTED, RadioLink::connected));
static_assert(same(OPENEVC_LINK_LOST, RadioLink::lost));
static_assert(same(OPENEVC_LINK_REFUSED, RadioLink::refused));
static_assert(kRadioLinkRows.size() == 4);

static_assert(same(OPENEVC_START, kernel::Select::start));
static_assert(same(OPENEVC_OVERRIDE, kernel::Select::override_));
static_assert(same(OPENEVC_SHUNTING, kernel::Select::shunting));
static_assert(same(OPENEVC_EXIT_SHUNTING, kernel::Select::exit_shunting));
static_assert(same(OPENEVC_NON_LEADING, kernel::Select::non_leading));
static_assert(same(OPENEVC_MAINTAIN_SHUNTING, kernel::Select::maintain_shunting));
static_assert(same(OPENEVC_TRAIN_DATA, kernel::Select::train_data));
static_assert(same(OPENEVC_SLIPPERY_RAIL, kernel::Select::slippery_rail));
static_assert(same(OPENEVC_ADHESION_NORMAL, kernel::Select::adhesion_normal));
static_assert(same(OPENEVC_ISOLATE, kernel::Select::isolate));
static_assert(same(OPENEVC_TRACK_AHEAD_FREE, kernel::Select::track_ahead_free));
static_assert(same(OPENEVC_MAIN, kernel::Select::main));
static_assert(same(OPENEVC_INTEGRITY_CONFIRMED, kernel::Select::integrity_confirmed));
static_assert(same(OPENEVC_LAST_RBC, kernel::Select::last_rbc));
static_assert(same(OPENEVC_SHORT_NUMBER, kernel::Select::short_number));
static_assert(same(OPENEVC_VBC_SET, kernel::Select::vbc_set));
static_assert(same(OPENEVC_VBC_REMOVE, kernel::Select::vbc_remove));
static_assert(same(OPENEVC_RADIO_NETWORK, kernel::Select::radio_network));
static_assert(same(OPENEVC_TOGGLE, kernel::Select::toggle));
static_assert(same(OPENEVC_ATO_ENGAGE, kernel::Select::ato_engage));
static_assert(same(OPENEVC_ATO_DISENGAGE, kernel::Select::ato_disengage));
static_assert(same(OPENEVC_ASK_SM, kernel::Select::sm));
static_assert(same(OPENEVC_CONTINUE_SM, kernel::Select::continue_sm));
static_assert(same(OPENEVC_EXIT_SM, kernel::Select::exit_sm));
static_assert(same(OPENEVC_BMM_INHIBIT, kernel::Select::bmm_inhibit));
static_assert(same(OPENEVC_BMM_REVOKE, kernel::Select::bmm_revoke));
static_assert(int(kernel::Select::count) == 26);

static_assert(same(OPENEVC_ACK_OS, Ack::OS));
static_assert(same(OPENEVC_ACK_LS, Ack::LS));
static_assert(same(OPENEVC_ACK_SH, Ack::SH));
static_assert(same(OPENEVC_ACK_SR, Ack::SR));
static_assert(same(OPENEVC_ACK_UN, Ack::UN));
static_assert(same(OPENEVC_ACK_SN, Ack::SN));
static_assert(same(OPENEVC_ACK_RV, Ack::RV));
static_assert(same(OPENEVC_ACK_TRIP, Ack::trip));
static_assert(same(OPENEVC_ACK_LEVEL, Ack::level));
static_assert(same(OPENEVC_ACK_TEXT, Ack::text));
static_assert(same(OPENEVC_ACK_BRAKE, Ack::brake));
static_assert(same(OPENEVC_ACK_TRAIN_DATA, Ack::train_data));
static_assert(int(Ack::count) == 12);

static_assert(same(OPENEVC_ENTRY_DRIVER_ID, Entry::driver_id));
static_assert(same(OPENEVC_ENTRY_LEVEL, Entry::level));
static_assert(same(OPENEVC_ENTRY_RBC_CONTACT, Entry::rbc_contact));
static_assert(same(OPENEVC_ENTRY_TRAIN_DATA, Entry::train_data));
static_assert(same(OPENEVC_ENTRY_TRAIN_RUNNING_NUMBER, Entry::train_running_number));
static_assert(int(Entry::count) == 5);
// What is entered only has the numbers after them.
static_assert(OPENEVC_ENTRY_SR_SPEED == int(Entry::count) && OPENEVC_ENTRY_SR_DISTANCE == int(Entry::count) + 1 &&
              OPENEVC_ENTRY_VBC == int(Entry::count) + 2 && OPENEVC_ENTRY_NETWORK == int(Entry::count) + 3 &&
              OPENEVC_ENTRY_SET_SPEED == int(Entry::count) + 4 && OPENEVC_ENTRY_LANGUAGE == int(Entry::count) + 5);

static_assert(same(OPENEVC_INTEGRITY_UNKNOWN, TrainIntegrity::unknown));
static_assert(same(OPENEVC_INTEGRITY_OK, TrainIntegrity::confirmed));
static_assert(same(OPENEVC_INTEGRITY_LOST, TrainIntegrity::lost));
static_assert(kTrainIntegrityRows.size() == 3);

static_assert(same(OPENEVC_WINDOW_TRAIN_DATA, kernel::Window::train_data));
static_assert(same(OPENEVC_WINDOW_SR_DATA, kernel::Window::SR_data));
static_assert(int(kernel::Window::count) == 2);

static_assert(same(OPENEVC_MONITORING_NONE, Monitoring::none));
static_assert(same(OPENEVC_CSM, Monitoring::CSM));
static_assert(same(OPENEVC_TSM, Monitoring::TSM));
static_assert(same(OPENEVC_RSM, Monitoring::RSM));
static_assert(kMonitoringRows.size() == 4);

static_assert(same(OPENEVC_STATUS_NONE, Status::none));
static_assert(same(OPENEVC_NORMAL, Status::Normal));
static_assert(same(OPENEVC_INDICATION, Status::Indication));
static_assert(same(OPENEVC_OVERSPEED, Status::Overspeed));
static_assert(same(OPENEVC_WARNING, Status::Warning));
static_assert(same(OPENEVC_INTERVENTION, Status::Intervention));
static_assert(kStatusRows.size() == 6);

static_assert(same(OPENEVC_MEMO_NULL, MemoStatus::Null));
static_assert(same(OPENEVC_MEMO_P, MemoStatus::P));
static_assert(same(OPENEVC_MEMO_W, MemoStatus::W));
static_assert(same(OPENEVC_MEMO_SB, MemoStatus::SB));
static_assert(same(OPENEVC_MEMO_EB, MemoStatus::EB));
static_assert(same(OPENEVC_MEMO_TRIP, MemoStatus::Trip));
static_assert(kMemoStatusRows.size() == 6);

static_assert(same(OPENEVC_SESSION_IDLE, SessionPhase::idle));
static_assert(same(OPENEVC_SESSION_CONNECTING, SessionPhase::connecting));
static_assert(same(OPENEVC_SESSION_WAITING_VERSION, SessionPhase::waiting_version));
static_assert(same(OPENEVC_SESSION_UP, SessionPhase::up));
static_assert(same(OPENEVC_SESSION_LOST, SessionPhase::lost));
static_assert(same(OPENEVC_SESSION_TERMINATING, SessionPhase::terminating));
static_assert(kSessionPhaseRows.size() == 6);

static_assert(same(OPENEVC_SUPERVISING, SessionRole::supervising));
static_assert(same(OPENEVC_ACCEPTING, SessionRole::accepting));
static_assert(same(OPENEVC_HANDING_OVER, SessionRole::handing_over));
static_assert(kSessionRoleRows.size() == 3);

static_assert(same(OPENEVC_NON_STOPPING_AREA, TrackConditionKind::non_stopping_area));
static_assert(same(OPENEVC_TUNNEL_STOPPING_AREA, TrackConditionKind::tunnel_stopping_area));
static_assert(same(OPENEVC_SOUND_HORN, TrackConditionKind::sound_horn));
static_assert(same(OPENEVC_POWERLESS_LOWER_PANTOGRAPH, TrackConditionKind::powerless_lower_pantograph));
static_assert(same(OPENEVC_RADIO_HOLE, TrackConditionKind::radio_hole));
static_assert(same(OPENEVC_AIR_TIGHTNESS, TrackConditionKind::air_tightness));
static_assert(same(OPENEVC_SWITCH_OFF_REGENERATIVE_BRAKE, TrackConditionKind::switch_off_regenerative_brake));
static_assert(same(OPENEVC_SWITCH_OFF_EDDY_CURRENT_SERVICE_BRAKE,
                   TrackConditionKind::switch_off_eddy_current_service_brake));
static_assert(same(OPENEVC_SWITCH_OFF_MAGNETIC_SHOE_BRAKE, TrackConditionKind::switch_off_magnetic_shoe_brake));
static_assert(same(OPENEVC_POWERLESS_MAIN_SWITCH_OFF, TrackConditionKind::powerless_main_switch_off));
static_assert(same(OPENEVC_SWITCH_OFF_EDDY_CURRENT_EMERGENCY_BRAKE,
                   TrackConditionKind::switch_off_eddy_current_emergency_brake));
static_assert(kTrackConditionRows.size() == 11 && terms::value_is_code(kTrackConditionRows));

static_assert(same(OPENEVC_DATA_INVALID, DataStatus::invalid));
static_assert(same(OPENEVC_DATA_VALID, DataStatus::valid));
static_assert(same(OPENEVC_DATA_UNKNOWN, DataStatus::unknown));
static_assert(kDataStatusRows.size() == 3);

static_assert(same(OPENEVC_MRSP_SSP, MrspSource::SSP));
static_assert(same(OPENEVC_MRSP_ASP, MrspSource::ASP));
static_assert(same(OPENEVC_MRSP_TSR, MrspSource::TSR));
static_assert(same(OPENEVC_MRSP_PBD, MrspSource::PBD));
static_assert(same(OPENEVC_MRSP_LX, MrspSource::LX));
static_assert(same(OPENEVC_MRSP_SIGNALLING, MrspSource::signalling));
static_assert(same(OPENEVC_MRSP_TRAIN, MrspSource::train));
static_assert(same(OPENEVC_MRSP_MODE, MrspSource::mode));
static_assert(same(OPENEVC_MRSP_OVERRIDE, MrspSource::override_));
static_assert(int(MrspSource::count) == 9);

static_assert(same(OPENEVC_CONDITION_AHEAD, ConditionPhase::ahead));
static_assert(same(OPENEVC_CONDITION_ANNOUNCED, ConditionPhase::announced));
static_assert(same(OPENEVC_CONDITION_ACTIVE, ConditionPhase::active));
static_assert(same(OPENEVC_CONDITION_ENDING, ConditionPhase::ending));
static_assert(same(OPENEVC_CONDITION_OVER, ConditionPhase::over));
static_assert(kConditionPhaseRows.size() == 5);

static_assert(same(OPENEVC_DIAL_140, port::Dial::to_140));
static_assert(same(OPENEVC_DIAL_180, port::Dial::to_180));
static_assert(same(OPENEVC_DIAL_250, port::Dial::to_250));
static_assert(same(OPENEVC_DIAL_400, port::Dial::to_400));

static_assert(same(OPENEVC_RADIO_NOT_SHOWN, RadioIndication::none));
static_assert(same(OPENEVC_RADIO_FAILED, RadioIndication::failed));
static_assert(same(OPENEVC_RADIO_UP, RadioIndication::up));

static_assert(same(OPENEVC_TEXT_FIXED, port::TextKind::fixed));
static_assert(same(OPENEVC_TEXT_PLAIN, port::TextKind::plain));
static_assert(same(OPENEVC_TEXT_STATUS, port::TextKind::status));
static_assert(same(OPENEVC_TEXT_NATIONAL, port::TextKind::national));

static_assert(same(OPENEVC_WAITING_NOTHING, port::Waiting::nothing));
static_assert(same(OPENEVC_WAITING_END_OF_SESSION, port::Waiting::end_of_session));
static_assert(same(OPENEVC_WAITING_RADIO_REGISTRATION, port::Waiting::radio_registration));
static_assert(same(OPENEVC_WAITING_NETWORK_LIST, port::Waiting::network_list));
static_assert(same(OPENEVC_WAITING_SESSION, port::Waiting::session));
static_assert(same(OPENEVC_WAITING_TRAIN_ACCEPTED, port::Waiting::train_accepted));
static_assert(same(OPENEVC_WAITING_TRAIN_DATA_ACKNOWLEDGED, port::Waiting::train_data_acknowledged));
static_assert(same(OPENEVC_WAITING_ANSWER_TO_MA_REQUEST, port::Waiting::answer_to_ma_request));
static_assert(same(OPENEVC_WAITING_ANSWER_TO_SH_REQUEST, port::Waiting::answer_to_sh_request));
static_assert(same(OPENEVC_WAITING_ANSWER_TO_SM_REQUEST, port::Waiting::answer_to_sm_request));

static_assert(same(OPENEVC_BALISE, language::Form::balise));
static_assert(same(OPENEVC_LOOP, language::Form::loop));
static_assert(same(OPENEVC_RADIO, language::Form::radio));
static_assert(same(OPENEVC_PACKET, language::Form::packet));

/// Without a default, so that the compiler names a form that C does not have.
constexpr bool known_in_c(language::Form form) {
  switch (form) {
    case language::Form::balise:
    case language::Form::loop:
    case language::Form::radio:
    case language::Form::packet:
      return true;
  }
  return false;
}

}  // namespace evc::capi
