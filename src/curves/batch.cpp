#include "curves/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <memory>
#include <thread>

#include "batch/limits.h"
#include "curves/batch_queries.h"
#include "curves/parallel.h"
#include "io/file.h"
#include "io/number.h"

namespace evc::curves {
namespace {

/// Queries, and trains of them, that a thread takes at once; each is a task.
constexpr std::size_t kTogether = 64;

/// Where the kernels write the column; none for those that they do not compute.
std::span<double> batch::LimitsOut::*span_of(std::string_view name) {
  using L = batch::LimitsOut;
  static constexpr std::pair<const char*, std::span<double> L::*> kSpans[] = {
      {"EBD", &L::EBD},     {"SBD", &L::SBD},     {"GUI", &L::GUI},     {"EBI", &L::EBI},
      {"SBI1", &L::SBI1},   {"SBI2", &L::SBI2},   {"FLOI", &L::FLOI},   {"W", &L::W},
      {"P", &L::P},         {"I", &L::I},         {"W_EOA", &L::W_EOA}, {"P_EOA", &L::P_EOA},
      {"I_EOA", &L::I_EOA}, {"W_SvL", &L::W_SvL}, {"P_SvL", &L::P_SvL}, {"I_SvL", &L::I_SvL},
  };
  for (const auto& [known, span] : kSpans)
    if (name == known) return span;
  return nullptr;
}

/// One train of a query with all its targets.
struct Task {
  const BatchQuery* query = nullptr;
  std::size_t number = 0;  // of the query, from 1
  std::size_t train = 0;
};

/// The memory of one thread.
class Worker {
 public:
  explicit Worker(const std::vector<Column<SpeedRow>>& columns) : columns_(columns) {
    for (const auto& c : columns_) vectorised_ = vectorised_ && span_of(c.name) != nullptr;
  }

  io::Result<BatchRows> compute(const Task& task) {
    auto input = task.query->input(task.train, 0);
    if (!input) return tl::unexpected(input.error());
    BatchRows rows;
    rows.values.resize(columns_.size());
    if (!vectorised_ || !kernels_suffice(*input)) {
      if (const auto done = one_by_one(task, rows); !done) return tl::unexpected(done.error());
      return rows;
    }
    if (const auto done = by_kernels(task, *input, rows); !done) return tl::unexpected(done.error());
    return rows;
  }

 private:
  /// The drawing conventions of 3.4.0 are those of `speed_row`, as is what `state` assumes of V_ura and of the brake
  /// pressure. With more restrictions than these all targets may not fit (sdm::rebuild), which the kernels do not know.
  static bool kernels_suffice(const io::CurvesInput& input) {
    constexpr std::size_t kStepsThatFit = 8;
    return input.inputs.srs != SrsVersion::v3_4_0 && !input.assumed.V_ura_of_041 && !input.assumed.brake_pressure &&
           input.inputs.mrsp.size() <= kStepsThatFit;
  }

  static void begin_rows(const Task& task, std::size_t target, const std::vector<double>& speeds, BatchRows& rows) {
    for (const double v : speeds) {
      rows.query.push_back(static_cast<std::int64_t>(task.number));
      rows.train.push_back(static_cast<std::int64_t>(task.train) + 1);
      rows.target.push_back(static_cast<std::int64_t>(target) + 1);
      rows.v_kmh.push_back(v);
    }
  }

  io::Result<bool> by_kernels(const Task& task, const io::CurvesInput& input, BatchRows& rows) {
    trains_.clear();
    batch::State state;
    state.V_ura = input.V_ura;
    state.A_est = input.A_est;
    state.motion = input.motion;
    (void)trains_.add(input.inputs, state);
    targets_.clear();
    target_of_.clear();
    speeds_.clear();
    for (std::size_t k = 0; k < task.query->targets(); ++k) {
      targets_.push_back(task.query->target(k));
      if (task.query->targets_depend_on_trains() && task.train > 0 && targets_.back().kind == sdm::TargetKind::MRSP) {
        const auto own = task.query->input(task.train, k);
        if (!own) return tl::unexpected(own.error());
      }
      for (const double v : input.speeds_kmh) {
        speeds_.push_back(v / kKmh);
        target_of_.push_back(static_cast<std::uint32_t>(k));
      }
      begin_rows(task, k, input.speeds_kmh, rows);
    }
    batch::LimitsOut out;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      rows.values[c].resize(speeds_.size());
      out.*span_of(columns_[c].name) = rows.values[c];
    }
    batch::limits(trains_, targets_, {{}, target_of_, speeds_}, out);
    return true;
  }

  io::Result<bool> one_by_one(const Task& task, BatchRows& rows) {
    for (std::size_t k = 0; k < task.query->targets(); ++k) {
      auto input = task.query->input(task.train, k);
      if (!input) return tl::unexpected(input.error());
      begin_rows(task, k, input->speeds_kmh, rows);
      if (!memory_) memory_ = std::make_unique<sdm::Derived>();
      Approached approached(std::move(*input), std::move(memory_));
      for (const double v : approached.input().speeds_kmh) {
        const SpeedRow row = speed_row(approached, v);
        for (std::size_t c = 0; c < columns_.size(); ++c)
          rows.values[c].push_back((row.*columns_[c].value).value_or(std::numeric_limits<double>::quiet_NaN()));
      }
      memory_ = std::move(approached).release();
    }
    return true;
  }

  const std::vector<Column<SpeedRow>>& columns_;
  bool vectorised_ = true;
  batch::Trains trains_;
  std::vector<batch::Target> targets_;
  std::vector<std::uint32_t> target_of_;
  std::vector<double> speeds_;
  std::unique_ptr<sdm::Derived> memory_;
};

/// The rows as CSV: a header, then one line a row; empty where there is no value. The header comes with the first row:
/// of an input that is refused, standard output has nothing.
class Csv {
 public:
  Csv(io::WholeFile& file, const std::vector<Column<SpeedRow>>& columns) : file_(file) {
    text_ = "query,train,target,v_kmh";
    for (const auto& c : columns) text_ += std::string(",") + c.name;
    text_ += '\n';
  }
  void take(const BatchRows& rows) {
    for (std::size_t i = 0; i < rows.v_kmh.size(); ++i) {
      for (const std::int64_t number : {rows.query[i], rows.train[i], rows.target[i]}) {
        io::append_number(text_, number);
        text_ += ',';
      }
      io::append_number(text_, rows.v_kmh[i]);
      for (const auto& column : rows.values) {
        text_ += ',';
        if (column[i] == column[i]) io::append_number(text_, column[i]);
      }
      text_ += '\n';
    }
    if (!rows.v_kmh.empty()) write();
  }
  /// After the last rows: the header where there was none.
  void write() {
    file_.write(text_);
    text_.clear();
  }

 private:
  io::WholeFile& file_;
  std::string text_;  // not yet written
};

/// The rows as a structured array of NumPy (format version 1.0); NaN where there is no value.
class Npy {
 public:
  void take(const BatchRows& rows) {
    static_assert(std::endian::native == std::endian::little);
    const auto append = [this](const auto& value) {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      data_.append(bytes, sizeof value);
    };
    for (std::size_t i = 0; i < rows.v_kmh.size(); ++i) {
      append(rows.query[i]);
      append(rows.train[i]);
      append(rows.target[i]);
      append(rows.v_kmh[i]);
      for (const auto& column : rows.values) append(column[i]);
    }
    rows_ += rows.v_kmh.size();
  }
  void write(io::WholeFile& file, const std::vector<Column<SpeedRow>>& columns) const {
    std::string header = "{'descr': [('query', '<i8'), ('train', '<i8'), ('target', '<i8'), ('v_kmh', '<f8')";
    for (const auto& c : columns) header += fmt::format(", ('{}', '<f8')", c.name);
    header += fmt::format("], 'fortran_order': False, 'shape': ({},), }}", rows_);
    constexpr std::size_t kBefore = 10;  // magic, version, length
    constexpr std::size_t kAligned = 64;
    while ((kBefore + header.size() + 1) % kAligned != 0) header += ' ';
    header += '\n';
    std::string begin("\x93NUMPY\x01\x00", 8);
    begin += static_cast<char>(header.size() & 0xff);
    begin += static_cast<char>(header.size() >> 8);
    file.write(begin + header);
    file.write(data_);
  }

 private:
  std::string data_;
  std::size_t rows_ = 0;
};

std::string known_columns() {
  std::string names;
  for (const auto& c : speed_columns(true)) names += (names.empty() ? "" : ", ") + std::string(c.name);
  return names;
}

}  // namespace

io::Result<std::vector<Column<SpeedRow>>> batch_columns(const std::string& names) {
  std::vector<Column<SpeedRow>> columns;
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t end = std::min(names.find(',', from), names.size());
    const std::string name = names.substr(from, end - from);
    from = end + 1;
    const auto& all = speed_columns(true);
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& c) { return name == c.name; });
    if (known == all.end())
      return tl::unexpected(io::Diagnostic{"--columns", "", "\"" + name + "\"", "some of " + known_columns()});
    for (const auto& c : columns)
      if (name == c.name) return tl::unexpected(io::Diagnostic{"--columns", "", name + " twice", "each column once"});
    columns.push_back(*known);
  }
  return columns;
}

io::Result<bool> compute_batch(std::string_view text, const std::string& file,
                               const std::vector<Column<SpeedRow>>& columns, unsigned threads,
                               const std::function<void(const BatchRows&)>& take) {
  const BatchText all = documents_of(text);
  std::vector<std::unique_ptr<Worker>> workers;
  for (unsigned i = 0; i < threads; ++i) workers.push_back(std::make_unique<Worker>(columns));
  const std::size_t round = kTogether * threads;
  for (std::size_t first = 0; first < all.documents.size(); first += round) {
    const std::size_t count = std::min(round, all.documents.size() - first);
    std::vector<std::optional<io::Result<BatchQuery>>> queries(count);
    in_threads(threads, count, [&](unsigned, std::size_t n) {
      const BatchText::Document& document = all.documents[first + n];
      queries[n] = BatchQuery::read(document.text, file, document.where);
    });
    std::vector<Task> tasks;
    std::optional<io::Diagnostic> wrong;
    for (std::size_t n = 0; n < count && !wrong; ++n) {
      if (!queries[n]->has_value()) {
        wrong = queries[n]->error();
        break;
      }
      for (std::size_t i = 0; i < (**queries[n]).trains(); ++i)
        tasks.push_back({&**queries[n], all.documents[first + n].number, i});
    }
    for (std::size_t done = 0; done < tasks.size(); done += round) {
      const std::size_t now = std::min(round, tasks.size() - done);
      std::vector<std::optional<io::Result<BatchRows>>> rows(now);
      in_threads(threads, now,
                 [&](unsigned worker, std::size_t n) { rows[n] = workers[worker]->compute(tasks[done + n]); });
      for (const auto& one : rows) {
        if (!one->has_value()) return tl::unexpected(one->error());
        take(**one);
      }
    }
    if (wrong) return tl::unexpected(*wrong);
  }
  return true;
}

int limits_of_many(const BatchOptions& o) {
  for (const char* other : {".xlsx", ".svg", ".png", ".pdf", ".html"})
    if (o.output.ends_with(other))
      return io::complain({"evc curves", "-o", io::printable(o.output, 200), "FILE.npy, or a file of CSV"});
  const auto columns = batch_columns(o.columns);
  if (!columns) return io::complain(columns.error());
  if (const auto apart = io::not_the_input(o.input, o.output); !apart) return io::complain(apart.error());
  const auto text = io::read_text(o.input, io::kLargestStream);
  if (!text) return io::complain(text.error());
  const unsigned threads = o.threads != 0 ? o.threads : std::max(1u, std::thread::hardware_concurrency());
  auto file = io::WholeFile::create(o.output);
  if (!file) return io::complain(file.error());
  io::Result<bool> done = true;
  if (o.output.ends_with(".npy")) {
    Npy npy;
    done = compute_batch(*text, o.input, *columns, threads, [&](const BatchRows& rows) { npy.take(rows); });
    if (done) npy.write(*file, *columns);
  } else {
    Csv csv(*file, *columns);
    done = compute_batch(*text, o.input, *columns, threads, [&](const BatchRows& rows) { csv.take(rows); });
    if (done) csv.write();
  }
  if (!done) return io::complain(done.error());
  if (const auto written = file->commit(); !written) return io::complain(written.error());
  return 0;
}

}  // namespace evc::curves
