// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/page.h"

namespace boxplus::viewer {

std::string_view icon_svg() {
  // ⊞
  return R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><path d="M2 2h12v12H2zM8 4v8M4 8h8" )"
         R"(fill="#fff" stroke="#1f5fbf" stroke-width="1.6"/></svg>)";
}

}  // namespace boxplus::viewer
