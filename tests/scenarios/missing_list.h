#pragma once
#include <map>
#include <string>
#include <vector>

// Lists of what no scenario shows, files beside the scenarios: rows `NAME,NAME KEY: why`.
namespace evc::scenario {

/// What is not shown, and why.
using MissingList = std::map<std::string, std::string>;

/// The rows of a file: `NAME KEY` for each of the names of a row.
MissingList missing_list(const std::string& file);
/// Of what no scenario shows that of which the list has no row.
std::vector<std::string> without_row(const MissingList& list, const std::vector<std::string>& not_shown);
/// Rows of something else, or without a reason.
std::vector<std::string> wrong_rows(const MissingList& list, const std::vector<std::string>& not_shown);

/// The items of a list with commas.
std::vector<std::string> items_of(const std::string& list);

}  // namespace evc::scenario
