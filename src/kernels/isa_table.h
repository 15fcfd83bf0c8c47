// SPDX-License-Identifier: BSD-3-Clause
// Included once per instruction set, by isa_….cpp.
#include "kernels/between_lanes.h"
#include "kernels/edge_lanes.h"
#include "kernels/kernel_table.h"
#include "kernels/normal_kernels.h"
#include "kernels/panel_kernels.h"
#include "kernels/run_kernels.h"
#include "kernels/vector_kernels.h"

#define BOXPLUS_TEXT(word) #word
#define BOXPLUS_TEXT_OF(macro) BOXPLUS_TEXT(macro)

namespace boxplus::dense::BOXPLUS_ISA {

const KernelTable kTable{BOXPLUS_TEXT_OF(BOXPLUS_ISA),
                         kNanosecondsPerFlop,
                         factor_panel,
                         set_to_minus_square,
                         subtract_square,
                         subtract_product_transposed,
                         subtract_product,
                         divide_by_transposed,
                         divide_by,
                         solve_forward,
                         solve_backward,
                         gather_runs,
                         scatter_runs,
                         extend_add,
                         normal_products<1>,
                         add_block,
                         add_edges_for,
                         to_lanes,
                         squared_norms,
                         between_se2,
                         between_se3};

}  // namespace boxplus::dense::BOXPLUS_ISA
