#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/test_paths.h"
#include "io/file.h"

// Runs the program as a user does, for tests.
namespace evc {

inline std::string text_of(const std::string& file) {
  const auto text = io::read_text(file);
  return text ? *text : std::string();
}

/// A new empty folder, deleted at the end.
class Folder {
 public:
  explicit Folder(const char* name)
      : path_((std::filesystem::temp_directory_path() / ("openevc_" + std::to_string(::getpid()) + "_" + name))
                  .string()) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const char* name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline std::string program() {
  return "OPENEVC_DATA='" + evc::test::source_folder() + "/data' '" + evc::test::evc_command() + "' ";
}

struct Ended {
  int exit_code = -1;
  std::string output, errors;
};
/// Runs the program; the arguments go through the shell and may redirect.
inline Ended ended(const std::string& arguments) {
  const Folder folder("ended");
  // The redirections of the caller are last and take effect.
  const std::string command = program() + ">'" + (folder / "output") + "' 2>'" + (folder / "errors") + "' " + arguments;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "output"), text_of(folder / "errors")};
}

}  // namespace evc
