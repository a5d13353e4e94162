#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "io/file.h"

namespace evc::serve {

/// Cuts the bytes of a partner, as they come, into lines. Nothing is kept but the line that has begun.
class LineCutter {
 public:
  /// `line` is called with each line that ends in `bytes`, without its end, in order. False when the line that has
  /// begun is longer than io::kLongestLine: nothing is taken any more.
  template <class Line>
  [[nodiscard]] bool take(std::string_view bytes, Line&& line) {
    while (!too_long_ && !bytes.empty()) {
      const std::size_t end = bytes.find('\n');
      begun_ += bytes.substr(0, end);
      too_long_ = begun_.size() > io::kLongestLine;
      if (too_long_ || end == std::string_view::npos) break;
      line(std::move(begun_));
      begun_.clear();
      bytes.remove_prefix(end + 1);
    }
    return !too_long_;
  }

  /// What has no end when nothing more comes: as the last line of a file it is a line. Empty: there is none.
  std::string rest() { return too_long_ ? std::string() : std::move(begun_); }

 private:
  std::string begun_;
  bool too_long_ = false;
};

}  // namespace evc::serve
