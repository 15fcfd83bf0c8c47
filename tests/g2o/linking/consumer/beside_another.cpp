// SPDX-License-Identifier: BSD-3-Clause
// A library with an isolated copy works even if symbols of the same names come first.
extern "C" int foreign_calls();
extern "C" double optimum();

int main() {
  return foreign_calls() == 1 && optimum() > 0 && foreign_calls() == 2 ? 0 : 1;
}
