#include "cab/command.h"

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/data_files.h"
#include "io/file.h"
#include "io/line_file.h"
#include "io/line_networks.h"
#include "ride/given.h"
#include "run/load.h"

namespace evc::cab {
namespace {

using io::complain;

/// The page that `make cab` compiles: script and WebAssembly, without a line and a train.
io::Result<std::string> load_page() {
  const std::string file = io::data_file("cab/page.html");
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    return tl::unexpected(io::Diagnostic{file, "", "no file", "the compiled page: `make cab` makes it"});
  auto page = io::read_text(file);
  if (page && page->find(ride::given_place()) == std::string::npos)
    return tl::unexpected(io::Diagnostic{
        file, "",
        page->find("@given") == std::string::npos ? "no " + ride::given_place() : "the page of another version",
        "the compiled page of this one: `make cab` makes it"});
  return page;
}

io::Result<ride::Given> load(const Options& options) {
  const std::string file = run::line_file(options.line);
  const auto text = io::read_text(file);  // once: it may be standard input
  if (!text) return tl::unexpected(text.error());
  auto line = io::read_line(*text, file);
  if (!line) return tl::unexpected(line.error());
  auto networks = io::read_networks(*text, file);
  if (!networks) return tl::unexpected(networks.error());
  auto train = run::load_train(options.train);
  if (!train) return tl::unexpected(train.error());
  return ride::Given{*std::move(line), train->name, train->data, train->dynamics, train->document, *networks};
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8 | (at + i < bytes.size() ? static_cast<std::uint8_t>(bytes[at + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += at + i > bytes.size() ? '=' : digits[three >> (18 - 6 * i) & 63];
  }
  return text;
}

int cab(const Options& options) {
  for (const std::string& input : {options.line, options.train})
    if (const auto apart = io::not_the_input(input, options.output); !apart) return complain(apart.error());
  const auto given = load(options);
  if (!given) return complain(given.error());
  auto page = load_page();
  if (!page) return complain(page.error());
  const std::string place = ride::given_place();
  page->replace(page->find(place), place.size(), base64(ride::bytes_of(*given)));
  if (const auto written = io::write_whole(options.output, *page); !written) return complain(written.error());
  return 0;
}

}  // namespace evc::cab
