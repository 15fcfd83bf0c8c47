// SPDX-License-Identifier: BSD-3-Clause
// Feeds requests to the viewer's guard and to the parsers of commands and of queries. They may only refuse.
// Laws: without the token, no request may change or read the graph; no other host or origin is served.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "boxplus/base/error.h"
#include "viewer/server/command.h"
#include "viewer/server/element_request.h"
#include "viewer/server/guard.h"

namespace {

using boxplus::InvalidArgument;
using boxplus::viewer::Guard;
using boxplus::viewer::Parameters;
using boxplus::viewer::RequestFacts;

constexpr std::string_view kToken = "0123456789abcdef0123456789abcdef";

/// The input as lines. Missing lines are empty.
std::array<std::string_view, 8> lines_of(std::string_view text) {
  std::array<std::string_view, 8> lines;
  for (std::string_view& line : lines) {
    const std::size_t end = text.find('\n');
    line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

void require(bool law) {
  if (!law) std::abort();
}

void check_guard(const std::array<std::string_view, 8>& lines) {
  const RequestFacts request{.method = lines[0],
                             .path = lines[1],
                             .host = lines[2],
                             .origin = lines[3],
                             .fetch_site = lines[4],
                             .content_type = lines[5],
                             .header_token = lines[6],
                             .query_token = lines[7]};
  for (const char* const host : {"127.0.0.1", "0.0.0.0", "192.168.1.2"}) {
    const Guard guard(host, 8743, std::string(kToken));
    if (guard.check(request)) continue;
    const bool has_token = request.header_token == kToken || request.query_token == kToken;
    const bool is_icon = request.method == "GET" && request.path == "/favicon.ico";
    require(has_token || guard.is_loopback() || is_icon);
    require(request.method != "POST" || request.header_token == kToken);
    require(!guard.is_loopback() || request.host.ends_with(":8743"));
    require(request.origin.empty() || request.origin == "http://" + std::string(request.host));
  }
}

template <class F>
void may_refuse(F&& parse) {
  try {
    parse();
  } catch (const InvalidArgument&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto lines = lines_of(text);
  check_guard(lines);
  may_refuse([&] { boxplus::viewer::parse_command(text); });
  Parameters parameters;
  for (std::size_t k = 0; k + 1 < lines.size(); k += 2) parameters.emplace(lines[k], lines[k + 1]);
  may_refuse([&] { boxplus::viewer::parse_element_request(parameters); });
  return 0;
}
