// SPDX-License-Identifier: BSD-3-Clause
// The page, which is compiled into the library.
#pragma once

#include <string_view>

namespace boxplus::viewer {

/// One HTML file, compressed with gzip (viewer/page/dist/page.html.gz).
std::string_view page_html_gz();
std::string_view icon_svg();

}  // namespace boxplus::viewer
