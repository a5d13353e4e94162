#include "io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace evc::io {
namespace {

Diagnostic system_error_at(const std::string& file, const char* expected) {
  return {file, "", std::strerror(errno), expected};
}

}  // namespace

Result<std::string> read_text(const std::string& file) {
  const bool standard = file == "-";
  std::error_code ignored;
  if (!standard && std::filesystem::is_directory(file, ignored))
    return tl::unexpected(Diagnostic{file, "", "a directory", "a file that can be read"});
  std::FILE* stream = standard ? stdin : std::fopen(file.c_str(), "rb");
  if (stream == nullptr) return tl::unexpected(system_error_at(file, "a file that can be read"));
  std::string text;
  char block[65536];
  for (std::size_t n = 0; (n = std::fread(block, 1, sizeof block, stream)) > 0;) text.append(block, n);
  const bool failed = std::ferror(stream) != 0;
  if (!standard) std::fclose(stream);
  if (failed) return tl::unexpected(system_error_at(file, "a file that can be read"));
  return text;
}

WholeFile::WholeFile(std::string file, std::string temporary, std::FILE* stream)
    : file_(std::move(file)), temporary_(std::move(temporary)), stream_(stream) {}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : file_(std::move(other.file_)),
      temporary_(std::move(other.temporary_)),
      stream_(std::exchange(other.stream_, nullptr)),
      failed_(other.failed_) {}

Result<WholeFile> WholeFile::create(const std::string& file) {
  if (file == "-") return WholeFile(file, "", stdout);
  // A device or pipe has no name to rename to: written straight.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool exists = !error && std::filesystem::exists(status);
  if (exists && std::filesystem::is_directory(status))
    return tl::unexpected(Diagnostic{file, "", "a directory", "a file that can be written"});
  if (exists && !std::filesystem::is_regular_file(status)) {
    std::FILE* device = std::fopen(file.c_str(), "wb");
    if (device == nullptr) return tl::unexpected(system_error_at(file, "a file that can be written"));
    return WholeFile(file, "", device);
  }
  const std::string temporary = file + "." + std::to_string(::getpid()) + ".part";
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  std::FILE* stream = descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
  if (stream == nullptr) return tl::unexpected(system_error_at(file, "a file that can be written"));
  return WholeFile(file, temporary, stream);
}

WholeFile::~WholeFile() {
  if (stream_ == nullptr) return;
  if (stream_ == stdout) {
    std::fflush(stdout);
    return;
  }
  std::fclose(stream_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void WholeFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) failed_ = true;
}

Result<bool> WholeFile::commit() {
  std::FILE* stream = std::exchange(stream_, nullptr);
  const bool closed = stream == stdout ? std::fflush(stream) == 0 : std::fclose(stream) == 0;
  bool whole = !failed_ && closed;
  if (whole && !temporary_.empty()) whole = std::rename(temporary_.c_str(), file_.c_str()) == 0;
  if (whole) return true;
  const Diagnostic diagnostic = system_error_at(file_, "room to write the whole file");
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  return tl::unexpected(diagnostic);
}

Result<bool> write_whole(const std::string& file, std::string_view text) {
  auto out = WholeFile::create(file);
  if (!out) return tl::unexpected(out.error());
  out->write(text);
  return out->commit();
}

}  // namespace evc::io
