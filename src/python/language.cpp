#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "io/telegram_explain.h"
#include "io/telegram_json.h"
#include "language/airgap.h"
#include "language/describe.h"
#include "python/bind.h"
#include "python/values.h"

// `evc decode`, `evc encode` and `evc describe`.
namespace evc::python {
namespace {

enum class Form : std::uint8_t { balise, loop, airgap, radio, packet };

lang::Direction direction_of(const py::object& name) {
  const Argument argument(name, "arguments", "direction");
  return argument.place().one_of({"to_train", "to_track"}) == 0 ? lang::Direction::to_train : lang::Direction::to_track;
}

bool flag_of(const py::object& flag, const char* name) { return Argument(flag, "arguments", name).place().boolean(); }

lang::SystemVersion version_of(const py::object& version) {
  const Argument argument(version, "arguments", "sv");
  const std::string text = argument.place().string();
  const auto sv = io::parse_version(text);
  if (!sv || lang::known_version(*sv) == 0)
    throw io::ReadError{{"arguments", "/sv", "\"" + text + "\"", "a system version 1.Y, 2.Y or 3.Y"}};
  return *sv;
}

template <class T>
T accepted(tl::expected<T, io::TelegramError> result) {
  if (!result) throw LanguageError{std::move(result.error())};
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

py::object decode(Form form, const std::string& hex, const py::object& direction, const py::object& sv,
                  const py::object& tolerant) {
  const lang::Direction towards = direction_of(direction);
  const lang::SystemVersion version = version_of(sv);
  const io::Bits bits = accepted(io::bits_of_hex(hex));
  const io::Spare spare = flag_of(tolerant, "tolerant") ? io::Spare::accept : io::Spare::refuse;
  std::string json;
  switch (form) {
    case Form::balise:
      accepted(io::append_balise_json(json, bits.bytes, bits.bits, spare));
      break;
    case Form::loop:
      accepted(io::append_loop_json(json, bits.bytes, bits.bits, spare));
      break;
    case Form::airgap:
      accepted(language::append_airgap_json(json, bits.bytes, bits.bits, spare));
      break;
    case Form::radio:
      accepted(io::append_radio_json(json, bits.bytes, towards, version, spare));
      break;
    case Form::packet:
      accepted(io::append_packet_json(json, bits.bytes, bits.bits, towards, version, spare));
      break;
  }
  return object_of(json);
}

std::string encode(Form form, const py::object& telegram, const py::object& direction, const py::object& sv) {
  const io::Json json = json_of(telegram, "telegram");
  io::EncodeOptions how;
  if (!direction.is_none()) how.direction = direction_of(direction);
  if (!sv.is_none()) how.sv = version_of(sv);
  io::Bits bits;
  switch (form) {
    case Form::balise:
      bits = accepted(io::encode_balise_json(json));
      break;
    case Form::loop:
      bits = accepted(io::encode_loop_json(json));
      break;
    case Form::airgap:
      bits = accepted(language::encode_airgap_json(json));
      break;
    case Form::radio:
      bits = accepted(io::encode_radio_json(json, how));
      break;
    case Form::packet:
      bits = accepted(io::encode_packet_json(json, how));
      break;
  }
  return io::hex_of_bits(bits.bytes, bits.bits);
}

language::DescribeOptions options_of(const py::object& id, const py::object& direction, const py::object& markdown) {
  language::DescribeOptions options;
  options.id = Argument(id, "arguments", "name").place().string();
  options.markdown = flag_of(markdown, "markdown");
  if (!direction.is_none())
    (direction_of(direction) == lang::Direction::to_train ? options.to_train : options.to_track) = true;
  return options;
}

}  // namespace

void bind_language(py::module_& module) {
  py::enum_<Form>(module, "Form")
      .value("balise", Form::balise)
      .value("loop", Form::loop)
      .value("airgap", Form::airgap)
      .value("radio", Form::radio)
      .value("packet", Form::packet);
  module.def("decode", decode);
  module.def("encode", encode);
  using Text = io::Result<std::string> (*)(const language::DescribeOptions&);
  const auto describe = [&module](const char* name, Text text) {
    module.def(name, [text](const py::object& id, const py::object& direction, const py::object& markdown) {
      return value_of(text(options_of(id, direction, markdown)));
    });
  };
  describe("describe_packets", language::packets_text);
  describe("describe_messages", language::messages_text);
  describe("describe_variables", language::variables_text);
  module.def("describe_schema", [] { return object_of(io::telegram_schema()); });
}

}  // namespace evc::python
