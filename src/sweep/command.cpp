#include "sweep/command.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "io/file.h"
#include "run/stop_signals.h"
#include "run/summary.h"
#include "sweep/computers.h"
#include "sweep/plan.h"
#include "sweep/progress.h"
#include "sweep/report.h"
#include "sweep/store.h"

namespace evc::sweep {
namespace {

using io::complain;
using Clock = std::chrono::steady_clock;

/// What is committed is whole after the process was killed: at most this much is lost.
constexpr std::chrono::milliseconds kCommitEvery(500);
/// Results of a fast sweep take less memory if they are not all in one transaction.
constexpr std::size_t kCommitRows = 20000;

io::Result<std::unique_ptr<const Plan>> load(const std::string& file) {
  const auto text = io::read_text(file);
  if (!text) return tl::unexpected(text.error());
  return Plan::make(*text, file);
}

/// The name of the results where none is given.
std::string results_of(const std::string& spec) {
  return spec == "-" ? "sweep.sqlite" : std::filesystem::path(spec).stem().string() + ".sqlite";
}

/// A cell of CSV (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

io::Result<bool> write_csv(const Store& store, io::WholeFile& out) {
  std::string line;
  for (const std::string& name : store.columns()) line += (line.empty() ? "" : ",") + cell(name);
  out.write(line + "\n");
  const auto read = store.each([&](const std::vector<Value>& values) {
    line.clear();
    for (std::size_t i = 0; i < values.size(); ++i) line += (i == 0 ? "" : ",") + cell(cell_text(values[i]));
    out.write(line + "\n");
  });
  if (!read) return read;
  return out.commit();
}

void describe(const Plan& plan) {
  const Spec& spec = plan.spec();
  fmt::print("{} case{}\n", spec.cases, spec.cases == 1 ? "" : "s");
  for (const std::uint64_t number : {std::uint64_t{0}, spec.cases / 2, spec.cases - 1}) {
    std::string line = fmt::format("case {}", number);
    const auto values = plan.values(number);
    for (std::size_t i = 0; i < values.size(); ++i)
      line += fmt::format("{} {} = {}", i == 0 ? ":" : ",", spec.vary[i].at, cell_text(value_of(values[i])));
    fmt::print("{}\n", io::printable(line, 1000));
    if (number == spec.cases - 1) break;
  }
  std::string names;
  for (const std::string& name : plan.measures()) names += (names.empty() ? "" : ", ") + name;
  fmt::print("measures: {}\n", names);
}

/// The caller's side of the computation: rows become rows of the store, committed at least once a second.
class Writer {
 public:
  Writer(Store& store, Store::Counts before, std::uint64_t all)
      : store_(store), counts_(before), progress_(before.done, all) {}

  /// Whether all was written.
  bool take(const std::vector<Row>& rows) {
    if (written_) written_ = store_.add(rows);
    if (!written_) return false;
    pending_ += rows.size();
    counts_.done += rows.size();
    counts_.failed += static_cast<std::uint64_t>(
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.outcome.error.empty(); }));
    progress_.show(counts_.done, counts_.failed);
    return Clock::now() - committed_ < kCommitEvery && pending_ < kCommitRows ? true : commit();
  }
  bool commit() {
    if (written_) written_ = store_.commit();
    committed_ = Clock::now();
    pending_ = 0;
    return written_.has_value();
  }
  const io::Result<bool>& written() const { return written_; }
  Store::Counts counts() const { return counts_; }
  Progress& progress() { return progress_; }

 private:
  Store& store_;
  Store::Counts counts_;
  Progress progress_;
  Clock::time_point committed_ = Clock::now();
  std::size_t pending_ = 0;
  io::Result<bool> written_ = true;
};

/// To the end, or until a signal stops it. `csv` is the table that is written of all rows, nullptr for none.
int compute_into(Store& store, const Plan& plan, Computers& computers, unsigned threads, const std::string& output,
                 io::WholeFile* csv) {
  const auto missing = store.missing();
  if (!missing) return complain(missing.error());
  const auto before = store.counts();
  if (!before) return complain(before.error());
  const std::uint64_t all = plan.spec().cases;
  Todo todo(*missing);
  Writer writer(store, *before, all);
  {
    const run::StopSignals signals;
    // After a signal what is finished is kept at once: who asked for the end may not wait long.
    const auto take = [&](std::vector<Row>&& rows) {
      const bool written = writer.take(rows);
      if (!signals.seen()) return written;
      (void)writer.commit();
      return false;
    };
    if (todo.left() > 0) computers.compute(plan, todo, threads, take);
    (void)writer.commit();
  }
  writer.progress().clear();
  if (!writer.written()) return complain(writer.written().error());
  const auto [done, failed] = writer.counts();
  const double seconds = writer.progress().seconds();
  if (done == all)
    if (const auto finished = store.finish(); !finished) return complain(finished.error());
  if (csv != nullptr && done == all)
    if (const auto written = write_csv(store, *csv); !written) return complain(written.error());
  std::string line = fmt::format("{} of {} cases, {} failed; {} computed in {:.1f} s", done, all, failed,
                                 done - before->done, seconds);
  if (done < all) line += csv != nullptr ? "; stopped" : "; stopped, --resume goes on";
  // CSV may be on standard output.
  fmt::print(csv != nullptr ? stderr : stdout, "{}{}\n", line, csv != nullptr ? "" : " -> " + output);
  return failed > 0 || done < all ? 1 : 0;
}

}  // namespace

int sweep(const Options& options) {
  Threads threads;
  return sweep(options, threads);
}

int sweep(const Options& options, Computers& computers) {
  const auto plan = load(options.spec);
  if (!plan) return complain(plan.error());
  if (options.dry_run) {
    describe(**plan);
    return 0;
  }
  const bool csv = options.format == Format::csv;
  if (csv && options.resume) return complain({options.command, "", "--resume with --format csv", "--format sqlite"});
  const std::string output = !options.output.empty() ? options.output : csv ? "-" : results_of(options.spec);
  if (const auto apart = io::not_the_input(options.spec, output); !apart) return complain(apart.error());
  if (!csv && output == "-") return complain({options.command, "-o", "standard output", "a file: SQLite"});
  if (const auto prepared = computers.prepare(**plan); !prepared) return complain(prepared.error());
  // Where the table cannot be written is said before anything is computed.
  std::optional<io::WholeFile> table;
  if (csv) {
    auto created = io::WholeFile::create(output);
    if (!created) return complain(created.error());
    table.emplace(*std::move(created));
  }
  const auto how = csv ? Store::Open::in_memory : options.resume ? Store::Open::resumed : Store::Open::created;
  const auto store = Store::open(output, how, **plan, EVC_VERSION);
  if (!store) return complain(store.error());
  return compute_into(**store, **plan, computers, options.threads, output, table ? &*table : nullptr);
}

int hash(const std::string& results) {
  const auto store = Store::read(results);
  if (!store) return complain(store.error());
  const auto digits = (*store)->hash();
  if (!digits) return complain(digits.error());
  fmt::print("{}\n", *digits);
  return 0;
}

int again(const CaseOptions& options) {
  const auto store = Store::read(options.results);
  if (!store) return complain(store.error());
  const Header& header = (*store)->header();
  if (options.number >= header.cases)
    return complain({options.results, "", fmt::format("no case {}", options.number),
                     fmt::format("one from 0 to {}", header.cases - 1)});
  const auto plan = Plan::make(header.spec, header.spec_file);
  if (!plan) return complain(plan.error());
  if ((*plan)->identity() != header.identity)
    return complain({options.results, "", "other files than those of the sweep", "those that it was computed from"});
  std::error_code ignored;
  const bool there = std::filesystem::exists(options.output, ignored);
  if (const auto folder = run::prepare_folder(options.output); !folder) return complain(folder.error());
  const auto recorded = (*plan)->record(options.number, options.output);
  if (!recorded) {
    // A folder made for nothing does not stay; one with a file in it does.
    if (!there) std::filesystem::remove(options.output, ignored);
    io::Diagnostic why = recorded.error();
    if (why.file.empty()) {  // of the case, which is in no file
      why.file = options.results;
      why.where = fmt::format("case {} {}", options.number, why.where);
    }
    return complain(why);
  }
  fmt::print("case {} -> {}\n", options.number, options.output);
  return 0;
}

int report(const ReportOptions& options) {
  if (const auto apart = io::not_the_input(options.results, options.output); !apart) return complain(apart.error());
  const auto store = Store::read(options.results);
  if (!store) return complain(store.error());
  const auto page = report_page(**store, options.results);
  if (!page) return complain(page.error());
  const auto written = io::write_whole(options.output, *page);
  return written ? 0 : complain(written.error());
}

}  // namespace evc::sweep
