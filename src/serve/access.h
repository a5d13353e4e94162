#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace evc::serve {

/// Whether the `Host` of a request is a name of this server: a name of a foreign site may be given the address of the
/// loopback interface by its owner, and the page of that site would then count as ours.
bool is_own_host(std::string_view host, std::uint16_t port);

/// Whether a page of this `Origin` is the one that this server gives at that own `Host`.
bool is_own_origin(std::string_view origin, std::string_view host);

}  // namespace evc::serve
