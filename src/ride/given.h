#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "sim/dynamics.h"
#include "sim/line.h"
#include "sim/networks.h"
#include "train/train_data.h"

namespace evc::ride {

/// What a journey is driven with: the line and the train as they were read from their files.
struct Given {
  sim::Line line;
  std::string train_name;
  train::TrainData train;
  sim::Dynamics dynamics;
  std::string train_document;   ///< the train file on one line, for the journal
  sim::Networks networks = {};  ///< they count in a journey by hand
  friend bool operator==(const Given& a, const Given& b);
};

/// The values as bytes, the same on every machine: fields in a fixed order, numbers with the least byte first. The
/// browser's module reads no files and parses no JSON; it gets these bytes.
std::string bytes_of(const Given& given);
/// Nothing for bytes that `bytes_of` of this version did not make.
std::optional<Given> given_of(std::string_view bytes);
/// Where they go in the compiled page: "@given 45564303@". With the version of the bytes in it, a page that was
/// compiled for another one has no such place.
std::string given_place();

}  // namespace evc::ride
