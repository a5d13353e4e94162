#pragma once
#include "openevc/port/config.h"
#include "openevc/port/display.h"
#include "openevc/port/event.h"
#include "openevc/port/inputs.h"
#include "openevc/port/outputs.h"
#include "openevc/port/planning.h"
#include "openevc/port/retained.h"

// The complete interface of the kernel. It has no other inputs or outputs: no clock, no file, no
// thread, no random number.
namespace evc::kernel {

using port::AutomaticOperation;
using port::BaliseTelegram;
using port::Cab;
using port::Config;
using port::DateTime;
using port::DirectionController;
using port::Display;
using port::DriverActions;
using port::Entered;
using port::Event;
using port::ExternalTrainData;
using port::Forwarded;
using port::ForwardedData;
using port::Inputs;
using port::kFirstStatusId;
using port::kLastStatusId;
using port::LoopMessage;
using port::NationalSystem;
using port::NidLrbg;
using port::Odometry;
using port::OrderedArea;
using port::OrderedCurrent;
using port::OrderedPlatform;
using port::OrderedTraction;
using port::OutgoingMessage;
using port::Outputs;
using port::PlannedCondition;
using port::PlannedGradient;
using port::PlannedSpeed;
using port::Planning;
using port::RadioMessage;
using port::RbcAddress;
using port::RbcIdentity;
using port::RbcSession;
using port::Retained;
using port::Select;
using port::ShownCondition;
using port::ShownCover;
using port::ShownData;
using port::ShownDialogue;
using port::ShownSR;
using port::ShownStatus;
using port::ShownText;
using port::ShownTrainData;
using port::TrainSignals;
using port::Window;
using port::with_selection;

}  // namespace evc::kernel
