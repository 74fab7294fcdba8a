// SPDX-License-Identifier: BSD-3-Clause
// Parts of the command that most of its runs do not need, and whose libraries take long to load.
#pragma once

#include <fca/formats/consumers/missing_module.h>

#include <string>

namespace fca::consumers {

/// Loads a module, never to be unloaded, and calls its function of that name, which has no arguments and returns a pointer to
/// what the module offers. `path`: from the folder of the command. Throws MissingModule, which says `what` the module does, a
/// clause ("which makes pictures"). In the command alone; the library is whole.
[[nodiscard]] const void* load_module(const std::string& path, const char* function, const Message& what);

}  // namespace fca::consumers
