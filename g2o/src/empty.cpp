// SPDX-License-Identifier: BSD-3-Clause
// The only source of libraries that exist for compatibility with g2o's names.
