// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/server/access.h"
#include "app/server/http_library.h"
#include "app/server/query.h"

namespace hydroscope {

/// What a request asks for: its address in parts.
struct RequestTarget {
  std::string path;   ///< decoded
  std::string query;  ///< as sent
};

/// Throws InputError for an address that is too long, broken, or no path.
RequestTarget split_target(const std::string& target);

RequestFacts make_facts(const httplib::Request& request, const RequestTarget& target);

/// A short page or JSON that says why not.
void refuse(const Refusal& refusal, bool is_page, httplib::Response& response);

}  // namespace hydroscope
