// SPDX-License-Identifier: BSD-3-Clause
// Which requests the server accepts. Any web page that a user visits can send requests to 127.0.0.1; the
// checks here keep such pages out. They do not keep out other users of the same machine, unless the server
// listens at another address than the loopback.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace boxplus::viewer {

/// The parts of a request that decide whether it is accepted. Absent headers are empty.
struct RequestFacts {
  std::string_view method = {}, path = {}, host = {}, origin = {};
  std::string_view fetch_site = {};  ///< Sec-Fetch-Site: who sends the request, as the browser says
  std::string_view content_type = {};
  std::string_view header_token = {};  ///< the header X-Boxplus-Token
  std::string_view query_token = {};   ///< ?token=…
};

struct Refusal {
  int status;        ///< of HTTP
  const char* text;  ///< one sentence for people
};

class Guard {
 public:
  /// `host` is the address at which the server listens. If it is not a loopback address, every request needs
  /// the token.
  Guard(std::string host, int port, std::string token);

  /// Returns nothing if the request is accepted.
  ///
  /// - Host must be the server's own, so that another name that resolves to this machine (DNS rebinding) does
  ///   not work. If the server listens at all addresses, any Host is accepted, because the token protects it.
  /// - Origin, if present, must be the server's own. Other sites may only link to the page itself.
  /// - POST needs the token and JSON as its type (/open: bytes), which no form and no other origin can send.
  std::optional<Refusal> check(const RequestFacts& request) const;

  const std::string& token() const { return token_; }
  bool is_loopback() const { return is_loopback_; }
  /// The URL to open, with the token if it is needed.
  std::string url() const;

 private:
  bool knows_host(std::string_view host) const;

  std::string host_, port_, token_;
  bool is_loopback_, is_any_;
};

/// Returns 32 hexadecimal digits from the system's source of random numbers. Throws Error if there is none.
std::string make_token();

}  // namespace boxplus::viewer
