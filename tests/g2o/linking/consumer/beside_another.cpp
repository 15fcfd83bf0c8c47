// SPDX-License-Identifier: BSD-3-Clause
// A library that hides its copy of the g2o API works even if the loader finds symbols of the same names in
// another library first.
extern "C" int foreign_calls();
extern "C" double optimum();

int main() {
  return foreign_calls() == 1 && optimum() > 0 && foreign_calls() == 2 ? 0 : 1;
}
