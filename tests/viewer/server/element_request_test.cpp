// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/element_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "boxplus/base/error.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::viewer {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class ElementRequests : public testing::Test {
 protected:
  void SetUp() override {
    workspace_.show(parse_graph("VERTEX_SE2 0 0 0 0\n"
                                "VERTEX_SE2 1 3 0 0\n"
                                "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n",
                                "small.g2o"),
                    "small.g2o");
  }
  std::string answer(const Parameters& parameters) {
    const ElementRequest request = parse_element_request(parameters);
    return workspace_.describe(request.structure, request.name);
  }
  std::string refusal(const Parameters& parameters) {
    try {
      return "answered: " + answer(parameters);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
  }
  Workspace workspace_;
};

TEST_F(ElementRequests, ForAVertexIsAnsweredWithItsEdges) {
  const Json json = Json::parse(answer({{"structure", "1"}, {"id", "1"}}));
  EXPECT_EQ(json["kind"], "vertex");
  EXPECT_EQ(json["structure"], 1);
  EXPECT_EQ(json["id"], "1");
  EXPECT_EQ(json["vertex"], 1);
  EXPECT_EQ(json["estimate"], "3 0 0");
  EXPECT_EQ(json["edges"][0]["chi2"], 4);
}

TEST_F(ElementRequests, ForALineIsAnsweredWithItsEdge) {
  const Json json = Json::parse(answer({{"structure", "1"}, {"line", "0"}}));
  EXPECT_EQ(json["kind"], "edge");
  EXPECT_EQ(json["vertices"][1]["id"], "1");
  EXPECT_EQ(json["error"], Json({2.0, 0.0, 0.0}));
}

TEST_F(ElementRequests, WithWrongNumbersIsRefusedWithAReason) {
  EXPECT_THAT(refusal({{"id", "1"}}), HasSubstr("expected the number of the structure"));
  EXPECT_THAT(refusal({{"structure", "2"}, {"id", "1"}}), HasSubstr("the graph has changed"));
  EXPECT_THAT(refusal({{"structure", "1"}}), HasSubstr("expected one of"));
  EXPECT_THAT(refusal({{"structure", "1"}, {"id", "1"}, {"line", "0"}}), HasSubstr("only one of"));
  for (const char* number : {"-1", "1x", "", " 1", "1.0", "99999999999999999999"})
    EXPECT_THAT(refusal({{"structure", "1"}, {"vertex", number}}), HasSubstr("vertex: expected a number"));
  EXPECT_THAT(refusal({{"structure", "1"}, {"vertex", "2"}}), HasSubstr("expected a number below 2, got 2"));
}

TEST_F(ElementRequests, IsRefusedWithoutAGraph) {
  Workspace empty;
  EXPECT_THROW(std::ignore = empty.describe(0, {ElementName::Kind::kVertex, 0}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus::viewer
