// `evc curves --batch`: the doubles of `evc curves`, tables of trains and targets, and what is refused.
#include "curves/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "curves/curves_test.h"
#include "curves/parallel.h"

namespace evc::curves {
namespace {

using nlohmann::json;

/// The cells of CSV, line by line.
std::vector<std::vector<std::string>> cells_of_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::size_t from = 0;
    for (;;) {
      const std::size_t end = line.find(',', from);
      rows.back().push_back(line.substr(from, end - from));
      if (end == std::string::npos) break;
      from = end + 1;
    }
  }
  return rows;
}

/// A shipped input that a batch takes: without queries by position, files named as seen from a scratch folder.
json by_speed_only(const std::string& file) {
  json query = load_json(file);
  for (const char* key : {"train", "national_values"})
    if (query.contains(key) && query[key].is_string())
      query[key] = kSource + "/data/curves/" + query[key].get<std::string>();
  for (const char* key : {"positions_m", "PBD", "LX"})
    if (query.contains("query")) query["query"].erase(key);
  query.erase("workbook");
  return query;
}

/// Every shipped input, with each issue of the standard.
std::vector<json> queries() {
  std::vector<json> all;
  for (const std::string& file : shipped())
    for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"}) {
      json query = by_speed_only(file);
      query["srs"] = srs;
      all.push_back(query);
    }
  // What `state` assumes, each alone.
  json feedback = by_speed_only(shipped().front());
  feedback["train"] = {{"schema", "etcs-train/1"}, {"service_brake_feedback", true}};
  feedback["national_values"] = {{"Q_NVSBFBPERM", true}};
  for (const char* srs : {"3.4.0", "3.6.0", "4.0.0"})
    for (const json& state : {json{{"V_ura_kmh", "f41"}}, json{{"V_ura_kmh", 4}}, json{{"A_est", 0.3}},
                              json{{"service_brake_feedback", "locked"}}}) {
      feedback["srs"] = srs;
      feedback["state"] = state;
      all.push_back(feedback);
    }
  return all;
}

const std::string kColumns = "EBD,SBD,GUI,EBI,SBI1,SBI2,FLOI,W,P,I,W_EOA,P_EOA,I_EOA,W_SvL,P_SvL,I_SvL";

TEST(InThreads, an_exception_comes_to_the_caller) {
  const auto job = [](unsigned, std::size_t i) {
    if (i == 17) throw std::runtime_error("17");
  };
  EXPECT_THROW(in_threads(3, 100, job, [](double) {}), std::runtime_error);
  EXPECT_THROW(in_threads(3, 100, job), std::runtime_error);
}

TEST(InThreads, every_job_is_done_once) {
  for (const unsigned threads : {0U, 1U, 3U})
    for (const std::size_t jobs : {0U, 1U, 50U}) {
      std::vector<std::atomic<int>> done(jobs);
      const auto job = [&](unsigned worker, std::size_t i) {
        EXPECT_LT(worker, std::max(1U, threads));
        ++done[i];
      };
      in_threads(threads, jobs, job);
      in_threads(threads, jobs, job, [](double share) { EXPECT_LE(share, 1.0); });
      for (const auto& times : done) EXPECT_EQ(times, 2);
    }
}

TEST(BatchOfCurves, EveryValueIsThatOfOneQuery) {
  std::string lines;
  std::string expected = "query,train,target,v_kmh," + kColumns + "\n";
  const auto columns = *batch_columns(kColumns);
  const std::vector<json> all = queries();
  ASSERT_GT(all.size(), 15u);
  std::size_t values = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    lines += all[i].dump() + "\n";
    const Approached one = approached(all[i]);
    for (const double v : one.input().speeds_kmh) {
      const SpeedRow row = speed_row(one, v);
      expected += std::to_string(i + 1) + ",1,1," + shortest(v, "");
      for (const auto& c : columns) {
        expected += "," + shortest(row.*c.value, "");
        values += (row.*c.value).has_value() ? 1u : 0u;
      }
      expected += "\n";
    }
  }
  EXPECT_GT(values, 3000u);
  const Scratch input("queries.jsonl", lines);
  const Ended ran = run("--batch " + input.path() + " --columns " + kColumns);
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  EXPECT_EQ(ran.output, expected);
  // With a deceleration the queries are computed as by `evc curves`: the same columns again.
  const Ended slowly = run("--batch " + input.path() + " --columns A_safe," + kColumns);
  ASSERT_EQ(slowly.exit_code, 0) << slowly.errors;
  auto rows = cells_of_csv(slowly.output);
  ASSERT_GT(rows.size(), 100u);
  EXPECT_FALSE(rows[1][4].empty());
  for (auto& row : rows) row.erase(row.begin() + 4);
  EXPECT_EQ(rows, cells_of_csv(expected));
}

/// Three trains, one of them changed by a member, and four targets, with a speed each.
json table() {
  json query = by_speed_only(kSource + "/data/curves/passenger_eoa.json");
  query["query"]["speeds_kmh"] = {40, 77.5, 120};
  query["batch"]["train"] = {
      {{"brake_percentage", 100}}, {{"length_m", 120}, {"T_traction_cut_off_s", 0.5}}, query["train"]};
  query["batch"]["target"] = {{{"location_m", 6000}, {"svl_location_m", 6080}},
                              {{"type", "LOA"}, {"location_m", 5000}, {"speed_kmh", 60}},
                              {{"type", "MRSP"}, {"location_m", 4500}, {"speed_kmh", 80}},
                              {{"type", "SR"}, {"location_m", 3000}}};
  return query;
}

TEST(BatchOfCurves, ATableIsEveryTrainWithEveryTarget) {
  const json query = table();
  const Scratch input("table.json", query.dump(2));
  const Ended ran = run("--batch " + input.path() + " --columns EBD,FLOI,I");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  const auto rows = cells_of_csv(ran.output);
  ASSERT_EQ(rows.size(), 1u + 3 * 4 * 3);
  std::size_t n = 1;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k) {
      json one = query;
      one.erase("batch");
      if (i == 0) one["train"]["brake_percentage"] = 100;
      if (i == 1) {
        one["train"]["length_m"] = 120;
        one["train"]["T_traction_cut_off_s"] = 0.5;
      }
      if (k == 0) {
        one["target"]["location_m"] = 6000;
        one["target"]["svl_location_m"] = 6080;
      } else {
        one["target"] = query["batch"]["target"][static_cast<std::size_t>(k)];
      }
      const Approached alone = approached(one);
      for (const double v : {40.0, 77.5, 120.0}) {
        const SpeedRow row = speed_row(alone, v);
        const std::vector<std::string> expected{"1",
                                                std::to_string(i + 1),
                                                std::to_string(k + 1),
                                                shortest(v, ""),
                                                shortest(row.EBD, ""),
                                                shortest(row.FLOI, ""),
                                                shortest(row.I, "")};
        EXPECT_EQ(rows[n++], expected);
      }
    }
}

TEST(BatchOfCurves, TheNumberOfThreadsChangesNothing) {
  std::string lines;
  for (int i = 0; i < 300; ++i) {
    json query = by_speed_only(kSource + "/data/curves/passenger_eoa.json");
    query["train"]["brake_percentage"] = 60 + i % 150;
    if (i % 50 == 0) query = table();
    lines += query.dump() + "\n";
  }
  const Scratch input("many.jsonl", lines);
  const Ended one = run("-j 1 --batch " + input.path());
  const Ended three = run("-j 3 --batch " + input.path());
  ASSERT_EQ(one.exit_code, 0) << one.errors;
  EXPECT_GT(one.output.size(), 100000u);
  EXPECT_EQ(one.output, three.output);
  // From standard input.
  const Ended piped = run("--batch - < " + input.path());
  EXPECT_EQ(one.output, piped.output);
}

TEST(BatchOfCurves, AnArrayForNumPyHasTheSameNumbers) {
  const Scratch input("table_npy.json", table().dump());
  const Scratch array("limits.npy");
  ASSERT_EQ(run("--batch " + input.path() + " --columns SBI1,I -o " + array.path()).exit_code, 0);
  const std::string bytes = text_of(array.path());
  ASSERT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const auto at = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const std::size_t begin = 10 + at(8) + 256 * at(9);
  EXPECT_EQ(begin % 64, 0u);
  const std::string header = bytes.substr(10, begin - 10);
  EXPECT_EQ(header.substr(0, header.find_last_not_of(" \n") + 1),
            "{'descr': [('query', '<i8'), ('train', '<i8'), ('target', '<i8'), ('v_kmh', '<f8'), ('SBI1', '<f8'), "
            "('I', '<f8')], 'fortran_order': False, 'shape': (36,), }");
  ASSERT_EQ(bytes.size(), begin + 36 * 48);
  const auto rows = cells_of_csv(run("--batch " + input.path() + " --columns SBI1,I").output);
  for (std::size_t n = 0; n < 36; ++n) {
    std::int64_t numbers[3];
    double values[3];
    std::memcpy(numbers, bytes.data() + begin + 48 * n, sizeof numbers);
    std::memcpy(values, bytes.data() + begin + 48 * n + 24, sizeof values);
    const auto& row = rows[n + 1];
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(std::to_string(numbers[k]), row[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (row[3 + k].empty()) {
        EXPECT_TRUE(std::isnan(values[k])) << n;
      } else {
        EXPECT_EQ(shortest(values[k], ""), row[3 + k]) << n;
      }
    }
  }
}

/// The error of a batch, without the name of the file; nothing is written.
std::string refused(const std::string& text, const std::string& options = "") {
  const Scratch input("wrong.jsonl", text);
  const Scratch output("wrong.csv");
  const Ended ran = run("--batch " + input.path() + " -o " + output.path() + " " + options);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(output.path()));
  const std::string name = "evc: " + input.path() + ": ";
  const std::string bare = input.path() + ": ";
  std::string error = ran.errors;
  for (const std::string& begin : {name, bare})
    if (error.compare(0, begin.size(), begin) == 0) error.erase(0, begin.size());
  return error;
}

TEST(BatchOfCurves, ErrorsNameTheLineAndTheEntryOfTheTable) {
  const std::string good = by_speed_only(kSource + "/data/curves/passenger_eoa.json").dump() + "\n";
  json wrong = json::parse(good);
  wrong["train"]["length_m"] = -3;
  EXPECT_NE(refused(good + "\n" + wrong.dump() + "\n").find("line 3 /train/length_m: found -3, expected"),
            std::string::npos);
  EXPECT_NE(refused(good + "{\"schema\": \n").find("line 2"), std::string::npos);
  EXPECT_NE(refused("[1, 2]").find("found"), std::string::npos);
  EXPECT_NE(refused("").find("found"), std::string::npos);
  json entry = table();
  entry["batch"]["train"][1]["length_m"] = "long";
  EXPECT_NE(refused(entry.dump(1)).find("/batch/train/1/length_m: found"), std::string::npos) << refused(entry.dump(1));
  entry = table();
  entry["batch"]["target"][2]["speed_kmh"] = 700;
  EXPECT_NE(refused(good + entry.dump()).find("line 2 /batch/target/2/speed_kmh: found 700"), std::string::npos)
      << refused(good + entry.dump());
  entry = table();
  entry["batch"]["target"] = json::array();
  EXPECT_NE(refused(entry.dump()).find("/batch/target: found"), std::string::npos);
  entry["batch"] = {{"trains", 1}};
  EXPECT_NE(refused(entry.dump()).find("trains"), std::string::npos);
  entry["batch"] = {{"target", {5}}};
  EXPECT_NE(refused(entry.dump()).find("/batch/target/0: found 5, expected a target"), std::string::npos);
  entry["batch"] = {{"train", {"no such file"}}};
  EXPECT_NE(refused(entry.dump()).find("/batch/train/0: found"), std::string::npos) << refused(entry.dump());
  // What a batch does not give.
  wrong = json::parse(good);
  wrong["query"]["positions_m"] = {100};
  EXPECT_NE(refused(wrong.dump()).find("/query/positions_m: found"), std::string::npos);
}

TEST(BatchOfCurves, OfAnInputThatIsRefusedStandardOutputHasNothing) {
  json query = by_speed_only(shipped().front());
  query["train"] = 7;
  const Scratch wrong("wrong.jsonl", query.dump());
  const Ended refused = run("--batch " + wrong.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.output, "");
  EXPECT_NE(refused.errors, "");
}

TEST(BatchOfCurves, ARestrictionNotBelowTheSpeedOfOneOfTheTrainsIsRefused) {
  json query = by_speed_only(kSource + "/data/curves/passenger_eoa.json");
  query["track"].erase("mrsp");
  query["batch"]["train"] = {{{"max_speed_kmh", 160}}, {{"max_speed_kmh", 80}}};
  query["batch"]["target"] = {{{"type", "MRSP"}, {"location_m", 4500}, {"speed_kmh", 100}}};
  const std::string error = refused(query.dump());
  EXPECT_NE(error.find("/batch/target/0/speed_kmh: found 100, expected a speed below the MRSP"), std::string::npos)
      << error;
}

TEST(BatchOfCurves, ColumnsAreNamedOnceEach) {
  const std::string good = by_speed_only(kSource + "/data/curves/passenger_eoa.json").dump();
  EXPECT_NE(refused(good, "--columns EBI,EBJ").find("--columns: found \"EBJ\", expected some of A_safe"),
            std::string::npos);
  EXPECT_NE(refused(good, "--columns EBI,EBI").find("--columns: found EBI twice, expected each column once"),
            std::string::npos);
  EXPECT_NE(refused(good, "--columns EBI,").find("--columns: found \"\""), std::string::npos);
  EXPECT_EQ(run("--columns EBI").exit_code, 2);
  const Scratch input("own.jsonl", good);
  EXPECT_EQ(run("--batch " + input.path() + " -o " + input.path()).exit_code, 2);
  EXPECT_EQ(text_of(input.path()), good);
}

}  // namespace
}  // namespace evc::curves
