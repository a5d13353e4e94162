#include "io/data_files.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace evc::io {

std::string data_folder() {
  if (const char* given = std::getenv("OPENEVC_DATA"); given != nullptr && *given != '\0') return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = program.parent_path().parent_path() / "share" / "openevc";
    if (std::filesystem::is_directory(installed / "lines", error)) return installed.string();
  }
  return EVC_DATA_DIR;
}

std::string data_file(const std::string& path) { return data_folder() + "/" + path; }

}  // namespace evc::io
