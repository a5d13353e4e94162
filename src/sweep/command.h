#pragma once
#include <cstdint>
#include <string>

// `evc sweep` and its subcommands. Each returns the exit status: 0; 1 where a case failed or the sweep was stopped; 2
// for wrong input or a file that cannot be written, with one line on standard error.
namespace evc::sweep {

class Computers;

enum class Format : std::uint8_t { sqlite, csv };

struct Options {
  std::string spec;      ///< evc-sweep/1; "-": standard input
  std::string output;    ///< empty: the name of the spec with .sqlite here, or standard output for CSV
  unsigned threads = 0;  ///< 0: as many as there are processors
  bool resume = false;   ///< goes on with the results that are there
  bool dry_run = false;  ///< checks the spec and says what would be computed
  Format format = Format::sqlite;
  std::string command = "evc sweep";  ///< its name in messages
};
/// Computes the cases that are missing: by threads of this process, or by others.
int sweep(const Options& options);
int sweep(const Options& options, Computers& computers);

/// Prints the hash of the rows: the same for the same spec, whoever computed them in whatever order.
int hash(const std::string& results);

struct CaseOptions {
  std::string results;
  std::uint64_t number = 0;
  std::string output;  ///< folder
};
/// Computes a case again and leaves its files.
int again(const CaseOptions& options);

struct ReportOptions {
  std::string results;
  std::string output = "report.html";
};
/// The page of a sweep.
int report(const ReportOptions& options);

}  // namespace evc::sweep
