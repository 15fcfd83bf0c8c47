// SPDX-License-Identifier: BSD-3-Clause
// The table of the library's formats.
#include "boxplus/io/file_format.h"
#include "io/bal/bal_format.h"
#include "io/carmen/carmen_format.h"
#include "io/colmap/colmap_format.h"
#include "io/g2o/g2o_format.h"
#include "io/gm2dl/gm2dl_format.h"
#include "io/gnuplot/gnuplot_format.h"
#include "io/isam/isam_format.h"
#include "io/json/json_format.h"
#include "io/ply/ply_format.h"
#include "io/toro/toro_format.h"
#include "io/vrml/vrml_format.h"

namespace boxplus {

const FileFormats& default_formats() {
  static const FileFormats formats = [] {
    FileFormats all;
    all.add(g2o_format());
    all.add(toro_format());
    all.add(gm2dl_format());
    all.add(carmen_format());
    all.add(isam_format());
    all.add(bal_format());
    all.add(colmap_format());
    all.add(colmap_text_format());
    all.add(json_format());
    all.add(gnuplot_format());
    all.add(vrml_format());
    all.add(ply_format());
    return all;
  }();
  return formats;
}

}  // namespace boxplus
