#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "io/program_test.h"
#include "sweep/plan.h"
#include "sweep/queue.h"
#include "sweep/store.h"

// Rows, threads and the file of results, in the process and as a user has them.
namespace evc::sweep {
namespace {

using nlohmann::json;

/// Curves: short cases. Some percentages are below the tables: those cases cannot be.
std::string curves_spec(std::uint64_t cases) {
  return R"({"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},"sample":"random","cases":)" +
         std::to_string(cases) +
         R"(,"vary":[{"at":"/train/brake_percentage","uniform":[20,200]},{"at":"/track/gradient/1/1","normal":[-5,8]},
             {"at":"/srs","list":["3.4.0","3.6.0","4.0.0"]},{"at":"/query/speeds_kmh","list":[[80,120],[100]]}],
            "measure":["by_speed.0.EBI","by_speed.P","scalars.T_be_s","notes"]})";
}

/// Journeys of the shipped line.
std::string run_spec() {
  return R"({"schema":"evc-sweep/1","kind":"run","base":{"driver":"reckless"},
    "vary":[{"at":"/train/brake_percentage","list":[5,110,170]},{"at":"/odometer/error","uniform":[-0.04,0.04]},
            {"at":"/national_values/V_NVREL","list":[20,40]}]})";
}

std::unique_ptr<const Plan> plan_of(const std::string& spec) {
  auto plan = Plan::make(spec, evc::test::source_folder() + "/examples/sweep/spec.json");
  EXPECT_TRUE(plan) << plan.error().text();
  return plan ? *std::move(plan) : nullptr;
}

std::string text_of_row(const Row& row) {
  std::string text = std::to_string(row.number);
  for (const Value& value : row.values) text += '|' + cell_text(value);
  text += "|" + row.outcome.error;
  for (const Value& value : row.outcome.measures) text += '|' + std::to_string(value.index()) + cell_text(value);
  return text;
}

/// All rows, computed by so many threads, in the order in which they were finished.
std::vector<Row> rows_of(const Plan& plan, unsigned threads) {
  Todo todo({{0, plan.spec().cases}});
  std::vector<Row> rows;
  compute(plan, todo, threads, [&](std::vector<Row>&& block) {
    for (Row& row : block) rows.push_back(std::move(row));
    return true;
  });
  return rows;
}

std::string table_of(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.number < b.number; });
  std::string table;
  for (const Row& row : rows) table += text_of_row(row) + '\n';
  return table;
}

TEST(Todo, every_number_is_handed_out_once) {
  Todo todo({{3, 7}, {7, 7}, {10, 12}});
  EXPECT_EQ(todo.left(), 6U);
  EXPECT_EQ(todo.take(3), (Range{3, 6}));
  EXPECT_EQ(todo.take(3), (Range{6, 7}));
  EXPECT_EQ(todo.take(100), (Range{10, 12}));
  EXPECT_EQ(todo.take(1), std::nullopt);
}

// A rank of a cluster gets its numbers while its threads compute.
TEST(Todo, numbers_that_come_later_are_waited_for) {
  Todo todo;
  std::vector<Range> taken;
  {
    const std::jthread taking([&] {
      while (const auto range = todo.take(10)) taken.push_back(*range);
    });
    todo.add({0, 15});
    todo.add({20, 20});  // none
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    todo.add({30, 31});
    todo.close();
  }
  EXPECT_EQ(taken, (std::vector<Range>{{0, 10}, {10, 15}, {30, 31}}));
  EXPECT_EQ(todo.left(), 0U);
}

TEST(Compute, threads_that_wait_for_numbers_end_with_the_caller) {
  const auto plan = plan_of(curves_spec(100));
  ASSERT_TRUE(plan);
  Todo todo;  // none ever come
  int calls = 0;
  compute(
      *plan, todo, 3, [&](std::vector<Row>&&) { return ++calls < 3; }, std::chrono::milliseconds(1));
  EXPECT_EQ(calls, 3);
}

TEST(Compute, the_same_table_for_any_number_of_threads) {
  for (const std::string& spec : {curves_spec(2000), run_spec()}) {
    const auto plan = plan_of(spec);
    ASSERT_TRUE(plan);
    const std::string one = table_of(rows_of(*plan, 1));
    EXPECT_EQ(static_cast<std::uint64_t>(std::count(one.begin(), one.end(), '\n')), plan->spec().cases);
    EXPECT_EQ(table_of(rows_of(*plan, 2)), one);
    EXPECT_EQ(table_of(rows_of(*plan, 4)), one);
  }
}

// Memory is used again from case to case, on every way through the cases.
TEST(Compute, a_case_does_not_depend_on_those_before_it) {
  const auto plan = plan_of(curves_spec(400));
  ASSERT_TRUE(plan);
  const auto used = plan->scratch();
  for (std::uint64_t n = plan->spec().cases; n-- > 0;) {
    const auto fresh = plan->scratch();
    EXPECT_EQ(text_of_row(plan->compute(n, *used)), text_of_row(plan->compute(n, *fresh)));
  }
}

TEST(Compute, ends_when_no_rows_are_taken_any_more) {
  const auto plan = plan_of(curves_spec(100000));
  ASSERT_TRUE(plan);
  Todo todo({{0, plan->spec().cases}});
  std::size_t taken = 0;
  compute(*plan, todo, 3, [&](std::vector<Row>&& rows) {
    taken += rows.size();
    return taken < 50;
  });
  EXPECT_GE(taken, 50U);
  EXPECT_GT(todo.left(), 0U);
}

TEST(Case, a_bad_one_has_its_reason) {
  const auto plan = plan_of(run_spec());
  ASSERT_TRUE(plan);
  const auto scratch = plan->scratch();
  const Row bad = plan->compute(0, *scratch);
  EXPECT_EQ(bad.outcome.error.substr(0, 57), "/train/brake_percentage: found 5, expected 30 to 250 % (S");
  EXPECT_EQ(bad.outcome.measures.size(), plan->measures().size());
  const Row good = plan->compute(5, *scratch);
  EXPECT_EQ(good.outcome.error, "");
}

// The journey of a case is that of the command with the same settings, and its records can be replayed.
TEST(Case, is_the_journey_of_its_files) {
  const auto plan = plan_of(run_spec());
  ASSERT_TRUE(plan);
  const Folder folder("sweep_case");
  const Row row = plan->compute(4, *plan->scratch());
  ASSERT_TRUE(plan->record(4, folder.path()));
  const json summary = json::parse(text_of(folder / "summary.json"));
  for (std::size_t i = 0; i < plan->measures().size(); ++i) {
    json::json_pointer pointer;
    std::string name = plan->measures()[i];
    for (std::size_t dot; (dot = name.find('.')) != std::string::npos; name.erase(0, dot + 1))
      pointer /= name.substr(0, dot);
    pointer /= name;
    EXPECT_EQ(cell_text(row.outcome.measures[i]), cell_text(value_of(summary.at(pointer)))) << plan->measures()[i];
  }
  EXPECT_GT(summary["energy_kwh"].get<double>(), 10.0);
  const Ended replay = ended("replay '" + (folder / "inputs.jsonl") + "' -o '" + (folder / "again.jsonl") + "'");
  EXPECT_EQ(replay.exit_code, 0) << replay.errors;
  EXPECT_EQ(text_of(folder / "again.jsonl"), text_of(folder / "outputs.jsonl"));
}

TEST(Case, is_the_query_of_its_file) {
  const auto plan = plan_of(curves_spec(50));
  ASSERT_TRUE(plan);
  const Folder folder("sweep_query");
  const auto scratch = plan->scratch();
  for (std::uint64_t n = 0; n < 50; n += 7) {
    if (!plan->compute(n, *scratch).outcome.error.empty()) continue;
    ASSERT_TRUE(plan->record(n, folder.path()));
    const Ended curves = ended("curves '" + (folder / "query.json") + "'");
    EXPECT_EQ(curves.output, text_of(folder / "result.json"));
    const json result = json::parse(curves.output);
    EXPECT_EQ(cell_text(plan->compute(n, *scratch).outcome.measures[0]),
              cell_text(value_of(result["by_speed"][0]["EBI"])));
  }
}

// A list may name files, as `base` does.
TEST(Case, trains_by_name) {
  const std::string begin = R"({"schema":"evc-sweep/1","kind":"run","measure":["duration_s","energy_kwh"],)";
  const auto named =
      plan_of(begin + R"("vary":[{"at":"/train","list":["push_pull","../../data/trains/freight_P.json"]}]})");
  const auto alone = plan_of(begin + R"("base":{"train":"freight_P"},"vary":[{"at":"/seed","count":1}]})");
  ASSERT_TRUE(named && alone);
  const Row row = named->compute(1, *named->scratch());
  EXPECT_EQ(cell_text(row.values[0]), "../../data/trains/freight_P.json");
  EXPECT_EQ(row.outcome.error, "");
  EXPECT_EQ(row.outcome.measures, alone->compute(0, *alone->scratch()).outcome.measures);
  EXPECT_NE(row.outcome.measures, named->compute(0, *named->scratch()).outcome.measures);
}

// In a query too; a name without a file is an error of the description, and the files are part of what a plan is.
TEST(Case, trains_of_a_query_by_name) {
  const std::string begin = R"({"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},)"
                            R"("measure":["scalars.T_be_s"],)";
  const auto named =
      plan_of(begin + R"("vary":[{"at":"/train","list":["standard","../../data/trains/freight_P.json"]}]})");
  ASSERT_TRUE(named);
  const Row first = named->compute(0, *named->scratch()), second = named->compute(1, *named->scratch());
  EXPECT_EQ(first.outcome.error + second.outcome.error, "");
  EXPECT_NE(first.outcome.measures, second.outcome.measures);
  EXPECT_FALSE(Plan::make(begin + R"("vary":[{"at":"/train","list":["nope"]}]})", "spec.json"));
  const Folder folder("sweep_trains");
  std::string identity;
  for (const char* percentage : {"100", "140"}) {
    ASSERT_TRUE(io::write_whole(folder / "t.json",
                                std::string(R"({"schema":"etcs-train/1","brake_percentage":)") + percentage + "}"));
    const auto plan = Plan::make(begin + R"("vary":[{"at":"/train","list":["t.json"]}]})", folder / "spec.json");
    ASSERT_TRUE(plan);
    EXPECT_NE((*plan)->identity(), identity);
    identity = (*plan)->identity();
    EXPECT_EQ((*plan)->compute(0, *(*plan)->scratch()).outcome.error, "");
  }
}

// The odometer of a case declares what covers its error: the true front end stays in the interval.
TEST(Case, odometer_errors_are_covered_by_what_is_declared) {
  const auto plan = plan_of(
      R"({"schema":"evc-sweep/1","kind":"run","vary":[{"at":"/odometer/error","list":[-0.1,-0.04,0,0.04,0.1]}],
          "measure":["confidence_interval_violations","max_position_error_m","interventions.trip"]})");
  ASSERT_TRUE(plan);
  const auto scratch = plan->scratch();
  for (std::uint64_t n = 0; n < 5; ++n) {
    const Row row = plan->compute(n, *scratch);
    EXPECT_EQ(row.outcome.error, "");
    EXPECT_EQ(cell_text(row.outcome.measures[0]), "0") << n;
    const double error = std::get<double>(row.outcome.measures[1]);
    if (n == 2)
      EXPECT_LT(error, 5.0);
    else
      EXPECT_GT(error, 10.0);
  }
}

TEST(Case, replay_with_another_configuration) {
  const Folder folder("sweep_replay");
  ASSERT_EQ(ended("run -o '" + folder.path() + "'").exit_code, 0);
  const json summary = json::parse(text_of(folder / "summary.json"));
  auto plan = Plan::make(R"({"schema":"evc-sweep/1","kind":"replay","base":{"inputs":"inputs.jsonl"},
      "vary":[{"at":"/config/srs","list":["3.6.0","4.0.0"]},{"at":"/config/train/length_m","list":[0,200]}]})",
                         folder / "spec.json");
  ASSERT_TRUE(plan) << plan.error().text();
  const Row same = (*plan)->compute(1, *(*plan)->scratch());
  const auto& names = (*plan)->measures();
  const auto measure = [&](const Row& row, const char* name) {
    return cell_text(
        row.outcome.measures[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())]);
  };
  EXPECT_EQ(measure(same, "output_hash"), summary["output_hash"]);
  EXPECT_EQ(measure(same, "modes"), summary["modes"].dump());
  EXPECT_EQ(measure(same, "cycles"), summary["cycles"].dump());
  const Row bad = (*plan)->compute(0, *(*plan)->scratch());
  EXPECT_EQ(bad.outcome.error.substr(0, 40), "/config/train/length_m: found 0, expecte");
}

TEST(Store, keeps_what_was_committed_and_knows_what_is_missing) {
  const Folder folder("sweep_store");
  const auto plan = plan_of(curves_spec(100));
  ASSERT_TRUE(plan);
  const std::string file = folder / "r.sqlite";
  const auto rows = rows_of(*plan, 1);
  {
    const auto store = Store::open(file, Store::Open::created, *plan, "1");
    ASSERT_TRUE(store) << store.error().text();
    ASSERT_TRUE((*store)->add({rows.begin() + 10, rows.begin() + 20}));
    ASSERT_TRUE((*store)->commit());
    ASSERT_TRUE((*store)->add({rows.begin() + 30, rows.begin() + 40}));  // never committed
    // Another one finds it locked, and loses nothing.
    const auto second = Store::open(file, Store::Open::resumed, *plan, "1");
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().text(),
              file + ": found a database that another program has open, expected one that no other sweep writes");
    EXPECT_FALSE(Store::read(file));
  }
  EXPECT_FALSE(Store::open(file, Store::Open::created, *plan, "1"));
  EXPECT_FALSE(Store::open(file, Store::Open::resumed, *plan, "2"));
  EXPECT_FALSE(Store::open(file, Store::Open::resumed, *plan_of(curves_spec(101)), "1"));
  const auto store = Store::open(file, Store::Open::resumed, *plan, "1");
  ASSERT_TRUE(store) << store.error().text();
  EXPECT_EQ((*store)->missing(), (std::vector<Range>{{0, 10}, {20, 100}}));
  EXPECT_EQ((*store)->counts()->done, 10U);
}

// What is read back is what was put in, bit for bit.
TEST(Store, values_survive) {
  const auto plan = plan_of(curves_spec(1));
  ASSERT_TRUE(plan);
  Row row;
  row.values = {0.1 + 0.2, std::int64_t{-7}, std::string("a \"quoted\", 'text'\n"), Value()};
  row.outcome.measures = {std::nextafter(1.0, 2.0), std::string(), std::numeric_limits<double>::denorm_min(),
                          std::numeric_limits<std::int64_t>::min()};
  const auto store = Store::open("", Store::Open::in_memory, *plan, "1");
  ASSERT_TRUE(store);
  ASSERT_TRUE((*store)->add({row}));
  std::vector<Value> back;
  ASSERT_TRUE((*store)->each([&](const std::vector<Value>& values) { back = values; }));
  std::vector<Value> expected{std::int64_t{0}};
  expected.insert(expected.end(), row.values.begin(), row.values.end());
  expected.emplace_back(std::string("done"));
  expected.emplace_back();
  expected.insert(expected.end(), row.outcome.measures.begin(), row.outcome.measures.end());
  EXPECT_EQ(back, expected);
  EXPECT_EQ(back.size(), (*store)->columns().size());
}

// What fails does not let the rest of the row, or the next one, be kept without it.
TEST(Store, a_row_that_does_not_fit_is_refused_with_the_reason) {
  const auto plan = plan_of(curves_spec(1));
  ASSERT_TRUE(plan);
  Row row;
  row.values.resize(5);  // of 4 entries
  row.outcome.measures.resize(4);
  const auto store = Store::open("", Store::Open::in_memory, *plan, "1");
  ASSERT_TRUE(store);
  const auto added = (*store)->add({row});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().found, "column index out of range");
}

/// Does this to a file of results.
void change(const std::string& file, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
  sqlite3_close(database);
}

// A file of results may come from anybody.
TEST(Store, a_file_that_was_changed_is_refused) {
  const Folder folder("sweep_changed");
  const auto plan = plan_of(curves_spec(3));
  ASSERT_TRUE(plan);
  const std::string file = folder / "r.sqlite";
  for (const char* sql :
       {"UPDATE sweep SET cases = 0", "UPDATE sweep SET cases = -1", "UPDATE sweep SET cases = 1e12",
        "UPDATE sweep SET spec = 'alert(1)'", "UPDATE sweep SET measures = '[1]'", "UPDATE sweep SET varied = '[]'",
        "DELETE FROM sweep", "UPDATE cases SET number = -1", "UPDATE cases SET number = 3", "DROP TABLE cases",
        "DROP TABLE results", "DROP TABLE sweep"}) {
    std::filesystem::remove(file);
    {
      const auto store = Store::open(file, Store::Open::created, *plan, "1");
      ASSERT_TRUE(store) << store.error().text();
      ASSERT_TRUE((*store)->add({plan->compute(2, *plan->scratch())}) && (*store)->commit());
    }
    change(file, sql);
    const auto store = Store::open(file, Store::Open::resumed, *plan, "1");
    EXPECT_TRUE(!store || !(*store)->missing()) << sql;
    if (!store) {
      EXPECT_NE(store.error().found, "not an error") << sql;
    }
  }
}

class Program : public ::testing::Test {
 protected:
  std::string write(const char* name, const std::string& text) {
    const std::string file = folder_ / name;
    std::ofstream(file) << text;
    return "'" + file + "'";
  }
  std::string file(const char* name) const { return "'" + (folder_ / name) + "'"; }
  std::string hash(const char* name) const { return ended("sweep hash " + file(name)).output; }
  std::uint64_t done(const char* name) const {
    const auto store = Store::read(folder_ / name);
    return store ? (*store)->counts()->done : 0;
  }
  Folder folder_{"sweep_program"};
};

TEST_F(Program, kill_and_resume_give_the_same_table) {
  constexpr std::uint64_t kCases = 20000;
  const std::string spec = write("spec.json", curves_spec(kCases));
  const Ended whole = ended("sweep " + spec + " -j 2 -o " + file("whole.sqlite"));
  EXPECT_EQ(whole.exit_code, 1) << whole.errors;  // some percentages are too low
  for (int i = 0; i < 3; ++i) {
    (void)write("kill.sh", program() + "sweep " + spec + " -j 1 --resume -o " + file("killed.sqlite") +
                               " >/dev/null 2>&1 & pid=$!; sleep 0.12; kill -9 $pid; wait $pid");
    (void)std::system(("bash " + file("kill.sh") + " 2>/dev/null").c_str());
    if (i == 0) {
      EXPECT_LT(done("killed.sqlite"), kCases);
    }
  }
  const Ended rest = ended("sweep " + spec + " -j 4 --resume -o " + file("killed.sqlite"));
  EXPECT_EQ(rest.exit_code, 1) << rest.errors;
  EXPECT_EQ(done("killed.sqlite"), kCases);
  EXPECT_EQ(hash("killed.sqlite"), hash("whole.sqlite"));
  EXPECT_EQ(hash("whole.sqlite").size(), 65U);
  // Nothing is left to do.
  EXPECT_NE(ended("sweep " + spec + " --resume -o " + file("whole.sqlite")).output.find("; 0 computed"),
            std::string::npos);
}

TEST_F(Program, a_signal_stops_it_with_whole_results) {
  const std::string spec = write("spec.json", curves_spec(1000000));
  // Of a shell without job control a background process ignores SIGINT.
  (void)write("stop.sh", "set -m; " + program() + "sweep " + spec + " -j 1 -o " + file("r.sqlite") + " >" +
                             file("said") + " & pid=$!; sleep 0.4; kill -INT $pid; wait $pid");
  const int status = std::system(("bash " + file("stop.sh")).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(text_of(folder_ / "said").find("; stopped, --resume goes on"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.sqlite-journal"));
  EXPECT_LT(done("r.sqlite"), 1000000U);
}

TEST_F(Program, refusals_are_one_sentence_and_lose_nothing) {
  const std::string spec = write("spec.json", curves_spec(50));
  ASSERT_LE(ended("sweep " + spec + " -o " + file("r.sqlite")).exit_code, 1);
  const std::string before = hash("r.sqlite");
  const std::string bytes = text_of(folder_ / "r.sqlite");
  const Ended again = ended("sweep " + spec + " -o " + file("r.sqlite"));
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.errors.find("found a file, expected a new name, or --resume"), std::string::npos);
  for (const char* resume : {"", " --resume"})
    EXPECT_EQ(ended("sweep " + spec + " -o /dev/null" + resume).errors,
              "/dev/null: found a device or pipe, expected a file that can be written\n");
  EXPECT_EQ(ended("sweep hash /dev/null").errors, "/dev/null: found a device or pipe, expected results of evc sweep\n");
  EXPECT_EQ(ended("sweep hash /").errors, "/: found a directory, expected results of evc sweep\n");
  const std::string other = write("other.json", curves_spec(51));
  EXPECT_EQ(ended("sweep " + other + " --resume -o " + file("r.sqlite")).exit_code, 2);
  EXPECT_EQ(hash("r.sqlite"), before);
  EXPECT_EQ(text_of(folder_ / "r.sqlite"), bytes) << "a file that is refused stays as it is";
  (void)write("text.sqlite", "no database, but longer than the header of one: " + std::string(200, 'x'));
  for (const char* command : {"sweep hash ", "sweep report ", "sweep case "}) {
    const std::string rest = std::string(command) == "sweep case " ? " 0 -o /tmp" : "";
    for (const char* name : {"text.sqlite", "absent.sqlite"}) {
      const Ended wrong = ended(command + file(name) + rest);
      EXPECT_EQ(wrong.exit_code, 2);
      EXPECT_EQ(std::count(wrong.errors.begin(), wrong.errors.end(), '\n'), 1) << wrong.errors;
    }
  }
  EXPECT_EQ(ended("sweep case " + file("r.sqlite") + " 50 -o " + file("case")).exit_code, 2);
  EXPECT_EQ(ended("sweep " + write("bad.json", "{}") + " -o " + file("bad.sqlite")).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.sqlite"));
  EXPECT_EQ(ended("sweep").exit_code, 2);
}

// File, place, found, expected; and nothing is left of what could not be made.
TEST_F(Program, what_is_wrong_is_named) {
  const std::string spec = write("spec.json", curves_spec(50));
  const auto errors = [](const Ended& wrong) {
    EXPECT_EQ(wrong.exit_code, 2);
    return wrong.errors;
  };
  EXPECT_EQ(errors(ended("sweep " + spec + " -o " + file("absent/r.sqlite"))),
            folder_ / "absent/r.sqlite" + ": found No such file or directory, expected a file that can be written\n");
  EXPECT_EQ(errors(ended("sweep " + spec + " -o " + file("."))),
            folder_ / "." + ": found a directory, expected a file that can be written\n");
  // SQLite takes a device for a database without tables, and makes its files beside it.
  std::filesystem::create_symlink("/dev/full", folder_ / "full.sqlite");
  for (const char* resume : {"", " --resume"})
    EXPECT_EQ(ended("sweep " + spec + resume + " -o " + file("full.sqlite")).exit_code, 2);
  EXPECT_EQ(errors(ended("sweep " + spec + " --resume -o " + file("full.sqlite"))),
            folder_ / "full.sqlite" + ": found a device or pipe, expected a file that can be written\n");
  EXPECT_FALSE(std::filesystem::exists("/dev/full-journal"));
  EXPECT_EQ(errors(ended("sweep " + spec + " -o -")),
            "evc sweep: -o: found standard output, expected a file: SQLite\n");
  // Before a million cases are computed for a table that cannot be written.
  EXPECT_EQ(
      errors(ended("sweep " + write("many.json", curves_spec(1000000)) + " --format csv -o " + file("absent/r.csv"))),
      folder_ / "absent/r.csv" + ": found No such file or directory, expected a file that can be written\n");
  EXPECT_EQ(errors(ended("sweep case " + file("r.sqlite") + " -1 -o " + file("case"))),
            "evc sweep case: number: found -1, expected a whole number from 0 to 999999999\n");
}

TEST_F(Program, a_case_that_failed_is_named_with_its_results) {
  const std::string spec = write("spec.json", R"({"schema": "evc-sweep/1", "kind": "run", "base": {},
    "vary": [{"at": "/driver", "list": ["hasty"]}], "measure": ["duration_s"]})");
  EXPECT_EQ(ended("sweep " + spec + " --dry-run").output.substr(0, 7), "1 case\n");
  ASSERT_EQ(ended("sweep " + spec + " -o " + file("r.sqlite")).exit_code, 1);
  const Ended wrong = ended("sweep case " + file("r.sqlite") + " 0 -o " + file("case"));
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.errors, (folder_ / "r.sqlite") +
                              ": case 0 /driver: found \"hasty\", expected one of \"perfect\", "
                              "\"late\", \"reckless\"\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "case"));
}

TEST_F(Program, a_full_disk_is_a_sentence_and_resume_goes_on) {
  const std::string spec = write("spec.json", curves_spec(20000));
  ASSERT_EQ(ended("sweep " + spec + " -o " + file("whole.sqlite")).exit_code, 1);
  // No file may grow beyond 400 blocks: writing fails as on a full disk.
  const std::string command = "ulimit -f 400; " + program() + "sweep " + spec + " -o " + file("full.sqlite") +
                              " >/dev/null 2>" + file("errors");
  (void)write("full.sh", command);
  const int status = std::system(("bash " + file("full.sh")).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  std::string errors;
  std::istringstream said(text_of(folder_ / "errors"));
  for (std::string line; std::getline(said, line);)
    if (line.rfind("libgcov", 0) != 0) errors += line + '\n';  // its files cannot grow either
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  EXPECT_NE(errors.find("expected room for the results"), std::string::npos) << errors;
  EXPECT_EQ(ended("sweep " + spec + " --resume -o " + file("full.sqlite")).exit_code, 1);
  EXPECT_EQ(hash("full.sqlite"), hash("whole.sqlite"));
}

// SQLite itself would take it for a database in memory.
TEST_F(Program, any_name_is_that_of_a_file) {
  const std::string spec = write("spec.json", curves_spec(5));
  (void)write("here.sh", "cd '" + folder_.path() + "' && " + program() + "sweep spec.json -o :memory: >/dev/null");
  EXPECT_LE(WEXITSTATUS(std::system(("bash " + file("here.sh")).c_str())), 1);
  EXPECT_EQ(done(":memory:"), 5U);
}

TEST_F(Program, csv_has_the_rows_in_order) {
  const std::string spec = write("spec.json", curves_spec(30));
  const Ended csv = ended("sweep " + spec + " --format csv -j 3");
  EXPECT_EQ(std::count(csv.output.begin(), csv.output.end(), '\n'), 31);
  EXPECT_EQ(csv.output.substr(0, csv.output.find('\n')),
            "number,/train/brake_percentage,/track/gradient/1/1,/srs,/query/speeds_kmh,status,error,by_speed.0.EBI,"
            "by_speed.P,scalars.T_be_s,notes");
  std::size_t at = 0;
  for (int n = 0; n < 30; ++n) {
    at = csv.output.find('\n', at) + 1;
    EXPECT_EQ(std::stoi(csv.output.substr(at)), n);
  }
  EXPECT_EQ(ended("sweep " + spec + " --format csv --resume").exit_code, 2);
}

TEST_F(Program, report_and_dry_run) {
  const std::string spec = write("spec.json", curves_spec(200));
  const Ended dry = ended("sweep " + spec + " --dry-run");
  EXPECT_EQ(dry.exit_code, 0);
  EXPECT_EQ(dry.output.substr(0, 10), "200 cases\n");
  ASSERT_EQ(ended("sweep " + spec + " -o " + file("r.sqlite")).exit_code, 1);
  ASSERT_EQ(ended("sweep report " + file("r.sqlite") + " -o " + file("report.html")).exit_code, 0);
  const std::string page = text_of(folder_ / "report.html");
  EXPECT_EQ(page.find("/*DATA*/null"), std::string::npos);
  EXPECT_NE(page.find("\"/train/brake_percentage: found "), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);  // one file, no network
  const auto store = Store::read(folder_ / "r.sqlite");
  std::string good;
  ASSERT_TRUE((*store)->each([&](const std::vector<Value>& row) {
    if (row[5] == Value(std::string("done"))) good = cell_text(row[0]);
  }));
  ASSERT_EQ(ended("sweep case " + file("r.sqlite") + " " + good + " -o " + file("case")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "case/query.json"));
}

}  // namespace
}  // namespace evc::sweep
