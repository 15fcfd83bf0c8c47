// SPDX-License-Identifier: BSD-3-Clause
#include "io/vrml/vrml_format.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(VrmlFormat, HasPointsAndTheLinesOfEdges) {
  const std::string text =
      format_graph(parse_graph("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0.5 0\nVERTEX_XY 2 3 4\n"
                               "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2_XY 1 2 1 1 1 0 1\n"
                               "EDGE_PRIOR_SE2 0 0 0 0 1 0 0 1 0 1\n",
                               "g"),
                   {.format = "VRML"});
  EXPECT_EQ(text,
            "#VRML V2.0 utf8\n# a graph, written by boxplus\n"
            "Shape {\n geometry PointSet {\n  coord DEF positions Coordinate { point [\n"
            "0 0 0,\n1 0.5 0,\n3 4 0,\n"
            "  ] }\n  color Color { color [\n"
            "0.851 0.282 0.0588,\n0.851 0.282 0.0588,\n0.541 0.576 0.639,\n"
            "  ] }\n }\n}\n"
            "Shape {\n appearance Appearance { material Material { emissiveColor 0.4 0.45 0.5 } }\n"
            " geometry IndexedLineSet {\n  coord USE positions\n  coordIndex [\n"
            "0 1 -1,\n1 2 -1,\n"
            "  ]\n }\n}\n");
}

TEST(VrmlFormat, HasCamerasAsPyramidsInsteadOfTheLinesOfEdges) {
  const std::string text = format_graph(read_model_texts({}), {.format = "VRML"});
  EXPECT_THAT(text, HasSubstr("emissiveColor 0.85 0.28 0.06"));
  EXPECT_THAT(text, HasSubstr("3 4 -1,\n3 5 -1,\n3 6 -1,\n3 7 -1,\n4 5 -1,\n")) << "after three points";
  EXPECT_THAT(text, Not(HasSubstr("emissiveColor 0.4 0.45 0.5")));
}

TEST(VrmlFormat, CannotBeReadNorShowAGraphWithoutPositions) {
  EXPECT_THAT(complaint_of([] { parse_graph("#VRML V2.0 utf8\n", "g"); }),
              EndsWith("got VRML's .wrl, which boxplus can only write"));
  EXPECT_THAT(complaint_of([] { format_graph(Graph{}, {.format = "VRML"}); }),
              HasSubstr("cannot write VRML's .wrl: expected poses or points"));
}

}  // namespace
}  // namespace boxplus
