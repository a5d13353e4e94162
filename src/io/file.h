#pragma once
#include <cstdio>
#include <string>
#include <string_view>

#include "io/diagnostic.h"

namespace evc::io {

/// The whole text of a file, or of standard input for "-".
Result<std::string> read_text(const std::string& file);

/// A file that appears under its name only when it is whole: written beside it under a temporary
/// name and renamed by `commit`. Without `commit` nothing is left. "-" is standard output.
class WholeFile {
 public:
  static Result<WholeFile> create(const std::string& file);
  WholeFile(WholeFile&& other) noexcept;
  WholeFile& operator=(WholeFile&&) = delete;
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();

  void write(std::string_view text);
  /// Gives the file its name; the error of any write until now is told here.
  Result<bool> commit();

 private:
  WholeFile(std::string file, std::string temporary, std::FILE* stream);
  std::string file_;
  std::string temporary_;
  std::FILE* stream_ = nullptr;
  int error_ = 0;  // errno of the first write that failed
};

/// Whether files can be made in a folder, tried with one that does not stay.
Result<bool> can_be_written_in(const std::string& folder);

/// Writes a whole file at once.
Result<bool> write_whole(const std::string& file, std::string_view text);

}  // namespace evc::io
