#pragma once
#include <cstddef>
#include <string>
#include <vector>

// JSON pointers (RFC 6901) as lists of their tokens, unescaped.
namespace evc::io {

std::vector<std::string> tokens_of(const std::string& pointer);
/// The pointer of the first `count` tokens.
std::string pointer_of(const std::vector<std::string>& tokens, std::size_t count);

/// The token of no element of a list.
inline constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);
/// A token as the index of a list: digits without leading zeros; kNoIndex for another one.
std::size_t index_of(const std::string& token);

}  // namespace evc::io
