#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/diagnostic.h"
#include "sweep/plan.h"
#include "sweep/queue.h"

namespace evc::sweep {

/// What the table `sweep` of a file of results says.
struct Header {
  std::string spec;       ///< the text of the spec, one line
  std::string spec_file;  ///< absolute name of its file
  std::string identity;   ///< of the plan
  std::string kind;       ///< run, curves or replay
  std::uint64_t cases = 0;
  std::string version;   ///< of the program
  std::string started;   ///< UTC
  std::string finished;  ///< UTC; empty while cases are missing
};

/// Results in SQLite: the tables `sweep`, `cases` and `results`. One process at a time writes a file; what was
/// committed stays, whatever happens to the process.
class Store {
 public:
  enum class Open : std::uint8_t {
    created,   ///< a new file; one that exists is refused
    resumed,   ///< of the same plan, made if it does not exist
    in_memory  ///< no file
  };
  /// For the rows of a plan.
  static io::Result<std::unique_ptr<Store>> open(const std::string& file, Open how, const Plan& plan,
                                                 const std::string& version);
  /// An existing file, to be read.
  static io::Result<std::unique_ptr<Store>> read(const std::string& file);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  const Header& header() const;
  /// The numbers that have no row yet.
  io::Result<std::vector<Range>> missing() const;
  struct Counts {
    std::uint64_t done = 0, failed = 0;
  };
  io::Result<Counts> counts() const;

  /// Adds rows to the transaction that is open.
  io::Result<bool> add(const std::vector<Row>& rows);
  /// What was added is kept from now on.
  io::Result<bool> commit();
  /// All rows are there: leaves one file, without a journal beside it.
  io::Result<bool> finish();

  /// The columns: number, the places that vary, status, error, the measures.
  std::vector<std::string> columns() const;
  std::size_t varied() const;
  /// Every row in the order of the numbers: one value for each column. Every `stride`th.
  io::Result<bool> each(const std::function<void(const std::vector<Value>&)>& take, std::uint64_t stride = 1) const;
  /// SHA-256 of all rows: of the columns and values, not of times.
  io::Result<std::string> hash() const;

 private:
  struct Database;
  explicit Store(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

/// A value as text: the shortest number that reads back to the same double; "" for none.
std::string cell_text(const Value& value);

}  // namespace evc::sweep
