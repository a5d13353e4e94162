// A balise telegram to JSON and back, with openevc::language alone.
#include <openevc/language.h>

#include <cstdio>

namespace language = evc::language;

int main(int argc, char** argv) {
  const char* hex = argc > 1 ? argv[1] : "A1027F802015505023A0E0D480C8087F8";
  const language::Bits bits = language::bits_of_hex(hex);
  if (bits.error) {
    std::printf("bit %zu: %s\n", bits.error->bit, bits.error->why.c_str());
    return 2;
  }
  const language::Text text = language::decode(bits.bytes, bits.size, {});
  if (text.error) {
    std::printf("bit %zu, packet %d, %s: %s\n", text.error->bit, text.error->packet, text.error->variable.c_str(),
                text.error->why.c_str());
    return 1;
  }
  std::printf("%s\n", text.json.c_str());
  const language::Bits again = language::encode(text.json, {});
  std::printf("%s\n", language::hex_of_bits(again.bytes, again.size).c_str());
  return again.bytes == bits.bytes ? 0 : 1;
}
