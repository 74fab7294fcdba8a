// SPDX-License-Identifier: BSD-3-Clause
#pragma once

extern "C" [[gnu::weak]] void __asan_init();  // NOLINT(bugprone-reserved-identifier)

namespace fca::test {

/// Is what is tested built with AddressSanitizer? Asked where it is linked: a test's own object may be without.
inline bool is_sanitized() { return &__asan_init != nullptr; }

}  // namespace fca::test
