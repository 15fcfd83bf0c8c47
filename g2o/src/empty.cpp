// SPDX-License-Identifier: BSD-3-Clause
// The source of libraries that exist for their names.
