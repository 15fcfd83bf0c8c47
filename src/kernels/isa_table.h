// SPDX-License-Identifier: BSD-3-Clause
// Defines the table of the kernels for one instruction set. Each isa_*.cpp includes this file once.
#include "kernels/between_lanes.h"
#include "kernels/coupling_lanes.h"
#include "kernels/edge_lanes.h"
#include "kernels/elimination_kernels.h"
#include "kernels/kernel_table.h"
#include "kernels/normal_kernels.h"
#include "kernels/panel_kernels.h"
#include "kernels/run_kernels.h"
#include "kernels/unary_kernels.h"
#include "kernels/vector_kernels.h"

#define BOXPLUS_TEXT(word) #word
#define BOXPLUS_TEXT_OF(macro) BOXPLUS_TEXT(macro)

namespace boxplus::dense::BOXPLUS_ISA {

template <class Scalar>
constexpr FactorKernels<Scalar> kFactorKernels{factor_panel<Scalar>,     set_to_minus_square<Scalar>,
                                               subtract_square<Scalar>,  subtract_product_transposed<Scalar>,
                                               subtract_product<Scalar>, divide_by_transposed<Scalar>,
                                               divide_by<Scalar>,        solve_forward<Scalar>,
                                               solve_backward<Scalar>,   gather_runs<Scalar>,
                                               scatter_runs<Scalar>,     add_runs<Scalar>,
                                               extend_add<Scalar>};

const KernelTable kTable{BOXPLUS_TEXT_OF(BOXPLUS_ISA),
                         kNanosecondsPerFlop,
                         kFactorKernels<double>,
                         kFactorKernels<float>,
                         normal_products,
                         add_block,
                         add_edges_for,
                         subtract_coupling_for,
                         add_unary_edges_for,
                         to_lanes,
                         squared_norms_for,
                         between_se2,
                         between_se3,
                         elimination_kernels_for};

}  // namespace boxplus::dense::BOXPLUS_ISA
