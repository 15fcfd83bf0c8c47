// SPDX-License-Identifier: BSD-3-Clause
// A header of the client that has the name of a header of g2o.
#pragma once

struct ClientCache {
  int size = 3;
};
