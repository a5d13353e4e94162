#include "app/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/standard_streams.h"
#include "io/diagnostic.h"
#include "io/file.h"

namespace evc::app {
namespace {

using io::Diagnostic;

/// The text before and after `middle`.
struct Parts {
  std::string before, behind;
};
std::optional<Parts> split(const std::string& text, std::string_view middle) {
  const std::size_t at = text.find(middle);
  if (at == std::string::npos) return std::nullopt;
  return Parts{text.substr(0, at), text.substr(at + middle.size())};
}

bool take_end(std::string& text, std::string_view end) {
  if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0) return false;
  text.resize(text.size() - end.size());
  return true;
}

/// "600.000000" without the trailing zeros.
std::string plain(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number;
}

std::string listed(std::string names) {
  for (std::size_t at = 0; (at = names.find(',', at)) != std::string::npos; at += 2) names.replace(at, 1, ", ");
  return names;
}

std::string names_of_commands(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

/// Of one option: the text of CLI11 after its name.
void explain_option(Diagnostic& d, std::string what) {
  if (const auto ours = split(what, ", expected "); ours && what.rfind("found ", 0) == 0) {
    d.found = ours->before.substr(6);
    d.expected = ours->behind;
  } else if (auto set = split(what, " not in {"); set && take_end(set->behind, "}")) {
    d.found = set->before;
    d.expected = "one of " + listed(set->behind);
  } else if (const auto range = split(what, " not in range "); range && what.rfind("Value ", 0) == 0) {
    const auto ends = split(range->behind, " to ");
    d.found = range->before.substr(6);
    d.expected = "a number from " + (ends ? plain(ends->before) + " to " + plain(ends->behind) : range->behind);
  } else if (what.find(" required ") != std::string::npos && take_end(what, " missing")) {
    d.found = "nothing after it";
    d.expected = "a value";
  } else if (const auto often = split(what, "At Most 1 required but received "); often && often->before.empty()) {
    d.found = "it " + often->behind + " times";
    d.expected = "it once";
  } else if (const auto few = split(what, " required but received "); few && few->before.rfind("At least ", 0) == 0) {
    d.found = few->behind + " behind it";
    d.expected = few->before.substr(9);
  } else {
    d.where += (d.where.empty() ? "" : ": ") + what;
  }
  if (d.found.empty() && !d.expected.empty()) d.found = "an empty argument";
}

void explain_missing(Diagnostic& d, const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  d.found = "no " + name;
  d.expected = option != nullptr && !option->get_description().empty() ? option->get_description() : "one";
}

void explain_extra(Diagnostic& d, const std::string& words) {
  // CLI11 returns them from the last to the first.
  std::istringstream in(words);
  std::vector<std::string> extras;
  for (std::string word; in >> word;) extras.insert(extras.begin(), word);
  const auto option = std::find_if(extras.begin(), extras.end(), [](const auto& e) { return e.front() == '-'; });
  if (option != extras.end()) {
    d.found = *option;
    d.expected = "an option that `" + d.file + " --help` lists";
  } else {
    d.found = extras.empty() ? "one more argument" : "\"" + extras.front() + "\"";
    d.expected = "no further argument";
  }
}

/// An option as it was written, `-j` or `--threads`; CLI11 has its long name. Where it is there in both ways, the one
/// with the value `found`, else the last one.
std::string as_written(const CLI::App& command, const std::string& name, const std::string& found,
                       const std::vector<std::string>& arguments) {
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr || option->get_positional()) return name;
  const auto written = [&](const std::string& argument) -> std::optional<Parts> {
    for (const std::string& letter : option->get_snames())
      if (argument.rfind("-" + letter, 0) == 0) return Parts{"-" + letter, argument.substr(1 + letter.size())};
    for (const std::string& word : option->get_lnames())
      if (argument == "--" + word || argument.rfind("--" + word + "=", 0) == 0)
        return Parts{"--" + word, argument.substr(std::min(argument.size(), word.size() + 3))};
    return std::nullopt;
  };
  std::string last = name;
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    const auto way = written(arguments[i]);
    if (!way) continue;
    last = way->before;
    if (!found.empty() && (way->behind == found || (i + 1 < arguments.size() && arguments[i + 1] == found))) break;
  }
  return last;
}

Diagnostic explain(const CLI::App& command, const std::string& name, const std::string& what,
                   const std::vector<std::string>& arguments) {
  const auto written = [&](const std::string& option, const std::string& found = {}) {
    return as_written(command, option, found, arguments);
  };
  Diagnostic d{name, "", "", ""};
  std::string rest = what;
  if (const auto extra = split(what, "not expected: ")) {
    explain_extra(d, extra->behind);
  } else if (const auto conversion = split(what, "Could not convert: ")) {
    const auto value = split(conversion->behind, " = ");
    d.found = value ? value->behind : "";
    d.where = written(value ? value->before : conversion->behind, d.found);
    d.expected = "a number";
  } else if (what.rfind("found ", 0) == 0) {
    explain_option(d, what);
  } else if (const auto option = split(what, ": ")) {
    d.where = option->before;
    explain_option(d, option->behind);
    if (d.where == option->before) d.where = written(d.where, d.found);
  } else if (const auto two = split(what, " excludes ")) {
    d.found = written(two->before) + " and " + written(two->behind);
    d.expected = "one of them";
  } else if (const auto alone = split(what, " requires ")) {
    d.found = written(alone->before) + " alone";
    d.expected = alone->behind + " with it";
  } else if (take_end(rest, " is required")) {
    explain_missing(d, command, rest);
  } else {
    d.where = what;
  }
  return d;
}

/// The error of the command line, in one line. `arguments` are those of the program, without its name.
std::string wrong_command_line(std::string name, const CLI::App& app, const CLI::ParseError& error,
                               const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  std::size_t used = 0;
  // Commands are first: `evc decode radio ...`.
  for (; used < arguments.size(); ++used) {
    const auto commands = command->get_subcommands([](const CLI::App*) { return true; });
    const auto next = std::find_if(commands.begin(), commands.end(),
                                   [&](const CLI::App* c) { return c->get_name() == arguments[used]; });
    if (next == commands.end()) break;
    command = *next;
    name += " " + arguments[used];
  }
  // A command is missing or does not exist.
  if (std::string(error.what()) == "A subcommand is required") {
    const bool named = used < arguments.size();
    return Diagnostic{name, "", named ? "\"" + arguments[used] + "\"" : "no command",
                      "one of " + names_of_commands(*command)}
               .text() +
           "\n";
  }
  return explain(*command, name, error.what(), arguments).text() + "\n";
}

/// Help or version.
int answer(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  app.exit(asked, text, text);
  const auto written = io::write_whole("-", text.str());
  return written ? 0 : io::complain(written.error());
}

}  // namespace

int run_command(const Program& program, int argc, char** argv) {
  CLI::App app{program.description};
  app.set_version_flag("--version", program.version);
  app.require_subcommand(1);
  int exit_code = 0;
  program.add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are not errors; anything else is a wrong command line: one line and exit status 2.
    if (error.get_exit_code() == 0) return answer(app, error);
    std::fputs(wrong_command_line(program.name, app, error, {argv + (argc > 0 ? 1 : 0), argv + argc}).c_str(), stderr);
    return 2;
  }
  return exit_code;
}

int run_guarded(const char* program, const std::function<int()>& command) {
  int exit_code = 2;
  int write_error = 0;
  try {
    exit_code = command();
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: found not enough memory, expected enough for the input\n", program);
  } catch (const std::exception& error) {
    // fmt throws this when standard output cannot be written; anything else is a different failure.
    const auto* failed = dynamic_cast<const std::system_error*>(&error);
    if (failed != nullptr && std::ferror(stdout) != 0) {
      exit_code = 0;
      write_error = failed->code().value();
    } else {
      std::fprintf(stderr, "%s: found %s, expected no failure\n", program, error.what());
    }
  }
  return with_all_written(exit_code, write_error);
}

}  // namespace evc::app
