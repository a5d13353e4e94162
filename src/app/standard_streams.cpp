#include "app/standard_streams.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/diagnostic.h"

namespace evc::app {

void take_closed_streams() {
  for (int stream = 0; stream <= 2; ++stream) {
    if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest free number. Standard output is opened for reading: a write to it is reported as failed.
    (void)::open("/dev/null", stream == 1 ? O_RDONLY : O_WRONLY);
  }
}

int with_all_written(int exit_code, int error) {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return exit_code;
  if (exit_code == 2) return 2;
  if (error == 0) error = errno;
  const io::Diagnostic lost{"standard output", "", error != 0 ? std::strerror(error) : "a write that failed",
                            "space for the whole file"};
  std::fputs((lost.text() + "\n").c_str(), stderr);
  return 2;
}

}  // namespace evc::app
