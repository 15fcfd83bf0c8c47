// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/guard.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "boxplus/base/error.h"
#include "platform/process.h"

namespace boxplus::viewer {
namespace {

/// Compares in a time that does not depend on the position of the first difference.
bool is_same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]));
  return difference == 0;
}

}  // namespace

Guard::Guard(std::string host, int port, std::string token)
    : host_(std::move(host)),
      port_(std::to_string(port)),
      token_(std::move(token)),
      is_loopback_(host_ == "127.0.0.1" || host_ == "localhost" || host_ == "::1"),
      is_any_(host_ == "0.0.0.0" || host_ == "::") {}

bool Guard::knows_host(std::string_view host) const {
  if (is_any_) return true;
  for (const std::string_view name : {std::string_view(host_), std::string_view("127.0.0.1"),
                                      std::string_view("localhost"), std::string_view("[::1]")}) {
    if (host == fmt::format("{}:{}", name, port_)) return true;
    if (port_ == "80" && host == name) return true;  // browsers leave out the usual port
  }
  return host == fmt::format("[{}]:{}", host_, port_);
}

std::optional<Refusal> Guard::check(const RequestFacts& request) const {
  if (!knows_host(request.host)) return Refusal{403, "the request is for another host"};
  if (!request.origin.empty() && request.origin != fmt::format("http://{}", request.host))
    return Refusal{403, "the request comes from another site"};
  const bool is_foreign = request.fetch_site == "cross-site" || request.fetch_site == "same-site";
  if (is_foreign && request.path != "/") return Refusal{403, "the request comes from another site"};
  const bool has_token = is_same(request.header_token, token_) || is_same(request.query_token, token_);
  const bool is_icon = request.method == "GET" && request.path == "/favicon.ico";
  if (!is_loopback_ && !has_token && !is_icon)
    return Refusal{403, "the token is missing or wrong: open the URL that boxplus printed"};
  if (request.method == "GET") return std::nullopt;
  if (request.method != "POST") return Refusal{405, "only GET and POST are possible"};
  if (!is_same(request.header_token, token_)) return Refusal{403, "the token is missing or wrong"};
  const std::string_view type = request.path == "/open" ? "application/octet-stream" : "application/json";
  if (request.content_type != type) return Refusal{415, "the Content-Type is wrong"};
  return std::nullopt;
}

std::string Guard::url() const {
  if (is_any_) {  // not an address to open; others reach the machine by its name
    if (const std::optional<std::string> name = host_name())
      return fmt::format("http://{}:{}/?token={}", *name, port_, token_);
  }
  const std::string host = host_.find(':') == std::string::npos ? host_ : "[" + host_ + "]";
  return is_loopback_ ? fmt::format("http://{}:{}/", host, port_)
                      : fmt::format("http://{}:{}/?token={}", host, port_, token_);
}

std::string make_token() {
  std::array<unsigned char, 16> bytes;
  if (!fill_randomly(bytes)) throw Error("the system has no random numbers for the viewer's token");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace boxplus::viewer
