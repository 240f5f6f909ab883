// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hydroscope {

/// Who may ask the server for anything.
struct AccessRules {
  std::string token;               ///< secret of this start of the server
  int port = 0;                    ///< where it listens
  std::vector<std::string> hosts;  ///< names besides 127.0.0.1, localhost and [::1], in lower case
  bool any_address = false;        ///< it listens everywhere: any numeric address may be its name
};

/// What of a request decides whether it may pass.
struct RequestFacts {
  std::vector<std::string> hosts;        ///< values of all Host headers
  std::vector<std::string> origins;      ///< of all Origin headers
  std::string fetch_site;                ///< Sec-Fetch-Site, empty when there is none
  std::vector<std::string> cookies;      ///< of all Cookie headers
  std::string authorization;             ///< of the header; empty when there is none
  std::optional<std::string> url_token;  ///< `token` of the query
  bool is_page = false;                  ///< the page itself, which a user may come to from anywhere
};

struct Refusal {
  int status = 403;  ///< HTTP
  std::string text;  ///< for people
};

/// 160 bits from the system's random source, as 40 hexadecimal digits. Throws EnvironmentError.
std::string make_token();

/// Takes as long for any two texts of these lengths.
bool is_equal_secret(std::string_view a, std::string_view b);

/// Name of the cookie that carries the token; cookies know no ports, so that the name has to.
std::string cookie_name(int port);

/// Value of a cookie in Cookie headers; empty when it is not there.
std::string find_cookie(const std::vector<std::string>& headers, const std::string& name);

/// Host and Origin: keeps pages of other places, and names that were made to point here, out.
std::optional<Refusal> check_place(const AccessRules& rules, const RequestFacts& facts);

/// Cookie or `Authorization: Bearer`; the query's token only counts for the page.
bool has_token(const AccessRules& rules, const RequestFacts& facts);

}  // namespace hydroscope
