// Any bytes of a partner of `evc serve`, in any pieces, with and without the clock: every line that it is answered is
// one JSON object with its end, an error is the last of them and names its place, and the session ends.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <stop_token>
#include <string>
#include <string_view>

#include "io/json.h"
#include "realtime/clock.h"
#include "serve/lines.h"
#include "serve/session.h"

namespace {

/// Whoever waits is there at once.
class NoTime final : public evc::realtime::Clock {
 public:
  evc::realtime::Nanoseconds now() override { return now_; }
  void wait_until(evc::realtime::Nanoseconds at, const std::stop_token&) override { now_ = std::max(now_, at); }

 private:
  evc::realtime::Nanoseconds now_{0};
};

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  // A distant time would give many cycles: some are enough. Nobody takes any meanwhile.
  evc::serve::Room room;
  room.outputs = 300'000;
  room.patience = {};
  evc::serve::Conversation partner(room, [] {});
  evc::serve::LineCutter cutter;
  const bool by_clock = data[0] % 2 == 1;
  const std::size_t piece = 1 + data[1];
  evc::realtime::Nanoseconds arrived{0};
  std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) {
    arrived += std::chrono::milliseconds(70);
    require(cutter.take(text.substr(0, piece), [&](std::string&& line) { partner.put({std::move(line), arrived}); }));
  }
  if (std::string rest = cutter.rest(); !rest.empty()) partner.put({std::move(rest), arrived});
  partner.end_inputs();
  NoTime clock;
  std::stop_source nobody;
  evc::serve::answer(partner, {by_clock, {}}, clock, nobody.get_token());
  require(partner.finished());
  if (partner.dropped()) return 0;
  bool wrong = false;
  for (const std::string& line : partner.take(std::size_t{1} << 30)) {
    require(!wrong && line.find('\n') == line.size() - 1);
    const auto answer = evc::io::Json::parse(line);
    wrong = answer.contains("error");
    if (!wrong) require(answer.contains("t_ms"));
    if (!wrong) continue;
    const std::string error = answer.at("error");
    require(error.rfind("line ", 0) == 0 || error.rfind("session: ", 0) == 0);
  }
  return 0;
}
