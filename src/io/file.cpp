#include "io/file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace evc::io {
namespace {

Diagnostic system_error_at(const std::string& file, const char* expected) {
  return {file, "", std::strerror(errno), expected};
}

/// Names of the files that are not complete: a signal handler can ask nobody else. Further ones stay after a signal.
std::array<std::atomic<char*>, 64> unfinished{};
static_assert(std::atomic<char*>::is_always_lock_free);

void note_unfinished(const std::string& name) {
  char* const copy = ::strdup(name.c_str());
  for (auto& slot : unfinished) {
    char* free = nullptr;
    if (slot.compare_exchange_strong(free, copy)) return;
  }
  std::free(copy);
}

void forget_unfinished(const std::string& name) {
  for (auto& slot : unfinished) {
    char* noted = slot.load();
    if (noted == nullptr || name != noted) continue;
    if (slot.compare_exchange_strong(noted, nullptr)) std::free(noted);
    return;
  }
}

/// Holds back the signals that end the program while a file has a name that is not noted.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : kEndingSignals) sigaddset(&ending, signal);
    (void)::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsHeld() { (void)::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

/// Creates a new file next to `file` with a new name: no existing file or link is written to. Below 0: the reason is in
/// errno.
int open_beside(const std::string& file, std::string& name) {
  const SignalsHeld held;
  int descriptor = -1;
  for (int attempt = 0; descriptor < 0 && attempt < 100; ++attempt) {
    name = file + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
    descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  if (descriptor >= 0) note_unfinished(name);
  return descriptor;
}

/// Deletes a file of `open_beside`.
void discard(const std::string& name) {
  std::remove(name.c_str());
  forget_unfinished(name);
}

bool status_of(const std::string& file, struct stat& status) {
  return (file == "-" ? ::fstat(1, &status) : ::stat(file.c_str(), &status)) == 0;
}

/// How long a pipe with a name (FIFO) may be without anybody at its other end. A stream (`Lines`) waits for who feeds
/// it.
constexpr int kPatience_ms = 3000;

/// Opens a file, or a pipe with a name that has somebody at its other end within kPatience_ms: without it `open` waits
/// for ever. Null: the reason is in errno, EPIPE for such a pipe.
std::FILE* open_or_give_up(const std::string& file, const char* mode) {
  constexpr int kAgain_ms = 20;
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISFIFO(status.st_mode)) return std::fopen(file.c_str(), mode);
  const bool reading = mode[0] == 'r';
  const int flags = (reading ? O_RDONLY : O_WRONLY) | O_NONBLOCK | O_CLOEXEC;
  int descriptor = ::open(file.c_str(), flags);
  // Opened for writing it says at once that nobody reads.
  for (int waited = 0; !reading && descriptor < 0 && errno == ENXIO && waited < kPatience_ms; waited += kAgain_ms) {
    (void)::poll(nullptr, 0, kAgain_ms);
    descriptor = ::open(file.c_str(), flags);
  }
  if (descriptor < 0 && errno == ENXIO) errno = EPIPE;
  if (descriptor < 0) return nullptr;
  // Opened for reading it has an end, as long as nobody writes; a writer without anything yet makes it wait.
  pollfd pipe{descriptor, POLLIN, 0};
  const bool silent = reading && ::poll(&pipe, 1, kPatience_ms) == 0;
  char first = 0;
  const ssize_t got = silent ? ::read(descriptor, &first, 1) : 1;
  (void)::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  std::FILE* const stream = got == 0 ? nullptr : ::fdopen(descriptor, mode);
  if (stream == nullptr) {
    const int error = got == 0 ? EPIPE : errno;
    ::close(descriptor);
    errno = error;
    return nullptr;
  }
  if (silent && got == 1) (void)std::ungetc(static_cast<unsigned char>(first), stream);
  return stream;
}

/// For more than `most` bytes.
Diagnostic too_large(const std::string& file, std::string where, const char* what, std::size_t most) {
  return {file, std::move(where), what + std::to_string(most) + " bytes", "at most " + std::to_string(most)};
}

}  // namespace

Result<std::string> read_text(const std::string& file, std::size_t most) {
  const bool standard = file == "-";
  std::error_code ignored;
  if (!standard && std::filesystem::is_directory(file, ignored))
    return tl::unexpected(Diagnostic{file, "", "a directory", "a file that can be read"});
  std::FILE* stream = standard ? stdin : open_or_give_up(file, "rb");
  if (stream == nullptr && errno == EPIPE)
    return tl::unexpected(Diagnostic{file, "", "a pipe that nobody writes into", "a file that can be read"});
  if (stream == nullptr) return tl::unexpected(system_error_at(file, "a file that can be read"));
  std::string text;
  char block[65536];
  for (std::size_t n = 0; text.size() <= most && (n = std::fread(block, 1, sizeof block, stream)) > 0;)
    text.append(block, n);
  const bool whole = text.size() <= most;
  Result<std::string> read = std::move(text);
  if (!whole) read = tl::unexpected(too_large(file, "", "more than ", most));
  if (std::ferror(stream) != 0) read = tl::unexpected(system_error_at(file, "a file that can be read"));
  if (!standard) std::fclose(stream);
  return read;
}

Diagnostic line_too_long(const std::string& file, std::size_t number) {
  return too_large(file, "line " + std::to_string(number), "a line of more than ", kLongestLine);
}

Lines::Lines(std::string file)
    : file_(std::move(file)), stream_(file_ == "-" ? stdin : std::fopen(file_.c_str(), "rb")), error_(errno) {}

Lines::~Lines() {
  if (stream_ != nullptr && stream_ != stdin) (void)std::fclose(stream_);
}

bool Lines::next(std::string& line) {
  const auto cannot_be_read = [&] { return ReadError{{file_, "", std::strerror(error_), "a file that can be read"}}; };
  if (stream_ == nullptr) throw cannot_be_read();
  ++number_;
  line.clear();
  for (int c = 0; (c = ::getc_unlocked(stream_)) != EOF;) {
    if (c == '\n') return true;
    if (line.size() == kLongestLine) throw ReadError{line_too_long(file_, number_)};
    line += static_cast<char>(c);
  }
  error_ = errno;
  if (std::ferror(stream_) != 0 && error_ == EISDIR)
    throw ReadError{{file_, "", "a directory", "a file that can be read"}};
  if (std::ferror(stream_) != 0) throw cannot_be_read();
  return !line.empty();
}

void delete_unfinished_files() noexcept {
  for (auto& slot : unfinished)
    if (const char* name = slot.load(); name != nullptr) (void)::unlink(name);
}

WholeFile::WholeFile(std::string file, std::string temporary, std::FILE* stream)
    : file_(std::move(file)), temporary_(std::move(temporary)), stream_(stream) {}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : file_(std::move(other.file_)),
      temporary_(std::exchange(other.temporary_, {})),
      stream_(std::exchange(other.stream_, nullptr)),
      error_(other.error_) {}

Result<WholeFile> WholeFile::create(const std::string& file) {
  if (file == "-") return WholeFile(file, "", stdout);
  // A device or pipe cannot be replaced by renaming: it is written directly.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool exists = !error && std::filesystem::exists(status);
  if (exists && std::filesystem::is_directory(status))
    return tl::unexpected(Diagnostic{file, "", "a directory", "a file that can be written"});
  if (exists && !std::filesystem::is_regular_file(status)) {
    std::FILE* device = open_or_give_up(file, "wb");
    if (device == nullptr && errno == EPIPE)
      return tl::unexpected(Diagnostic{file, "", "a pipe that nobody reads from", "a file that can be written"});
    if (device == nullptr) return tl::unexpected(system_error_at(file, "a file that can be written"));
    return WholeFile(file, "", device);
  }
  std::string temporary;
  const int descriptor = open_beside(file, temporary);
  if (descriptor < 0) return tl::unexpected(system_error_at(file, "a file that can be written"));
  std::FILE* stream = ::fdopen(descriptor, "wb");
  if (stream == nullptr) {
    auto failure = tl::unexpected(system_error_at(file, "a file that can be written"));
    ::close(descriptor);
    discard(temporary);
    return failure;
  }
  return WholeFile(file, temporary, stream);
}

WholeFile::~WholeFile() {
  if (stream_ == stdout)
    std::fflush(stdout);
  else if (stream_ != nullptr)
    std::fclose(stream_);
  if (!temporary_.empty()) discard(temporary_);
}

void WholeFile::write(std::string_view text) {
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) error_ = errno;
}

void WholeFile::flush() {
  if (std::fflush(stream_) != 0 && error_ == 0) error_ = errno;
}

Result<bool> WholeFile::finish() {
  if (std::FILE* stream = std::exchange(stream_, nullptr); stream != nullptr) {
    const bool closed = stream == stdout ? std::fflush(stream) == 0 : std::fclose(stream) == 0;
    if (error_ == 0 && !closed) error_ = errno;
  }
  if (error_ == 0) return true;
  errno = error_;  // of the first operation that failed
  return tl::unexpected(system_error_at(file_, "space for the whole file"));
}

Result<bool> WholeFile::commit() {
  if (const auto whole = finish(); !whole) return whole;
  if (temporary_.empty()) return true;
  if (std::rename(temporary_.c_str(), file_.c_str()) != 0)
    return tl::unexpected(system_error_at(file_, "a file that can be written"));
  forget_unfinished(temporary_);
  temporary_.clear();
  return true;
}

Result<bool> commit_together(std::initializer_list<WholeFile*> files) {
  for (WholeFile* file : files)
    if (const auto whole = file->finish(); !whole) return whole;
  for (WholeFile* file : files)
    if (const auto named = file->commit(); !named) return named;
  return true;
}

bool same_file(const std::string& a, const std::string& b) {
  struct stat one {};
  struct stat two {};
  struct stat null {};
  const bool both = status_of(a, one);
  if (both != status_of(b, two)) return false;
  if (both) {
    const bool nobodys = ::stat("/dev/null", &null) == 0 && one.st_dev == null.st_dev && one.st_ino == null.st_ino;
    return !nobodys && one.st_dev == two.st_dev && one.st_ino == two.st_ino;
  }
  // Neither file exists yet: compare the names in normal form.
  std::error_code error;
  const auto whole = [&](const std::string& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  };
  return whole(a) == whole(b);
}

Result<bool> not_the_input(const std::string& input, const std::string& output) {
  const auto no_name = [](const std::string& name) { return name.empty() || name == "-"; };
  if (no_name(input) || no_name(output) || !same_file(input, output)) return true;
  return tl::unexpected(Diagnostic{output, "", "the input", "another file for the output"});
}

Result<bool> can_be_written_in(const std::string& folder) {
  std::string name;
  const int descriptor = open_beside(folder + "/.openevc", name);
  if (descriptor < 0) return tl::unexpected(system_error_at(folder, "a folder that can be written"));
  ::close(descriptor);
  discard(name);
  return true;
}

Result<bool> write_whole(const std::string& file, std::string_view text) {
  auto out = WholeFile::create(file);
  if (!out) return tl::unexpected(out.error());
  out->write(text);
  return out->commit();
}

}  // namespace evc::io
