#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/diagnostic.h"
#include "run/drive.h"
#include "run/journey.h"
#include "run/on_board.h"
#include "sim/line.h"
#include "sim/world.h"

// What a run leaves: its summary, and the files of its folder.
namespace evc::run {

/// In the order of sim::DriverKind.
inline constexpr std::array<const char*, 3> kDriverNames{"perfect", "late", "reckless"};

/// `evc-summary/1`. `outputs`: the text of outputs.jsonl; without it the summary has no `output_hash`.
nlohmann::ordered_json summary_of(const Journey& journey, const sim::World& world, const sim::Line& line,
                                  const OnBoard& on_board, const std::string* outputs);

/// Why a journey did not take place: the train never moved, or found no end in time. Nothing for one that did.
std::optional<io::Diagnostic> fault_of(const std::string& line, const sim::World& world, const Journey& journey);

/// Writes the files of a run into its folder.
io::Result<bool> write_records(const std::string& folder, const Records& records, const nlohmann::ordered_json& summary,
                               const std::string& page);

/// Makes the folder. Before the run, so that a long simulation is not lost because it cannot be written.
io::Result<bool> prepare_folder(const std::string& folder);

}  // namespace evc::run
