#pragma once
#include "base/set.h"
#include "terms/level.h"
#include "terms/medium.h"
#include "terms/mode.h"
#include "terms/requests.h"
#include "terms/srs_version.h"
#include "terms/stored.h"

// The terms under the name of this room.
namespace evc::modes {

using evc::Ack;
using evc::Entry;
using evc::Inform;
using evc::kLevels;
using evc::kModes;
using evc::kStored;
using evc::Level;
using evc::Medium;
using evc::Mode;
using evc::name;
using evc::Offer;
using evc::Set;
using evc::Stored;
using Edition = evc::SrsVersion;

}  // namespace evc::modes
