#pragma once
#include <array>
#include <string>

#include "io/json.h"
#include "sim/dynamics.h"
#include "terms/srs_version.h"
#include "train/national_values.h"
#include "train/train_data.h"

namespace evc::lang {
struct Packet3;
}

namespace evc::io {

/// The names of train categories in a train file. Those of axle loads and loading gauges: terms/axle_load.h.
inline constexpr std::array<const char*, 3> kOtherCategoryNames{"FreightP", "FreightG", "Passenger"};

/// A train as described in a file: the train data of the on-board, and the data of the simulated
/// world only.
struct Train {
  std::string name = "passenger, 135 %";
  train::TrainData data;
  sim::Dynamics dynamics;
  std::string document = R"({"schema":"etcs-train/1"})";  // the JSON of the file on one line, for `config`
};

/// Reads `etcs-train/1`; absent keys have the values of the standard train, unknown keys are errors.
Result<Train> read_train(std::string_view text, const std::string& file);

/// The same from a place in a larger document (`train` of a curves input, `config`); throws ReadError. The key
/// `schema` may be absent there. A fault of `train::check` is an error that names the key and the clause.
Train read_train(const JsonPlace& place);
/// Train data entered by the driver: the same, but the on-board rejects data that cannot be supervised
/// (`train::check`).
Train read_entered_train(const JsonPlace& place);

/// National values by their SRS names, speeds in km/h, distances in m; those left out keep the
/// defaults of A.3.2. "infinity" is allowed where the standard has it. A fault of `train::check` is an error that names
/// the key and the clause. Throws ReadError.
train::NationalValues read_national_values(const JsonPlace& place);
/// The values as `read_national_values` reads them.
nlohmann::ordered_json national_values_json(const train::NationalValues& values);
/// The values as packet 3, in force at once and valid in the area of one NID_C; without the correction factors Kv_int,
/// Kr_int, Kt_int. Rounded to the steps of the variables.
lang::Packet3 packet_3(const train::NationalValues& values, std::uint16_t NID_C);

/// "3.4.0", "3.6.0" or "4.0.0"; throws ReadError.
SrsVersion read_srs_version(const JsonPlace& place);

}  // namespace evc::io
