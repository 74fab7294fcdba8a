// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "seeded_files.h"

namespace fca::test {
namespace {

// Changing the number at a fact's place, and nothing else, changes the fact.
TEST(Places, HoldTheNumberOfTheFact) {
  int checked_places = 0;
  for (const Good& good : all_good()) {
    const text::Document& document = good.calibration.documents.front();
    const Places places(document, good.calibration);
    for (const Camera& camera : good.calibration.rig.cameras) {
      for (const ParameterId name : ParameterIds{"fx", "cy"}) {
        const std::optional<double> value = parameter(camera.model, name);
        if (!value) continue;
        const SourceRange where = places.parameter(camera, name);
        if (where.length == 0) continue;
        text::Document changed = document;
        const bool binary = document.syntax() == text::Syntax::kBinary;
        changed.replace({where.offset, where.length}, binary ? std::string("\0\0\0\0\0\xD0\x5E\x40", 8) : "123.25");
        Diagnostics diagnostics;
        const std::optional<text::Document> reread =
            text::parse_document({document.source().name, changed.bytes()}, diagnostics);
        ASSERT_TRUE(reread) << good.name;
        const std::optional<Rig> rig = good.calibration.format->read(std::span(&*reread, 1), {}, diagnostics);
        if (!rig || rig->find_camera(camera.name) == nullptr) continue;
        EXPECT_NE(parameter(rig->find_camera(camera.name)->model, name), value) << good.name << " " << name.name();
        ++checked_places;
      }
    }
  }
  EXPECT_GE(checked_places, has_corpus() ? 300 : 20);
}

}  // namespace
}  // namespace fca::test
