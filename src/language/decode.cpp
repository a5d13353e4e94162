#include "language/decode.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/file.h"
#include "io/pcapng.h"
#include "io/telegram_explain.h"
#include "io/telegram_json.h"
#include "io/terminal_line.h"
#include "language/airgap.h"

namespace evc::language {
namespace {

using io::complain;
using lang::Direction;

using Done = tl::expected<void, io::TelegramError>;

/// Decodes one line of input. The JSON object is appended to `out`.
class Decoder {
 public:
  Decoder(const DecodeOptions& options, lang::SystemVersion sv) : options_(options), sv_(sv) {
    direction_ = options.to_track ? Direction::to_track : Direction::to_train;
    // A single packet without its telegram is only displayed: spare codes are shown.
    const bool accept = options.tolerant || (options.what == What::packet && !options.strict);
    spare_ = accept ? io::Spare::accept : io::Spare::refuse;
  }

  /// Also writes accepted input to `file`, a capture for Wireshark.
  void trace(io::WholeFile& file) {
    file_ = &file;
    std::string head;
    pcapng_.emplace(head);
    if (options_.what == What::radio) pcapng_->append_version(head, sv_);
    file.write(head);
  }

  /// False: rejected, and the error object is appended. `number` is the line of a file or pipe, from 1.
  bool line(std::string& out, std::string_view hex, std::uint64_t number = 0) {
    Done done;
    const auto bits = io::bits_of_hex(hex);
    if (bits)
      done = options_.explain ? explain(out, *bits) : json(out, *bits);
    else
      done = tl::unexpected(bits.error());
    if (!done) out += refusal(done.error(), number, bits ? &*bits : nullptr);
    if (done && pcapng_) frame(*bits);
    if (!done || !options_.explain) out += '\n';
    return done.has_value();
  }

 private:
  Done json(std::string& out, const io::Bits& bits) const {
    switch (options_.what) {
      case What::balise:
        return options_.loop ? io::append_loop_json(out, bits.bytes, bits.bits, spare_)
                             : io::append_balise_json(out, bits.bytes, bits.bits, spare_);
      case What::airgap:
        return append_airgap_json(out, bits.bytes, bits.bits, spare_);
      case What::radio:
        return io::append_radio_json(out, bits.bytes, direction_, sv_, spare_);
      case What::packet:
        return io::append_packet_json(out, bits.bytes, bits.bits, direction_, sv_, spare_);
    }
    return {};
  }
  /// The error object. Where the language rejects what the air gap gave, with that.
  std::string refusal(const io::TelegramError& error, std::uint64_t number, const io::Bits* bits) const {
    std::string object = io::error_json(error, number);
    if (options_.what != What::airgap || bits == nullptr) return object;
    const auto coded = read_airgap(bits->bytes, bits->bits);
    if (!coded) return object;
    const std::string user = user_hex(*coded);
    if (options_.explain) return explain_airgap(*coded) + "user bits  " + user + "\n" + object;
    std::string airgap = airgap_json(*coded);
    airgap.pop_back();
    object.pop_back();
    return object + ",\"airgap\":" + airgap + ",\"user_bits\":\"" + user + "\"}}";
  }
  /// The table, after the same checks as for JSON.
  Done explain(std::string& out, const io::Bits& bits) const {
    std::string sink;
    if (Done done = json(sink, bits); !done) return done;
    if (!out.empty()) out += '\n';
    switch (options_.what) {
      case What::balise:
        out += io::explain_balise(bits.bytes, bits.bits);
        break;
      case What::airgap: {
        const auto coded = read_airgap(bits.bytes, bits.bits);
        if (!coded) break;
        out += explain_airgap(*coded);
        out += io::explain_balise(coded->received.user_bytes(), airgap::user_bits(coded->received.format));
        break;
      }
      case What::radio:
        out += io::explain_radio(bits.bytes, direction_, sv_);
        break;
      case What::packet:
        out += io::explain_packet(bits.bytes, bits.bits, direction_, sv_);
        break;
    }
    return {};
  }

  void frame(const io::Bits& bits) {
    std::string block;
    if (options_.what == What::radio) {
      pcapng_->append(block, io::Pcapng::Port::radio, direction_, bits.bytes);
    } else if (options_.what == What::airgap) {
      if (const auto coded = read_airgap(bits.bytes, bits.bits))
        pcapng_->append(block, io::Pcapng::Port::balise, Direction::to_train, coded->received.user_bytes());
    } else {
      pcapng_->append(block, options_.loop ? io::Pcapng::Port::loop : io::Pcapng::Port::balise, Direction::to_train,
                      bits.bytes);
    }
    file_->write(block);
  }

  const DecodeOptions& options_;
  lang::SystemVersion sv_;
  Direction direction_;
  io::Spare spare_;
  io::WholeFile* file_ = nullptr;
  std::optional<io::Pcapng> pcapng_;
};

/// Progress of a long file, on standard error if that is a terminal.
class Share {
 public:
  explicit Share(std::uint64_t bytes) : bytes_(bytes), seen_(bytes > 4'000'000 && line_.is_seen()) {}
  void reach(std::uint64_t done, std::uint64_t lines) {
    if (!seen_) return;
    const int percent = static_cast<int>(100 * done / bytes_);
    if (percent == shown_) return;
    shown_ = percent;
    line_.show(fmt::format("decode [{}] {:3} %  {} lines", io::bar_of(percent / 100.0, 40), percent, lines));
  }

 private:
  std::uint64_t bytes_;
  io::TerminalLine line_;
  bool seen_;
  int shown_ = -1;
};

/// Decodes the lines of a file or pipe in sequence.
int decode_stream(int stream, const std::string& name, Decoder& decoder, io::WholeFile& out) {
  struct stat info {};
  const bool is_file = ::fstat(stream, &info) == 0 && S_ISREG(info.st_mode);
  Share share(is_file ? static_cast<std::uint64_t>(info.st_size) : 0);
  std::string pending, answers;
  std::string chunk(1 << 20, '\0');
  bool all_taken = true;
  std::uint64_t done = 0;
  std::uint64_t lines = 0, telegrams = 0;
  std::optional<std::uint64_t> too_long;
  const auto answer = [&](std::string_view line) {
    ++lines;
    if (line.size() > io::kLongestLine && !too_long) too_long = lines;
    if (too_long) return;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') return;
    ++telegrams;
    all_taken = decoder.line(answers, line, lines) && all_taken;
  };
  for (;;) {
    const ::ssize_t n = ::read(stream, chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      return complain({name, "", std::strerror(errno), "a file that can be read"});
    }
    if (n == 0) break;
    done += static_cast<std::uint64_t>(n);
    std::string_view rest(chunk.data(), static_cast<std::size_t>(n));
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      if (pending.empty()) {
        answer(rest.substr(0, end));
      } else {
        pending.append(rest.substr(0, end));
        answer(pending);
        pending.clear();
      }
      rest.remove_prefix(end + 1);
    }
    pending.append(rest);
    out.write(answers);
    answers.clear();
    if (pending.size() > io::kLongestLine && !too_long) too_long = lines + 1;
    if (too_long) return complain(io::line_too_long(name, *too_long));
    if (!is_file) out.flush();
    share.reach(done, lines);
  }
  answer(pending);
  if (telegrams == 0) {
    return complain({name, "", "nothing", "a line of hexadecimal digits"});
  }
  out.write(answers);
  return all_taken ? 0 : 1;
}

int decode_to(const DecodeOptions& options, Decoder& decoder, io::WholeFile& out) {
  if (options.input == "-") return decode_stream(0, "-", decoder, out);
  const int stream = ::open(options.input.c_str(), O_RDONLY | O_CLOEXEC);
  if (stream >= 0) {
    const int code = decode_stream(stream, options.input, decoder, out);
    ::close(stream);
    return code;
  }
  // Not a file: the digits themselves; a name with "." or "/" is a missing file.
  if (options.input.find_first_of("./") != std::string::npos)
    return complain({options.input, "", std::strerror(errno), "a file that can be read"});
  std::string text;
  const int code = decoder.line(text, options.input) ? 0 : 1;
  out.write(text);
  return code;
}

}  // namespace

int decode(const DecodeOptions& options) {
  const auto sv = io::parse_version(options.sv);
  if (!sv || lang::known_version(*sv) == 0)
    return complain({"--sv", "", options.sv, "a system version 1.Y, 2.Y or 3.Y"});
  Decoder decoder(options, *sv);
  if (options.pcapng.empty()) {
    auto out = io::WholeFile::create(options.output);
    if (!out) return complain(out.error());
    const int code = decode_to(options, decoder, *out);
    if (code == 2) return code;
    const auto done = out->commit();
    return done ? code : complain(done.error());
  }
  if (io::same_file(options.output, options.pcapng))
    return complain({"--pcapng", "", options.pcapng == "-" ? "standard output" : options.pcapng,
                     "another file than the one for JSON or tables (-o)"});
  auto out = io::WholeFile::create(options.output);
  if (!out) return complain(out.error());
  auto trace = io::WholeFile::create(options.pcapng);
  if (!trace) return complain(trace.error());
  decoder.trace(*trace);
  const int code = decode_to(options, decoder, *out);
  if (code == 2) return code;
  const auto done = io::commit_together({&*trace, &*out});
  return done ? code : complain(done.error());
}

}  // namespace evc::language
