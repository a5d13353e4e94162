#include "io/json_pointer.h"

#include <charconv>

#include "io/json.h"

namespace evc::io {

std::vector<std::string> tokens_of(const std::string& pointer) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/')
      tokens.emplace_back();
    else if (pointer[i] == '~' && i + 1 < pointer.size())
      tokens.back() += pointer[++i] == '1' ? '/' : '~';
    else
      tokens.back() += pointer[i];
  }
  return tokens;
}

std::string pointer_of(const std::vector<std::string>& tokens, std::size_t count) {
  std::string pointer;
  for (std::size_t i = 0; i < count; ++i) pointer += "/" + reference_token(tokens[i]);
  return pointer;
}

std::size_t index_of(const std::string& token) {
  std::size_t index = kNoIndex;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  const bool whole = error == std::errc{} && end == token.data() + token.size();
  return whole && (token.size() == 1 || token.front() != '0') ? index : kNoIndex;
}

}  // namespace evc::io
