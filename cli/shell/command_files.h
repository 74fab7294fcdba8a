// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "streams.h"

#include <fca/toolkit/files.h>

namespace fca::cli {

/// Files on the disk, standard input, and images as the pictures module decodes them.
class CommandFiles : public Files {
 public:
  explicit CommandFiles(Streams& streams) : streams_(&streams) {}

  [[nodiscard]] std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics) override;

 protected:
  [[nodiscard]] std::optional<text::Source> fetch(const std::string& path, Diagnostics& diagnostics) const override;

 private:
  Streams* streams_;
};

}  // namespace fca::cli
