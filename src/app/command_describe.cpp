#include "app/command_describe.h"

#include <fmt/core.h>

#include <charconv>
#include <memory>
#include <string>

#include "io/file.h"
#include "io/telegram_explain.h"

namespace evc::app {
namespace {

struct Options {
  std::string id;
  bool markdown = false, to_train = false, to_track = false, index = false;
};

int print(const std::string& text, const std::string& what, const std::string& id) {
  if (text.empty()) {
    fmt::print(stderr, "evc describe {0}: found {1}, expected one that `evc describe {0}` lists\n", what, id);
    return 2;
  }
  const auto written = io::write_whole("-", text);
  if (!written) fmt::print(stderr, "{}\n", written.error().text());
  return written ? 0 : 2;
}

int number_of(const std::string& id) {
  int n = -1;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), n);
  return error == std::errc{} && end == id.data() + id.size() && n >= 0 && n <= 255 ? n : -1;
}

int describe_packets(const Options& o) {
  if (o.index) return print(io::packet_index_page(), "packets", "");
  if (o.id.empty()) return print(io::list_packets(), "packets", "");
  const int n = number_of(o.id);
  if (n < 0) return print("", "packets", o.id);
  const auto nid = static_cast<std::uint8_t>(n);
  std::string text;
  if (!o.to_track) text += io::describe_packet(nid, lang::Direction::to_train, o.markdown);
  if (!o.to_train) text += (text.empty() ? "" : "\n") + io::describe_packet(nid, lang::Direction::to_track, o.markdown);
  if (text == "\n") text.clear();
  return print(text, "packets", o.id);
}

int describe_messages(const Options& o) {
  if (o.id.empty()) return print(io::list_messages(), "messages", "");
  const int n = number_of(o.id);
  return print(n < 0 ? "" : io::describe_message(static_cast<std::uint8_t>(n), o.markdown), "messages", o.id);
}

int describe_variables(const Options& o) {
  if (o.id.empty()) return print(io::list_variables(), "variables", "");
  return print(io::describe_variable(o.id, o.markdown), "variables", o.id);
}

}  // namespace

void add_describe_command(CLI::App& app, int& exit_code) {
  CLI::App* describe = app.add_subcommand("describe", "The tables of the ETCS language (SUBSET-026-7, -8)");
  describe->require_subcommand(1);
  const auto options = std::make_shared<Options>();
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
  schema->callback([&exit_code] { exit_code = print(io::telegram_schema(), "schema", ""); });
  packets->callback([options, &exit_code] { exit_code = describe_packets(*options); });
  variables->callback([options, &exit_code] { exit_code = describe_variables(*options); });
  messages->callback([options, &exit_code] { exit_code = describe_messages(*options); });
}

}  // namespace evc::app
