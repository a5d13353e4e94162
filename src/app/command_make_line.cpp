#include "app/command_make_line.h"

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

#include "app/make_line.h"
#include "io/file.h"

namespace evc::app {
namespace {

int make(const std::string& input, const std::string& output) {
  const auto complain = [](const io::Diagnostic& diagnostic) {
    fmt::print(stderr, "{}\n", diagnostic.text());
    return 2;
  };
  if (const auto apart = io::not_the_input(input, output); !apart) return complain(apart.error());
  const auto text = io::read_text(input);
  if (!text) return complain(text.error());
  const auto line = make_line(*text, input);
  if (!line) return complain(line.error());
  const auto written = io::write_whole(output, *line);
  return written ? 0 : complain(written.error());
}

}  // namespace

void add_make_line_command(CLI::App& app, int& exit_code) {
  auto input = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>("-");
  CLI::App* command =
      app.add_subcommand("make-line", "Encode a readable description of a line into telegrams and messages");
  command->add_option("description", *input, "description (evc-line-description/1); - for standard input")->required();
  command->add_option("-o,--output", *output, "line file (etcs-line/1); standard output when not given");
  command->callback([input, output, &exit_code] { exit_code = make(*input, *output); });
}

}  // namespace evc::app
