// SPDX-License-Identifier: Apache-2.0
// Where the web server listens, and which names a request may have for it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace web {

struct Address {
  std::string host;  // without the brackets of an IPv6 address
  std::uint16_t port{};
  bool operator==(const Address&) const = default;
};

inline constexpr std::uint16_t usual_port = 5080;

// HOST, HOST:PORT or :PORT, an IPv6 address in brackets where a port follows; without one it is
// `port`. Port 0: any free one. Throws std::runtime_error.
Address address_of(std::string_view text, std::uint16_t port = usual_port);
// Only programs of this machine reach it.
bool is_loopback(std::string_view host);
// Of a URL: with brackets where they are needed.
std::string written(const Address& address);

// Whether the name that a request has in its Host header is this server's: an address, localhost or
// one of `names`. Another one comes from a page whose name was pointed here (DNS rebinding).
bool is_own_name(std::string_view host_header, const std::vector<std::string>& names);

}  // namespace web
