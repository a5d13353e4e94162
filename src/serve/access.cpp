#include "serve/access.h"

#include <algorithm>

namespace evc::serve {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

bool is_own_host(std::string_view host, std::uint16_t port) {
  for (const std::string name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (same(host, name + ":" + std::to_string(port))) return true;
    if (port == 80 && same(host, name)) return true;  // browsers leave it out
  }
  return false;
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  return same(origin, "http://" + std::string(host));
}

}  // namespace evc::serve
