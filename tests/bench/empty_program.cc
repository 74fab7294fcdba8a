// SPDX-License-Identifier: BSD-3-Clause
// A C++ program that does nothing, but with the library that every one loads: the unit in which process_bench.cc counts.
#include <iostream>

int main() {
  std::cout.flush();
  return 0;
}
