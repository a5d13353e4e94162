#include "run/load.h"

#include "io/data_files.h"
#include "io/file.h"
#include "io/line_file.h"

namespace evc::run {

std::string line_file(const std::string& file) { return file.empty() ? io::data_file("lines/brunnental.json") : file; }

io::Result<sim::Line> load_line(const std::string& file) {
  const std::string name = line_file(file);
  const auto text = io::read_text(name);
  if (!text) return tl::unexpected(text.error());
  return io::read_line(*text, name);
}

io::Result<io::Train> load_train(const std::string& file) {
  if (file.empty()) return {};
  const auto text = io::read_text(file);
  if (!text) return tl::unexpected(text.error());
  return io::read_train(*text, file);
}

}  // namespace evc::run
