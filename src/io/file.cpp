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
  Result<std::string> read = std::move(text);
  if (std::ferror(stream) != 0) read = tl::unexpected(system_error_at(file, "a file that can be read"));
  if (!standard) std::fclose(stream);
  return read;
}

WholeFile::WholeFile(std::string file, std::string temporary, std::FILE* stream)
    : file_(std::move(file)), temporary_(std::move(temporary)), stream_(stream) {}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : file_(std::move(other.file_)),
      temporary_(std::move(other.temporary_)),
      stream_(std::exchange(other.stream_, nullptr)),
      error_(other.error_) {}

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
  // A name of its own: nothing that is there, a link included, is written through.
  std::string temporary;
  int descriptor = -1;
  for (int attempt = 0; descriptor < 0 && attempt < 100; ++attempt) {
    temporary = file + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
    descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  if (descriptor < 0) return tl::unexpected(system_error_at(file, "a file that can be written"));
  std::FILE* stream = ::fdopen(descriptor, "wb");
  if (stream == nullptr) {
    auto failure = tl::unexpected(system_error_at(file, "a file that can be written"));
    ::close(descriptor);
    std::remove(temporary.c_str());
    return failure;
  }
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
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) error_ = errno;
}

Result<bool> WholeFile::commit() {
  std::FILE* stream = std::exchange(stream_, nullptr);
  const bool closed = stream == stdout ? std::fflush(stream) == 0 : std::fclose(stream) == 0;
  if (error_ == 0 && !closed) error_ = errno;
  if (error_ == 0 && !temporary_.empty() && std::rename(temporary_.c_str(), file_.c_str()) != 0) error_ = errno;
  if (error_ == 0) return true;
  errno = error_;  // of the first thing that failed
  const Diagnostic diagnostic = system_error_at(file_, "room to write the whole file");
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  return tl::unexpected(diagnostic);
}

Result<bool> can_be_written_in(const std::string& folder) {
  const auto file = WholeFile::create(folder + "/probe");
  if (!file) return tl::unexpected(Diagnostic{folder, "", file.error().found, "a folder that can be written"});
  return true;
}

Result<bool> write_whole(const std::string& file, std::string_view text) {
  auto out = WholeFile::create(file);
  if (!out) return tl::unexpected(out.error());
  out->write(text);
  return out->commit();
}

}  // namespace evc::io
