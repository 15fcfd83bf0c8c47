// SPDX-License-Identifier: BSD-3-Clause
// The only source file of the empty libraries. The empty libraries exist because clients link libraries with
// these names.
