#pragma once
#include <array>

#include "dmi/state.h"
#include "openevc/port/display.h"

// The sequences of dialogues of 015560 11.7 as data: what the on-board shows, what the driver presses then, and the
// window that follows.
namespace evc::test {

using dmi::WindowId;
using port::Display;
using port::Waiting;

/// What the on-board shows anew. `change` is null where nothing changes.
struct OnBoard {
  const char* what;
  void (*change)(Display&);
};

struct SequenceStep {
  const char* step;     ///< its name in 11.7; several where the driver goes through more than one
  OnBoard onboard;      ///< comes before the presses
  const char* presses;  ///< names of places of touch, with `|` between them
  WindowId window;      ///< open after it
  bool waits;           ///< with the hour glass, its buttons disabled
  bool closes;          ///< the button Close is enabled
  const char* given;    ///< what the on-board gets, but for the selection of the window Main; several with `, ` between
};

struct Sequence {
  const char* clause;
  const char* name;
  SequenceStep steps[14];  ///< up to the first without a name
};

inline constexpr OnBoard kSame{"", nullptr};
inline constexpr OnBoard kNoSession{"waits for the end of the session", [](Display& d) {
                                      d.start_of_mission = true;
                                      d.step = Dialogue::start_S0;
                                      d.waiting = Waiting::end_of_session;
                                    }};
inline constexpr OnBoard kAsksDriverId{"asks for the driver ID", [](Display& d) {
                                         d.start_of_mission = true;
                                         d.step = Dialogue::start_S1;
                                         d.waiting = Waiting::nothing;
                                       }};
inline constexpr OnBoard kAsksLevel{"asks for the level", [](Display& d) {
                                      d.start_of_mission = true;
                                      d.step = Dialogue::start_S2;
                                      d.level_valid = false;
                                    }};
inline constexpr OnBoard kAsksRbc{"asks for the RBC", [](Display& d) {
                                    d.start_of_mission = true;
                                    d.step = Dialogue::start_S3;
                                    d.level = Level::L2;
                                    d.level_valid = true;
                                  }};
inline constexpr OnBoard kAsksOneSystem{"asks whether one radio system is enough",
                                        [](Display& d) { d.start_of_mission = d.data.asks_one_radio_system = true; }};
inline constexpr OnBoard kOpensSession{"waits for the session", [](Display& d) {
                                         d.step = Dialogue::start_D31;
                                         d.waiting = Waiting::session;
                                       }};
inline constexpr OnBoard kAsksToBeAccepted{"waits to be accepted", [](Display& d) {
                                             d.step = Dialogue::start_D33;
                                             d.waiting = Waiting::train_accepted;
                                           }};
inline constexpr OnBoard kReady{"has what it needs", [](Display& d) {
                                  d.step = Dialogue::start_S10;
                                  d.start_of_mission = false;
                                  d.level_valid = true;
                                  d.waiting = Waiting::nothing;
                                }};
inline constexpr OnBoard kListsNetworks{"waits for the list of networks",
                                        [](Display& d) { d.waiting = Waiting::network_list; }};
inline constexpr OnBoard kNoNetworks{"has an empty list", [](Display& d) {
                                       d.data.networks.clear();
                                       d.waiting = Waiting::nothing;
                                     }};
inline constexpr OnBoard kRegisters{"waits for the registration",
                                    [](Display& d) { d.waiting = Waiting::radio_registration; }};
inline constexpr OnBoard kAnswered{"waits no longer", [](Display& d) { d.waiting = Waiting::nothing; }};
inline constexpr OnBoard kWaitsForSession{"waits for the session", [](Display& d) { d.waiting = Waiting::session; }};
inline constexpr OnBoard kNoNumber{"has no valid running number",
                                   [](Display& d) { d.data.stored.train_running_number_status = DataStatus::unknown; }};
inline constexpr OnBoard kLevel2{"is in level 2, in a session", [](Display& d) {
                                   d.level = Level::L2;
                                   d.radio = RadioIndication::up;
                                 }};
inline constexpr OnBoard kUnknownRbc{"has no RBC", [](Display& d) { d.data.stored.rbc_status = DataStatus::unknown; }};
inline constexpr OnBoard kSendsTrainData{"waits until the RBC has acknowledged",
                                         [](Display& d) { d.waiting = Waiting::train_data_acknowledged; }};
inline constexpr OnBoard kAsksForAuthority{"waits for the answer of the RBC",
                                           [](Display& d) { d.waiting = Waiting::answer_to_ma_request; }};
inline constexpr OnBoard kAsksForShunting{"waits for the answer of the RBC",
                                          [](Display& d) { d.waiting = Waiting::answer_to_sh_request; }};
inline constexpr OnBoard kAsksForManoeuvre{"waits for the answer of the RBC",
                                           [](Display& d) { d.waiting = Waiting::answer_to_sm_request; }};
inline constexpr OnBoard kShunts{"is in SH", [](Display& d) {
                                   d.mode = Mode::SH;
                                   d.waiting = Waiting::nothing;
                                 }};
inline constexpr OnBoard kManoeuvres{"is in SM", [](Display& d) {
                                       d.mode = Mode::SM;
                                       d.waiting = Waiting::nothing;
                                     }};
inline constexpr OnBoard kRegistersFirst{"waits for the registration of its network", [](Display& d) {
                                           d.start_of_mission = true;
                                           d.step = Dialogue::start_S4;
                                           d.waiting = Waiting::radio_registration;
                                         }};
inline constexpr OnBoard kGsmrAlone{"uses GSM-R alone",
                                    [](Display& d) { d.data.radio = port::RadioNetworkType::gsmr; }};
inline constexpr OnBoard kNoFrmcs{"has no FRMCS network", [](Display& d) { d.data.frmcs_registered = false; }};
inline constexpr OnBoard kTrips{"is in TR, in level 2", [](Display& d) {
                                  d.mode = Mode::TR;
                                  d.level = Level::L2;
                                  (void)d.acks.push_back({Ack::trip, 0, d.now});
                                }};
inline constexpr OnBoard kPostTrip{"is in PT", [](Display& d) {
                                     d.mode = Mode::PT;
                                     d.acks.clear();
                                   }};
inline constexpr OnBoard kUnfitted{"is in UN, in level 0", [](Display& d) {
                                     d.mode = Mode::UN;
                                     d.level = Level::L0;
                                   }};
inline constexpr OnBoard kAsksAck{"asks for an acknowledgement", [](Display& d) {
                                    (void)d.acks.push_back({Ack::brake, 0, d.now});
                                  }};
inline constexpr OnBoard kNothingEnabled{"enables no button", [](Display& d) { d.buttons = {}; }};

/// All train data: a category, the rest as it is.
inline constexpr const char* kAllTrainData = "key 1|field 1|field 2|field 3|field 4|field 5|field 6|field 7|Yes";

inline constexpr auto kSequences = std::to_array<Sequence>({
    {"11.7.2",
     "start-up, level 1",
     {{"S0", kNoSession, "", WindowId::main, true, false, ""},
      {"S1", kAsksDriverId, "", WindowId::driver_id, false, false, ""},
      {"S1-1", kSame, "SE04", WindowId::settings, false, true, ""},
      {"S1", kSame, "close", WindowId::driver_id, false, false, ""},
      {"S1-2", kSame, "TRN", WindowId::train_running_number, false, true, ""},
      {"S1", kSame, "key 4|key 7|field 1", WindowId::driver_id, false, false, "enters the running number"},
      {"D2", kSame, "key 1|field 1", WindowId::main, true, false, "enters the driver ID"},
      {"S2", kAsksLevel, "", WindowId::level, false, false, ""},
      {"S2", kSame, "key 1|field 1", WindowId::main, true, false, "enters the level"},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, level 2 with a network and an RBC entered",
     {{"S2", kAsksLevel, "key 2|field 1", WindowId::main, true, false, "enters the level"},
      {"S3-1", kAsksRbc, "", WindowId::radio_data, false, false, ""},
      {"S3-4", kSame, "Radio network type", WindowId::radio_type, false, true, ""},
      {"S3-1", kSame, "key 3|field 1", WindowId::radio_data, false, false, "enters the radio network type"},
      {"S3-1", kSame, "GSM-R network ID", WindowId::network_id, false, true, "`radio_network`"},
      {"S3-2-1", kListsNetworks, "", WindowId::radio_data, true, false, ""},
      {"S3-2-2", kAnswered, "", WindowId::network_id, false, true, ""},
      {"S3-2-2", kSame, "key 2|field 1", WindowId::radio_data, true, false, "enters the network"},
      {"S3-2-3", kRegisters, "", WindowId::radio_data, true, false, ""},
      {"S3-1", kAnswered, "Enter RBC data", WindowId::rbc_data, false, true, ""},
      {"S3-3", kSame, "field 1|field 2|Yes", WindowId::main, true, false, "enters the RBC contact"},
      {"A31", kOpensSession, "", WindowId::main, true, false, ""},
      {"D32", kAsksToBeAccepted, "", WindowId::main, true, false, ""},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, level 2 with the last RBC",
     {{"S3-1", kAsksRbc, "", WindowId::radio_data, false, false, ""},
      {"S3-1", kSame, "Contact last RBC", WindowId::main, true, false, "`last_rbc`"},
      {"A31", kOpensSession, "", WindowId::main, true, false, ""},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, level 2 with the short number, no network found before",
     {{"S3-1", kAsksRbc, "GSM-R network ID", WindowId::network_id, false, true, "`radio_network`"},
      {"S3-2-1", kListsNetworks, "", WindowId::radio_data, true, false, ""},
      {"A29, D10", kNoNetworks, "", WindowId::radio_data, false, false, ""},
      {"S3-1", kSame, "Use short number", WindowId::main, true, false, "`short_number`"},
      {"A31", kOpensSession, "", WindowId::main, true, false, ""},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up with one radio system",
     {{"S5", kAsksOneSystem, "", WindowId::one_radio_system, false, false, ""},
      {"S5", kSame, "key 8|field 1", WindowId::main, true, false, "enters one radio system"},
      {"A31", kOpensSession, "", WindowId::main, true, false, ""},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, one radio system refused",
     {{"S5", kAsksOneSystem, "", WindowId::one_radio_system, false, false, ""},
      {"S5", kSame, "key 7|field 1", WindowId::main, true, false, "enters one radio system"},
      {"S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, level 2 with a valid position, once the network is registered",
     {{"D7, S4", kRegistersFirst, "", WindowId::main, true, false, ""},
      {"A31", kOpensSession, "", WindowId::main, true, false, ""},
      {"D31, A32, S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.2",
     "start-up, level 2, the registration failed",
     {{"D7, S4", kRegistersFirst, "", WindowId::main, true, false, ""},
      {"A42, D9, S10", kReady, "", WindowId::main, false, true, ""}}},
    {"11.7.3",
     "driver ID, level and running number from the window Main",
     {{"S1", kSame, "F1", WindowId::main, false, true, ""},
      {"S2", kSame, "Driver ID", WindowId::driver_id, false, true, ""},
      {"S1", kSame, "key 1|field 1", WindowId::main, false, true, "enters the driver ID"},
      {"S4", kSame, "Level", WindowId::level, false, true, ""},
      {"D5, S1", kSame, "key 1|field 1", WindowId::main, false, true, "enters the level"},
      {"S6", kSame, "Train running number", WindowId::train_running_number, false, true, ""},
      {"S1", kSame, "key 4|field 1", WindowId::main, false, true, "enters the running number"},
      {"S1", kSame, "close", WindowId::default_, false, true, ""}}},
    {"11.7.3",
     "train data, validation refused once, then the running number",
     {{"S1", kNoNumber, "F1", WindowId::main, false, true, ""},
      {"S3-1", kSame, "Train data", WindowId::train_data, false, true, "`train_data`"},
      {"S3-2", kSame, kAllTrainData, WindowId::validate_train_data, false, true, ""},
      {"S3-1", kSame, "key 7|field 1", WindowId::train_data, false, true, ""},
      {"S3-2", kSame, "Yes", WindowId::validate_train_data, false, true, ""},
      {"D6, S3-3", kSame, "field 1", WindowId::train_running_number, false, true, "enters train data"},
      {"D1, S1", kSame, "key 4|field 1", WindowId::main, false, true, "enters the running number"}}},
    {"11.7.3",
     "train data, the running number left out",
     {{"S3-1", kNoNumber, "F1|Train data", WindowId::train_data, false, true, "`train_data`"},
      {"S3-2", kSame, kAllTrainData, WindowId::validate_train_data, false, true, ""},
      {"D6, S3-3", kSame, "field 1", WindowId::train_running_number, false, true, "enters train data"},
      {"S1", kSame, "close", WindowId::main, false, true, ""}}},
    {"11.7.3",
     "train data in level 2",
     {{"S1", kLevel2, "F1", WindowId::main, false, true, ""},
      {"S3-1", kSame, "Train data", WindowId::train_data, false, true, "`train_data`"},
      {"S3-2", kSame, kAllTrainData, WindowId::validate_train_data, false, true, ""},
      {"D8", kSame, "field 1", WindowId::main, true, false, "enters train data"},
      {"S9", kSendsTrainData, "", WindowId::main, true, false, ""},
      {"S1", kAnswered, "", WindowId::main, false, true, ""}}},
    {"11.7.3",
     "level 2 with a known RBC",
     {{"S4", kSame, "F1|Level", WindowId::level, false, true, ""},
      {"D5", kSame, "key 2|field 1", WindowId::main, true, false, "enters the level"},
      {"S8", kWaitsForSession, "", WindowId::main, true, false, ""},
      {"D3, D4, S1", kAnswered, "", WindowId::main, false, true, ""}}},
    {"11.7.3",
     "level 2 without an RBC, network and radio data",
     {{"S4", kUnknownRbc, "F1|Level", WindowId::level, false, true, ""},
      {"D5, S5-1", kSame, "key 2|field 1", WindowId::radio_data, false, true, "enters the level"},
      {"S5-1", kSame, "GSM-R network ID", WindowId::network_id, false, true, "`radio_network`"},
      {"S5-2-1", kListsNetworks, "", WindowId::radio_data, true, false, ""},
      {"S5-2-2", kAnswered, "key 1|field 1", WindowId::radio_data, true, false, "enters the network"},
      {"S5-2-3", kRegisters, "", WindowId::radio_data, true, false, ""},
      {"S5-4", kAnswered, "Radio network type", WindowId::radio_type, false, true, ""},
      {"S5-1", kSame, "key 3|field 1", WindowId::radio_data, false, true, "enters the radio network type"},
      {"S5-3", kSame, "Enter RBC data", WindowId::rbc_data, false, true, ""},
      {"S8", kSame, "key 1|field 1|key 2|field 2|Yes", WindowId::main, true, false, "enters the RBC contact"},
      {"S8", kWaitsForSession, "", WindowId::main, true, false, ""},
      {"D3, S1", kAnswered, "", WindowId::main, false, true, ""}}},
    {"11.7.3",
     "level 2 without a registered network",
     {{"S4", kNoFrmcs, "F1|Level", WindowId::level, false, true, ""},
      {"D5, S5-1", kSame, "key 2|field 1", WindowId::radio_data, false, true, "enters the level"}}},
    {"11.7.3",
     "level 2 from level 0, which trips the train",
     {{"S4", kUnfitted, "F1|Level", WindowId::level, false, true, ""},
      {"D5", kSame, "key 2|field 1", WindowId::main, true, false, "enters the level"},
      {"exception", kTrips, "", WindowId::default_, false, true, ""},
      {"S5-1", kPostTrip, "", WindowId::radio_data, false, true, ""}}},
    {"11.7.3",
     "the last RBC, and the short number",
     {{"S5-1", kSame, "F1|Radio data", WindowId::radio_data, false, true, ""},
      {"S8", kSame, "Contact last RBC", WindowId::main, true, false, "`last_rbc`"},
      {"S8", kWaitsForSession, "", WindowId::main, true, false, ""},
      {"D3, S1", kAnswered, "Radio data", WindowId::radio_data, false, true, ""},
      {"S8", kSame, "Use short number", WindowId::main, true, false, "`short_number`"}}},
    {"11.7.3",
     "no network found, with both radio systems and with GSM-R alone",
     {{"S5-1", kSame, "F1|Radio data|GSM-R network ID", WindowId::network_id, false, true, "`radio_network`"},
      {"S5-2-1", kListsNetworks, "", WindowId::radio_data, true, false, ""},
      {"A5, D9, S5-1", kNoNetworks, "", WindowId::radio_data, false, true, ""},
      {"A5, D9, S1", kGsmrAlone, "GSM-R network ID", WindowId::main, false, true, "`radio_network`"}}},
    {"11.7.3",
     "a radio network type without its network",
     {{"S5-1", kNoFrmcs, "F1|Radio data|Radio network type", WindowId::radio_type, false, true, ""},
      {"A6, D9, S5-1", kSame, "key 2|field 1", WindowId::radio_data, false, true, "enters the radio network type"},
      {"S5-4", kSame, "Radio network type", WindowId::radio_type, false, true, ""},
      {"A6, D9, S1", kSame, "key 1|field 1", WindowId::main, false, true, "enters the radio network type"}}},
    {"11.7.3",
     "one radio system",
     {{"S5-1", kSame, "F1|Radio data", WindowId::radio_data, false, true, ""},
      {"A7, S10", kSame, "Mission with one radio system", WindowId::one_radio_system, false, true, ""},
      {"S5-1", kSame, "key 8|field 1", WindowId::radio_data, false, true, "enters one radio system"},
      {"A7, S10", kSame, "Mission with one radio system", WindowId::one_radio_system, false, true, ""},
      {"S1", kSame, "key 7|field 1", WindowId::main, false, true, "enters one radio system"}}},
    {"11.7.3",
     "start, level 1",
     {{"S1", kSame, "F1", WindowId::main, false, true, ""},
      {"S1", kSame, "Start", WindowId::default_, false, true, "`start`"}}},
    {"11.7.3",
     "start, level 2",
     {{"D7", kLevel2, "F1|Start", WindowId::main, true, false, "`start`"},
      {"S7", kAsksForAuthority, "", WindowId::main, true, false, ""},
      {"S7", kAnswered, "", WindowId::default_, false, true, ""}}},
    {"11.7.3",
     "non-leading and maintained shunting",
     {{"S1", kSame, "F1|Non-Leading", WindowId::default_, false, true, "`non_leading`"},
      {"S1", kShunts, "F1|Maintain Shunting", WindowId::default_, false, true, "`maintain_shunting`"}}},
    {"11.7.4",
     "shunting, level 1, and its end",
     {{"S1", kSame, "F1|Shunting", WindowId::default_, false, true, "`shunting`"},
      {"S1", kShunts, "F1|Exit Shunting", WindowId::default_, false, true, "`exit_shunting`"}}},
    {"11.7.4",
     "shunting, level 2, refused and then authorised",
     {{"S1", kLevel2, "F1|Shunting", WindowId::main, true, false, "`shunting`"},
      {"S1", kAsksForShunting, "", WindowId::main, true, false, ""},
      {"refused", kAnswered, "", WindowId::main, false, true, ""},
      {"S1", kSame, "Shunting", WindowId::main, true, false, "`shunting`"},
      {"S1", kAsksForShunting, "", WindowId::main, true, false, ""},
      {"authorised", kShunts, "", WindowId::default_, false, true, ""}}},
    {"11.7.8",
     "supervised manoeuvre, refused and then authorised",
     {{"S1", kLevel2, "F1|Initiate SM", WindowId::main, true, false, "`sm`"},
      {"S1", kAsksForManoeuvre, "", WindowId::main, true, false, ""},
      {"refused", kAnswered, "", WindowId::main, false, true, ""},
      {"S1", kSame, "Initiate SM", WindowId::main, true, false, "`sm`"},
      {"S1", kAsksForManoeuvre, "", WindowId::main, true, false, ""},
      {"authorised", kManoeuvres, "", WindowId::default_, false, true, ""},
      {"S1", kSame, "F1|Exit SM", WindowId::default_, false, true, "`exit_sm`"}}},
    {"11.7.5",
     "override",
     {{"S1", kSame, "F2", WindowId::override_, false, true, ""},
      {"S1", kSame, "close", WindowId::default_, false, true, ""},
      {"S1", kSame, "F2|EOA", WindowId::default_, false, true, "`override`"}}},
    {"11.7",
     "data view",
     {{"1", kSame, "F3", WindowId::data_view, false, true, ""},
      {"2", kSame, "next", WindowId::data_view, false, true, ""},
      {"1", kSame, "previous", WindowId::data_view, false, true, ""},
      {"1", kSame, "close", WindowId::default_, false, true, ""}}},
    {"11.7.6",
     "special",
     {{"S1", kSame, "F4", WindowId::special, false, true, ""},
      {"adhesion", kSame, "Adhesion", WindowId::adhesion, false, true, ""},
      {"S1", kSame, "key 2|field 1", WindowId::special, false, true, "`slippery_rail`"},
      {"SR speed / distance", kSame, "SR speed / distance", WindowId::sr_data, false, true, ""},
      {"S1", kSame, "key 3|key 11|field 1|field 2|Yes", WindowId::special, false, true, "enters SR speed and distance"},
      {"S1", kSame, "Train integrity", WindowId::default_, false, true, "`integrity_confirmed`"},
      {"S1", kSame, "F4|BMM reaction inhibition", WindowId::default_, false, true, "`bmm_inhibit`"}}},
    {"11.7.7",
     "settings",
     {{"S1", kSame, "F5", WindowId::settings, false, true, ""},
      {"language", kSame, "Language", WindowId::language, false, true, ""},
      {"S1", kSame, "key 2|field 1", WindowId::settings, false, true, "enters the language"},
      {"volume", kSame, "Volume", WindowId::volume, false, true, ""},
      {"S1", kSame, "key 2|field 1", WindowId::settings, false, true, ""},
      {"brightness", kSame, "Brightness", WindowId::brightness, false, true, ""},
      {"S1", kSame, "key 4|field 1", WindowId::settings, false, true, ""},
      {"system version", kSame, "System version", WindowId::system_version, false, true, ""},
      {"S1", kSame, "close", WindowId::settings, false, true, ""},
      {"ATO", kSame, "ATO", WindowId::ato, false, true, ""},
      {"S1", kSame, "key 2|field 1", WindowId::settings, false, true, "enters the ATO selector"},
      {"S1", kSame, "close", WindowId::default_, false, true, ""}}},
    {"11.7.7",
     "a virtual balise cover set, its validation refused once",
     {{"entry", kSame, "F5|Set VBC", WindowId::set_vbc, false, true, "`vbc_set`"},
      {"validation", kSame, "key 3|key 2|key 1|key 4|key 5|key 6|field 1|Yes", WindowId::validate_set_vbc, false, true,
       ""},
      {"entry", kSame, "key 7|field 1", WindowId::set_vbc, false, true, ""},
      {"validation", kSame, "Yes", WindowId::validate_set_vbc, false, true, ""},
      {"settings", kSame, "field 1", WindowId::settings, false, true, "`vbc_set`, enters a cover"}}},
    {"11.7.7",
     "a virtual balise cover removed",
     {{"entry", kSame, "F5|Remove VBC", WindowId::remove_vbc, false, true, "`vbc_remove`"},
      {"validation", kSame, "key 5|field 1|Yes", WindowId::validate_remove_vbc, false, true, ""},
      {"settings", kSame, "field 1", WindowId::settings, false, true, "`vbc_remove`, enters a cover"}}},
    {"11.7.1.7",
     "the condition of the button is lost",
     {{"S6", kSame, "F1|Train running number", WindowId::train_running_number, false, true, ""},
      {"S1", kNothingEnabled, "", WindowId::main, false, true, ""}}},
    {"11.7.1.9",
     "an acknowledgement is asked for during entry",
     {{"S3-1", kSame, "F1|Train data|key 1", WindowId::train_data, false, true, "`train_data`"},
      {"S1", kAsksAck, "", WindowId::main, false, true, ""}}},
});

}  // namespace evc::test
