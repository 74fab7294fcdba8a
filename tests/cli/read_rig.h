// SPDX-License-Identifier: BSD-3-Clause
// What our own reader reads from a file that the program wrote.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>

#include <string>

#include <gtest/gtest.h>

namespace fca::test {

inline Rig rig_in(const std::string& bytes) {
  Diagnostics diagnostics;
  std::optional<text::Document> document = text::parse_document({"output", bytes}, diagnostics);
  std::optional<Calibration> calibration;
  if (document) calibration = read_calibration({*std::move(document)}, nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration) << bytes;
  return calibration ? calibration->rig : Rig();
}

}  // namespace fca::test
