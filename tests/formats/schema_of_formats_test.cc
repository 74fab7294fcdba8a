// SPDX-License-Identifier: BSD-3-Clause
// The tables of formats, with the good files of testdata: a format's writer edits where its table says that a fact stands.
#include "formats/test_files.h"
#include "schema/schema.h"

namespace fca::test {
namespace {

using schema::Fact;
using schema::FactKind;
using schema::Schema;

// No pose is made up in an edit.
TEST(SchemaOfFormats, ARigWithoutPosesEditsNone) {
  for (const char* file : {"no-extrinsic.json", "carla.json", "no-quaternion.json"}) {
    SCOPED_TRACE(file);
    const Calibration calibration = calibration_of(read_file(testdata_dir() / "woodscape" / "bad" / file), file);
    Rig rig = calibration.rig;
    ASSERT_TRUE(rig.poses.empty());
    ASSERT_TRUE(set_parameter(rig.cameras.front().model, "k1", 338.625));
    Diagnostics diagnostics;
    const text::Document& base = calibration.documents.front();
    const std::optional<Written> written = calibration.format->write(&base, rig, {}, diagnostics);
    ASSERT_TRUE(written);
    EXPECT_EQ(written->files.front().document.edited_spans().size(), 1U);
    EXPECT_TRUE(written->files.front().programs.empty()) << "projection.py wants a pose";
  }
}

/// A good file of testdata whose format is a table, and its rig.
struct Tabled {
  const Schema& table;
  Calibration calibration;
  [[nodiscard]] const text::Document& document() const { return calibration.documents.front(); }
};

std::vector<Tabled> tabled_files() {
  std::vector<Tabled> files;
  for (const fs::path& path : files_of_all_formats("good")) {
    Parsed parsed = parse(read_file(path), path.filename().string());
    if (!parsed.document) continue;
    std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
    const bool is_written = calibration && calibration->format->is_written();
    const Schema* table = is_written ? calibration->format->table : nullptr;
    // TUM-VI's table is that of its chains, not of DSO's text.
    const bool is_chain = parsed.document->syntax() != text::Syntax::kWords;
    if (table != nullptr && is_chain) files.push_back({*table, *std::move(calibration)});
  }
  return files;
}

/// Is the place of a fact among what the format's writer edits for a rig that specifies another one?
bool is_edited(const Tabled& file, std::size_t camera, const Fact& fact, const Rig& changed) {
  const text::Node* place = schema::place_of(file.table, file.document(), file.calibration.rig, camera, fact);
  Diagnostics diagnostics;
  const std::optional<Written> written = file.calibration.format->write(&file.document(), changed, {}, diagnostics);
  if (place == nullptr || !written) return false;
  const std::vector<text::Span> spans = written->files.front().document.edited_spans();
  return std::ranges::find(spans, place->span) != spans.end();
}

/// Has the format no number for a parameter, which has one value in its files?
bool is_fixed(const Format& format, const CameraModel& model, std::string_view name) {
  const StoredModel* stored = find_stored_model(format, model_info(model).id, false);
  return stored != nullptr && std::ranges::any_of(stored->ranges, [name](const ParameterRange& range) {
           return range.parameter.name() == name && range.lower == range.upper;
         });
}

TEST(SchemaOfFormats, TheWriterEditsWhereTheTableSaysThatAParameterStands) {
  int found = 0;
  for (const Tabled& file : tabled_files()) {
    const Rig& rig = file.calibration.rig;
    for (std::size_t c = 0; c < rig.cameras.size(); ++c) {
      const auto& parameters = model_info(rig.cameras[c].model).parameters;
      for (std::size_t p = 0; p < parameters.size(); ++p) {
        if (parameters[p].name == "k3" && model_info(rig.cameras[c].model).id == "radtan") continue;  // no key for it
        if (is_fixed(*file.calibration.format, rig.cameras[c].model, parameters[p].name)) continue;
        SCOPED_TRACE(file.document().source().name + " " + std::string(parameters[p].name));
        Rig changed = rig;
        double& value = parameter_values(changed.cameras[c].model)[p];
        value = value == 0.0 ? 1e-9 : value * (1.0 - 1e-9);
        EXPECT_TRUE(is_edited(file, c, {.kind = FactKind::kParameter, .parameter = parameters[p].name}, changed));
        ++found;
      }
    }
  }
  EXPECT_GT(found, 200);
}

TEST(SchemaOfFormats, TheWriterEditsWhereTheTableSaysThatAPoseStands) {
  int found = 0;
  for (const Tabled& file : tabled_files()) {
    const Rig& rig = file.calibration.rig;
    for (std::size_t i = 0; i < rig.poses.size(); ++i) {
      for (int row = 0; row < 3; ++row) {
        SCOPED_TRACE(file.document().source().name + " " + rig.poses[i].a + " " + rig.poses[i].b);
        Rig changed = rig;
        changed.poses[i].T_a_b(row, 3) += 1e-4;
        const Fact fact = {.kind = FactKind::kPose, .pose = &rig.poses[i], .row = row, .column = 3};
        const auto camera = [&rig](const std::string& name) {
          return static_cast<std::size_t>(std::ranges::find(rig.cameras, name, &Camera::name) - rig.cameras.begin());
        };
        const std::size_t of_b = camera(rig.poses[i].b);
        const std::size_t of_a = camera(rig.poses[i].a);
        const bool there = (of_b < rig.cameras.size() && is_edited(file, of_b, fact, changed)) ||
                           (of_a < rig.cameras.size() && is_edited(file, of_a, fact, changed));
        found += there ? 1 : 0;
        // Of a chain's own keys at its top, T_cam1_cam0, the table knows nothing.
        EXPECT_TRUE(there || file.document().bytes().find("\nT_cam") != std::string::npos);
      }
    }
  }
  EXPECT_GT(found, 40);
}

TEST(SchemaOfFormats, TheWriterEditsWhereTheTableSaysThatSizeAndOffsetStand) {
  int found = 0;
  for (const Tabled& file : tabled_files()) {
    const Rig& rig = file.calibration.rig;
    for (std::size_t c = 0; c < rig.cameras.size(); ++c) {
      SCOPED_TRACE(file.document().source().name);
      Rig changed = rig;
      if (changed.cameras[c].image_size) {
        changed.cameras[c].image_size->height += 1;
        EXPECT_TRUE(is_edited(file, c, {.kind = FactKind::kImageSize, .row = 1}, changed));
        ++found;
      }
      if (!rig.cameras[c].time_offset_s) continue;
      for (Camera& camera : changed.cameras) camera.time_offset_s = rig.cameras[c].time_offset_s.value() + 1e-3;
      EXPECT_TRUE(is_edited(file, c, {FactKind::kTimeOffset}, changed));
      ++found;
    }
  }
  EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace fca::test
