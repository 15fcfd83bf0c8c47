// SPDX-License-Identifier: BSD-3-Clause
// A library with a copy that keeps to its own works beside symbols of the same names that come first.
extern "C" int foreign_calls();
extern "C" double optimum();

int main() {
  return foreign_calls() == 1 && optimum() > 0 && foreign_calls() == 2 ? 0 : 1;
}
