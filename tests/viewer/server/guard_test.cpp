// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boxplus::viewer {
namespace {

using testing::HasSubstr;

/// The status of the answer: 200 if the guard accepts the request.
int status_of(const Guard& guard, const RequestFacts& request) {
  const std::optional<Refusal> refusal = guard.check(request);
  return refusal ? refusal->status : 200;
}

RequestFacts get(std::string_view host) {
  return {.method = "GET", .path = "/", .host = host};
}

RequestFacts post(std::string_view token) {
  return {.method = "POST",
          .path = "/command",
          .host = "127.0.0.1:8080",
          .content_type = "application/json",
          .header_token = token};
}

TEST(Guard, AcceptsTheNamesOfTheLoopbackWithItsPort) {
  const Guard guard("127.0.0.1", 8080, "secret");
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "[::1]:8080"})
    EXPECT_EQ(status_of(guard, get(host)), 200) << host;
  for (const char* host :
       {"", "127.0.0.1", "127.0.0.1:81", "evil.example:8080", "127.0.0.1:8080.evil.example"})
    EXPECT_EQ(status_of(guard, get(host)), 403) << host;
}

TEST(Guard, KnowsThatBrowsersLeaveOutTheUsualPort) {
  const Guard guard("127.0.0.1", 80, "secret");
  EXPECT_EQ(status_of(guard, get("127.0.0.1")), 200);
  EXPECT_EQ(status_of(guard, get("evil.example")), 403);
}

TEST(Guard, LetsOtherSitesOnlyLinkToThePage) {
  const Guard guard("127.0.0.1", 8080, "secret");
  RequestFacts request = get("127.0.0.1:8080");
  request.fetch_site = "cross-site";
  EXPECT_EQ(status_of(guard, request), 200);
  request.path = "/stream";
  EXPECT_EQ(status_of(guard, request), 403);
}

TEST(Guard, AcceptsOnlyItsOwnOrigin) {
  const Guard guard("127.0.0.1", 8080, "secret");
  RequestFacts request = get("localhost:8080");
  request.origin = "http://localhost:8080";
  EXPECT_EQ(status_of(guard, request), 200);
  for (const char* origin :
       {"null", "http://127.0.0.1:8080", "https://localhost:8080", "http://evil.example"}) {
    request.origin = origin;
    EXPECT_EQ(status_of(guard, request), 403) << origin;
  }
}

TEST(Guard, AcceptsCommandsOnlyWithTheTokenInTheHeader) {
  const Guard guard("127.0.0.1", 8080, "secret");
  EXPECT_EQ(status_of(guard, post("secret")), 200);
  for (const char* token : {"", "secre", "secret!", "terces"}) EXPECT_EQ(status_of(guard, post(token)), 403);
  RequestFacts request = post("");
  request.query_token = "secret";
  EXPECT_EQ(status_of(guard, request), 403);
  request = post("secret");
  request.content_type = "application/x-www-form-urlencoded";
  EXPECT_EQ(status_of(guard, request), 415);
}

TEST(Guard, AsksForTheTokenInEveryRequestIfOtherMachinesCanSendThem) {
  for (const char* host : {"0.0.0.0", "192.0.2.7"}) {
    const Guard guard(host, 8080, "secret");
    RequestFacts request = get("192.0.2.7:8080");
    EXPECT_EQ(status_of(guard, request), 403);
    request.query_token = "secret";
    EXPECT_EQ(status_of(guard, request), 200);
    EXPECT_THAT(guard.url(), HasSubstr("/?token=secret"));
  }
}

TEST(Token, IsLongAndDifferentEachTime) {
  EXPECT_EQ(make_token().size(), 32U);
  EXPECT_NE(make_token(), make_token());
}

}  // namespace
}  // namespace boxplus::viewer
