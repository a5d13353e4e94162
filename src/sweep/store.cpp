#include "sweep/store.h"

#include <fmt/core.h>
#include <openssl/evp.h>
#include <sqlite3.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/file.h"
#include "io/number.h"

namespace evc::sweep {
namespace {

/// "SWEE", the application_id of a file of results.
constexpr int kApplication = 0x53574545;

constexpr const char* kKinds[] = {"run", "curves", "replay"};

std::string now() {
  const std::time_t t = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  (void)::gmtime_r(&t, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

/// A name as SQL: in double quotes.
std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

/// A prepared statement.
class Statement {
 public:
  Statement(sqlite3* database, const std::string& sql) {
    code_ = sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()), &statement_, nullptr);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(int at, std::int64_t value) { note(sqlite3_bind_int64(statement_, at, value)); }
  void bind(int at, const std::string& text) {
    note(sqlite3_bind_text64(statement_, at, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
  }
  /// The value must live until the statement is run.
  void bind(int at, const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      bind(at, *whole);
    else if (const auto* number = std::get_if<double>(&value))
      note(sqlite3_bind_double(statement_, at, *number));
    else if (const auto* text = std::get_if<std::string>(&value))
      bind(at, *text);
    else
      note(sqlite3_bind_null(statement_, at));
  }
  /// A row is there.
  bool step() {
    if (code_ != SQLITE_OK) return false;
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) code_ = code;
    return code == SQLITE_ROW;
  }
  /// Runs one that gives no rows, and makes it ready for the next values. Whether nothing failed since it was made.
  bool run() {
    (void)step();
    if (ok()) (void)sqlite3_reset(statement_);  // of one that failed the database keeps the error
    return ok();
  }
  std::int64_t whole(int column) const { return sqlite3_column_int64(statement_, column); }
  std::string text(int column) const {
    const auto* bytes = sqlite3_column_text(statement_, column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
    return bytes == nullptr ? "" : std::string(reinterpret_cast<const char*>(bytes), size);
  }
  Value value(int column) const {
    switch (sqlite3_column_type(statement_, column)) {
      case SQLITE_INTEGER:
        return whole(column);
      case SQLITE_FLOAT:
        return sqlite3_column_double(statement_, column);
      case SQLITE_NULL:
        return {};
      default:
        return text(column);
    }
  }
  int columns() const { return sqlite3_column_count(statement_); }
  bool ok() const { return code_ == SQLITE_OK; }

 private:
  void note(int code) {
    if (code != SQLITE_OK && code_ == SQLITE_OK) code_ = code;
  }
  sqlite3_stmt* statement_ = nullptr;
  int code_ = SQLITE_OK;
};

namespace {

/// SHA-256 piece by piece.
class Hash {
 public:
  Hash() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    (void)EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
  }
  void add(const std::string& text) { (void)EVP_DigestUpdate(context_.get(), text.data(), text.size()); }
  std::string digits() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    (void)EVP_DigestFinal_ex(context_.get(), digest, &size);
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

struct Store::Database {
  sqlite3* handle = nullptr;
  std::string file;  ///< empty: in memory
  Header header;
  std::vector<std::string> varied, measures;
  std::unique_ptr<Statement> insert_case, insert_result;
  bool in_transaction = false;

  ~Database() {
    insert_case.reset();
    insert_result.reset();
    sqlite3_close(handle);
  }

  /// The error of the last call, and what it needs.
  io::Diagnostic error() const {
    const int code = sqlite3_errcode(handle);
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
      return {file, "", "a database that another program has open", "one that no other sweep writes"};
    if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
      return {file, "", sqlite3_errmsg(handle), "results of evc sweep (SQLite)"};
    if (code == SQLITE_FULL || (code & 0xFF) == SQLITE_IOERR)
      return {file, "", sqlite3_errmsg(handle), "room for the results; what was committed is whole, --resume goes on"};
    return {file, "", sqlite3_errmsg(handle), "a database that can be read and written"};
  }

  io::Result<bool> run(const std::string& sql) {
    if (sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return tl::unexpected(error());
    return true;
  }

  io::Result<bool> open(int flags) {
    // For SQLite ":memory:" is no file, and "file:" may begin a URI.
    const std::string name = file.empty() ? ":memory:" : file.front() == '/' ? file : "./" + file;
    if (sqlite3_open_v2(name.c_str(), &handle, flags, nullptr) != SQLITE_OK) return tl::unexpected(error());
    (void)sqlite3_extended_result_codes(handle, 0);
    return true;
  }

  std::string create_cases() const {
    std::string sql = "CREATE TABLE cases (number INTEGER PRIMARY KEY";
    for (const std::string& name : varied) sql += ", " + quoted(name);
    return sql + ", status TEXT NOT NULL, error TEXT)";
  }
  std::string create_results() const {
    std::string sql = "CREATE TABLE results (number INTEGER PRIMARY KEY";
    for (const std::string& name : measures) sql += ", " + quoted(name);
    return sql + ")";
  }
  static std::vector<std::string> places_of(const Plan& plan) {
    std::vector<std::string> places;
    for (const Entry& entry : plan.spec().vary) places.push_back(entry.at);
    return places;
  }
  static std::string insertion(const char* table, std::size_t columns) {
    std::string sql = std::string("INSERT INTO ") + table + " VALUES (?";
    for (std::size_t i = 1; i < columns; ++i) sql += ",?";
    return sql + ")";
  }

  /// The table `sweep` in a file that may be of something else.
  io::Result<bool> read_header() {
    Statement id(handle, "PRAGMA application_id");
    if (!id.step()) return tl::unexpected(error());
    if (id.whole(0) != kApplication)
      return tl::unexpected(io::Diagnostic{file, "", "a database of something else", "results of evc sweep"});
    Statement row(
        handle,
        "SELECT spec, spec_file, identity, kind, cases, version, started, finished, varied, measures FROM sweep");
    if (!row.step()) return tl::unexpected(row.ok() ? broken() : error());
    const std::int64_t cases = row.whole(4);
    // The page of a report has the spec unchanged.
    if (cases < 1 || cases > static_cast<std::int64_t>(kMostCases) || !io::Json::accept(row.text(0)))
      return tl::unexpected(broken());
    header = {row.text(0), row.text(1), row.text(2), row.text(3), static_cast<std::uint64_t>(cases),
              row.text(5), row.text(6), row.text(7)};
    const auto names = [](const std::string& list) {
      return io::Json::parse(list, nullptr, false).get<std::vector<std::string>>();
    };
    try {
      varied = names(row.text(8));
      measures = names(row.text(9));
    } catch (const io::Json::exception&) {
      return tl::unexpected(broken());
    }
    return true;
  }
  io::Diagnostic broken() const { return {file, "", "a table sweep that is not whole", "results of evc sweep"}; }

  io::Result<bool> create(const Plan& plan, const std::string& version) {
    const Spec& spec = plan.spec();
    std::error_code ignored;
    const std::string place = spec.file == "-" ? "-" : std::filesystem::absolute(spec.file, ignored).string();
    header = {spec.text,  place,   plan.identity(), kKinds[static_cast<std::size_t>(spec.kind)],
              spec.cases, version, now(),           ""};
    varied = places_of(plan);
    measures = plan.measures();
    if (const auto begun = run("BEGIN EXCLUSIVE"); !begun) return begun;
    if (const auto made = run(fmt::format("PRAGMA application_id = {}", kApplication)); !made) return made;
    for (const std::string& sql :
         {std::string("CREATE TABLE sweep (spec TEXT, spec_file TEXT, identity TEXT, kind TEXT, cases INTEGER, version "
                      "TEXT, sqlite TEXT, started TEXT, finished TEXT, varied TEXT, measures TEXT)"),
          create_cases(), create_results()})
      if (const auto made = run(sql); !made) return made;
    Statement row(handle, "INSERT INTO sweep VALUES (?,?,?,?,?,?,?,?,NULL,?,?)");
    const std::string sqlite = sqlite3_libversion();
    const std::string varied_list = io::Json(varied).dump();
    const std::string measure_list = io::Json(measures).dump();
    row.bind(1, header.spec);
    row.bind(2, header.spec_file);
    row.bind(3, header.identity);
    row.bind(4, header.kind);
    row.bind(5, static_cast<std::int64_t>(header.cases));
    row.bind(6, header.version);
    row.bind(7, sqlite);
    row.bind(8, header.started);
    row.bind(9, varied_list);
    row.bind(10, measure_list);
    if (!row.run()) return tl::unexpected(error());
    return run("COMMIT");
  }

  /// Whether the results are of this plan.
  io::Result<bool> belongs_to(const Plan& plan, const std::string& version) const {
    if (header.identity != plan.identity())
      return tl::unexpected(io::Diagnostic{file, "", "results of another description, or of other files",
                                           "those of " + plan.spec().file + ", or a file that does not exist"});
    if (header.cases != plan.spec().cases || varied != places_of(plan) || measures != plan.measures())
      return tl::unexpected(broken());
    if (header.version != version)
      return tl::unexpected(io::Diagnostic{file, "", "results of version " + header.version, "of version " + version});
    return true;
  }

  io::Result<bool> prepare() {
    // The database has the error of the last call alone.
    insert_case = std::make_unique<Statement>(handle, insertion("cases", varied.size() + 3));
    if (!insert_case->ok()) return tl::unexpected(error());
    insert_result = std::make_unique<Statement>(handle, insertion("results", measures.size() + 1));
    if (!insert_result->ok()) return tl::unexpected(error());
    return true;
  }
};

Store::Store(std::unique_ptr<Database> database) : database_(std::move(database)) {}
Store::~Store() = default;

io::Result<std::unique_ptr<Store>> Store::open(const std::string& file, Open how, const Plan& plan,
                                               const std::string& version) {
  auto d = std::make_unique<Database>();
  std::error_code error;
  const bool there = how != Open::in_memory && std::filesystem::exists(file, error);
  if (there && std::filesystem::is_directory(file, error))
    return tl::unexpected(io::Diagnostic{file, "", "a directory", "a file that can be written"});
  // SQLite would take a device for an empty database, and leave files beside it.
  if (there && !std::filesystem::is_regular_file(file, error))
    return tl::unexpected(io::Diagnostic{file, "", "a device or pipe", "a file that can be written"});
  if (there && how == Open::created)
    return tl::unexpected(io::Diagnostic{file, "", "a file", "a new name, or --resume to go on with it"});
  // Why a file cannot be made: SQLite tries again without writing, and then knows that there is none.
  if (how != Open::in_memory && !there)
    if (const auto can_be = io::WholeFile::create(file); !can_be) return tl::unexpected(can_be.error());
  if (how != Open::in_memory) d->file = file;
  if (const auto opened = d->open(SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE); !opened)
    return tl::unexpected(opened.error());
  // The lock is kept from the first transaction to the end: a second sweep finds it.
  if (const auto set = d->run("PRAGMA locking_mode = EXCLUSIVE"); !set) return tl::unexpected(set.error());
  // A process that was killed at the very begin has left a file without tables.
  std::int64_t tables = 0;
  {
    Statement count(d->handle, "SELECT count(*) FROM sqlite_master");
    if (!count.step()) return tl::unexpected(d->error());
    tables = count.whole(0);
  }
  if (tables > 0) {
    if (const auto read = d->read_header(); !read) return tl::unexpected(read.error());
    // A file that is refused stays as it is.
    if (const auto same = d->belongs_to(plan, version); !same) return tl::unexpected(same.error());
  }
  // With the write-ahead log a commit is one append; a process that is killed loses what was not committed, and
  // nothing else.
  for (const char* sql : {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = NORMAL"})
    if (const auto set = d->run(sql); !set) return tl::unexpected(set.error());
  if (tables > 0) {
    if (const auto mine = d->run("BEGIN EXCLUSIVE; COMMIT"); !mine) return tl::unexpected(mine.error());
  } else if (const auto created = d->create(plan, version); !created) {
    return tl::unexpected(created.error());
  }
  if (const auto prepared = d->prepare(); !prepared) return tl::unexpected(prepared.error());
  return std::unique_ptr<Store>(new Store(std::move(d)));
}

io::Result<std::unique_ptr<Store>> Store::read(const std::string& file) {
  auto d = std::make_unique<Database>();
  d->file = file;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    const bool there = std::filesystem::exists(file, error);
    const bool folder = std::filesystem::is_directory(file, error);
    return tl::unexpected(io::Diagnostic{file, "",
                                         folder  ? "a directory"
                                         : there ? "a device or pipe"
                                                 : "no file",
                                         "results of evc sweep"});
  }
  // Of a sweep that was killed the log beside the file must be read in: that is writing.
  if (const auto opened = d->open(SQLITE_OPEN_READWRITE); !opened) return tl::unexpected(opened.error());
  if (const auto header = d->read_header(); !header) return tl::unexpected(header.error());
  return std::unique_ptr<Store>(new Store(std::move(d)));
}

const Header& Store::header() const { return database_->header; }
std::size_t Store::varied() const { return database_->varied.size(); }

io::Result<std::vector<Range>> Store::missing() const {
  std::vector<Range> missing;
  std::uint64_t next = 0;
  Statement rows(database_->handle, "SELECT number FROM cases ORDER BY number");
  while (rows.step()) {
    const auto number = static_cast<std::uint64_t>(rows.whole(0));
    if (number >= database_->header.cases)
      return tl::unexpected(io::Diagnostic{database_->file, "", fmt::format("a case {}", rows.whole(0)),
                                           fmt::format("cases from 0 to {}", database_->header.cases - 1)});
    if (number > next) missing.push_back({next, number});
    next = number + 1;
  }
  if (!rows.ok()) return tl::unexpected(database_->error());
  if (next < database_->header.cases) missing.push_back({next, database_->header.cases});
  return missing;
}

io::Result<Store::Counts> Store::counts() const {
  Statement row(database_->handle, "SELECT count(*), count(*) FILTER (WHERE status <> 'done') FROM cases");
  if (!row.step()) return tl::unexpected(database_->error());
  return Counts{static_cast<std::uint64_t>(row.whole(0)), static_cast<std::uint64_t>(row.whole(1))};
}

io::Result<bool> Store::add(const std::vector<Row>& rows) {
  Database& d = *database_;
  if (rows.empty()) return true;
  if (!d.in_transaction) {
    if (const auto begun = d.run("BEGIN"); !begun) return begun;
    d.in_transaction = true;
  }
  static const std::string kDone = "done", kFailed = "failed";
  for (const Row& row : rows) {
    const auto number = static_cast<std::int64_t>(row.number);
    int at = 1;
    d.insert_case->bind(at, number);
    for (const Value& value : row.values) d.insert_case->bind(++at, value);
    const bool failed = !row.outcome.error.empty();
    d.insert_case->bind(++at, failed ? kFailed : kDone);
    const Value reason = failed ? Value(row.outcome.error) : Value();
    d.insert_case->bind(++at, reason);
    // A failure may have ended the transaction: nothing may be added after it.
    if (!d.insert_case->run()) return tl::unexpected(d.error());
    at = 1;
    d.insert_result->bind(at, number);
    for (const Value& value : row.outcome.measures) d.insert_result->bind(++at, value);
    if (!d.insert_result->run()) return tl::unexpected(d.error());
  }
  return true;
}

io::Result<bool> Store::commit() {
  if (!database_->in_transaction) return true;
  if (const auto done = database_->run("COMMIT"); !done) return done;
  database_->in_transaction = false;
  return true;
}

io::Result<bool> Store::finish() {
  database_->header.finished = now();
  if (const auto noted = database_->run("UPDATE sweep SET finished = '" + database_->header.finished + "'"); !noted)
    return noted;
  return database_->run("PRAGMA journal_mode = DELETE");
}

std::vector<std::string> Store::columns() const {
  std::vector<std::string> columns{"number"};
  columns.insert(columns.end(), database_->varied.begin(), database_->varied.end());
  columns.emplace_back("status");
  columns.emplace_back("error");
  columns.insert(columns.end(), database_->measures.begin(), database_->measures.end());
  return columns;
}

io::Result<bool> Store::each(const std::function<void(const std::vector<Value>&)>& take, std::uint64_t stride) const {
  Statement rows(
      database_->handle,
      fmt::format("SELECT c.*, r.* FROM cases c JOIN results r ON c.number = r.number WHERE c.number % {} = 0 "
                  "ORDER BY c.number",
                  stride));
  const auto behind = static_cast<int>(database_->varied.size()) + 3;  // the number of the second table
  std::vector<Value> values;
  while (rows.step()) {
    values.clear();
    for (int i = 0; i < rows.columns(); ++i)
      if (i != behind) values.push_back(rows.value(i));
    take(values);
  }
  if (!rows.ok()) return tl::unexpected(database_->error());
  return true;
}

io::Result<std::string> Store::hash() const {
  Hash hash;
  const auto add_row = [&](const auto& cells, auto text) {
    std::string line;
    for (const auto& cell : cells) line += text(cell) + '\x1f';
    hash.add(line + '\n');
  };
  add_row(columns(), [](const std::string& name) { return name; });
  const auto read = each([&](const std::vector<Value>& values) {
    // A text and a number that look the same differ.
    add_row(values, [](const Value& v) { return std::to_string(v.index()) + cell_text(v); });
  });
  if (!read) return tl::unexpected(read.error());
  return hash.digits();
}

std::string cell_text(const Value& value) {
  std::string text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) io::append_number(text, *whole);
  if (const auto* number = std::get_if<double>(&value)) io::append_number(text, *number);
  if (const auto* given = std::get_if<std::string>(&value)) text = *given;
  return text;
}

}  // namespace evc::sweep
