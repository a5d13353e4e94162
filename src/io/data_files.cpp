#include "io/data_files.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace evc::io {
namespace {

bool is_data(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder / "lines", error);
}

/// Of a library that is loaded by another program, as the Python module is: it is below the prefix of the installation,
/// how deep depends on the interpreter. Empty where there is none.
std::filesystem::path of_library() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&data_folder), &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code error;
  auto folder = std::filesystem::canonical(info.dli_fname, error).parent_path();
  constexpr int kDeepest = 6;
  for (int i = 0; i < kDeepest && folder.has_relative_path(); ++i, folder = folder.parent_path())
    if (is_data(folder / "share" / "openevc")) return folder / "share" / "openevc";
  return {};
}

}  // namespace

std::string data_folder() {
  if (const char* given = std::getenv("OPENEVC_DATA"); given != nullptr && *given != '\0') return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = program.parent_path().parent_path() / "share" / "openevc";
    if (is_data(installed)) return installed.string();
  }
  if (const auto beside = of_library(); !beside.empty()) return beside.string();
  return EVC_DATA_DIR;
}

std::string data_file(const std::string& path) { return data_folder() + "/" + path; }

}  // namespace evc::io
