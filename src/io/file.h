#pragma once
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

#include "io/diagnostic.h"

namespace evc::io {

/// The whole text of a file, or of standard input for "-".
Result<std::string> read_text(const std::string& file);

/// A file that gets its name only when it is complete: written next to it under a temporary name
/// and renamed by `commit`. Without `commit` nothing remains. "-" is standard output.
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
