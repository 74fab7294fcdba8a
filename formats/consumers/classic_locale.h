// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clocale>  // and POSIX's newlocale and uselocale

namespace fca::consumers {

/// While it lives, the calling thread's scanf, strtod and printf know decimal points and no commas.
class ClassicLocale {
 public:
  ClassicLocale() : classic_(::newlocale(LC_ALL_MASK, "C", nullptr)), before_(::uselocale(classic_)) {}
  ~ClassicLocale() {
    ::uselocale(before_);
    ::freelocale(classic_);
  }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  locale_t classic_;
  locale_t before_;
};

}  // namespace fca::consumers
