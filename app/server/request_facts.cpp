// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/request_facts.h"

#include "app/server/api_json.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr std::size_t kLongestPath = 512;

std::vector<std::string> list_header(const httplib::Request& request, const std::string& name) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < request.get_header_value_count(name); ++i)
    values.push_back(request.get_header_value(name, i));
  return values;
}

std::string escape_html(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else
      escaped += c;
  }
  return escaped;
}

std::optional<std::string> find_url_token(const RequestTarget& target) {
  try {
    const Query query = Query::parse(target.query);
    return query.has("token") ? std::optional(query.text("token")) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

RequestTarget split_target(const std::string& target) {
  const std::size_t mark = std::min(target.find('?'), target.size());
  if (mark > kLongestPath) throw InputError("the address is too long");
  if (target.empty() || target.front() != '/') throw InputError("the address is no path");
  RequestTarget parts{decode_url(target.substr(0, mark), false), ""};
  if (mark < target.size()) parts.query = target.substr(mark + 1);
  return parts;
}

RequestFacts make_facts(const httplib::Request& request, const RequestTarget& target) {
  RequestFacts facts;
  facts.hosts = list_header(request, "Host");
  facts.origins = list_header(request, "Origin");
  facts.fetch_site = request.get_header_value("Sec-Fetch-Site");
  facts.cookies = list_header(request, "Cookie");
  facts.authorization = request.get_header_value("Authorization");
  facts.is_page = target.path == "/";
  if (facts.is_page) facts.url_token = find_url_token(target);
  return facts;
}

void refuse(const Refusal& refusal, bool is_page, httplib::Response& response) {
  response.status = refusal.status;
  if (is_page) {
    response.set_content(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Hydroscope</title>"
        "<h1>No entry</h1><p>" +
            escape_html(refusal.text) + "</p></html>\n",
        "text/html; charset=utf-8");
  } else {
    response.set_content(to_line(make_error_json(refusal.text)), "application/json");
  }
}

}  // namespace hydroscope
