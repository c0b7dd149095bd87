// Header: runtime/live/access.hpp. Test: tests/runtime/live/access_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/access.hpp"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace director::live {

namespace {

/// The host without the port, and without the brackets of an IPv6 address; nothing: it is invalid.
std::optional<std::string> name_in(std::string_view host) {
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos || (end + 1 < host.size() && host[end + 1] != ':')) return std::nullopt;
    return std::string(host.substr(1, end - 1));
  }
  const std::size_t end = std::min(host.find(':'), host.size());
  if (host.find(':', end + 1) != std::string_view::npos && end != host.size()) return std::nullopt;
  return std::string(host.substr(0, end));
}

bool is_address(const std::string& name) {
  std::array<unsigned char, 16> bytes{};
  return inet_pton(AF_INET, name.c_str(), bytes.data()) == 1 || inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1;
}

bool same_name(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other,
                            [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

} // namespace

std::optional<std::string> new_token() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::array<unsigned char, 16> bits{};
  if (getrandom(bits.data(), bits.size(), 0) != static_cast<ssize_t>(bits.size())) return std::nullopt;
  std::string out;
  for (const unsigned char byte : bits) {
    out += digits[byte >> 4];
    out += digits[byte & 15];
  }
  return out;
}

bool is_token(std::string_view given, std::string_view token) {
  unsigned differ = given.size() == token.size() ? 0U : 1U;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const char letter = i < given.size() ? given[i] : '\0';
    differ |= static_cast<unsigned>(static_cast<unsigned char>(letter ^ token[i]));
  }
  return differ == 0;
}

bool is_own_host(std::string_view host, std::span<const std::string> names) {
  const std::optional<std::string> name = name_in(host);
  if (!name || name->empty()) return false;
  return is_address(*name) || same_name(*name, "localhost") ||
         std::ranges::any_of(names, [&](const std::string& own) { return same_name(*name, own); });
}

std::vector<std::string> own_names() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return {};
  return {name.data(), std::string(name.data()) + ".local"};
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  return origin.empty() || (origin.starts_with("http://") && same_name(origin.substr(7), host));
}

} // namespace director::live
