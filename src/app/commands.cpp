#include "app/commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cab/command.h"
#include "check/command.h"
#include "curves/batch.h"
#include "curves/command.h"
#include "deceleration/command.h"
#include "explain/command.h"
#include "explain/modes.h"
#include "io/date_time.h"
#include "io/file.h"
#include "io/make_line.h"
#include "language/decode.h"
#include "language/describe.h"
#include "language/encode.h"
#include "matrix/command.h"
#include "run/replay.h"
#include "run/run.h"
#include "screen/command.h"
#include "serve/command.h"
#include "sweep/command.h"

// The command line with the texts of `evc COMMAND --help`. The commands themselves are in their rooms.
namespace evc::app {
namespace {

std::optional<std::uint64_t> seed_of(const std::string& digits) {
  std::uint64_t seed = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, seed);
  return error == std::errc{} && stop == end ? std::optional(seed) : std::nullopt;
}

/// A number in a range. CLI::Range takes "nan" for one.
CLI::Validator number_between(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range, least, most](std::string& given) {
        double number = 0.0;
        if (range(given).empty() && CLI::detail::lexical_cast(given, number) && number >= least && number <= most)
          return std::string();
        return fmt::format("found {}, expected a number from {} to {}", given, least, most);
      },
      "");
}

/// A whole number in a range.
CLI::Validator whole_number_between(std::int64_t least, std::int64_t most) {
  return CLI::Validator(
      [least, most](std::string& given) {
        std::int64_t number = 0;
        const auto [stop, error] = std::from_chars(given.data(), given.data() + given.size(), number);
        const bool whole = error == std::errc{} && stop == given.data() + given.size();
        if (whole && number >= least && number <= most) return std::string();
        return fmt::format("found {}, expected a whole number from {} to {}", given, least, most);
      },
      "");
}

/// An empty argument is what a shell makes of an unset variable: it is not taken for an absent one.
void refuse_empty_arguments(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_items_expected_max() > 0; }))
    option->check([](const std::string& given) {
      return given.empty() ? std::string("found an empty argument, expected a value") : std::string();
    });
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_arguments(*command);
}

std::vector<std::string> editions() {
  std::vector<std::string> names;
  names.reserve(kSrsVersionRows.size());
  for (const auto& row : kSrsVersionRows) names.emplace_back(row.name);
  return names;
}

void add_run(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<run::RunOptions>();
  auto seed = std::make_shared<std::string>("1");
  auto srs = std::make_shared<std::string>(name(options->srs));
  auto utc = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("run", "Drive a simulated train along a line, supervised by the on-board");
  command->add_option("line", options->line,
                      "line file (etcs-line/1), - for standard input; default: the shipped line");
  command->add_option("--train", options->train, "train file (etcs-train/1); default: the standard train");
  command->add_option("--driver", options->driver, "perfect, late or reckless")
      ->check(CLI::IsMember({"perfect", "late", "reckless"}));
  command->add_option("--odometer", options->odometer, "random, or as wrong as it declares possible: over or under")
      ->check(CLI::IsMember({"random", "over", "under"}));
  command->add_option("--last-ma", options->last_ma, "withhold movement authorities with a higher seq")
      ->check(whole_number_between(0, 1000000));
  command->add_option("--seed", *seed, "seed of odometer errors and delays")->check([](const std::string& given) {
    return seed_of(given) ? std::string()
                          : "found " + given + ", expected a whole number from 0 to 18446744073709551615";
  });
  command->add_option("--srs", *srs, "edition of the on-board and its display; default: 3.6.0")
      ->check(CLI::IsMember(editions()));
  command->add_option("--utc", *utc, "the on-board's clock at the begin, as 2026-01-01T08:00:00Z; default: no clock")
      ->check([](const std::string& given) {
        return io::read_utc(given) ? std::string() : "found " + given + ", expected a time as 2026-01-01T08:00:00Z";
      });
  command->add_flag("--real-time", options->real_time, "cycles by the clock, to the end of the run, SIGINT or SIGTERM");
  command->add_option("--cycle", options->cycle_ms, "length of a cycle in ms; default: 100")
      ->check(whole_number_between(1, 1000));
  command->add_option("-o,--output", options->output, "folder for the report and the records");
  command->callback([options, seed, srs, utc, &exit_code] {
    options->seed = *seed_of(*seed);
    for (const auto& row : kSrsVersionRows)
      if (*srs == row.name) options->srs = row.value;
    options->utc = io::read_utc(*utc);
    exit_code = run::run(*options);
  });
}

void add_replay(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<run::ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "Run the on-board on a stream of inputs and print its outputs");
  CLI::Option* input = command->add_option("input", options->input, "JSON Lines of inputs; - for standard input");
  command->add_option("--config", options->config, "configuration, instead of the stream's first line");
  command->add_option(
      "--persistent", options->persistent,
      "file of what the unit keeps without power: read if it exists, written at power off and at the end");
  command->add_option("-o,--output", options->output, "file for the outputs; default: standard output");
  command->add_option("--every", options->every, "print only every Nth cycle")
      ->check(whole_number_between(1, 1000000000));
  command->add_flag("--changes", options->changes,
                    "print a cycle only when something other than position and speed changed");
  command->add_flag("--planning", options->planning, "print the advance display: gradient, speeds, orders ahead");
  command->add_flag("--dmi", options->dmi, "print the record of the display: what the driver is shown and asked");
  // What has no meaning for a comparison.
  const std::vector<CLI::Option*> of_replay =
      command->get_options([](const CLI::Option* option) { return option->get_name() != "--help"; });
  auto compared = std::make_shared<std::vector<std::string>>();
  CLI::Option* diff =
      command->add_option("--diff", *compared, "compare two streams of outputs: the first line that differs, by fields")
          ->expected(2);
  for (CLI::Option* other : of_replay) diff->excludes(other);
  command->callback([options, compared, input, &exit_code] {
    if (compared->empty() && input->count() == 0) throw CLI::RequiredError("input");
    exit_code = compared->empty() ? run::replay(*options) : run::diff((*compared)[0], (*compared)[1]);
  });
}

void add_serve(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<serve::Options>();
  CLI::App* command =
      app.add_subcommand("serve", "Units behind a port of this machine: lines as of evc replay over TCP or WebSocket");
  command->add_option("--port", options->port, "port of the loopback interface, 0 for a free one; default: 8026")
      ->check(whole_number_between(0, 65535));
  CLI::Option* real_time = command->add_flag("--real-time", options->real_time, "cycles by the clock");
  command
      ->add_option("--cycle", options->cycle_ms,
                   "length of a cycle in ms, with --real-time; default: that of the configuration")
      ->check(whole_number_between(1, 1000))
      ->needs(real_time);
  command->add_flag("--planning", options->planning, "with the advance display (3.15.10) in each line");
  command->add_flag("--dmi", options->dmi, "with the record of the display (ERA_ERTMS_015560) in each line");
  command->callback([options, &exit_code] { exit_code = serve::serve(*options); });
}

void add_cab(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<cab::Options>();
  CLI::App* command = app.add_subcommand("cab", "A driver's cab as one page for the browser: display, desk, line");
  command->add_option("line", options->line,
                      "line file (etcs-line/1), - for standard input; default: the shipped line");
  command->add_option("--train", options->train, "train file (etcs-train/1); default: the standard train");
  command->add_option("-o,--output", options->output, "the page")->capture_default_str();
  command->callback([options, &exit_code] { exit_code = cab::cab(*options); });
}

/// `--set`, once for every member of a query that is replaced.
void add_set(CLI::App& command, std::vector<std::string>& replaced) {
  command
      .add_option("--set", replaced,
                  "a member of the query, by its keys or a JSON pointer: train.brake_percentage=120; may be repeated")
      ->type_name("PLACE=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_picture(CLI::App& command, std::string& plot, std::string& theme) {
  command.add_option("--plot", plot, "a chart: FILE.svg, FILE.png or FILE.pdf, or FILE.html, interactive");
  command.add_option("--theme", theme, "of a picture: screen, or print: light, with names at the curves")
      ->check(CLI::IsMember({"screen", "print"}))
      ->capture_default_str();
}

void add_curves(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<curves::Options>();
  CLI::App* command = app.add_subcommand("curves", "Braking curves and supervision limits for a train and a target");
  command->add_option("input", options->input, "query (evc-curves/1); default: a shipped example");
  command->add_option("--format", options->format, "json, csv or table")
      ->check(CLI::IsMember({"json", "csv", "table"}))
      ->capture_default_str();
  command->add_option("--model", options->model, "srs, or workbook: an early spreadsheet model of the curves")
      ->check(CLI::IsMember({"srs", "workbook"}))
      ->capture_default_str();
  command->add_option("--explain", options->explain_kmh, "the computation for this speed (km/h), step by step")
      ->check(number_between(0.0, 600.0));
  add_set(*command, options->replaced);
  add_picture(*command, options->plot, options->theme);
  command->add_option("-o,--output", options->output,
                      "file to write to instead of standard output; FILE.xlsx is a workbook");
  auto many = std::make_shared<curves::BatchOptions>();
  CLI::Option* batch = command->add_option(
      "--batch", many->input, "limits of many: a query a line, or a query with a table; - for standard input");
  command->add_option("-j,--threads", many->threads, "of --batch: number of threads; default: one for each processor")
      ->check(whole_number_between(1, 1024))
      ->needs(batch);
  command->add_option("--columns", many->columns, "of --batch: columns by speed, separated by commas")
      ->needs(batch)
      ->capture_default_str();
  for (const char* other : {"input", "--format", "--model", "--explain", "--set", "--plot", "--theme"})
    batch->excludes(command->get_option(other));
  command->callback([command, options, many, batch, &exit_code] {
    if (!command->get_subcommands().empty()) return;
    if (batch->count() == 0) {
      exit_code = curves::show(*options);
      return;
    }
    many->output = options->output;
    exit_code = curves::limits_of_many(*many);
  });

  auto two = std::make_shared<curves::CompareOptions>();
  CLI::App* comparison =
      command->add_subcommand("compare", "Difference between two trains, sets of national values or SRS versions");
  comparison->add_option("a", two->a, "input A (evc-curves/1)")->required();
  comparison->add_option("b", two->b, "input B")->required();
  comparison->add_option("--format", two->format, "json, csv or table")
      ->check(CLI::IsMember({"json", "csv", "table"}))
      ->capture_default_str();
  comparison->add_option("more", two->more, "further inputs, each compared with A");
  add_set(*comparison, two->replaced);
  add_picture(*comparison, two->plot, two->theme);
  comparison->add_option("-o,--output", two->output,
                         "file to write to instead of standard output; FILE.xlsx is a workbook");
  comparison->callback([two, &exit_code] { exit_code = curves::compare(*two); });
}

void add_decode(CLI::App& app, int& exit_code) {
  CLI::App* decode = app.add_subcommand("decode", "Decode bits of balises and radio to JSON or a table");
  decode->require_subcommand(1);
  using language::What;
  struct Kind {
    const char* name;
    const char* help;
    What what;
  };
  for (const Kind& kind :
       {Kind{"balise", "User bits of a balise telegram: 830, 210, or fewer up to packet 255", What::balise},
        Kind{"airgap", "Coded bits of a balise: 1023 or 341 at any rotation, or a stream", What::airgap},
        Kind{"radio", "A radio message", What::radio}, Kind{"packet", "One packet", What::packet}}) {
    CLI::App* sub = decode->add_subcommand(kind.name, kind.help);
    const auto o = std::make_shared<language::DecodeOptions>();
    o->what = kind.what;
    sub->add_option("INPUT", o->input, "Hexadecimal digits, a file with one telegram a line, or - for standard input")
        ->required();
    sub->add_option("-o,--output", o->output, "File to write; standard output if absent");
    sub->add_flag("--explain", o->explain, "A readable table: bit, variable, raw code, meaning");
    CLI::Option* strict = sub->add_flag("--strict", o->strict, "Reject spare codes (the default except for packets)");
    sub->add_flag("--tolerant", o->tolerant, "Accept spare codes, wrong media and packets that occur twice")
        ->excludes(strict);
    if (kind.what != What::packet)
      sub->add_option("--pcapng", o->pcapng,
                      "Also write what was accepted as a capture for Wireshark (etcs-wireshark)");
    if (kind.what == What::balise) sub->add_flag("--loop", o->loop, "The bits are a Euroloop message");
    if (kind.what == What::radio || kind.what == What::packet) {
      CLI::Option* to_train = sub->add_flag("--to-train", o->to_train, "From track to train");
      CLI::Option* to_track = sub->add_flag("--to-track", o->to_track, "From train to track");
      to_track->excludes(to_train);
      sub->add_option("--sv", o->sv, "System version of the session")->capture_default_str();
    }
    const bool needs_direction = kind.what == What::radio || kind.what == What::packet;
    sub->callback([o, needs_direction, &exit_code] {
      if (needs_direction && !o->to_train && !o->to_track)
        throw CLI::ValidationError("found no direction, expected --to-train or --to-track");
      exit_code = language::decode(*o);
    });
  }
}

void add_encode(CLI::App& app, int& exit_code) {
  CLI::App* encode = app.add_subcommand("encode", "Encode the JSON of `evc decode` to bits");
  encode->require_subcommand(1);
  using language::What;
  struct Kind {
    const char* name;
    const char* help;
    What what;
  };
  for (const Kind& kind : {Kind{"balise", "User bits of a balise telegram", What::balise},
                           Kind{"airgap", "Coded bits of a balise: 1023 or 341", What::airgap},
                           Kind{"radio", "A radio message", What::radio}, Kind{"packet", "One packet", What::packet}}) {
    CLI::App* sub = encode->add_subcommand(kind.name, kind.help);
    const auto o = std::make_shared<language::EncodeOptions>();
    o->what = kind.what;
    sub->add_option("INPUT", o->input, "A JSON object, a file of JSON objects, or - for standard input")->required();
    sub->add_option("-o,--output", o->output, "File to write; standard output if absent");
    if (kind.what == What::balise) sub->add_flag("--loop", o->loop, "A Euroloop message");
    if (kind.what == What::radio || kind.what == What::packet) {
      CLI::Option* to_train = sub->add_flag("--to-train", o->to_train, "From track to train");
      sub->add_flag("--to-track", o->to_track, "From train to track")->excludes(to_train);
      sub->add_option("--sv", o->sv, "System version; the newest that fits the members if absent");
    }
    sub->callback([o, &exit_code] { exit_code = language::encode(*o); });
  }
}

void add_describe(CLI::App& app, int& exit_code) {
  CLI::App* describe =
      app.add_subcommand("describe", "The tables of the ETCS language (SUBSET-026-7, -8) and of the modes");
  describe->require_subcommand(1);
  const auto options = std::make_shared<language::DescribeOptions>();
  CLI::App* packets = describe->add_subcommand("packets", "All packets, or the layouts of one with bit offsets");
  CLI::App* variables = describe->add_subcommand("variables", "All variables, or the codes of one");
  CLI::App* messages = describe->add_subcommand("messages", "All radio messages, or one with its packets");
  packets->add_option("ID", options->id, "NID_PACKET");
  variables->add_option("ID", options->id, "Name, V_STATIC");
  messages->add_option("ID", options->id, "NID_MESSAGE");
  for (CLI::App* sub : {packets, variables, messages}) sub->add_flag("--markdown", options->markdown, "As a page");
  CLI::Option* to_train = packets->add_flag("--to-train", options->to_train, "Only the packet from track to train");
  packets->add_flag("--to-track", options->to_track, "Only the packet from train to track")->excludes(to_train);
  packets->add_flag("--index", options->index, "The index of the pages in docs/packets");
  CLI::App* schema = describe->add_subcommand("schema", "The JSON schema of telegrams, messages and packets");
  schema->callback([&exit_code] { exit_code = language::describe_schema(); });
  CLI::App* modes = describe->add_subcommand("modes", "The table of mode transitions (SUBSET-026-4 4.6.2)");
  const auto table = std::make_shared<explain::ModesOptions>();
  modes->add_option("--srs", table->srs, "edition: 3.4.0 and 3.6.0 have the same table, 4.0.0 another one")
      ->check(CLI::IsMember(editions()))
      ->capture_default_str();
  modes->add_flag("--svg", table->svg, "A graph instead of the matrix");
  modes->add_option("-o,--output", table->output, "File to write; standard output if absent");
  modes->callback([table, &exit_code] { exit_code = explain::describe_modes(*table); });
  packets->callback([options, &exit_code] { exit_code = language::describe_packets(*options); });
  variables->callback([options, &exit_code] { exit_code = language::describe_variables(*options); });
  messages->callback([options, &exit_code] { exit_code = language::describe_messages(*options); });
}

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<check::Options>();
  CLI::App* command =
      app.add_subcommand("check", "Review the trackside data of a line: findings with place and clause");
  command->add_option("line", options->line,
                      "line file (etcs-line/1), - for standard input; default: the shipped line");
  command->add_option("--train", options->train,
                      "train file (etcs-train/1): also restrictions that reach this train too late to brake");
  command->add_option("--format", options->format, "table or json")
      ->check(CLI::IsMember({"table", "json"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "file to write to instead of standard output");
  command->callback([options, &exit_code] { exit_code = check::check(*options); });
}

void add_track(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<matrix::Options>();
  CLI::App* command = app.add_subcommand(
      "track", "What the on-board has stored about the track ahead of a place, as a matrix of distance");
  command->add_option("line", options->line,
                      "line file (etcs-line/1), - for standard input; default: the shipped line");
  command->add_option("--at", options->at_m, "place of the front end, m along the run")
      ->required()
      ->check(number_between(-1e7, 1e7));
  command->add_option("--train", options->train, "train file (etcs-train/1); default: the standard train");
  command
      ->add_option("--quantum", options->quantum, "length of a row in m: auto (by the target distance), 0.5, 5 or 50")
      ->check(CLI::IsMember({"auto", "0.5", "5", "50"}))
      ->capture_default_str();
  command->add_option("--format", options->format, "table, csv or json")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "file to write to instead of standard output");
  command->callback([options, &exit_code] { exit_code = matrix::track(*options); });
}

void add_explain(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<explain::Options>();
  CLI::App* command = app.add_subcommand(
      "explain", "Why a journey was as it was: mode, level, brake, speed, and what hinders each mode transition");
  command->add_option("input", options->input, "JSON Lines of inputs, as for evc replay; - for standard input")
      ->required();
  command->add_option("--at", options->at_ms, "time in ms: the last cycle not after it is explained")
      ->required()
      ->check(whole_number_between(0, 1000000000000));
  command->add_flag("--why-brake", options->why_brake, "the chain from the first cause to the brake command");
  command->add_option("--config", options->config, "configuration, instead of the stream's first line");
  command->add_option("--persistent", options->persistent,
                      "file of what the unit kept without power, read at the start");
  command->add_option("-o,--output", options->output, "file to write to instead of standard output");
  command->callback([options, &exit_code] { exit_code = explain::explain(*options); });
}

void add_dmi(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<screen::Options>();
  auto at_s = std::make_shared<std::optional<double>>();
  auto presses = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("dmi", "The screen of the driver-machine interface at a moment of a replay");
  CLI::Option* input =
      command->add_option("input", options->input,
                          "JSON Lines of inputs, as for evc replay; - for standard input; default: the shipped line");
  CLI::Option* at = command->add_option("--at", *at_s, "time in s: the screen then; default: after the last cycle")
                        ->check(number_between(0.0, 1e9));
  CLI::Option* press =
      command->add_option("--press", *presses, "X,Y@SECONDS: the driver touches this place; repeatable")
          ->check([](const std::string& given) {
            return screen::press_of(given) ? std::string()
                                           : "found " + given + ", expected X,Y@SECONDS on the screen of 640 x 480";
          });
  CLI::Option* config =
      command->add_option("--config", options->config, "configuration, instead of the stream's first line");
  command
      ->add_option("--cases", options->cases, "file of described cases: what the screen has of each, one line a case")
      ->excludes(input)
      ->excludes(at)
      ->excludes(press)
      ->excludes(config);
  command->add_option("-o,--output", options->output,
                      "FILE.svg, FILE.png or FILE.json; default: JSON on standard output");
  command->callback([options, at_s, presses, &exit_code] {
    if (*at_s) options->at_ms = static_cast<std::int64_t>(**at_s * 1000.0 + 0.5);
    for (const std::string& given : *presses) options->presses.push_back(*screen::press_of(given));
    exit_code = screen::show(*options);
  });
}

/// `sweep` itself, without the commands below it; `begin` computes.
CLI::App* add_sweep_itself(CLI::App& app, int& exit_code, const char* usual_threads,
                           const std::function<int(const sweep::Options&)>& begin) {
  auto options = std::make_shared<sweep::Options>();
  auto format = std::make_shared<std::string>("sqlite");
  CLI::App* command = app.add_subcommand("sweep", "Many journeys, curves or replays from one description, into SQLite");
  CLI::Option* spec =
      command->add_option("description", options->spec, "description (evc-sweep/1); - for standard input");
  command->add_option("-j,--threads", options->threads, usual_threads)->check(whole_number_between(1, 1024));
  command->add_flag("--resume", options->resume, "compute what the results do not have yet");
  command->add_flag("--dry-run", options->dry_run, "check the description and say what would be computed");
  command->add_option("--format", *format, "sqlite or csv")
      ->check(CLI::IsMember({"sqlite", "csv"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "results; default: the name of the description with .sqlite, or standard output for csv");
  command->callback([command, spec, options, format, begin, &exit_code] {
    if (!command->get_subcommands().empty()) return;
    if (spec->count() == 0) throw CLI::RequiredError("description");
    options->format = *format == "csv" ? sweep::Format::csv : sweep::Format::sqlite;
    exit_code = begin(*options);
  });
  return command;
}

void add_sweep(CLI::App& app, int& exit_code) {
  CLI::App* command = add_sweep_itself(app, exit_code, "number of threads; default: one for each processor",
                                       [](const sweep::Options& options) { return sweep::sweep(options); });

  auto hashed = std::make_shared<std::string>();
  CLI::App* hash = command->add_subcommand("hash", "A hash of the rows: the same for whoever computed them");
  hash->add_option("results", *hashed, "results of a sweep")->required();
  hash->callback([hashed, &exit_code] { exit_code = sweep::hash(*hashed); });

  auto page = std::make_shared<sweep::ReportOptions>();
  CLI::App* report = command->add_subcommand("report", "A page: distributions, one value over another, worst cases");
  report->add_option("results", page->results, "results of a sweep")->required();
  report->add_option("-o,--output", page->output, "the page")->capture_default_str();
  report->callback([page, &exit_code] { exit_code = sweep::report(*page); });

  auto one = std::make_shared<sweep::CaseOptions>();
  CLI::App* again = command->add_subcommand("case", "Compute one case again and leave its files in a folder");
  again->add_option("results", one->results, "results of a sweep")->required();
  again->add_option("number", one->number, "number of the case, from 0")
      ->check(whole_number_between(0, 999999999))
      ->required();
  again->add_option("-o,--output", one->output, "folder")->required();
  again->callback([one, &exit_code] { exit_code = sweep::again(*one); });
}

void add_brakes(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<deceleration::Options>();
  CLI::App* command = app.add_subcommand("brakes", "The guaranteed deceleration of a train from its brake units");
  command->add_option("description", options->spec, "brake units (evc-brakes/1); - for standard input")->required();
  command->add_option("-j,--threads", options->threads, "number of threads; default: one for each processor")
      ->check(whole_number_between(1, 1024));
  command->add_option("--format", options->format, "table or json")
      ->check(CLI::IsMember({"table", "json"}))
      ->capture_default_str();
  command
      ->add_option("--plain", options->plain,
                   "compare with a plain run of this many samples, without stratification and importance sampling")
      ->check(whole_number_between(1000, 10000000000));
  command->add_option("--plot", options->plot, "a chart: FILE.svg");
  command->add_option("-o,--output", options->output, "train file (etcs-train/1)");
  command->callback([options, &exit_code] { exit_code = deceleration::brakes(*options); });
}

int make(const std::string& input, const std::string& output) {
  using io::complain;
  if (const auto apart = io::not_the_input(input, output); !apart) return complain(apart.error());
  const auto text = io::read_text(input);
  if (!text) return complain(text.error());
  const auto line = io::make_line(*text, input);
  if (!line) return complain(line.error());
  const auto written = io::write_whole(output, *line);
  return written ? 0 : complain(written.error());
}

void add_make_line(CLI::App& app, int& exit_code) {
  auto input = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>("-");
  CLI::App* command =
      app.add_subcommand("make-line", "Encode a readable description of a line into telegrams and messages");
  command->add_option("description", *input, "description (evc-line-description/1); - for standard input")->required();
  command->add_option("-o,--output", *output, "line file (etcs-line/1); default: standard output");
  command->callback([input, output, &exit_code] { exit_code = make(*input, *output); });
}

}  // namespace

void add_commands(CLI::App& app, int& exit_code) {
  add_run(app, exit_code);
  add_replay(app, exit_code);
  add_serve(app, exit_code);
  add_curves(app, exit_code);
  add_decode(app, exit_code);
  add_encode(app, exit_code);
  add_describe(app, exit_code);
  add_make_line(app, exit_code);
  add_check(app, exit_code);
  add_track(app, exit_code);
  add_explain(app, exit_code);
  add_dmi(app, exit_code);
  add_cab(app, exit_code);
  add_sweep(app, exit_code);
  add_brakes(app, exit_code);
  refuse_empty_arguments(app);
}

void add_commands_of_ranks(CLI::App& app, int& exit_code, sweep::Computers& ranks) {
  add_sweep_itself(app, exit_code, "number of threads of each rank; default: 1", [&ranks](const sweep::Options& given) {
    sweep::Options options = given;
    options.command = "evc-mpi sweep";
    return sweep::sweep(options, ranks);
  });
  refuse_empty_arguments(app);
}

}  // namespace evc::app
