#pragma once
#include <string>

namespace evc::io {

/// A line on standard error that is written over and over, to show how far something has come; nothing where standard
/// error is no terminal.
class TerminalLine {
 public:
  TerminalLine();
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  /// Whether anybody sees it.
  bool is_seen() const { return terminal_; }
  void show(const std::string& text);
  /// The line is empty again.
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
};

/// So much of a bar of `width` characters: "####......".
std::string bar_of(double share, std::size_t width);

}  // namespace evc::io
