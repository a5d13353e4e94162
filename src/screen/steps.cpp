#include <array>

#include "screen/scene.h"

namespace evc::screen {
namespace {

using port::Waiting;
using enum Dialogue;
constexpr auto kNothing = Waiting::nothing;

// What the on-board shows at a step, and its window; that of a step of the start-up dialogue opens by itself where
// none is named. The steps without a window (D2, A29 and others) are passed at once.
constexpr auto kSteps = std::to_array<Step>({
    // 11.7.2 Start-up
    {"start-up S0", start_S0, Waiting::end_of_session, nullptr},
    {"start-up S1", start_S1, kNothing, nullptr},
    {"start-up S1-1", start_S1, kNothing, "Settings"},
    {"start-up S1-2", start_S1, kNothing, "Train running number"},
    {"start-up S2", start_S2, kNothing, nullptr},
    {"start-up S3-1", start_S3, kNothing, nullptr},
    {"start-up S3-2-1", start_S3, Waiting::network_list, nullptr},
    {"start-up S3-2-2", start_S3, kNothing, "GSM-R network ID"},
    {"start-up S3-2-3", start_S3, Waiting::radio_registration, nullptr},
    {"start-up S3-3", start_S3, kNothing, "RBC data"},
    {"start-up S3-4", start_S3, kNothing, "Radio network type"},
    {"start-up S4", start_S4, Waiting::radio_registration, nullptr},
    {"start-up S5", start_S4, kNothing, nullptr, true},
    {"start-up A31", start_D31, Waiting::session, nullptr},
    {"start-up S10", start_S10, kNothing, nullptr},
    // 11.7.3 Main window
    {"main S1", std::nullopt, kNothing, "Main"},
    {"main S2", std::nullopt, kNothing, "Driver ID"},
    {"main S3-1", std::nullopt, kNothing, "Train data"},
    {"main S3-2", std::nullopt, kNothing, "Validate train data"},
    {"main S3-3", std::nullopt, kNothing, "Train running number"},
    {"main S4", std::nullopt, kNothing, "Level"},
    {"main S5-1", std::nullopt, kNothing, "Radio data"},
    {"main S5-2-1", std::nullopt, Waiting::network_list, "Radio data"},
    {"main S5-2-2", std::nullopt, kNothing, "GSM-R network ID"},
    {"main S5-2-3", std::nullopt, Waiting::radio_registration, "Radio data"},
    {"main S5-3", std::nullopt, kNothing, "RBC data"},
    {"main S5-4", std::nullopt, kNothing, "Radio network type"},
    {"main S6", std::nullopt, kNothing, "Train running number"},
    {"main S7", std::nullopt, Waiting::answer_to_ma_request, "Main"},
    {"main S8", std::nullopt, Waiting::session, "Main"},
    {"main S9", std::nullopt, Waiting::train_data_acknowledged, "Main"},
    {"main S10", std::nullopt, kNothing, "Mission with one radio system"},
    // 11.7.4 to 11.7.8
    {"shunting S1", std::nullopt, Waiting::answer_to_sh_request, "Main"},
    {"override S1", std::nullopt, kNothing, "Override"},
    {"special S1", std::nullopt, kNothing, "Special"},
    {"special S2", std::nullopt, kNothing, "Adhesion"},
    {"special S3", std::nullopt, kNothing, "SR speed / distance"},
    {"settings S1", std::nullopt, kNothing, "Settings"},
    {"settings S2", std::nullopt, kNothing, "Language"},
    {"settings S3", std::nullopt, kNothing, "Volume"},
    {"settings S4", std::nullopt, kNothing, "Brightness"},
    {"settings S5", std::nullopt, kNothing, "System version"},
    {"settings S6-1", std::nullopt, kNothing, "Set VBC"},
    {"settings S6-2", std::nullopt, kNothing, "Validate set VBC"},
    {"settings S7-1", std::nullopt, kNothing, "Remove VBC"},
    {"settings S7-2", std::nullopt, kNothing, "Validate remove VBC"},
    {"settings S8", std::nullopt, kNothing, "ATO selector"},
    {"supervised manoeuvre S1", std::nullopt, Waiting::answer_to_sm_request, "Main"},
});

}  // namespace

const Step& step_named(const io::JsonPlace& place) {
  for (const Step& step : kSteps)
    if (place.string() == step.name) return step;
  place.fail("a step with a window, as \"start-up S3-1\", \"main S8\" or \"settings S6-2\" (015560 11.7)");
}

}  // namespace evc::screen
