#include "io/named_document.h"

#include <filesystem>
#include <utility>

#include "io/data_files.h"
#include "io/file.h"

namespace evc::io {

Named read_named(const JsonPlace& place, const std::string& folder) {
  if (place.is_object()) return {"", place.value().dump(-1, ' ', false, Json::error_handler_t::replace)};
  const std::string& name = place.string();
  const bool shipped = name.find('/') == std::string::npos && name.find('.') == std::string::npos && !name.empty();
  const std::string file = shipped ? data_file(folder + "/" + name + ".json")
                                   : (std::filesystem::path(place.file()).parent_path() / name).string();
  if (name.empty() || name == "-") place.fail("the name of a file");
  auto text = read_text(file, kLargestDocument);
  if (!text) place.fail("\"" + name + "\" (" + text.error().found + ")", "a file, or the name of a shipped one");
  return {file, *std::move(text)};
}

std::string put_named(Json& document, const std::string& member, const std::string& folder, const JsonPlace& owner) {
  const auto place = owner.find(member);
  if (!place || !place->is_string()) return "";
  const Named named = read_named(*place, folder);
  document[member] = parse_json(named.text, named.file);
  return named.file;
}

}  // namespace evc::io
