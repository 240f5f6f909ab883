// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/access.h"

#include <arpa/inet.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::string to_lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// "name:port" in two; brackets of an IPv6 address stay with the name.
struct Authority {
  std::string name, port;
};

std::optional<Authority> split_authority(const std::string& text) {
  const std::size_t bracket = text.find(']');
  if ((text.rfind('[', 0) == 0) != (bracket != std::string::npos)) return std::nullopt;
  const std::size_t from = bracket == std::string::npos ? 0 : bracket + 1;
  const std::size_t colon = text.find(':', from);
  if (colon == std::string::npos)
    return from == 0 || from == text.size() ? std::optional(Authority{text, ""}) : std::nullopt;
  if (from > 0 && colon != from) return std::nullopt;
  return Authority{text.substr(0, colon), text.substr(colon + 1)};
}

bool is_address(std::string name) {
  std::array<unsigned char, 16> bytes{};
  if (inet_pton(AF_INET, name.c_str(), bytes.data()) == 1) return true;
  if (name.size() < 2 || name.front() != '[' || name.back() != ']') return false;
  name = name.substr(1, name.size() - 2);
  return inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1;
}

bool is_own_host(const AccessRules& rules, const std::string& text) {
  const std::optional<Authority> host = split_authority(to_lower(text));
  if (!host) return false;
  if (host->port != std::to_string(rules.port) && !(host->port.empty() && rules.port == 80)) return false;
  for (const char* name : {"127.0.0.1", "localhost", "[::1]"})
    if (host->name == name) return true;
  if (std::find(rules.hosts.begin(), rules.hosts.end(), host->name) != rules.hosts.end()) return true;
  return rules.any_address && is_address(host->name);
}

}  // namespace

std::string make_token() {
  std::array<unsigned char, 20> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw EnvironmentError("the system gives no random numbers for the token");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

bool is_equal_secret(std::string_view a, std::string_view b) {
  if (b.empty()) return false;
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |=
        static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i % b.size()]));
  return difference == 0;
}

std::string cookie_name(int port) { return "hydroscope_" + std::to_string(port); }

std::string find_cookie(const std::vector<std::string>& headers, const std::string& name) {
  for (const std::string& header : headers) {
    std::size_t from = 0;
    while (from < header.size()) {
      const std::size_t end = std::min(header.find(';', from), header.size());
      const std::size_t start = std::min(header.find_first_not_of(' ', from), end);
      const std::string pair = header.substr(start, end - start);
      if (pair.rfind(name + "=", 0) == 0) return pair.substr(name.size() + 1);
      from = end + 1;
    }
  }
  return "";
}

std::optional<Refusal> check_place(const AccessRules& rules, const RequestFacts& facts) {
  if (facts.hosts.size() != 1) return Refusal{400, "a request needs one Host header"};
  const std::string& host = facts.hosts.front();
  if (!is_own_host(rules, host))
    return Refusal{421, "this server does not answer to the name '" + host + "'"};
  for (const std::string& origin : facts.origins)
    if (to_lower(origin) != "http://" + to_lower(host))
      return Refusal{403, "requests from pages of another origin are refused"};
  const std::string& site = facts.fetch_site;
  if (!facts.is_page && !site.empty() && site != "same-origin" && site != "none")
    return Refusal{403, "requests from pages of another origin are refused"};
  return std::nullopt;
}

bool has_token(const AccessRules& rules, const RequestFacts& facts) {
  const std::string bearer = "Bearer ";
  if (facts.authorization.rfind(bearer, 0) == 0 &&
      is_equal_secret(facts.authorization.substr(bearer.size()), rules.token))
    return true;
  if (facts.is_page && facts.url_token && is_equal_secret(*facts.url_token, rules.token)) return true;
  return is_equal_secret(find_cookie(facts.cookies, cookie_name(rules.port)), rules.token);
}

}  // namespace hydroscope
