// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program: it begins in the locale of its environment, as programs with a user interface do.
#include <clocale>
#include <iostream>
#include <locale>

namespace {

const bool kSwitched = [] {
  static const std::ios_base::Init streams;  // they must be there before they get another locale
  std::setlocale(LC_ALL, "");
  std::locale::global(std::locale(""));
  return true;
}();

}  // namespace
