#include "serve/page.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/data_files.h"
#include "io/file.h"

namespace evc::serve {

extern const char unit_page_template[];

namespace {

/// Where `evc cab` puts the line and the train: "@given 45564303@", with the version of what it puts there.
constexpr std::string_view kPlace = "@given";

}  // namespace

std::string page() {
  const std::string file = io::data_file("cab/page.html");
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return unit_page_template;
  auto text = io::read_text(file);
  const std::size_t place = text ? text->find(kPlace) : std::string::npos;
  const std::size_t end = place == std::string::npos ? place : text->find('@', place + 1);
  if (end == std::string::npos) return unit_page_template;
  return text->replace(place, end + 1 - place, "");
}

}  // namespace evc::serve
