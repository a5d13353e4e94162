#pragma once
#include <csignal>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

#include "io/diagnostic.h"

namespace evc::io {

/// Limits of what is read into memory, in bytes: a document (a line, a train, a query), a file of telegrams or outputs,
/// a line of such a file. A document of this size takes up to 1.5 GB when it is parsed.
inline constexpr std::size_t kLargestDocument = std::size_t{64} << 20;
inline constexpr std::size_t kLargestStream = std::size_t{4} << 30;
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// The whole text of a file, or of standard input for "-". Errors: more than `most` bytes; a pipe without a writer.
Result<std::string> read_text(const std::string& file, std::size_t most = kLargestDocument);

/// The error for line `number` of a file when it is longer than kLongestLine.
Diagnostic line_too_long(const std::string& file, std::size_t number);

/// Lines of a file in sequence, "-" for standard input: a live stream is answered line by line.
class Lines {
 public:
  explicit Lines(std::string file);
  ~Lines();
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  /// Stores the next line, without its end; false at the end of the file. Throws ReadError for a file that cannot be
  /// read and for a line beyond kLongestLine.
  bool next(std::string& line);

 private:
  std::string file_;
  std::FILE* stream_;
  int error_;  // errno of opening
  std::size_t number_ = 0;
};

/// The signals that end the program before its files are complete.
inline constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
/// Deletes the temporary files of every WholeFile that is not complete. Only for a signal handler that ends the
/// program.
void delete_unfinished_files() noexcept;

/// A file that gets its name only when it is complete: written next to it under a temporary name
/// and renamed by `commit`. Without `commit` nothing remains. "-" is standard output. A pipe needs a reader.
class WholeFile {
 public:
  static Result<WholeFile> create(const std::string& file);
  WholeFile(WholeFile&& other) noexcept;
  WholeFile& operator=(WholeFile&&) = delete;
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  void write(std::string_view text);
  /// Writes out everything so far, for a reader of a live stream.
  void flush();
  /// Writes everything that is buffered; the file still has its temporary name. Returns the error of any write so far.
  Result<bool> finish();
  /// Finishes the file and gives it its name.
  Result<bool> commit();

 private:
  WholeFile(std::string file, std::string temporary, std::FILE* stream);
  std::string file_;
  std::string temporary_;
  std::FILE* stream_ = nullptr;
  int error_ = 0;  // errno of the first write that failed
};

/// Files that belong together: none gets its name before all are finished. They are renamed in this order.
Result<bool> commit_together(std::initializer_list<WholeFile*> files);

/// Whether two names, each a file or "-" for standard output, are the same file. The null device is never the same.
bool same_file(const std::string& a, const std::string& b);

/// An error when the output would overwrite the input.
Result<bool> not_the_input(const std::string& input, const std::string& output);

/// Whether files can be created in a folder, tested with a temporary file.
Result<bool> can_be_written_in(const std::string& folder);

/// Writes a complete file at once.
Result<bool> write_whole(const std::string& file, std::string_view text);

}  // namespace evc::io
