#include "io/terminal_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace evc::io {

TerminalLine::TerminalLine() : terminal_(::isatty(STDERR_FILENO) != 0) {}

TerminalLine::~TerminalLine() { clear(); }

void TerminalLine::show(const std::string& text) {
  if (!terminal_) return;
  (void)std::fputs(("\r" + text + " \033[K").c_str(), stderr);
  (void)std::fflush(stderr);
  shown_ = true;
}

void TerminalLine::clear() {
  if (!shown_) return;
  (void)std::fputs("\r\033[K", stderr);
  (void)std::fflush(stderr);
  shown_ = false;
}

std::string bar_of(double share, std::size_t width) {
  const auto full = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(width));
  return std::string(full, '#') + std::string(width - full, '.');
}

}  // namespace evc::io
